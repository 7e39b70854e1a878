"""What the code of a master assigns."""

import ast


def assigned_names(source, names):
    """Which of `names` a cell assigns at its top level, in order."""
    return [name for node in ast.parse(source).body for name in assigned_by(node, names)]


def assigned_by(statement, names):
    """Which of `names` a statement of `ast` assigns, in order."""
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
