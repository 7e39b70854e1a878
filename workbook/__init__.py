"""The course around `trajlib`: checks of answers, notebooks, grading, authoring and lectures; the
command `workbook`."""
