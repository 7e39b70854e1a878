"""Docstrings of the public names of trajlib: a summary of one line, and every argument documented."""

import functools
import importlib
import inspect
import re

import pytest

import trajlib

NumpyDocString = pytest.importorskip("numpydoc.docscrape").NumpyDocString

#: A heading that a reflow has joined with its underline and its text.
HEADING_IN_A_LINE = re.compile(r"^\w[\w ]* -{4,}", re.MULTILINE)

#: The longest first line of a docstring.
LONGEST = 90


def public_objects(package):
    """Names and objects: functions and classes, and the public members of the classes."""
    module = importlib.import_module(f"trajlib.{package}")
    for name in module.__all__:
        value = getattr(module, name)
        if inspect.isroutine(value) or inspect.isclass(value):
            yield name, value
        if inspect.isclass(value):
            ours = [base for base in value.__mro__ if base.__module__.startswith("trajlib.")]
            for member in {member for base in ours for member in vars(base)}:
                if not member.startswith("_"):
                    yield f"{name}.{member}", inspect.getattr_static(value, member)


def documented(value):
    """The function, class or getter behind a member; None for a plain value, such as a default."""
    if isinstance(value, (staticmethod, classmethod)):
        return value.__func__
    if isinstance(value, property):
        return value.fget
    if isinstance(value, functools.cached_property):
        return value.func
    return value if inspect.isroutine(value) or inspect.isclass(value) else None


def arguments(value):
    try:
        signature = inspect.signature(value)
    except ValueError:  # an error class without arguments of its own
        return []
    names = [
        parameter.name.lstrip("*")
        for parameter in signature.parameters.values()
        if parameter.name not in ("self", "cls")
    ]
    return [name for name in names if not name.startswith("_")]


def faults(name, value):
    text = inspect.getdoc(value)
    if not text:
        return [f"{name}: no docstring"]
    first, _, rest = text.partition("\n")
    found = []
    if len(first) > LONGEST or not first.endswith(".") or (rest and not rest.startswith("\n")):
        found.append(f"{name}: the summary is not one sentence of one line: {first!r}")
    sections = NumpyDocString(text)
    listed = {
        part.strip().lstrip("*")
        for section in ("Parameters", "Other Parameters", "Attributes")
        for entry in sections[section]
        for part in entry.name.split(",")
    }
    missing = [argument for argument in arguments(value) if argument not in listed]
    if missing:
        found.append(f"{name}: not documented: {', '.join(missing)}")
    if HEADING_IN_A_LINE.search(text):
        found.append(f"{name}: a heading and its underline stand in one line")
    return found


@pytest.mark.parametrize("package", dir(trajlib))
def test_public_names_are_documented(package):
    objects = [(name, documented(value)) for name, value in public_objects(package)]
    assert objects
    found = [fault for name, value in objects if value for fault in faults(name, value)]
    assert not found, "\n".join(found)
