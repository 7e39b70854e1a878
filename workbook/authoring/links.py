"""Addresses of the book's labels on the site, for links from the student notebooks."""

import re
from pathlib import Path

LABEL = re.compile(r"^\s*:label:\s*(\S+)\s*$|^\(([\w-]+)\)=\s*$", re.M)


class Links:
    """Addresses of the labels of the book, below the site's root: "book/ch1/hurwitz.html#thm-1-2".

    Parameters
    ----------
    root : path_like
        The checkout.
    base : str
        Address of the site (`html.baseurl` of _config.yml), "" where there is none.
    """

    def __init__(self, root, base=""):
        self.root, self.base = Path(root), base
        self.pages = {}
        for folder in ("book", "solutions"):
            for page in sorted(self.root.glob(f"{folder}/**/*.md")):
                for match in LABEL.finditer(page.read_text(encoding="utf-8")):
                    self.pages[match[1] or match[2]] = (
                        page.relative_to(self.root).with_suffix(".html").as_posix()
                    )

    def url(self, label):
        """Return the address of a label, or None for an unknown label."""
        page = self.pages.get(label)
        return None if page is None else f"{page}#{label}"
