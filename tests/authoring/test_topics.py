"""Every topic has one name, so that its problems stand in one list."""

import re
from pathlib import Path

from workbook.authoring import master_paths
from workbook.authoring.front_matter import read_front_matter

SOLUTIONS = Path(__file__).resolve().parents[2] / "solutions"
ENDINGS = re.compile(r"('s|um|a|s)$")
STOP_WORDS = {"a", "an", "by", "in", "of", "the", "with"}


def stem(topic):
    """What a topic has in any number and order of its words."""
    return frozenset(
        ENDINGS.sub("", word)
        for word in re.findall(r"[\w']+", topic.lower())
        if word not in STOP_WORDS
    )


def test_topics_have_one_name_each():
    topics = {
        topic
        for path in master_paths(SOLUTIONS)
        for topic in read_front_matter(path, path.read_text(encoding="utf-8"))[0]["topics"]
    }
    names = {}
    for topic in sorted(topics):
        names.setdefault(stem(topic), []).append(topic)
    assert len(topics) > 200 and not [same for same in names.values() if len(same) > 1]


def test_stems_of_topics():
    assert stem("equilibria") == stem("equilibrium") and stem("moving ends") == stem("moving end")
    assert (
        stem("Kelley's condition") == stem("Kelley condition") != stem("condition on a parameter")
    )
