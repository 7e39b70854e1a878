"""Answers as people type them into the box of 1.15 a: what is read, the verdict, and what is said.

Pages, notebooks and the command judge them alike.
"""

#: (what is typed, what is shown as read, verdict, part of what is said besides)
TYPED = [
    ("(k1 > 0) & (k1*k2 > 1)", "a_region = (k1 > 0) & (k1*k2 > 1)", "right", ""),
    ("# my answer\nsp.And(k1 > 0, k2 > 0)", "a_region = sp.And(k1 > 0, k2 > 0)", "wrong", ""),
    ("(k₁ > 0) & (k₁·k₂ > 1)", "a_region = (k1 > 0) & (k1*k2 > 1)", "right", ""),
    ("a_region = (k₁ > 0) & (k₁×k₂ > 1)", "a_region = (k1 > 0) & (k1*k2 > 1)", "right", ""),
    ("a_region = (k1 − 0 ≥ 0) & (k1*k2 > 1)", "a_region = (k1 - 0 >= 0) & (k1*k2 > 1)", "right", ""),
    ("a_region = k₁² > √3", "a_region = k1**2 > sp.sqrt(3)", "wrong", ""),
    ("$k_1>0$", "a_region = k1>0", "wrong", ""),
    ("a_region = k1 > 0\u00a0", "a_region = k1 > 0 ", "wrong", ""),
    ("a_region = (k1 > 0) & (k1*k2 > 1)", "", "right", ""),
    ("a_regoin = k1 > 0", "", "missing", "your code assigns `a_regoin`: did you mean `a_region`?"),
    ("region = k1 > 0", "", "missing", "your code assigns `region`: did you mean `a_region`?"),
    ("а_region = k1 > 0", "", "missing", "in which `а` is a Cyrillic letter"),
    ("a_region == (k1 > 0)", "", "missing", "your cell compares, `a_region == ...`"),
    ("a_region = к1 > 0", "", "missing", "`к` in `к1` is a Cyrillic letter: type k1"),
    ("a_region = k_1 > 0", "", "missing", "Did you mean k1?"),
    ("a_region = k1·k2 > 1", "", "missing", "a product is written with *, k1*k2"),
    ("a_region = k1 > π", "", "missing", "Write sp.pi"),
    ("a_region = k2^2 > 0", "", "missing", "A power is x**2"),
    ("a_region = k1 > 0 ∧ k2 > 0", "", "missing", "Join conditions of SymPy with &"),
    ("a_region = k1 ≠ 0", "", "missing", "sp.Ne"),
    ("a_region = unstable", "", "missing", 'it stands in quotation marks: "unstable"'),
    ("a_region = np.array([k1 > 0])", "", "missing", "A vector is a list"),
    ("a_region = [k1 > 0, k1*k2 > 1]", "", "right", ""),
    ("a_region = [k1 > 0, k2 > 0]", "", "wrong", "for one of them write `sp.Or(...)`"),
    ('a_region = "k1 > 0"', "", "invalid", "leave its quotation marks out"),
]  # fmt: skip
