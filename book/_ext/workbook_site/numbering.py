"""Numbers follow labels.

An equation labelled eq-1-15-a is (1.15a), a theorem labelled thm-1-2 is Theorem 1.2: on every page,
in references, in the student's notebook, and in the problem book where the number comes from. All
else is counted as usual. A number given by TeX's own \\tag is placed as all others are. A chapter's
number is that of its file, book/ch5.md, whichever chapters come before it.
"""

import re
from copy import deepcopy

from docutils import nodes

EQUATION = re.compile(r"eq-(\d+)-([\w-]+)")
TAG = re.compile(r"\\tag\{([^{}]*)\}")
STATEMENT = re.compile(r"[a-z]+-(\d+)-(\d+)")
CHAPTER = re.compile(r"book/ch(\d+)")


def _number_equations(app, document):
    equations = app.env.get_domain("math").equations
    for node in document.findall(nodes.math_block):
        match = EQUATION.fullmatch(node.get("label") or "")
        if match:
            node["number"] = f"{match[1]}.{match[2].replace('-', '')}"
            equations[node["label"]] = node["docname"], node["number"]
        tags = TAG.findall(node.astext())
        if len(tags) == 1 and not node["nowrap"]:
            # Sphinx puts a formula of several lines into an environment where \tag is not allowed.
            node["number"] = tags[0]
            node.children = [nodes.Text(TAG.sub("", node.astext()))]


def _label_statements(app, document):
    """Let [text](#thm-1-2) and {ref} find theorems, which have a domain of their own."""
    labels = app.env.get_domain("std")
    for node in document.findall(nodes.Admonition):
        if "realtype" in node:
            match = STATEMENT.fullmatch(node["label"])
            name = (
                f"{node['realtype'].capitalize()} {match[1]}.{match[2]}"
                if match
                else node["realtype"]
            )
            labels.note_hyperlink_target(node["label"], app.env.docname, node["label"], name)


def _number_statements(app, env):
    """Replace the numbers that Sphinx has counted by those of the labels."""
    env.workbook_counted = deepcopy(env.toc_fignumbers)
    for label, entry in getattr(env, "proof_list", {}).items():
        match = STATEMENT.fullmatch(label)
        counted = env.toc_fignumbers.get(entry["docname"], {}).get(entry["countertype"], {})
        if match and label in counted:
            counted[label] = int(match[1]), int(match[2])
    return []


def _number_chapters(app, env):
    """Replace the numbers that Sphinx has counted by those of the files."""
    env.workbook_counted_chapters = deepcopy(env.toc_secnumbers)
    for page in list(env.toc_secnumbers):
        if match := CHAPTER.fullmatch(page):
            chapter = int(match[1])
            numbers = env.toc_secnumbers[page]
            env.toc_secnumbers[page] = {
                anchor: (chapter, *number[1:]) if number else number
                for anchor, number in numbers.items()
            }
            for node in (env.titles[page], *env.tocs[page].findall(nodes.reference)):
                if node.get("secnumber"):
                    node["secnumber"] = [chapter, *node["secnumber"][1:]]
    return []


def _restore_counts(app, env, added, changed, removed):
    # Sphinx compares its counts with those of the last build, and writes every page whose numbers
    # differ.
    env.toc_fignumbers = getattr(env, "workbook_counted", env.toc_fignumbers)
    env.toc_secnumbers = getattr(env, "workbook_counted_chapters", env.toc_secnumbers)
    return []


def setup(app):
    app.connect("doctree-read", _number_equations)
    app.connect("doctree-read", _label_statements)
    app.connect("env-get-outdated", _restore_counts)
    app.connect("env-get-updated", _number_statements, priority=900)
    app.connect("env-get-updated", _number_chapters, priority=900)
