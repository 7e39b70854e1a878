"""Show the cost of the tests in core-seconds, by layer and by problem.

    python benchmarks/suite_cost.py            # of the last `make test`: the reports in _build/tests
    python benchmarks/suite_cost.py one.xml    # of reports that pytest wrote with --junitxml

This is the processor time of each test and of its child processes. A problem costs the sum of its proof
(the tests of tests/problems under its number), its page (executed in a kernel), its part of the
Sphinx builds of both editions and of the tests of the built files, its visit by the browser and
by Chromium, and the tests of the grader and others under its number. The
setup before the first and after the last problem is not included.

Use a quiet machine: other load has made the same proof cost up to twice as much.
"""

import re
import sys
from collections import Counter, defaultdict
from datetime import datetime
from pathlib import Path
from xml.etree import ElementTree

from jupyter_cache import get_cache

ROOT = Path(__file__).resolve().parents[1]
#: The number of the problem that a test is about: "test_x[2.30]", "test_y[2.30-full]".
NUMBER = re.compile(r"[\[-](\d+\.\d+)[]-]")
#: A reference cost of a problem in core-seconds, and how many of the costliest are named.
BAR, COSTLIEST = 6, 10
#: Patterns of modules of tests, and the layer to which they belong; the first match counts. Of other
#: tests each folder is a layer.
LAYERS = [
    (r"tests\.problems\.test_masters", "proofs"),
    (r"tests\.problems\.test_exercises", "exercises"),
    (r"tests\.problems", "exercises judged by others"),
    (r"tests\.checks\.test_cases", "cases of the checks"),
    (r"tests\.checks", "checks beside their cases"),
    (r"tests\.site\.test_(pages|page_content|readability|library_pages)", "built files"),
    (r"tests\.site\.test_execution", "page execution, its own tests"),
    (r"tests\.site", "site in the browser"),
    (r"(?!tests\.)", "doctests"),
]


def layer(module):
    layers = (name for pattern, name in LAYERS if re.match(pattern, module))
    return next(layers, "/".join(module.split(".")[:2]))


def tests(report):
    """Yield (module, number of the problem or None, {kind: core-seconds}) of each test."""
    for case in ElementTree.parse(report).iter("testcase"):
        noted = {
            each.get("name"): float(each.get("value"))
            for each in case.iter("property")
            if each.get("name").startswith("core seconds")
        }
        number = NUMBER.search(case.get("name"))
        yield case.get("classname"), number and number[1], noted


def pages(since):
    """Return problem or page -> core-seconds of executing it, for pages executed after `since`."""
    costs = {}
    for record in get_cache(ROOT / "_build" / ".jupyter_cache").list_cache_records():
        path = Path(record.uri)
        if record.data["executed"] > since:
            problem = path.parent.name.startswith("ch")
            number = f"{path.parent.name[2:]}.{int(path.stem[1:])}" if problem else path.stem
            costs[number] = record.data["core_seconds"]
    return costs


def in_order(numbers):
    return sorted(numbers, key=lambda number: [int(part) for part in number.split(".")])


def main(*reports):
    reports = reports or sorted((ROOT / "_build" / "tests").glob("*.xml"))
    if not reports:
        sys.exit("There is no report of the tests: run make test first.")
    began = min(
        datetime.fromisoformat(suite.get("timestamp")).timestamp()
        for report in reports
        for suite in ElementTree.parse(report).iter("testsuite")
    )
    layers, proofs, visits, others = (defaultdict(float) for _ in range(4))
    counts = Counter()
    for report in reports:
        for module, number, noted in tests(report):
            # Building the site and Chromium are noted separately and included in the time of a test.
            built, browser = (
                noted.get("core seconds of a build", 0),
                noted.get("core seconds of a browser", 0),
            )
            seconds = noted.get("core seconds", 0) - built - browser
            layers["site builds"] += built
            layers["site in the browser"] += browser
            layers[layer(module)] += seconds
            counts[layer(module)] += 1
            if number:
                visits[number] += noted.get("core seconds in Chromium", 0)
                {"proofs": proofs, "exercises": proofs, "site in the browser": visits}.get(
                    layer(module), others
                )[number] += seconds
    executed = pages(began) if layers["site builds"] else {}
    layers["site builds"] -= sum(executed.values())
    layers["pages executed"] += sum(executed.values())

    total = sum(layers.values())
    print(f"{'layer':32}{'tests':>7}{'core-seconds':>15}{'share':>8}")
    for name, seconds in sorted(layers.items(), key=lambda pair: -pair[1]):
        if seconds or counts[name]:
            print(
                f"{name:32}{counts[name] or '':>7}{seconds:15.1f}{seconds / max(total, 1e-9):8.0%}"
            )
    print(
        f"{'all':32}{counts.total():7}{total:15.1f}   at least {total / 120:.1f} min on two cores"
    )
    by_problem(proofs, visits, others, layers, executed)


def by_problem(proofs, visits, others, layers, executed):
    """Print a line for each problem, the means of the chapters, and the costliest problems."""
    numbers = in_order(proofs)
    if not numbers:
        return
    built = (layers["site builds"] + layers["built files"]) / len(numbers)
    columns = "proof", "page", "built", "visit", "others", "all"
    print("\ncore-seconds by problem\n" + " " * 10 + "".join(f"{name:>8}" for name in columns))
    costs = {}
    for number in numbers:
        parts = (proofs[number], executed.get(number, 0.0), built, visits[number], others[number])
        costs[number] = *parts, sum(parts)
        print(f"{number:>10}" + line(costs[number]))
    chapters = defaultdict(list)
    for number, parts in costs.items():
        chapters[number.partition(".")[0]].append(parts)
    for chapter, rows in [*chapters.items(), ("all", list(costs.values()))]:
        print(f"{'mean ' + chapter:>10}" + line([sum(column) / len(rows) for column in zip(*rows)]))
    above = [number for number in numbers if costs[number][-1] > BAR]
    print(
        f"\n{len(above)} of {len(numbers)} problems cost more than {BAR} core-seconds; the costliest:"
    )
    for number in sorted(numbers, key=lambda number: -costs[number][-1])[:COSTLIEST]:
        part = max(zip(costs[number], columns[:-1]))
        print(
            f"{number:>10}{costs[number][-1]:8.1f}, {costs[number][-1] / BAR:.1f} times the bar, "
            f"of which {part[1]} {part[0]:.1f}"
        )
    if missing := [number for number in numbers if number not in executed]:
        print(
            f"\nWithout the page, which was not executed in this run, are {len(missing)} problems: "
            "`make clean` comes first to see what pages cost."
        )


def line(numbers):
    return "".join(f"{number:8.1f}" for number in numbers)


if __name__ == "__main__":
    main(*sys.argv[1:])
