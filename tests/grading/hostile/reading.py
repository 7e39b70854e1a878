"""Submissions that read what is secret."""

from hostile.attack import Attack, gained, leaked

READING = [
    Attack(
        "reads the solution",
        "opens the solution file beside the course",
        "the file is there to be opened",
        "no such file is in sight",
        gained,
        ("exec(open(HERE + '/solutions/p15.py').read())",),
    ),
    Attack(
        "reads the master",
        "looks for the worked solution in the checkout that workbook was loaded from",
        "an installation by `pip install -e` leads straight to solutions/",
        "the folders of trajlib and workbook stand there alone",
        gained,
        (
            """
               import re, pathlib, workbook
               text = (pathlib.Path(workbook.__file__).parents[1] / "solutions/ch1/p15.md").read_text()
               a_region = eval(re.search("^a_region = (.*)$", text, re.M)[1])
               """,
        ),
    ),
    Attack(
        "searches the disk",
        "walks through every folder for a file that assigns the answer",
        "it finds the solution",
        "it finds neither notebooks nor solutions",
        gained,
        blame="",
        cells=(
            """
               import os, re
               def search():
                   outside = [name for name in os.listdir("/") if name not in ("proc", "sys", "usr")]
                   for top in [HERE, *(os.path.join("/", name) for name in outside)]:
                       for folder, folders, files in os.walk(top):
                           for name in files:
                               if name.endswith((".md", ".ipynb")) or name == "p15.py":
                                   text = open(os.path.join(folder, name), errors="replace").read(500_000)
                                   if (found := re.search(r"a_region = (sp[.]And.*)", text)):
                                       return eval(found[1])
                   return ...
               a_region = search()
               """,
        ),
    ),
    Attack(
        "reads another's submission",
        "opens the notebook of the student before",
        "all submissions lie in one readable folder",
        "no submission but its own exists for it",
        gained,
        (
            """
               import json
               for cell in json.load(open(HERE + "/submitted/a-honest/hw/p15.ipynb"))["cells"]:
                   if "a_region = sp" in "".join(cell["source"]):
                       exec("".join(cell["source"]))
               """,
        ),
    ),
    Attack(
        "finds another's work among objects",
        "looks through all objects of the process for another's source",
        "a process that has run other notebooks still holds their sources",
        "the process has never held anybody else's",
        gained,
        blame="",
        cells=(
            """
               import gc, re
               lists = [owner for owner in gc.get_objects() if type(owner) is list]
               for one in [value for owner in lists for value in owner if type(value) is str]:
                   if (found := re.search(r"^a_region = (sp[.]And.k1 > 0, k1[*]k2 > 1.)$", one, re.M)):
                       a_region = eval(found[1])
               """,
        ),
    ),
    Attack(
        "finds another's work in raw memory",
        "looks through the memory of the process, also what was given back, for another's source",
        "a process that has run other notebooks still holds their sources",
        "the process has never held anybody else's",
        gained,
        blame="",
        cells=(
            r"""
               import ctypes, os, re
               # The kernel refuses to write from an address that is not there, which makes looking safe.
               libc, (out, into) = ctypes.CDLL(None), os.pipe()
               libc.sbrk.restype, libc.sbrk.argtypes = ctypes.c_void_p, [ctypes.c_long]
               libc.write.argtypes = [ctypes.c_int, ctypes.c_void_p, ctypes.c_size_t]
               top, small = libc.sbrk(0), id("a" * 9)
               for start, stop in [(top - 2**28, top), (small - 2**26, small + 2**26)]:
                   for address in range(start & ~4095, stop, 4096):
                       if libc.write(into, address, 4096) == 4096:
                           found = re.search(rb"a_region = (sp[.]And\(k1 > 0, k1[*]k2 > 1\))", os.read(out, 4096))
                           if found:
                               a_region = eval(found[1])
               """,
        ),
    ),
    Attack(
        "reads the environment",
        "reads every variable",
        "the grader's environment is inherited",
        "only six harmless variables are set",
        leaked,
        ("import os\na_region = str(dict(os.environ))[-15000:]",),
    ),
    Attack(
        "reads the environment in /proc",
        "reads the variables of the grader's processes",
        "/proc shows them to the same user",
        "there is no /proc",
        leaked,
        (
            """
               import glob
               a_region = ""
               for path in glob.glob("/proc/[0-9]*/environ"):
                   try:
                       text = open(path, errors="replace").read()
                   except OSError:
                       continue
                   if HERE in text:
                       a_region = text[text.find("COURSE_SECRET"):][:100].split("\\0")[0]
               """,
        ),
    ),
    Attack(
        "reads the home",
        "reads a file in the home folder, by variable and by name",
        "the notebook runs as the lecturer",
        "there is no home but an empty /tmp",
        leaked,
        blame="",
        cells=(
            """
               import os
               for folder in (os.path.expanduser("~"), HERE + "/home"):
                   try:
                       a_region = open(folder + "/private.txt").read()
                   except OSError:
                       pass
               """,
        ),
    ),
    Attack(
        "reads open files",
        "tries every descriptor number for something the grader has open",
        "descriptors are inherited",
        "only the pipe for its own answers is open",
        leaked,
        (
            """
               import os
               found = b""
               for number in range(3, 200):
                   try:
                       found += os.pread(number, 1000, 0)
                   except OSError:
                       pass
               a_region = found.decode(errors="replace")[:15000]
               """,
        ),
    ),
]
