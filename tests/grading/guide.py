"""The commands of a guide and the output that it shows, to be run and compared."""

import re


def steps(text):
    """Return (section, command, lines that it prints) for every command of the page.

    Blocks of TOML are pieces of files, which other tests read.
    """
    text = re.sub(r"^```toml\n.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    commands, section, inside = [], "", False
    for line in text.replace("\\\n", "").split("\n"):
        if line.startswith("#") and not inside:
            section = line.lstrip("# ")
        if line.startswith("```"):
            assert inside or line == "```console", f"{line}: shell commands stand in console blocks"
            inside = not inside
        elif inside and line.startswith("$ "):
            commands.append((section, line[2:], []))
        elif inside:
            commands[-1][2].append(line)
    return commands


def like(shown, printed):
    """Return whether output is as the page shows it; `...` stands for anything."""
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
