"""Right sides of worked answers, and all texts of a built site in which they could stand."""

import ast
import gzip
import html
import io
import re
import tarfile
import zipfile

#: Shorter right sides stand everywhere.
SHORTEST = 14
#: Right sides that the student edition may hold, and why.
ALLOWED = {
    "structure.controllability_matrix(A,b)": "a call without the matrices, not a result",
    "sp.Integer(-1)": "a number as the library's own code writes it",
    "sp.Matrix([[1,-2]])": "an input matrix in other numbers of 3.25",
    "-x2*sp.Abs(x2)/2": "the switching curve of the double integrator, of the theory of section 5.3",
    "sp.Matrix([[1,1],[1,-1]])": "the data of problem 2.1, and a matrix of an example of the library",
    "sp.Matrix([[0,1,1],[1,1,0],[0,-1,1]])": "the problem book prints worked example 6 as 2.30 k, too",
}
TEXTS = {
    ".css",
    ".html",
    ".inv",
    ".ipynb",
    ".js",
    ".json",
    ".md",
    ".py",
    ".svg",
    ".toml",
    ".txt",
    "",
}


def worked_answers(masters):
    """Return {right side without spaces: numbers of its problems}, also with & and | for And and Or."""
    found = {}
    for master in masters:
        for source in master.code("answer"):
            for node in ast.walk(ast.parse(source)):
                if (
                    isinstance(node, ast.Assign)
                    and isinstance(node.targets[0], ast.Name)
                    and node.targets[0].id in master.answers
                    and not isinstance(node.value, ast.Constant)  # a word that is offered
                ):
                    for text in (ast.get_source_segment(source, node.value), _infix(node.value)):
                        found.setdefault(plain(text), set()).add(master.number)
    return {text: numbers for text, numbers in found.items() if len(text) >= SHORTEST}


def _infix(node):
    """Return a condition with & and | in place of sp.And and sp.Or."""
    sign = {"sp.And": "&", "sp.Or": "|"}.get(isinstance(node, ast.Call) and ast.unparse(node.func))
    return sign.join(f"({_infix(part)})" for part in node.args) if sign else ast.unparse(node)


def plain(text):
    """Return a text without spaces, without bars of quotations and with one kind of quotation marks."""
    return re.sub(r"\s+", "", text).replace("'", '"')


def texts_below(folder):
    """Yield (name, text) of each text below a folder, also those in archives, wheels and packed files."""
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield from _texts(path.relative_to(folder).as_posix(), path.read_bytes())


def _texts(name, data):
    if data[:4] == b"PK\3\4":  # zipfile.is_zipfile also takes what ends in an archive
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for member in archive.namelist():
                yield from _texts(f"{name}/{member}", archive.read(member))
    elif data[:2] == b"\x1f\x8b":
        yield from _texts(name, gzip.decompress(data))
    elif data[257:262] == b"ustar":
        with tarfile.open(fileobj=io.BytesIO(data)) as archive:
            for member in filter(tarfile.TarInfo.isfile, archive):
                yield from _texts(f"{name}/{member.name}", archive.extractfile(member).read())
    elif data.startswith(b"workbookEngineData("):
        return  # the packed files once more, in parts, for pages opened as files
    elif "." + name.rpartition("/")[2].rpartition(".")[2] in TEXTS or name.endswith("METADATA"):
        text = data.decode("utf-8", "replace")
        if name.endswith((".html", ".svg")):
            text = html.unescape(re.sub(r"<[^>]*>", "", text))
        elif name.endswith((".ipynb", ".json", ".js")):
            text = _unescaped(text)
        yield name, plain(text)


def _unescaped(text):
    """Return a text with the line breaks and quotation marks of its JSON strings as they read."""
    return text.replace("\\n", "\n").replace('\\"', '"').replace("\\\\", "\\")


def given_away(texts, answers):
    """Return [(file, right side, problems)] of the right sides that stand in texts."""
    return [
        (name, answer, sorted(numbers))
        for name, text in texts
        for answer, numbers in answers.items()
        if answer in text and answer not in ALLOWED
    ]
