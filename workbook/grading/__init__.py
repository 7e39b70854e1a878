"""Grade a course's homework: run notebooks in a sandbox, judge their answers elsewhere.

The trust boundary: `isolation` and `notebook_worker` run what students wrote, and only bytes leave
the sandbox; `judging` decodes their answers in another process and runs nothing of a student's. The
contributor's guide has a picture of all processes.
"""
