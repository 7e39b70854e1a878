"""Interactive figures: their script and style are files that only pages with a figure load.

In a notebook each figure brings them along; in the site that would repeat them in every page.
"""

import re

ASSETS = re.compile(r'<(style|script) class="explorer-asset">.*?</\1>', re.DOTALL)


def _load_once(app, pagename, templatename, context, doctree):
    body, found = ASSETS.subn("", context.get("body", ""))
    if found:
        context["body"] = body
        app.add_css_file("explorer.css")
        app.add_js_file("explorer.js")


def setup(app):
    app.connect("html-page-context", _load_once)
