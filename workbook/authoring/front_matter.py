"""Read the front matter of a master, with the line numbers of its parts."""

import yaml

from workbook.authoring.errors import MasterError


def read_front_matter(path, text):
    """Return what stands under `problem:` and the line numbers of its parts.

    Parameters
    ----------
    path : pathlib.Path
        File of the master, for messages.
    text : str
        Its content.

    Returns
    -------
    front : dict
        What stands under `problem:`.
    lines : dict
        Line numbers by paths of keys, such as ("answers", "a_region"); () for `problem:`.

    Raises
    ------
    MasterError
        For malformed YAML, a key that stands twice, or no `problem:`.
    """
    opened, _, after_opening = text.partition("---\n")
    head, closed, _ = after_opening.partition("\n---\n")
    if opened or not closed:
        raise MasterError(path, 1, "a master opens with its front matter between two lines ---")
    try:
        loader = yaml.SafeLoader(head)
        node = loader.get_single_node()
        document = loader.construct_document(node) if node is not None else None
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 2
        raise MasterError(
            path, line, f"the front matter is not YAML here: {error.problem}"
        ) from None
    except yaml.YAMLError as error:
        raise MasterError(
            path, 1, f"the front matter is not YAML: {str(error).splitlines()[0]}"
        ) from None
    lines = _lines(path, node)
    if ("problem",) not in lines:
        raise MasterError(path, 1, "the front matter needs problem:")
    return document["problem"], {
        keys[1:]: line for keys, line in lines.items() if keys[0] == "problem"
    }


def _lines(path, node, parent_keys=()):
    """Return {path of keys: line of the file} for a mapping and those in it."""
    lines = {}
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        keys = (*parent_keys, key.value)
        if keys in lines:
            raise MasterError(
                path, key.start_mark.line + 2, f"{key.value} stands twice in the front matter"
            )
        lines |= {keys: key.start_mark.line + 2} | _lines(path, value, keys)
    return lines
