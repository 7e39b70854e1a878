"""The course on top of `trajlib`: checks of answers, notebooks, grading, authoring and lectures.

The command is `workbook` (`workbook.cli`).
"""
