"""The front matter of a master: what it says under `problem:`, and on which line of the file each
part stands."""

import yaml

from workbook.authoring.errors import MasterError


def read_front_matter(path, text):
    """What stands under `problem:`, and {("answers", "a_region"): its line, ...} with the line of
    `problem:` under ().

    Raises `MasterError` with the line of a slip in the YAML, also of a name that is written twice.
    """
    opened, _, rest = text.partition("---\n")
    head, closed, _ = rest.partition("\n---\n")
    if opened or not closed:
        raise MasterError(path, 1, "a master opens with its front matter between two lines ---")
    try:
        loader = yaml.SafeLoader(head)
        node = loader.get_single_node()
        said = loader.construct_document(node) if node is not None else None
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
    return said["problem"], {
        place[1:]: line for place, line in lines.items() if place[0] == "problem"
    }


def _lines(path, node, above=()):
    """{path of keys: line of the file} for all keys of a mapping and of those in it."""
    lines = {}
    for key, value in node.value if isinstance(node, yaml.MappingNode) else ():
        place = (*above, key.value)
        if place in lines:
            raise MasterError(
                path, key.start_mark.line + 2, f"{key.value} stands twice in the front matter"
            )
        lines |= {place: key.start_mark.line + 2} | _lines(path, value, place)
    return lines
