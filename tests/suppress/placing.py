"""What a run finds, and the readers that judge a file after comments were written into it."""

from __future__ import annotations

import ast
import json
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from bringup_lint.parsers.yaml_kinds import YAML_KINDS
from bringup_lint.source import Source
from bringup_lint.suppress.forms import PYTHON_KINDS
from bringup_lint.suppress.forms import XML_KINDS
from tests.lint import lint


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
