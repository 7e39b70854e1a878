"""What the tests cost in core-seconds, by layer and by problem, as the last `make test` noted it.

    python benchmarks/suite_cost.py

Processor time of each test and of its child processes. What a problem costs is the sum of its proof (all tests in
tests/problems under its number), its page (executed in a kernel), its part of the Sphinx builds of both editions and of
the tests of the built files, its visits by the browser, and the tests of the grader and others under its number. What
a browser computed is known when it is closed, so it counts under "built", a like part for each problem.

Read the numbers of a quiet machine: what runs beside the tests made the same proof cost up to a third more.
"""

import re
import sys
from collections import defaultdict
from datetime import datetime
from pathlib import Path
from xml.etree import ElementTree

from jupyter_cache import get_cache

ROOT = Path(__file__).resolve().parents[1]
#: The number of the problem that a test is about: "test_x[2.30]", "test_y[2.30-full]".
NUMBER = re.compile(r"[\[-](\d+\.\d+)[]-]")


def tests(report):
    """(place, number of the problem or None, core-seconds) of each test in a report."""
    for case in ElementTree.parse(report).iter("testcase"):
        seconds = sum(float(each.get("value")) for each in case.iter("property") if each.get("name") == "core seconds")
        number = NUMBER.search(case.get("name"))
        yield case.get("classname").split("."), number and number[1], seconds


def pages(since):
    """Problem or page of theory -> core-seconds of executing it, for pages executed after the moment `since`."""
    found = {}
    for record in get_cache(ROOT / "_build" / ".jupyter_cache").list_cache_records():
        path = Path(record.uri)
        if record.data["executed"] > since:
            problem = path.parent.name.startswith("ch")
            number = f"{path.parent.name[2:]}.{int(path.stem[1:])}" if problem else path.stem
            found[number] = record.data["core_seconds"]
    return found


def main():
    reports = sorted((ROOT / "_build" / "tests").glob("*.xml"))
    if not reports:
        sys.exit("There is no report of the tests: run make test first.")
    began = min(datetime.fromisoformat(suite.get("timestamp")).timestamp()
                for report in reports for suite in ElementTree.parse(report).iter("testsuite"))
    layers, proofs, visits, others = (defaultdict(float) for _ in range(4))
    for report in reports:
        for place, number, seconds in tests(report):
            layers["doctests" if place[0] != "tests" else place[1]] += seconds
            if number:
                {"problems": proofs, "site": visits}.get(place[1], others)[number] += seconds
    executed = pages(began)
    layers["site"] -= sum(executed.values())
    layers["pages executed"] = sum(executed.values())

    print("core-seconds by layer")
    for layer, seconds in sorted(layers.items(), key=lambda pair: -pair[1]):
        print(f"  {layer:20}{seconds:8.1f}")
    print(f"  {'all':20}{sum(layers.values()):8.1f}")

    numbers = sorted(proofs, key=lambda number: [int(part) for part in number.split(".")])
    if not numbers:
        return
    built = (layers["site"] - sum(visits.values())) / len(numbers)
    print("\ncore-seconds by problem\n   problem   proof    page   built   visit  others     all")
    total = defaultdict(list)
    for number in numbers:
        costs = proofs[number], executed.get(number, 0.0), built, visits[number], others[number]
        total[number.split(".")[0]].append(costs)
        print(f"  {number:>8}" + "".join(f"{cost:8.1f}" for cost in (*costs, sum(costs))))
    for chapter, costs in [*total.items(), ("all", [one for costs in total.values() for one in costs])]:
        means = [sum(column) / len(costs) for column in zip(*costs)]
        print(f"  mean {chapter:>3}" + "".join(f"{mean:8.1f}" for mean in (*means, sum(means))))
    if len(executed) < len(numbers):
        print("\nNot all pages were executed in this run: begin with make clean to see what a page costs.")


if __name__ == "__main__":
    main()
