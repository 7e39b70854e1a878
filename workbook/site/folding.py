"""Statements, and folded solutions, hints and code.

A fold is the browser's own <details>: it opens without scripts, by keyboard, in print, and when a
search or a link leads into it.
"""

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx_exercise.nodes import exercise_node, solution_node
from sphinx_proof.nodes import unenumerable_node

from workbook.authoring.contract import item_of
from workbook.checks.contract.check_cells import reported_names

#: The code of these cells is folded, their outputs stay; the other roles (data, check) are shown
#: whole.
FOLDED_CODE = {
    "answer": "computation",
    "figure": "code of the figure",
    "drawing": "code of the drawing",
}


class details(nodes.General, nodes.Element):
    pass


class summary(nodes.General, nodes.TextElement):
    pass


class UniqueIds(SphinxPostTransform):
    """Removes the ids that sphinx-exercise and sphinx-proof give to every box of a kind."""

    default_priority = 10
    formats = ("html",)
    shared = {"exercise-content", "solution-content", "proof-content", "proof"}

    def run(self, **kwargs):
        for box in self.document.findall(
            lambda node: isinstance(node, (nodes.section, nodes.admonition))
        ):
            box["ids"] = [name for name in box["ids"] if name not in self.shared]
        for box in self.document.findall(unenumerable_node):
            # Its title repeats its id, which tells the writer where the word "Theorem" stands.
            box[0]["ids"] = []
            box[0].insert(
                0, nodes.inline("", box["realtype"].capitalize(), classes=["caption-number"])
            )


class FoldSolutions(SphinxPostTransform):
    """Folds solutions and gives short titles: the page's own title already names the problem."""

    default_priority = 30  # after sphinx-exercise has resolved its titles (20 to 22)
    formats = ("html",)

    def run(self, **kwargs):
        for exercise in self.document.findall(exercise_node):
            exercise[0].children = [nodes.Text("Problem")]
        solutions = [
            node for node in self.document.findall(solution_node) if "dropdown" in node["classes"]
        ]
        for solution in solutions:
            # a single solution is that of the whole problem
            item = self._item(solution) if len(solutions) > 1 else ""
            title = "Worked solution" + (f", item {item})" if item else "")
            # A link to an element inside a fold opens it, a link to the fold itself does not.
            solution[1]["ids"], solution["ids"] = solution["ids"], []
            fold = details("", summary("", title), classes=["solution"], items=item)
            fold += solution.children[1:]
            solution.replace_self(fold)

    def _item(self, solution):
        """Return the letters of the items that a solution is of: sol-1-15-a, sol-1-15-ab."""
        last = solution["label"].rpartition("-")[2]
        return last if last.isalpha() else ""


def solution_of(name, nodes_before):
    """Return the fold with the worked solution of an answer, or else the last one; None without any."""
    folds = [n for n in nodes_before if isinstance(n, details) and "solution" in n["classes"]]
    item = item_of(name)
    return next((fold for fold in folds if item and item in fold["items"]), (folds or [None])[-1])


class FoldChecks(SphinxPostTransform):
    """Moves the check of a worked solution into its fold: its verdict is not the reader's."""

    default_priority = 197  # after the boxes, whose place depends on it, are there (195)
    formats = ("html",)

    def run(self, **kwargs):
        order = list(self.document.findall(nodes.Element))
        for k, cell in enumerate(order):
            if "tag_check" in cell["classes"] and cell.get("nb_element") == "cell_code":
                (name, *_) = reported_names(next(cell.findall(nodes.literal_block)).astext())
                if fold := solution_of(name, order[:k]):
                    cell.parent.remove(cell)
                    fold += cell


class FoldCode(SphinxPostTransform):
    """Folds the code of the answer, figure and drawing cells by their role.

    It does what the tag `hide-input` of myst-nb does. Adding that tag would repeat the role in the
    master and invalidate the cached outputs, which are found by a cell's text and tags.
    """

    default_priority = 190  # before myst-nb folds (199)
    formats = ("html",)

    def run(self, **kwargs):
        if self.env.docname.startswith("exercises/"):
            return  # the student's answer cells are stubs to be read
        for cell in self.document.findall(nodes.container):
            for role, name in FOLDED_CODE.items():
                if cell.get("nb_element") == "cell_code" and f"tag_{role}" in cell["classes"]:
                    cell.update_all_atts(
                        {
                            "hide_mode": "input",
                            "prompt_show": f"Show the {name}",
                            "prompt_hide": f"Hide the {name}",
                        },
                        replace=True,
                    )


def _open_statement(self, node):
    self.body.append(self.starttag(node, "div", CLASS="admonition"))


def _close_statement(self, node):
    self.body.append("</div>\n")


def _open_details(self, node):
    self.body.append(self.starttag(node, "details"))


def _close_details(self, node):
    self.body.append("</details>\n")


def _open_summary(self, node):
    self.body.append(self.starttag(node, "summary", suffix=""))


def _close_summary(self, node):
    self.body.append("</summary>\n")


def setup(app):
    app.add_node(unenumerable_node, override=True, html=(_open_statement, _close_statement))
    app.add_node(details, html=(_open_details, _close_details))
    app.add_node(summary, html=(_open_summary, _close_summary))
    app.add_post_transform(UniqueIds)
    app.add_post_transform(FoldSolutions)
    app.add_post_transform(FoldCode)
    app.add_post_transform(FoldChecks)
