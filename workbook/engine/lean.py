"""The lean WebAssembly file: without the code of packages that no check uses.

The bodies of functions that belong to these packages become `unreachable`: a call traps, so that
nothing is silently wrong. Which functions these are is read from the file's own name section, which
then goes, too. Binary format: WebAssembly core specification 2.0, section 5.
"""

import re

#: Packages whose code is left out, as Cython writes them into the names of functions.
LEFT_OUT = ("lxml", "pandas", "sklearn", "statsmodels")
#: A Python function of a package that stays.
KEPT = re.compile(r"__pyx_pw_\d+(numpy|scipy)_")
CODE, CUSTOM, IMPORT = 10, 0, 2
FUNCTION_NAMES = 1
#: Bodies of a function and of a static initialiser, which runs at the start and then does nothing.
UNREACHABLE, NOTHING = b"\x03\x00\x00\x0b", b"\x02\x00\x0b"


def lean(wasm):
    """Return the bytes of a module without the code of `LEFT_OUT` and without names.

    Parameters
    ----------
    wasm : bytes
        A WebAssembly module with a name section.

    Returns
    -------
    bytes
    """
    sections = list(_sections(wasm))
    names = _function_names(sections)
    gone = left_out(names)
    out = [wasm[:8]]
    imported = next(_imported_functions(body) for number, body in sections if number == IMPORT)
    for number, body in sections:
        if number == CODE:
            body = _without(body, imported, gone, names)
        if number != CUSTOM:
            out.append(bytes([number]) + _encoded(len(body)) + body)
    return b"".join(out)


def left_out(names):
    """Return the indices of the functions whose bodies go.

    Parameters
    ----------
    names : dict of str
        Names of functions by index, in the order in which they were linked.

    Returns
    -------
    set of int

    Notes
    -----
    Cython marks a function with its package, `__pyx_pw_6pandas_5_libs_...`. The linker puts the
    object files of a package one after the other, so the functions from the first marked one to the
    last belong to it, with the C code between them. C++ functions are kept: of an inline one the
    linker keeps a single copy for all packages.
    """
    gone = set()
    for package in LEFT_OUT:
        mark = re.compile(rf"_{len(package)}{package}_")
        marked = [index for index, name in names.items() if mark.search(name)]
        inside = range(min(marked), max(marked) + 1)
        gone |= {index for index in inside if "::" not in names[index].split("(")[0]}
    kept = [index for index, name in names.items() if KEPT.match(name)]
    if gone.intersection(kept):
        raise ValueError("functions of a package that is kept lie between those that go")
    return gone


def _sections(wasm):
    position = 8
    while position < len(wasm):
        size, start = _number(wasm, position + 1)
        yield wasm[position], wasm[start : start + size]
        position = start + size


def _function_names(sections):
    for number, body in sections:
        if number == CUSTOM:
            length, start = _number(body, 0)
            if body[start : start + length] == b"name":
                return dict(_names(body, start + length))
    raise ValueError("the module has no name section")


def _names(body, position):
    while position < len(body):
        kind = body[position]
        size, position = _number(body, position + 1)
        if kind == FUNCTION_NAMES:
            count, entry = _number(body, position)
            for _ in range(count):
                index, entry = _number(body, entry)
                length, entry = _number(body, entry)
                yield index, body[entry : entry + length].decode()
                entry += length
        position += size


def _imported_functions(body):
    """Return how many functions are imported; a module imports nothing else here."""
    count, position = _number(body, 0)
    for _ in range(count):
        for _ in range(2):
            length, position = _number(body, position)
            position += length
        if body[position] != 0:
            raise ValueError("the module imports more than functions")
        _, position = _number(body, position + 1)
    return count


def _without(body, imported, gone, names):
    count, position = _number(body, 0)
    out = [_encoded(count)]
    for index in range(imported, imported + count):
        size, start = _number(body, position)
        if index in gone:
            out.append(NOTHING if names[index].startswith("_GLOBAL__") else UNREACHABLE)
        else:
            out.append(body[position : start + size])
        position = start + size
    return b"".join(out)


def _number(data, position):
    """Return an unsigned LEB128 number and the position after it."""
    result = shift = 0
    while True:
        byte = data[position]
        position += 1
        result |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            return result, position


def _encoded(number):
    out = bytearray()
    while number > 127:
        out.append(number & 127 | 128)
        number >>= 7
    return bytes([*out, number])
