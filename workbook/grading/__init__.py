"""Grade a course's homework: student notebooks run in a sandbox, answers leave it as bytes, a
separate process judges.

The trust boundary: `isolation` and `worker` run what students wrote; `judging` decodes their
answers and runs nothing of theirs.
"""
