"""Polls: what is offered, that nothing tells the right answer before the reveal, and what is said
then."""

import pytest

from workbook.live import LiveError
from workbook.live.polls import options, poll
from workbook.live.worked_problem import WorkedProblem


@pytest.fixture(scope="module")
def worked():
    return WorkedProblem("1.15")


def test_four_answers_one_of_them_right_in_an_order_that_stays(worked):
    offered = options(worked, "a_region")
    assert [option.right for option in offered].count(True) == 1 and len(offered) == 4
    assert len({option.text for option in offered}) == 4 and all(
        "$" in option.text for option in offered
    )
    assert offered == options(WorkedProblem("1.15"), "a_region")
    assert [option.explanation for option in offered if not option.right] == [
        option.explanation for option in offered if option.explanation
    ]
    assert any("Which minor was not looked at?" in option.explanation for option in offered)


def test_the_right_answer_is_not_always_at_one_place(worked):
    places = {
        next(k for k, option in enumerate(options(worked, name)) if option.right)
        for name in worked.exercise.about["answers"]
    }
    assert len(places) > 1


def test_hands_are_counted_and_the_reveal_tells(worked):
    found = poll(worked, "a_region", ["10", "20", "10", "0"])
    assert [bar.value.count("50%") for bar in found._bars] == [0, 1, 0, 0]
    button = found.children[2].children[1]
    button.click()
    assert found.counts[0].value == 11
    assert all(said.value == "" for said in found._explanations)  # nothing is told before
    found._reveal.click()
    told = [said.value for said in found._explanations]
    right = next(k for k, option in enumerate(found.options) if option.right)
    assert "right" in told[right] and all("✗" in said for k, said in enumerate(told) if k != right)
    assert any("Which minor was not looked at?" in said for said in told)


def test_words_and_truth_values_are_answers_too():
    offered = {option.text: option.right for option in options(WorkedProblem("1.13"), "c_kind")}
    assert offered == {"stable": False, "unstable": False, "semistable": True}


@pytest.mark.parametrize(
    "counts, said", [(["3", "4"], "there are 4 answers here"), (["many"], "whole numbers")]
)
def test_counts_that_do_not_fit_end_in_one_line(worked, counts, said):
    with pytest.raises(LiveError, match=said):
        poll(worked, "a_region", counts)
