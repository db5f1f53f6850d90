"""Units that scripts mask, also in the text that they hand to the shell of an image."""

from __future__ import annotations

import re

from bringup_lint.graph.installed.scripts import KINDS
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_TYPES = ("service", "socket", "target", "timer", "path", "mount")
_NAME = r"[\w@][\w@.:-]*"
_MASKS = regex(
    rf"^(?:sudo[ \t]+)?systemctl[ \t]+(?:--now[ \t]+)?mask[ \t]+(?:--now[ \t]+)?(?P<names>{_NAME}(?: {_NAME})*)$", re.M
)
"""At the start of a line: not under a condition."""


def masked_units(scripts: Scripts) -> dict[str, Located]:
    """The units that a script masks whatever it finds, with the word; none that anything of the tree unmasks."""
    found: dict[str, Located] = {}
    for source in scripts.files.of_kind(*KINDS):
        if source.judged and "mask" in source.text:
            for match in _MASKS.finditer(source.text):
                found |= {_unit(str(word)): word for word in source.located(*match.span("names")).words()}
    return {name: word for name, word in found.items() if not _is_unmasked(scripts, name)}


def _unit(name: str) -> str:
    return name if name.rpartition(".")[2] in _TYPES else f"{name}.service"


def _is_unmasked(scripts: Scripts, name: str) -> bool:
    stem = re.escape(name.removesuffix(".service"))
    unmasked = re.compile(
        rf"\bunmask\b[^\n]*(?:(?<![\w-]){stem}(?![\w-])|\$|\{{\{{)|\bmasked:[ \t]*[\"']?(?:no|false)\b"
    )
    return scripts.files.mentions(unmasked)
