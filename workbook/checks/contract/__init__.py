"""What a check is: verdicts, reports, how answers are read, and how they cross to a grader."""
