"""Formulas in outputs: what cells print is typeset, lines and columns stay; fractions are of full size."""

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform

from trajlib.typesetting import TYPEWRITTEN, typeset


class TypesetPrinted(SphinxPostTransform):
    """Typesets printed formulas, after myst-nb has chosen the outputs to show."""

    default_priority = 150
    formats = ("html",)

    def run(self, **kwargs):
        for printed in list(self.document.findall(nodes.literal_block)):
            kinds = {"output", "stream"}, {"output", "text_plain"}
            if any(kind <= set(printed["classes"]) for kind in kinds) and TYPEWRITTEN.search(
                printed.astext()
            ):
                classes = " ".join(printed["classes"])
                printed.replace_self(
                    nodes.raw(
                        "",
                        f'<div class="{classes}"><pre>{typeset(printed.astext())}</pre></div>',
                        format="html",
                    )
                )


class FullSizeFractions(SphinxPostTransform):
    """Shows fractions in the lines of outputs as large as in formulas of their own."""

    default_priority = 150
    formats = ("html",)

    def run(self, **kwargs):
        for output in self.document.findall(nodes.container):
            if "cell_output" in output["classes"]:
                for formula in output.findall(nodes.math):
                    if r"\frac" in formula.astext():
                        text = nodes.Text(rf"\displaystyle {formula.astext()}")
                        formula.children = [text]


def setup(app):
    app.add_post_transform(FullSizeFractions)
    app.add_post_transform(TypesetPrinted)
