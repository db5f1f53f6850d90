"""Results in the form of the other linters of ament: one suite, a case for each problem, or one case that passes."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

_ENDINGS = (".xml", ".xunit")
_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 cannot hold."""


class Case(NamedTuple):
    """A problem."""

    name: str
    message: str
    text: str
    """The message with its places, in several lines."""


def suite_name(file: Path) -> str:
    """The package and the test, as ament names its result files: ``<package>/<test>.xunit.xml``."""
    name = file.name
    for ending in _ENDINGS:
        name = name.removesuffix(ending)
    return f"{file.absolute().parent.name}.{name}"


def document(name: str, problems: Sequence[Case], kind: str, elapsed: float, output: str) -> str:
    """The document. ``kind`` is ``failure``, or ``error`` when the check did not work; ``elapsed`` is in seconds."""
    counts = {"failures": 0, "errors": 0, f"{kind}s": len(problems)}
    suite = ElementTree.Element("testsuite", name=name, tests=str(max(len(problems), 1)), time=f"{elapsed:.3f}")
    suite.attrib.update({key: str(count) for key, count in counts.items()}, skipped="0")
    for problem in problems:
        case = ElementTree.SubElement(suite, "testcase", name=_sound(problem.name), classname=name)
        ElementTree.SubElement(case, kind, message=_sound(problem.message)).text = _sound(problem.text)
    if not problems:
        ElementTree.SubElement(suite, "testcase", name="bringup_lint", classname=name)
    ElementTree.SubElement(suite, "system-out").text = _sound(output)
    ElementTree.indent(suite)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ElementTree.tostring(suite, "unicode")}\n'


def _sound(text: str) -> str:
    return _FORBIDDEN.sub("\ufffd", text)
