"""A comma or a full stop stays with the formula before it when a browser breaks lines."""

import re

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform


class KeepWithFormula(SphinxPostTransform):
    """Joins an inline formula and the punctuation right after it into one unbreakable span."""

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
                # By identity: texts of the same words are equal, and the first would be replaced.
                k = next(k for k, node in enumerate(after.parent.children) if node is after)
                after.parent[k : k + 1] = [nodes.Text(rest)] if rest else []
                together = formula.deepcopy(), nodes.Text(signs[0])
                formula.replace_self(nodes.inline("", "", *together, classes=["unbroken"]))


def setup(app):
    app.add_post_transform(KeepWithFormula)
