"""What the examples in docstrings may use without an import."""

import pytest


@pytest.fixture(autouse=True)
def names_of_examples(request, doctest_namespace):
    """Give the examples of checks SymPy and the checks, as a check cell has them."""
    if "workbook/checks/" in request.path.as_posix():
        import sympy as sp

        from workbook import checks

        doctest_namespace.update(sp=sp, checks=checks)
