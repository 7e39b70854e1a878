"""Find the answers that the code of a master assigns by its syntax trees."""

import ast


def assigned_names(source, names):
    """Return those of `names` that a cell assigns at its top level, in order."""
    return [name for node in ast.parse(source).body for name in assigned_by(node, names)]


def assigned_by(statement, names):
    """Return those of `names` that an `ast` statement assigns, in order."""
    if isinstance(statement, ast.FunctionDef):
        return [statement.name] if statement.name in names else []
    targets = (
        statement.targets
        if isinstance(statement, ast.Assign)
        else [statement.target]
        if isinstance(statement, ast.AnnAssign)
        else []
    )
    parts = [
        part
        for target in targets
        for part in (target.elts if isinstance(target, (ast.Tuple, ast.List)) else [target])
    ]
    return [part.id for part in parts if isinstance(part, ast.Name) and part.id in names]
