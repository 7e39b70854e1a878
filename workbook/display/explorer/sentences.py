"""Sentences that say what is seen in an `Explorer`, with its numbers."""

import re

import sympy as sp

__all__ = ["Sentence", "short"]

NAME = re.compile(r"\{(.*?)\}")


class Sentence:
    """Conditions in the scalars of a figure, each with a text; see `Explorer.sentence`.

    Attributes
    ----------
    cases : list of (Formula, list)
        Each condition with its text in pieces: a str as it is, an int the index of a scalar.
    """

    def __init__(self, explorer, cases):
        if not cases or cases[-1][0] not in (True, sp.true):
            raise ValueError("cases: expected the condition True in the last one")
        self._indices = {str(symbol): k for k, symbol in enumerate(explorer.scalars)}
        self.cases = [
            (explorer._formula("cases", condition), self._pieces(text)) for condition, text in cases
        ]

    def text(self, scalars):
        """Return the sentence for given values of the scalars."""
        pieces = next(pieces for condition, pieces in self.cases if condition(scalars))
        return "".join(
            piece if isinstance(piece, str) else short(scalars[piece]) for piece in pieces
        )

    def _pieces(self, text):
        pieces = NAME.split(text)
        for k in range(1, len(pieces), 2):
            if pieces[k] not in self._indices:
                raise ValueError(f"cases: {pieces[k]} is no scalar of the figure")
            pieces[k] = self._indices[pieces[k]]
        return [piece for piece in pieces if piece != ""]


def short(value):
    """Return a number in three digits.

    >>> short(-0.12345), short(12345.6), short(2.0)
    ('−0.123', '12300', '2')
    """
    if not abs(value) < float("inf"):
        return "∞" if value > 0 else "−∞" if value < 0 else "undefined"
    rounded = 0.0 if abs(value) < 5e-13 else float(f"{value:.3g}")
    plain = f"{rounded:.12f}".rstrip("0").rstrip(".")
    return plain.replace("-", "−")
