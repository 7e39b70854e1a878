"""Submissions that write outside, use the network, or leave something behind."""

import os

from hostile.attack import (
    RIGHT,
    WRONG,
    Attack,
    gained,
    harmed_others,
    heard,
    left_behind,
    marked,
    stopped_the_run,
    with_cells,
    write,
)

OUTSIDE = [
    Attack(
        "writes outside",
        "writes into the grader's folder",
        "the notebook runs with the lecturer's rights",
        "nothing has changed there",
        marked,
        ("open(HERE + '/marks/' + NAME, 'w').write('was here')", WRONG),
    ),
    Attack(
        "writes into the home",
        "adds a line to the shell's start-up file",
        "the home can be written",
        "there is no home",
        marked,
        (
            """
               import os
               for home in (HERE + "/home", os.path.expanduser("~")):
                   try:
                       open(home + "/.profile", "a").write("touch " + HERE + "/marks/'" + NAME + "'")
                   except OSError:
                       pass
               os.system("sh " + HERE + "/home/.profile")
               """,
            WRONG,
        ),
    ),
    Attack(
        "overwrites another's submission",
        "replaces the notebook of the next student",
        "submissions can be written",
        "the other keeps full marks",
        harmed_others,
        ("open(HERE + '/submitted/z-honest/hw/p15.ipynb', 'w').write('{}')", WRONG),
    ),
    Attack(
        "overwrites the library",
        "plants a module that replaces the workbook's checks for all who come later",
        "the folder of the grader's modules can be written",
        "all but /tmp is read-only",
        marked,
        (
            """
               import os, workbook
               # Unguarded, the true library is spared: the folder of marks stands for it.
               folder = HERE + "/marks" if os.path.exists(HERE) else os.path.dirname(workbook.__file__)
               open(folder + "/" + NAME, "w").write("def report(**given): pass")
               """,
            WRONG,
        ),
    ),
    Attack(
        "calls a server",
        "sends what it has found to an address on this machine",
        "the network is open",
        "there is no network",
        heard,
        (
            """
        import socket
        socket.create_connection(("127.0.0.1", PORT), timeout=2).sendall(b"found")
        """,
            WRONG,
        ),
    ),
    Attack(
        "calls by a local socket",
        "sends through a socket without a file name, which no folder confines",
        "such sockets are open to all",
        "they belong to another network",
        heard,
        (
            """
               import socket
               channel = socket.socket(socket.AF_UNIX)
               channel.connect("\\0" + TOKEN)
               channel.sendall(b"found")
               """,
            WRONG,
        ),
    ),
    Attack(
        "leaves a child behind",
        "starts a process that outlives the notebook",
        "nobody looks for it",
        "it has ended with the notebook",
        left_behind,
        (
            "import subprocess\nsubprocess.Popen(['/usr/bin/sleep', TOKEN.strip('t')], "
            "start_new_session=True)",
            WRONG,
        ),
    ),
    Attack(
        "leaves a daemon behind",
        "leaves a process, twice forked, that later writes its own marks",
        "the result file lies open",
        "it has ended with the notebook",
        gained,
        (
            """
               import os, time
               if os.fork() == 0:
                   if os.fork():
                       os._exit(0)
                   os.setsid()
                   give_up = time.time() + 3
                   while time.time() < give_up:
                       if os.path.exists(HERE + "/graded/" + NAME + ".json"):
                           time.sleep(0.1)
                           open(HERE + "/graded/" + NAME + ".json", "w").write('{"points": 1}')
                           break
                       time.sleep(0.001)
                   os._exit(0)
               """,
            WRONG,
        ),
        apart=True,
    ),
    Attack(
        "leaves a thread behind",
        "starts a thread that keeps replacing the check",
        "later students are marked in the same process",
        "every notebook has a process of its own",
        harmed_others,
        (
            """
               import threading, time, workbook.checks.stability.regions as regions
               from workbook.checks.contract.verdict import Wrong
               def refuse(*given, **more):
                   raise Wrong("not for you")
               def spoil():
                   give_up = time.time() + 15
                   while time.time() < give_up:
                       regions.compare_region = refuse
                       time.sleep(0.001)
               threading.Thread(target=spoil, daemon=True).start()
               """,
            WRONG,
        ),
    ),
    Attack(
        "is a link to another's work",
        "hands in a symbolic link to another's notebook",
        "links are followed",
        "links are named and left alone",
        gained,
        files=lambda folder: (folder / "p15.ipynb").symlink_to("../../a-honest/hw/p15.ipynb"),
    ),
    Attack(
        "is a link to a private file",
        "hands in a symbolic link to a notebook outside",
        "links are followed",
        "links are named and left alone",
        gained,
        files=lambda folder: _link_to_outside(folder),
    ),
    Attack(
        "is a folder",
        "hands in a folder by the name of a notebook",
        "opening it fails, and the run with it",
        "it is said to be no file",
        stopped_the_run,
        files=lambda folder: (folder / "p15.ipynb").mkdir(),
    ),
    Attack(
        "is a pipe",
        "hands in a named pipe, which nobody ever writes to",
        "reading it never ends",
        "it is said to be no file",
        stopped_the_run,
        files=lambda folder: os.mkfifo(folder / "p15.ipynb"),
        patience=2,
    ),
]


def _link_to_outside(folder):
    outside = folder.parents[2] / "home" / "right.ipynb"
    write(outside, with_cells([f"a_region = {RIGHT}"]))
    (folder / "p15.ipynb").symlink_to(outside)
