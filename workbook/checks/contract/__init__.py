"""Contract of checks: verdicts, reports, reading of answers and their encoding for a grader."""
