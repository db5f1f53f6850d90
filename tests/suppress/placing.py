"""Where a person writes the comment that silences a finding, and the readers that judge the file afterwards."""

from __future__ import annotations

import ast
import json
import shutil
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from bringup_lint.source import Source
from bringup_lint.suppress.forms import PYTHON_KINDS
from bringup_lint.suppress.forms import XML_KINDS
from bringup_lint.suppress.forms import YAML_KINDS
from bringup_lint.suppress.forms import form_of
from bringup_lint.suppress.reach import head_end
from bringup_lint.suppress.reach import is_comment
from bringup_lint.suppress.reach import statement_end
from tests.lint import lint

WHY = "accepted on this robot"


@dataclass(frozen=True)
class Found:
    """A finding of the JSON report."""

    rule: str
    path: str
    line: int
    """0 for the file as a whole."""
    message: str
    suppressed: bool
    copies: tuple[tuple[str, int], ...] = ()
    """The paths and lines of the same finding in copies of the file."""


def found(case: Path, *arguments: str) -> list[Found]:
    run = lint(*arguments, "--output-format", "json", "--min-severity", "info", cwd=case)
    assert run.code in (0, 1), run.stderr + run.stdout
    return [_found(each) for each in json.loads(run.stdout)["findings"]]


def _found(each: dict[str, Any]) -> Found:
    place = each["location"]
    line = place["start"]["line"] if place["end"]["offset"] else 0
    others = (other["location"] for other in each["related"] if other["message"] == "the same line in a copy")
    copies = tuple((other["path"], other["start"]["line"]) for other in others)
    return Found(each["rule"], place["path"], line, each["message"], bool(each["suppressed"]), copies)


def copied(case: Path, to: Path) -> Path:
    shutil.copytree(case, to, symlinks=True)
    return to


def with_comments(source: Source, wanted: dict[int, set[str]]) -> str | None:
    """The text of a file with a comment for each line of findings; None where its format has no comments."""
    form = form_of(source)
    if form is None:
        return None
    above: dict[int, set[str]] = defaultdict(set)
    for line, rules in wanted.items():
        above[_above(source, line)] |= rules
    lines = source.text.split("\n")
    for at in sorted(above, reverse=True):
        below = lines[min(at, len(lines) - 1)]
        indent = below[: len(below) - len(below.lstrip(" "))]
        end = "\r" * below.endswith("\r")
        lines.insert(at, indent + form(f"bringup-lint: ignore[{', '.join(sorted(above[at]))}]: {WHY}") + end)
    return "\n".join(lines)


def _above(source: Source, line: int) -> int:
    """The number of lines above the comment."""
    head = prolog_end(source)
    if line <= head_end(source):
        return head
    before = (at for at in range(max(head + 1, line - 60), line) if not is_comment(source, at))
    return next((at for at in before if statement_end(source, at) >= line), line) - 1


def prolog_end(source: Source) -> int:
    """The lines at the start that must stay there."""
    from bringup_lint.suppress.reach import _PROLOG

    end = 0
    for line in range(1, head_end(source) + 1):
        if _PROLOG.match(source.line_text(line)):
            end = line
    return end


def problems(source: Source, text: str) -> Iterator[str]:
    """What the real reader of a file says of it."""
    try:
        if source.kind in XML_KINDS:
            from lxml import etree

            etree.fromstring(text.encode())
        elif source.kind in YAML_KINDS:
            list(yaml.compose_all(text))
        elif source.kind in PYTHON_KINDS:
            ast.parse(text)
    except (SyntaxError, ValueError, yaml.YAMLError) as error:
        yield f"{type(error).__name__}"
