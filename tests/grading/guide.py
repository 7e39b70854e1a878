"""The commands of a guide, to be run as it shows them, and what it shows that they print."""

import re


def steps(text):
    """(section, command, lines it prints) for every command of the page."""
    found, section, inside = [], "", False
    for line in text.replace("\\\n", "").split("\n"):
        if line.startswith("#") and not inside:
            section = line.lstrip("# ")
        if line.startswith("```"):
            assert inside or line == "```console", f"{line}: shell commands stand in console blocks"
            inside = not inside
        elif inside and line.startswith("$ "):
            found.append((section, line[2:], []))
        elif inside:
            found[-1][2].append(line)
    return found


def like(shown, printed):
    """Whether what was printed is what the page shows; `...` stands for anything."""
    words = [" ".join(line.split()) for line in shown if line.strip()]
    pattern = "".join(
        ".*" if line == "..." else re.escape(line).replace(r"\.\.\.", ".*") + "\n" for line in words
    )
    text = (
        "\n".join(
            " ".join(line.split())
            for line in printed.replace("\ufeff", "").split("\n")
            if line.strip()
        )
        + "\n"
    )
    return re.fullmatch(pattern, text, re.DOTALL) is not None
