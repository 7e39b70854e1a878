"""Make notebooks and their cells as dicts in nbformat 4.5."""


def new_code_cell(source, **metadata):
    """Return a code cell that has not run."""
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": "",
        "metadata": metadata,
        "outputs": [],
        "source": source,
    }


def new_markdown_cell(source, attachments=None, **metadata):
    """Return a Markdown cell; `attachments` maps file names to {MIME type: base64 text}."""
    cell = {"cell_type": "markdown", "id": "", "metadata": metadata}
    if attachments:
        cell["attachments"] = attachments
    return cell | {"source": source}


def new_notebook(cells, **metadata):
    """Return a notebook of cells, which get the ids cell-00, cell-01, ..."""
    for k, cell in enumerate(cells):
        cell["id"] = f"cell-{k:02d}"
    return {
        "cells": cells,
        "metadata": {
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
            **metadata,
        },
        "nbformat": 4,
        "nbformat_minor": 5,
    }
