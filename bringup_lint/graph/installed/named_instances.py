"""The instances of templates of units that scripts and plays name."""

from __future__ import annotations

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import kept
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_INSTANCE = regex(r"(?<![\w-])(?P<stem>[\w:.\\-]{1,200}@)(?P<name>\{\{[^}\n]{1,80}\}\}|[^\s\"']{1,80})", hints="@")


class NamedInstance(NamedTuple):
    source: Source
    name: str
    """What is after the ``@``, without the suffix of a service."""


@kept
def named_instances(files: Files) -> dict[str, list[NamedInstance]]:
    """The name of a template up to the ``@`` -> the instances of it."""
    found: dict[str, list[NamedInstance]] = {}
    for source in files.of_kind("ansible", "shell-script"):
        for match in _INSTANCE.finditer(source.said):
            name = match["name"].removesuffix(".service")
            if name:
                found.setdefault(match["stem"], []).append(NamedInstance(source, name))
    return found
