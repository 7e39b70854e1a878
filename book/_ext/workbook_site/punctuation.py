"""A comma or a full stop stays with the formula before it: the browser may break a line between
them otherwise."""

import re

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform


class KeepWithFormula(SphinxPostTransform):
    """Puts an inline formula and the signs that follow it without a space into one span that does
    not break."""

    default_priority = 800
    formats = ("html",)

    def run(self, **kwargs):
        for formula in list(self.document.findall(nodes.math)):
            after = formula.next_node(descend=False, siblings=True)
            signs = (
                re.match(r"[.,;:!?)\]-]+", after.astext())
                if isinstance(after, nodes.Text)
                else None
            )
            if signs:
                rest = after.astext()[signs.end() :]
                # By identity: a text is equal to any other of the same words, and the first would
                # be replaced.
                k = next(k for k, node in enumerate(after.parent.children) if node is after)
                after.parent[k : k + 1] = [nodes.Text(rest)] if rest else []
                together = formula.deepcopy(), nodes.Text(signs[0])
                formula.replace_self(nodes.inline("", "", *together, classes=["unbroken"]))


def setup(app):
    app.add_post_transform(KeepWithFormula)
