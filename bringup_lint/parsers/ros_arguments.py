"""What comes after ``--ros-args``, as rcl reads it: every process of ROS ends at its start when rcl refuses one word.

Derived from ``rcl_parse_arguments`` and its lexer in ros2/rcl.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_TOKEN = r"(?:(?!\w*__)[A-Za-z_]\w*)"
_PATH = rf"{_TOKEN}(?:/{_TOKEN})*"
_REMAP = regex(
    rf"(?:{_TOKEN}:)?(?:__ns:=/(?:{_PATH})?/?|__(?:node|name):={_TOKEN}"
    rf"|(?:ros(?:service|topic):(?://)?)?(?:~?/)?{_PATH}:=(?:~?/)?{_PATH})\Z",
    re.ASCII,
)
_PARAMETER = regex(rf"(?:{_TOKEN}:)?/?{_TOKEN}(?:[./]{_TOKEN})*:=(?P<value>.*)\Z", re.ASCII | re.S)
_LEVEL = regex(r"(?:.+:=)?(?:unset|debug|info|warn|error|fatal)\Z", re.I | re.S)
_NESTED = regex(r"\[\s*\[")
_PLAIN = regex(r"[^\[{&*!|>'\"%@`:?-]|- ")
FLAGS = {
    "-r": "remap",
    "--remap": "remap",
    "-p": "parameter",
    "--param": "parameter",
    "--params-file": "file",
    "-e": "enclave",
    "--enclave": "enclave",
    "--log-level": "level",
    "--log-config-file": "file",
    "--log-file-name": "text",
}
"""The options with a value."""
SWITCHES = tuple(
    f"--{verb}-{what}" for verb in ("enable", "disable") for what in ("rosout-logs", "stdout-logs", "external-lib-logs")
)
LONGEST = 2000

Words = Sequence["Located | None"]
"""None: a word that is not known."""


def problems(words: Words, *, inside: bool = False) -> Iterator[Problem]:
    """What rcl refuses: ``ros-flag``, ``ros-value-missing``, ``remap-rule``, ``parameter-rule``, ``log-level``.
    ``inside``: the first word already comes after ``--ros-args``."""
    at = 0
    while at < len(words):
        word = words[at]
        at += 1
        if not inside:
            inside = word == "--ros-args"
            continue
        if word is None:
            return
        if word == "--":
            inside = False
        elif word in FLAGS:
            yield from _with_value(word, words[at : at + 1])
            at += 1
        elif word not in SWITCHES and word != "--ros-args":
            yield Problem("ros-flag", word)
            following = words[at] if at < len(words) else None
            at += following is not None and not following.startswith("-")


def _with_value(flag: Located, rest: Words) -> Iterator[Problem]:
    kind = FLAGS[flag]
    if not rest or (rest[0] == "--" and kind in ("file", "enclave")):
        yield Problem("ros-value-missing", flag)
        return
    value = rest[0]
    if value is None or len(value) > LONGEST:
        return
    if kind == "remap" and not _REMAP.match(value):
        yield Problem("remap-rule", value)
    elif kind == "parameter" and not _is_parameter(value):
        yield Problem("parameter-rule", value)
    elif kind == "level" and not _LEVEL.match(value):
        yield Problem("log-level", value)


def _is_parameter(rule: str) -> bool:
    match = _PARAMETER.match(rule)
    if match is None:
        return False
    value = match["value"].strip()
    if not value or _NESTED.match(value):
        return bool(value)
    if _PLAIN.match(value) and ": " not in value and not value.endswith(":"):
        return True
    from bringup_lint.parsers.params import parse

    return value[0] != "{" and parse(Source("rule", f"/**:\n  ros__parameters:\n    p: {value}\n")).accepted
