"""What students write takes time in proportion to its length, and is parsed within limits."""

import json
import os
import time

import pytest

from workbook.grading.course import objections, submissions, text_cells
from workbook.grading.course.assignment import of_problems
from workbook.grading.sandbox import limited_process, preloading, sanitising, submitted_file
from workbook.grading.sandbox.submitted_file import Reader, UnreadableFileError
from workbook.notebooks import exercises
from workbook.numbering import number_of_name

#: Texts of half a million characters on which a careless pattern begins again at each character.
LENGTH = 500_000
TEXTS = {
    "brackets": "[",
    "empty links": "[](",
    "links in links": "[a](",
    "closed": "[]",
    "letters": "a",
    "assignments": "a =",
    "spaces": " ",
    "lines": "\n",
    "library": "scipy ",
    "dots": "scipy.",
    "reports": 'checks.report("1.',
    "kept": "a=checks.kept_for_grading(",
    "digits": "1",
    "chapters": "ch1-p",
    "underscores": "_1_",
    "equals": "=",
    "quotes": '"',
    "nulls": "\0",
}
READERS = {
    "hash of a text cell": submitted_file.text_hash,
    "names in text": submitted_file.ASSIGNED_NAME.findall,
    "number of a name": number_of_name,
    "sanitise": sanitising.sanitise,
    "cells to run": lambda text: exercises.find("1.15").sources_to_run([text]),
    "libraries": lambda text: preloading.modules_for(["1.15"], [text]),
}


@pytest.mark.parametrize("reader", READERS)
def test_no_pattern_begins_again_at_each_character(reader):
    READERS[reader]("a")  # caches
    for name, part in TEXTS.items():
        before = time.process_time()
        READERS[reader]((part * LENGTH)[:LENGTH])
        # A quadratic pattern takes minutes, a linear one a tenth of a second.
        assert time.process_time() - before < 5, name


def test_a_notebook_of_brackets_costs_the_grader_nothing(tmp_path):
    path = tmp_path / "submitted/ada/hw1/ch1-p15.ipynb"
    path.parent.mkdir(parents=True)
    cells = [{"cell_type": "markdown", "metadata": {}, "source": "[" * 2 * 10**6}]
    path.write_text(json.dumps({"cells": cells, "metadata": {}}))
    before = os.times()
    (entry,) = submissions.find(tmp_path / "submitted")
    ((_, (text,)),) = text_cells.read(tmp_path / "submitted", of_problems("hw1", ["1.15"]))["ada"]
    used = os.times()
    assert entry.problem == "1.15" and not entry.trouble
    assert text.startswith("[" * 1000) and "1980000 more characters" in text
    assert used.user - before.user < 1, "in the process that grades"
    assert used.children_user - before.children_user < 10


def test_a_file_that_takes_too_long_ends_its_reader_alone(monkeypatch):
    monkeypatch.setattr(limited_process, "SECONDS", 1)
    content = json.dumps({"cells": [], "metadata": {"workbook": {"number": "1.4"}}}).encode()

    def parse(content):
        while content.startswith(b"endless"):
            pass
        return submitted_file._parse_json(content)[0], (), []

    monkeypatch.setattr(
        submitted_file, "_parse", lambda content: ("1.4", (), parse(content)[2], ())
    )
    with Reader() as reader:
        for _ in range(2):
            assert reader.notebook(content).number == "1.4"
            with pytest.raises(UnreadableFileError, match="more time or memory than allowed"):
                reader.notebook(b"endless")


def test_an_objection_is_read_as_far_as_it_is_shown(tmp_path):
    path = tmp_path / "submitted/ada/hw1/objection.txt"
    path.parent.mkdir(parents=True)
    path.write_bytes("я".encode() * 20 * 2**20)
    before = time.process_time()
    ((_, text),) = objections.handed_in(tmp_path / "submitted", "hw1")
    assert text == "я" * objections.MAX_LENGTH + " ..."
    assert time.process_time() - before < 3
