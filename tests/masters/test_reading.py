"""The reader holds a master to its contract, and says which file breaks it and how."""

from pathlib import Path

import pytest

from trajlib.masters import MasterError, read

ROOT = Path(__file__).resolve().parents[2]
GOOD = (ROOT / "solutions" / "ch1" / "p15.md").read_text(encoding="utf-8")


def test_reads_everything():
    master = read(ROOT / "solutions" / "ch1" / "p15.md")
    assert (master.number, master.section, master.level) == ("1.15", "§1.2", "core")
    assert list(master.answers) == ["a_region", "b_region", "c_region", "d_region", "e_region"]
    assert master.answers["a_region"].kind == "condition" and not master.answers["a_region"].exact
    assert master.exercise == ROOT / "exercises" / "ch1" / "p15.ipynb"
    assert len(master.code("check")) == 5 and all("checks.report" in source for source in master.code("check"))
    name, source, comment = master.trials("wrong")[0]
    assert name == "a_region" and comment == "positive coefficients taken for sufficient"


@pytest.mark.parametrize("old, new, said", [
    ('number: "1.15"', "number: 1.15", "quoted"),
    ("level: core", "level: easy", "core or starred"),
    ("  title: Stability regions in the plane of two parameters\n", "", "front matter"),
    ('a_region: "condition: the', 'a_region: "kind of set, the', "TYPE"),
    (":tags: [data]", ":tags: [date]", "exactly one role"),
    (":tags: [data]", ":tags: [data, check]", "exactly one role"),
    ("[wrong, skip-execution, remove-cell]", "[wrong]", "skip-execution"),
    ("# positive coefficients taken for sufficient\n", "", "under a comment"),
    ("b_region = sp.And(k2 > 0, k1 > k2)", "pass", "assign every answer once"),
    ("checks.report(b_region=", "checks.report(a_region=", "report every answer once"),
    ('    b_region: ["The leading', '    z_region: ["The leading', "hints"),
    ("a_poly = s**3", "a_region = s**3", "a data cell assigns"),
])
def test_a_broken_contract_is_named(tmp_path, old, new, said):
    assert old in GOOD
    (tmp_path / "p15.md").write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(MasterError, match=said) as raised:
        read(tmp_path / "p15.md")
    assert "p15.md" in str(raised.value)
