"""Where a label of the book stands, so that the student's copy can link to the site."""

import os
import re
from pathlib import Path

LABEL = re.compile(r"^\s*:label:\s*(\S+)\s*$|^\(([\w-]+)\)=\s*$", re.M)


class Links:
    """Addresses of the site's pages, seen from a file of the checkout.

    `base` is the site's address (`html.baseurl` of _config.yml). While it is empty the links are relative and lead to
    the site that `make book` builds in the same checkout.
    """

    def __init__(self, root, base=""):
        self.root, self.base = Path(root), base.rstrip("/")
        self.pages = {}
        for folder in ("book", "solutions"):
            for page in sorted(self.root.glob(f"{folder}/**/*.md")):
                for match in LABEL.finditer(page.read_text(encoding="utf-8")):
                    self.pages[match[1] or match[2]] = page.relative_to(self.root).with_suffix("")

    def to_label(self, label, source):
        """The address of a label for a link in the file `source`, or None for an unknown label."""
        page = self.pages.get(label)
        return None if page is None else f"{self.to_page(page, source)}#{label}"

    def to_page(self, page, source):
        """The address of a page such as book/ch1 for a link in the file `source`."""
        if self.base:
            return f"{self.base}/{Path(page).as_posix()}.html"
        built = self.root / "_build" / "html" / f"{page}.html"
        return Path(os.path.relpath(built, Path(source).parent)).as_posix()
