"""Submissions that exhaust processes, memory, disk, time or output.

What would endanger the machine is shown unguarded in a bounded form: as many processes and as many
megabytes as our limits in these tests forbid.
"""

from hostile.attack import WRONG, Attack, flooded, reached, stopped_the_run

MEGABYTES = 700  # above the 512 that these tests allow a notebook

RESOURCES = [
    Attack(
        "forks without end",
        "starts processes, here up to 60",
        "nothing counts them",
        "it gets no more than its limit, and all end with it",
        reached(60),
        (
            """
               import os, time
               started = 0
               try:
                   for _ in range(60):
                       if os.fork() == 0:
                           time.sleep(2)
                           os._exit(0)
                       started += 1
               except OSError:
                   pass
               a_region = started
               """,
        ),
    ),
    Attack(
        "starts threads without end",
        "starts threads, here up to 200",
        "nothing counts them",
        "it gets no more than its limit",
        reached(200),
        (
            """
               import threading, time
               started = 0
               try:
                   for _ in range(200):
                       threading.Thread(target=time.sleep, args=(0.5,), daemon=True).start()
                       started += 1
               except RuntimeError:
                   pass
               a_region = started
               """,
        ),
    ),
    Attack(
        "takes memory",
        "fills memory in one process",
        "nothing limits it",
        "it meets MemoryError",
        reached(MEGABYTES),
        (f"block = bytearray({MEGABYTES} * 2**20)\na_region = len(block) // 2**20",),
    ),
    Attack(
        "takes memory by many",
        "fills memory in several processes, each below a limit of its own",
        "limits of the kernel bind one process each",
        "the sum is watched",
        reached(MEGABYTES),
        (
            f"""
               import os, time
               out, into = os.pipe()
               for _ in range(7):
                   if os.fork() == 0:
                       block = bytearray({MEGABYTES} // 7 * 2**20)
                       time.sleep(0.5)
                       os.write(into, b"x")
                       time.sleep(0.2)
                       os._exit(0)
               count = sum(len(os.read(out, 1)) for _ in range(7))
               a_region = count * ({MEGABYTES} // 7)
               """,
        ),
        blame="limits",
    ),
    Attack(
        "takes memory of no process",
        "fills files that exist only in memory and belong to nobody",
        "no limit on processes binds them",
        "such files cannot be made",
        reached(MEGABYTES),
        (
            f"""
               import os
               size, files = 0, []
               try:
                   while size < {MEGABYTES}:
                       files.append(os.memfd_create("x"))
                       os.write(files[-1], bytes(50 * 2**20))
                       size += 50
               except OSError:
                   pass
               a_region = size
               """,
        ),
    ),
    Attack(
        "takes shared memory",
        "makes segments of shared memory, fills and lets go of them",
        "they stay, and belong to no process",
        "such segments cannot be made",
        reached(MEGABYTES),
        (
            f"""
               import ctypes
               libc = ctypes.CDLL(None)
               libc.shmat.restype = ctypes.c_void_p
               libc.shmdt.argtypes = [ctypes.c_void_p]
               size, made = 0, []
               while size < {MEGABYTES}:
                   number = libc.shmget(0, 50 * 2**20, 0o1600)
                   if number < 0:
                       break
                   made.append(number)
                   address = libc.shmat(number, None, 0)
                   ctypes.memset(address, 1, 50 * 2**20)
                   libc.shmdt(address)
                   size += 50
               for number in made:
                   libc.shmctl(number, 0, None)
               a_region = size
               """,
        ),
    ),
    Attack(
        "takes memory in sockets",
        "sends to itself what it never reads, and closes, here by 300 sockets",
        "what lies unread belongs to no process",
        "sockets are counted, open or not",
        reached(300),
        (
            """
               import socket, time
               listener, sent = socket.socket(socket.AF_UNIX), 0
               listener.bind("\\0" + TOKEN + NAME)
               listener.listen(1000)
               for _ in range(300):
                   caller = socket.socket(socket.AF_UNIX)
                   caller.connect("\\0" + TOKEN + NAME)
                   caller.send(bytes(10_000))
                   caller.close()
                   sent += 1
               time.sleep(1)
               a_region = sent
               """,
        ),
        blame="limits",
    ),
    Attack(
        "fills the disk",
        "writes a large file",
        "the disk is open",
        "its /tmp is small",
        reached(150),
        (
            """
        import os, tempfile
        size, folder = 0, tempfile.mkdtemp()
        try:
            with open(folder + "/large", "wb") as file:
                for _ in range(150):
                    file.write(bytes(2**20))
                    size += 1
        except OSError:
            pass
        os.remove(folder + "/large")
        a_region = size
        """,
        ),
    ),
    Attack(
        "fills the disk with files",
        "makes a great many small files",
        "the disk is open",
        "its /tmp holds ten thousand",
        reached(15000),
        (
            """
        import shutil, tempfile
        made, folder = 0, tempfile.mkdtemp()
        try:
            for made in range(1, 15001):
                open(f"{folder}/{made}", "x").close()
        except OSError:
            pass
        shutil.rmtree(folder)
        a_region = made
        """,
        ),
    ),
    Attack(
        "covers memory with mounts",
        "makes namespaces of its own, in which it may mount memory of any size",
        "nothing forbids it",
        "namespaces are forbidden",
        reached(1000),
        (
            """
               import ctypes, os
               libc, (out, into) = ctypes.CDLL(None), os.pipe()
               if os.fork() == 0:
                   user, group = os.getuid(), os.getgid()
                   if libc.unshare(0x10000000 | 0x20000) == 0:
                       open("/proc/self/setgroups", "w").write("deny") if os.path.exists("/proc/self") else None
                       try:
                           open("/proc/self/uid_map", "w").write(f"0 {user} 1")
                       except OSError:
                           pass
                       if libc.mount(b"x", b"/tmp", b"tmpfs", 0, b"size=1000m") == 0:
                           size = os.statvfs("/tmp").f_blocks * os.statvfs("/tmp").f_bsize // 2**20
                           os.write(into, str(size).encode())
                   os.close(into)
                   os._exit(0)
               os.close(into)
               a_region = int(os.read(out, 20) or 0)
               """,
        ),
    ),
    Attack(
        "computes by children it forgets",
        "lets short-lived children compute, whose time the kernel forgets since nobody waits for "
        "them",
        "nothing limits their time",
        "how children end is not the notebook's to say, so that their time counts",
        reached(6),
        (
            """
               import os, signal, time
               try:
                   signal.signal(signal.SIGCHLD, signal.SIG_IGN)
               except OSError:
                   pass
               computed = 0
               for _ in range(25):
                   children = []
                   for _ in range(4):
                       children.append(os.fork())
                       if children[-1] == 0:
                           before = time.process_time()
                           while time.process_time() < before + 0.06: pass
                           os._exit(0)
                   for child in children:
                       try:
                           os.waitpid(child, 0)
                       except ChildProcessError:
                           pass
                   computed += 0.24
               a_region = round(computed)
               """,
        ),
        blame="limits",
    ),
    Attack(
        "loops without end",
        "never ends",
        "nobody stops it",
        "the cell is stopped, and the run goes on",
        stopped_the_run,
        ("while True: pass", WRONG),
        patience=2,
        blame="limits",
    ),
    Attack(
        "loops and will not be stopped",
        "never ends, and swallows every exception",
        "nobody stops it",
        "its process is ended",
        stopped_the_run,
        (
            """
        while True:
            try:
                while True: sum(range(1000))
            except BaseException:
                pass
        """,
            WRONG,
        ),
        patience=2,
        blame="limits",
    ),
    Attack(
        "sleeps without end",
        "waits for ever without computing",
        "nobody stops it",
        "the cell is stopped on the clock",
        stopped_the_run,
        ("import time\nwhile True: time.sleep(1000)", WRONG),
        patience=2,
        blame="limits",
    ),
    Attack(
        "waits for input",
        "asks a question",
        "nobody answers",
        "there is no input, which is an error of its cell",
        stopped_the_run,
        ("import os\nos.read(os.pipe()[0], 1)", WRONG),
        patience=2,
        blame="limits",
    ),
    Attack(
        "prints without end",
        "prints for ever",
        "the log fills the disk",
        "what it prints is kept nowhere",
        flooded,
        ("while True: print('x' * 10_000)", WRONG),
        patience=2,
        blame="limits",
    ),
    Attack(
        "writes output past Python",
        "fills the output by its descriptor",
        "the log fills the disk",
        "descriptors 1 and 2 lead nowhere",
        flooded,
        ("import os\nwhile True: os.write(1, b'x' * 100_000); os.write(2, b'x' * 100_000)", WRONG),
        patience=2,
        blame="limits",
    ),
]
