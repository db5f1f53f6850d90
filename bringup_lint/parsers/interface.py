"""Interface definitions (``.msg``, ``.srv``, ``.action``): the fields of each part."""

from __future__ import annotations

import re

from bringup_lint.pattern import regex

CONSTANT = "="
"""What stands for the type of a constant."""
_LINE = regex(
    r"[ \t]*(?P<type>[A-Za-z][\w/]*)(?:<=\d+)?(?P<array>\[[<=\d]*\])?[ \t]+(?P<name>[A-Za-z]\w*)[ \t]*(?P<constant>=)?"
)

Fields = dict[str, str]
"""Name -> type: ``float64``, ``geometry_msgs/Point``, with ``[]`` at the end for arrays and sequences."""


def parse(text: str, package: str) -> list[Fields]:
    """One for a message, two for a service, three for an action. Lines that are no fields are left out."""
    parts: list[Fields] = [{}]
    for line in text.splitlines():
        if line.strip() == "---":
            parts.append({})
            continue
        match = _LINE.match(line.partition("#")[0])
        if match is not None:
            parts[-1][match["name"]] = CONSTANT if match["constant"] else _type(match, package)
    return parts


def fixed_arrays(text: str) -> frozenset[str]:
    """The fields that always have the same number of elements."""
    found = (_LINE.match(line) for line in text.splitlines())
    return frozenset(each["name"] for each in found if each is not None and (each["array"] or "")[1:-1].isdecimal())


def _type(match: re.Match[str], package: str) -> str:
    kind = match["type"]
    if kind == "Header":
        kind = "std_msgs/Header"
    elif kind[0].isupper() and "/" not in kind:
        kind = f"{package}/{kind}"
    kind = kind.replace("/msg/", "/")
    return f"{kind}[]" if match["array"] else kind
