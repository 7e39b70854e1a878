"""Ways through the course, week by week, and the map of its sections.

All of it is in one file, `book/routes.toml`, which the site, the commands and the wheel share.
`course` reads it, `spacing` chooses the questions of each week's self-test, `calendar` gives dates.
"""
