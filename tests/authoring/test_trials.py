"""Reading trials: where they begin and end, and errors."""

import pytest

from workbook.authoring import MasterError
from workbook.authoring.trials import Trial, read_trials

NAMES = {"a_region": None, "b_points": None}


def trials_of(tmp_path, text):
    path = tmp_path / "p15.trials.py"
    path.write_text(text, encoding="utf-8")
    return read_trials(path, NAMES)


def test_comments_behind_and_above(tmp_path):
    trials = trials_of(
        tmp_path,
        """\
# %% wrong
a_region = k > 0  # one sign – of two
# a point too many,
# and long

points = [0, 1]  # counted

# both of them
points = [[p, -p]
          for p in (1, 2)]
b_points = sorted(points)  # sorted

# %% right
b_points = {
    1: "# %% wrong"}  # as a dict
a_region = k > 1  # the other one
""".replace("points = [0, 1]  # counted\n\n", ""),
    )
    assert trials == {
        "wrong": [
            Trial("a_region", "a_region = k > 0", "one sign – of two"),
            Trial(
                "b_points",
                "points = [[p, -p]\n          for p in (1, 2)]\nb_points = sorted(points)",
                "both of them",
            ),
        ],
        "right": [
            Trial("b_points", 'b_points = {\n    1: "# %% wrong"}', "as a dict"),
            Trial("a_region", "a_region = k > 1", "the other one"),
        ],
    }


def test_several_lines_above_are_one_comment(tmp_path):
    trials = trials_of(tmp_path, "# %% right\n# a line,\n# and another\na_region = True\n")
    assert (
        trials["right"] == [Trial("a_region", "a_region = True", "a line, and another")]
        and trials["wrong"] == []
    )


@pytest.mark.parametrize(
    "text, line, message",
    [
        ("a_region = k > 0  # why\n", 1, "stands under a line"),
        ("# %% wrong\na_region = k > 0\n", 2, "under a comment"),
        ("# %% wrong\n# far away\n\na_region = k > 0\n", 4, "under a comment"),
        ("# %% wrnog\na_region = k > 0  # why\n", 1, "# %% wrong or # %% right"),
        ("# %% wrong\nk = 1\n# %% right\na_region = k > 0  # why\n", 3, "before a trial"),
        ("# %% wrong\na_region, b_points = 1, 2  # why\n", 2, "one answer"),
        ("# %% wrong\na_region = 1; b_points = 2  # why\n", 2, "one answer"),
        ("# %% wrong\na_region = 1  # why\nk = 2\n", 3, "assigns none"),
        ("# %% wrong\na_regoin = 1  # why\na_region = 2  # why\n", 2, "a_regoin is no answer"),
        ("# %% wrong\na_region = (1  # why\n", 2, "no Python"),
    ],
)
def test_malformed_trials_are_errors(tmp_path, text, line, message):
    with pytest.raises(MasterError, match=rf"p15\.trials\.py:{line}: .*{message}"):
        trials_of(tmp_path, text)
