"""The HTML of an `Explorer`: its declaration as data, its static picture, its script and style."""

import base64
import io
import json
from functools import cache
from html import escape
from pathlib import Path

__all__ = ["asset", "data", "html"]


@cache
def asset(name):
    """Return the text of explorer.js or explorer.css."""
    return (Path(__file__).parent / "static" / name).read_text(encoding="utf-8")


def html(explorer):
    """Return the figure as HTML that needs nothing else.

    The site takes the script and the style out again and loads them as files, once a page.
    """
    declaration = json.dumps(data(explorer), separators=(",", ":"), ensure_ascii=False)
    picture = base64.b64encode(_picture(explorer)).decode()
    return (
        f'<div class="explorer" data-explorer="{escape(declaration)}">'
        f'<p class="explorer-question">{escape(explorer.question)}</p>'
        f'<img class="explorer-still" alt="{escape(explorer.description)}" '
        f'src="data:image/svg+xml;base64,{picture}">'
        f'</div><style class="explorer-asset">{asset("explorer.css")}</style>'
        f'<script class="explorer-asset">{asset("explorer.js")}</script>'
    )


def data(explorer):
    """Return the declaration as lists, dictionaries, numbers and JavaScript expressions."""
    order = {str(parameter.symbol): k for k, parameter in enumerate(explorer.parameters)}
    dragged = explorer._dragged()

    def uses(inputs):
        return sorted(order[name] for name in inputs)

    def written(formulas):
        return {
            role: "[" + ", ".join(formula.javascript for formula in role_formulas) + "]"
            for role, role_formulas in formulas.items()
        }

    def part(drawn):
        moved = [None if name is None else order[name] for name in drawn.dragged]
        more = {"series": drawn.series} if drawn.series is not None else {}
        more |= {"moved": moved} if any(k is not None for k in moved) else {}
        common = {"kind": drawn.kind, "style": drawn.style, "label": drawn.label}
        return common | {"uses": uses(drawn.inputs)} | written(drawn.formulas) | more

    return {
        "description": explorer.description,
        "parameters": [
            {
                "name": str(parameter.symbol),
                "label": parameter.label,
                "value": parameter.value,
                "limits": parameter.limits,
                "step": parameter.step,
                "play": parameter.play,
                "slider": str(parameter.symbol) not in dragged,
            }
            for parameter in explorer.parameters
        ],
        "steps": [
            {"kind": step.kind, "uses": uses(step.inputs)}
            | written(step.formulas)
            | _plain(step.constants)
            for step in explorer.steps
        ],
        "panels": [
            {
                "names": panel.names,
                "x": panel.x_range,
                "y": panel.y_range,
                "height": panel.height,
                "below": panel.below,
                "parts": [part(one) for one in panel.parts],
            }
            for panel in explorer.panels
        ],
        "sentences": [
            [[condition.javascript, pieces] for condition, pieces in sentence.cases]
            for sentence in explorer.sentences
        ],
    }


def _plain(constants):
    if "data" not in constants:
        return constants
    columns = [[float(f"{value:.12g}") for value in column] for column in constants["data"]]
    return constants | {"data": columns}


def _picture(explorer):
    import matplotlib

    file = io.BytesIO()
    # reproducible bytes
    with matplotlib.rc_context({"svg.hashsalt": "workbook"}):
        explorer.plot().savefig(file, format="svg", metadata={"Date": None, "Creator": None})
    return file.getvalue()
