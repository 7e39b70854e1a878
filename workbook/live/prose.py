"""The book's Markdown for a notebook on a screen: references are named, not linked: nobody clicks
in a lecture."""


class _NoLinks:
    def place(self, label):
        return None


def prose(text, number=""):
    """MyST Markdown as any Jupyter shows it."""
    from workbook.authoring.student_notebook import plain_markdown

    return plain_markdown(text, _NoLinks(), number)[0]
