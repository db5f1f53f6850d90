"""The reference of the configuration, from its schema."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

INTRODUCTION = """\
# Configuration

`bringup-lint.toml`, or `[tool.bringup-lint]` in `pyproject.toml`. `bringup-lint init` writes one to start from. Paths
and patterns are relative to the file. An unknown key is an error with exit code 2. A configuration that is found never
runs code.

Give the [schema](bringup-lint.schema.json) to your editor, and it completes keys and checks values.
"""


def page(schema: Path) -> str:
    """The page of all keys."""
    data = json.loads(schema.read_text("utf-8"))
    return "\n".join([INTRODUCTION, *(line for item in data["properties"].items() for line in _setting(*item))])


def _setting(key: str, schema: dict[str, Any]) -> Iterator[str]:
    yield f"## `{key}`"
    yield ""
    yield schema["description"]
    yield ""
    yield f"- Type: {_type(schema)}"
    if "default" in schema:
        yield f"- Default: `{schema['default']}`"
    yield ""
    yield f"```toml\n{_example(key)}\n```"
    yield ""


def _type(schema: dict[str, Any]) -> str:
    if "enum" in schema:
        return "one of " + ", ".join(f"`{value}`" for value in schema["enum"])
    if schema["type"] == "array":
        return f"list of {_type(schema['items'])}"
    if schema["type"] == "object":
        return f"table, each value {_type(schema['additionalProperties'])}"
    return str(schema["type"])


EXAMPLES = {
    "select": 'select = ["systemd", "udev/symlink-match"]',
    "ignore": 'ignore = ["systemd/no-resource-limits"]',
    "exclude": 'exclude = ["simulation/", "*.bak"]',
    "min-severity": 'min-severity = "info"',
    "fail-on": 'fail-on = "error"',
    "severity": '[severity]\n"systemd/root-user" = "error"\n"node" = "off"',
    "per-file-ignores": '[per-file-ignores]\n"legacy/" = ["systemd", "udev/symlink-match"]',
    "target-ros": 'target-ros = "jazzy"',
    "target-systemd": "target-systemd = 255",
    "deploy": '[deploy]\n"deploy/units" = "/etc/systemd/system"',
    "purpose": '[purpose]\n"worlds" = "simulation"',
    "baseline": 'baseline = "known.json"',
    "rules": 'rules = ["lint/rules"]',
}


def _example(key: str) -> str:
    """Every key has one: a new key needs a row above."""
    return EXAMPLES[key]
