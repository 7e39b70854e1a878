"""Formulas typeset in what cells print; lines and columns stay as they are."""

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


def setup(app):
    app.add_post_transform(TypesetPrinted)
