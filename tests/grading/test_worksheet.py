"""Moodle's grading worksheet in the languages, separators and forms that come in."""

import csv
import io
import time
from datetime import datetime

import pytest

from workbook.grading.course import worksheet
from workbook.grading.course.assignment import InputError
from workbook.grading.course.policy import time_zone

#: As Moodle writes them: two participants, of whom the second has handed in nothing.
ENGLISH = """Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,\
Last modified (submission),Last modified (grade),Feedback comments
Participant 101,Ann Able,ann@uni.example,"Submitted for grading - 3 mins late",,7.00,Yes,\
"Tuesday, 1 September 2026, 2:14 PM",-,
Participant 1777,"Bee, Bob",bob@uni.example,No submission,,7.00,Yes,-,-,
"""
RUSSIAN = """Идентификатор,Полное имя,Адрес электронной почты,Состояние,Оценка,Максимальная \
оценка,Оценка может быть изменена,Последнее изменение (ответ),Последнее изменение (оценка),\
Отзыв в виде комментария
Участник101,Ann Able,ann@uni.example,Отправлено для оценивания,"6,50","7,00",Да,\
"вторник, 1 сентября 2026, 14:14","среда, 2 сентября 2026, 09:00",
Участник1777,"Bee, Bob",bob@uni.example,Нет ответа на задание,,"7,00",Да,-,-,
"""
GERMAN = """ID,"Vollständiger Name",E-Mail-Adresse,Status,Bewertung,Skala,"Bewertung kann geändert \
werden","Zuletzt geändert (Abgabe)","Texteingabe online","Zuletzt geändert (Bewertung)","Feedback \
als Kommentar"
Teilnehmer/in101,"Ann Able",ann@uni.example,"Zur Bewertung abgegeben -  - ",,"bestanden",Ja,\
"Dienstag, 1. September 2026, 14:14","Mittwoch, 2. September 2020, 10:00","Dienstag, 8. September \
2026, 10:37",Gut
Teilnehmer/in1777,"Bee, Bob",bob@uni.example,"Keine Abgabe -  - ",,"bestanden",Ja,-,,-,
"""
#: With due dates of its own for a participant.
FRENCH = """Identifiant,Nom complet,Adresse de courriel,Statut,Date de remise,Note,Note maximale,\
La note peut être modifiée,Dernière modification (travail remis),Dernière modification (note)
Participant 101,Ann Able,ann@uni.example,Remis,"mardi 8 septembre 2026, 23:59",,"7,00",Oui,\
"mardi 1 septembre 2026, 14:14",-
Participant 1777,"Bee, Bob",bob@uni.example,Aucun,"mardi 1 septembre 2026, 23:59",,"7,00",Oui,-,-
"""
SHEETS = {"en": ENGLISH, "ru": RUSSIAN, "de": GERMAN, "fr": FRENCH}
WHEN = datetime(2026, 9, 1, 14, 14).timestamp()


def read(folder, text):
    (folder / "sheet.csv").write_text(text, encoding="utf-8")
    return worksheet.read(folder / "sheet.csv")


def with_separator(text, separator):

    out = io.StringIO()
    csv.writer(out, delimiter=separator).writerows(csv.reader(io.StringIO(text)))
    return out.getvalue()


@pytest.mark.parametrize("bom", ["", "\ufeff"])
@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("language", SHEETS)
def test_a_worksheet_of_any_language(tmp_path, language, separator, bom):
    assert read(tmp_path, bom + with_separator(SHEETS[language], separator)) == {
        "101": worksheet.Participant("Ann Able", "ann@uni.example", WHEN),
        "1777": worksheet.Participant("Bee, Bob", "bob@uni.example", None),
    }


def test_names_and_addresses_that_moodle_hides(tmp_path):
    header = "Identifier,Status,Grade,Maximum Grade,Grade can be changed,Sub,Gr\n"
    rows = "".join(f"Участник {k},Отправлено,,7.00,Да,-,-\n" for k in (1, 2, 3))
    found = read(tmp_path, header + rows)
    assert found["2"] == worksheet.Participant("Участник", "", None)


def test_a_name_with_a_digit_is_one(tmp_path):
    """It turned all names into "Participant"."""
    found = read(tmp_path, ENGLISH.replace("Ann Able", "X AE A-12"))
    assert found["101"].name == "X AE A-12" and found["1777"].name == "Bee, Bob"
    header = "Identifier,Full name,Status,Grade\n"
    rows = "Participant 1,X AE A-12,None,\nParticipant 2,Ann,None,\nParticipant 3,Bob,None,\n"
    assert [p.name for p in read(tmp_path, header + rows).values()] == ["X AE A-12", "Ann", "Bob"]
    rows = "".join(f"Participant {k},Submitted - {k} days late,\n" for k in (1, 2, 3))
    assert read(tmp_path, "Identifier,Status,Grade\n" + rows)["2"].name == "Participant"


@pytest.mark.parametrize(
    "language, encoding, told",
    [
        ("ru", "cp1251", "Windows-1251"),
        ("de", "cp1252", "Windows-1252"),
        ("fr", "cp1252", "Windows-1252"),
        ("ru", "utf-16", None),
        ("de", "utf-8-sig", None),
    ],
)
def test_a_worksheet_that_a_spreadsheet_saved(tmp_path, capsys, language, encoding, told):
    text = with_separator(SHEETS[language], "\t" if encoding == "utf-16" else ";")
    path = tmp_path / "sheet.csv"
    path.write_bytes(text.encode(encoding))
    assert worksheet.read(path)["101"] == worksheet.Participant("Ann Able", "ann@uni.example", WHEN)
    worksheet.read(path)
    assert capsys.readouterr().err == (f"{path} is read as {told}\n" if told else "")


@pytest.mark.parametrize("encoding", ["mac_cyrillic", "cp866", "utf-32"])
def test_a_worksheet_in_another_encoding_says_how_to_save_it(tmp_path, encoding):
    (tmp_path / "sheet.csv").write_bytes(RUSSIAN.encode(encoding))
    with pytest.raises(InputError, match='save it in the spreadsheet as "CSV UTF-8'):
        worksheet.read(tmp_path / "sheet.csv")


@pytest.mark.parametrize("text", ["x", "x ", "@", "1:11 ", "x\n", "1 "])
def test_texts_of_students_in_a_worksheet_take_no_time(tmp_path, text):
    """Moodle puts what students typed in into a column; a pattern took time by the square of it."""
    long = text * (500_000 // len(text))
    sheet = ENGLISH.replace("Feedback comments", "Online text")
    sheet = "\n".join(line + f'"{long}"' if "@" in line else line for line in sheet.split("\n"))
    began = time.process_time()
    assert read(tmp_path, sheet)["101"].submitted == WHEN
    assert time.process_time() - began < 2


def test_groups_are_no_participants(tmp_path):
    text = "Group,Id,Name\nGroup 1,Participant 7,Ann\nGroup 1,Participant 8,Bob\n"
    assert list(read(tmp_path, text)) == ["7", "8"]


@pytest.mark.parametrize(
    "text, when",
    [
        ("Wednesday, September 23, 2020, 9:00 PM", (2020, 9, 23, 21, 0)),
        ("Wednesday, 23 September 2020, 12:05 AM", (2020, 9, 23, 0, 5)),
        ("среда, 6 мая 2026, 00:01", (2026, 5, 6, 0, 1)),
        ("Donnerstag, 5. März 2026, 12:00", (2026, 3, 5, 12, 0)),
        ("martes, 3 de marzo de 2026, 14:14", (2026, 3, 3, 14, 14)),
        ("martedì, 9 giugno 2026, 10:00", (2026, 6, 9, 10, 0)),
        ("понеділок, 2 листопада 2026, 10:00", (2026, 11, 2, 10, 0)),
        ("2026年6月10日(水曜日) 14:14", (2026, 6, 10, 14, 14)),
        ("2026-06-10 14:14:05", (2026, 6, 10, 14, 14, 5)),
        ("10.06.2026 14:14", (2026, 6, 10, 14, 14)),
        # November in Finnish, not March; August in Czech and July in Croatian; no month at all.
        ("keskiviikko 4. marraskuuta 2026, 10:00", None),
        ("srpna 4, 2026, 10:00", None),
        ("martes, 9 de xuño de 2026, 10:00", None),
        ("6/10/2026 14:14", None),
        ("1405-03-20 14:14", None),
        ("31 February 2026, 14:14", None),
        ("1 May 2026, 26:14", None),
        ("-", None),
    ],
)
def test_dates(text, when):
    """A date that cannot be read for sure is none."""
    assert worksheet.time(text) == (when and datetime(*when).timestamp())


@pytest.mark.parametrize(
    "zone, text, utc",
    [
        ("Europe/Moscow", "среда, 30 сентября 2026, 23:30", "2026-09-30T20:30"),
        ("Europe/Berlin", "Mittwoch, 30. September 2026, 23:30", "2026-09-30T21:30"),
        ("Europe/Berlin", "Montag, 30. November 2026, 23:30", "2026-11-30T22:30"),
        ("Asia/Yekaterinburg", "2026-09-30 23:30", "2026-09-30T18:30"),
        ("UTC", "30.09.2026 23:30", "2026-09-30T23:30"),
    ],
)
@pytest.mark.parametrize("computer", ["UTC", "America/New_York"])
def test_times_of_a_zone(monkeypatch, zone, text, utc, computer):
    """The time zone of the computer does not matter when another is given."""
    monkeypatch.setenv("TZ", computer)
    time.tzset()
    try:
        seconds = worksheet.time(text, time_zone(zone))
    finally:
        monkeypatch.undo()
        time.tzset()
    assert seconds == datetime.fromisoformat(f"{utc}+00:00").timestamp()


def test_a_date_that_cannot_be_read_leaves_the_time_unknown(tmp_path):
    """The column of the grade does not take its place."""
    text = ENGLISH.replace("1 September", "1 syyskuuta").replace(
        '2:14 PM",-', '2:14 PM","Friday, 4 September 2026, 9:00 AM"'
    )
    assert read(tmp_path, text)["101"].submitted is None


@pytest.mark.parametrize(
    "text, message",
    [
        (ENGLISH.replace("1777", "101"), "has the participant 101 more than once"),
        (ENGLISH.replace("bob@", "ann@"), "has the address ann@uni.example more than once"),
        ("Name,Grade\nann,1\n", "is not a grading worksheet of Moodle"),
        ("Identifier\n", "is not a grading worksheet of Moodle"),
        ("", "is not a grading worksheet of Moodle"),
    ],
)
def test_a_worksheet_that_cannot_be_used(tmp_path, text, message):
    with pytest.raises(InputError, match=f"sheet.csv {message}"):
        read(tmp_path, text)


def test_a_worksheet_that_cannot_be_read(tmp_path):
    with pytest.raises(InputError, match="No such file"):
        worksheet.read(tmp_path / "sheet.csv")
    (tmp_path / "sheet.csv").write_bytes(b"PK\x03\x04\x14\x00" + ENGLISH.encode())
    with pytest.raises(InputError, match="not CSV in UTF-8"):
        worksheet.read(tmp_path / "sheet.csv")
