"""Where a label of the book stands, so that the student's copy can link to the site."""

import re
from pathlib import Path

LABEL = re.compile(r"^\s*:label:\s*(\S+)\s*$|^\(([\w-]+)\)=\s*$", re.M)


class Links:
    """Places of the book by their labels, as the site addresses them below its root:
    "book/ch1.html#thm-1-2".

    `base` is the site's address (`html.baseurl` of _config.yml), empty where there is none.
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

    def place(self, label):
        """The place of a label, or None for an unknown label."""
        page = self.pages.get(label)
        return None if page is None else f"{page}#{label}"
