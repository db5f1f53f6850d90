"""Units that scripts mask, also in the text that they hand to the shell of an image."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.scripts import KINDS
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_TYPES = ("service", "socket", "target", "timer", "path", "mount")
_NAME = r"[\w@][\w@.:-]*"
_MASKS = regex(
    rf"^(?:sudo[ \t]+)?systemctl[ \t]+(?:--now[ \t]+)?mask[ \t]+(?:--now[ \t]+)?(?P<names>{_NAME}(?: {_NAME})*)$", re.M
)
"""At the start of a line, also of a text for another shell."""
_UNMASKS = regex(r"\bunmask\b([^\n]*)")
_REMOVES = regex(r"\brm\b([^\n]*)")
_UNMASKED = regex(r"\bmasked:[ \t]*[\"']?(?:no|false)\b")
_NAMES = regex(r"[\w@.:-]+")
_PATHS = regex(r"/([\w@.:-]+)")
_TAKES_AWAY = regex(r"(?i)(?:^|[^a-z])(?:un-?install|remove|purge|disable|stop|teardown|prerm|postrm)(?![a-z])")


@kept
def masked_units(scripts: Scripts) -> dict[str, Located]:
    """The units that a script masks whatever it finds, with the word; none that anything of the tree unmasks."""
    found: dict[str, Located] = {}
    for source in scripts.files.of_kind(*KINDS):
        if not source.judged or "mask" not in source.text or _TAKES_AWAY.search(source.basename):
            continue
        maybe, end = sorted(_conditional(scripts, source), reverse=True), 0
        for match in _MASKS.finditer(source.text):
            while maybe and maybe[-1][0] <= match.start():
                end = max(end, maybe.pop()[1])
            if match.start() >= end:
                found |= {_unit(str(word)): word for word in source.located(*match.span("names")).words()}
    unmasked = _unmasked(scripts) if found else set()
    return {name: word for name, word in found.items() if unmasked.isdisjoint(("*", name.removesuffix(".service")))}


def _conditional(scripts: Scripts, source: Source) -> Iterator[tuple[int, int]]:
    """The stretches of a script that it runs, or hands to another program, under a condition only."""
    for did in scripts.done(source):
        if isinstance(did, Run) and not did.certain and did.words:
            yield did.command.words[0].span.start, did.words[-1].span.end
            yield from did.given.places if did.given else ()


def _unit(name: str) -> str:
    return name if name.rpartition(".")[2] in _TYPES else f"{name}.service"


def _unmasked(scripts: Scripts) -> set[str]:
    """The units that a text of the tree unmasks, or whose file it removes; ``*`` for any."""
    found: set[str] = set()
    for source in scripts.files.sources:
        if not source.judged:
            continue
        for match in _UNMASKS.finditer(source.said):
            if "$" in match[1] or "{{" in match[1]:
                found.add("*")
            for word in _NAMES.findall(match[1]):
                bare = word.strip(".:")
                found |= {bare, bare.removesuffix(".service"), *re.split("[.:@]", word)}
        for match in _REMOVES.finditer(source.said):
            found.update(word.rstrip(":").removesuffix(".service") for word in _PATHS.findall(match[1]))
    return found | {"*"} if scripts.files.mentions(_UNMASKED) else found
