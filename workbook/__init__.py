"""The course on top of `trajlib`: checks, notebooks, grading, authoring and lectures.

The command is `workbook` (`workbook.cli`).
"""
