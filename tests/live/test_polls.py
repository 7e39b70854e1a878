"""Polls: the options, and the explanations, which appear at the reveal only."""

import re

import pytest

from workbook.live import LiveError, polls
from workbook.live.polls import options, poll
from workbook.live.worked_problem import WorkedProblem


@pytest.fixture(scope="module")
def problem():
    return WorkedProblem("1.15")


def test_four_options_one_of_them_right_in_a_fixed_order(problem):
    shown = options(problem, "a_region")
    assert [option.right for option in shown].count(True) == 1 and len(shown) == 4
    assert len({option.text for option in shown}) == 4 and all(
        "$" in option.text for option in shown
    )
    assert shown == options(WorkedProblem("1.15"), "a_region")
    assert [option.explanation for option in shown if not option.right] == [
        option.explanation for option in shown if option.explanation
    ]
    assert any("Which minor was not looked at?" in option.explanation for option in shown)


def test_the_position_of_the_right_option_varies(problem):
    positions = {
        next(k for k, option in enumerate(options(problem, name)) if option.right)
        for name in problem.exercise.about["answers"]
    }
    assert len(positions) > 1


def test_hands_are_counted_before_the_reveal(problem):
    widget = poll(problem, "a_region", ["10", "20", "10", "0"])
    assert [bar.value.count("50%") for bar in widget._bars] == [0, 1, 0, 0]
    button = widget.children[2].children[1]
    button.click()
    assert widget.counts[0].value == 11
    assert all(message.value == "" for message in widget._explanations)  # nothing is told before
    widget._reveal.click()
    explanations = [message.value for message in widget._explanations]
    right = next(k for k, option in enumerate(widget.options) if option.right)
    assert "right" in explanations[right] and all(
        "✗" in message for k, message in enumerate(explanations) if k != right
    )
    assert any("Which minor was not looked at?" in message for message in explanations)


def test_an_error_of_a_callback_is_one_line_in_the_poll(problem, monkeypatch, capsys, caplog):
    widget = poll(problem, "a_region")
    hand, count = widget.children[2].children[1:3]
    monkeypatch.setattr(polls, "typeset", lambda text: 1 / 0)
    click = {"method": "custom", "content": {"event": "click"}}
    widget._reveal._handle_msg({"content": {"data": click}, "buffers": []})
    message = "this does not work: ZeroDivisionError: division by zero"
    assert message in widget.error.value
    hand.click()
    assert count.value == 1 and widget.error.value == ""
    monkeypatch.setattr(widget, "_draw", lambda: 1 / 0)
    hand.click()
    assert count.value == 2 and message in widget.error.value
    assert capsys.readouterr().err == "" and not caplog.records


def test_choices_are_options_too():
    shown = {option.text: option.right for option in options(WorkedProblem("1.13"), "c_kind")}
    assert shown == {"stable": False, "unstable": False, "semistable": True}


@pytest.mark.parametrize(
    "counts, message", [(["3", "4"], "there are 4 answers here"), (["many"], "whole numbers")]
)
def test_bad_counts_end_in_one_line(problem, counts, message):
    with pytest.raises(LiveError, match=message):
        poll(problem, "a_region", counts)


@pytest.mark.parametrize(
    "number, name, texts",
    [
        ("2.4", "a_observable", ["weight * alpha + beta, 0)"]),  # in the names of the data
        # a right answer is not shown under another sign
        ("3.8", "gain", ["gain = Matrix([[-1], [-1], [-1]])", "gain = Matrix([[2], [2], [2]])"]),
        ("5.63", "eigenvalues", ["eigenvalues = [sqrt(6)/2]", "eigenvalues = [-sqrt(6)/2 - 1]"]),
    ],
)
def test_a_mistake_is_shown_without_the_right_answer(number, name, texts):
    problem = WorkedProblem(number)
    shown = [problem.trial_text(trial) for trial in problem.trials(name)]
    assert all(any(text in line for line in shown) for text in texts), shown
    values = (line.partition(f"{name} = ")[2] for line in shown)
    assert not any(re.search(rf"\b{name}\b", value) for value in values)
