# Written by `python -m workbook._stubs`.
from workbook.display.animations import Animation as Animation
from workbook.display.drawings import Drawing as Drawing
from workbook.display.explorer.declaration import Explorer as Explorer
from workbook.display.results import show as show
from workbook.display.results import table as table
from workbook.display.sheet import Sheet as Sheet
from workbook.display.sheet import along as along
