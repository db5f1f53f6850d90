"""Bake files (docker-bake.hcl): the targets with the names that they give, and their Dockerfiles."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.image_build import ImageBuild
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_BLOCK = regex(r'^[ \t]*(target|variable)[ \t]+"([\w-]+)"[ \t]*\{', re.M)
_TEXT = regex(r'^[ \t]*(context|dockerfile|target|default)[ \t]*=[ \t]*"([^"\n]*)"', re.M)
_LIST = regex(r"^[ \t]*(tags|inherits)[ \t]*=[ \t]*\[([^][]*)\]", re.M)
_WORD = regex(r'"([^"\n]*)"')
_VARIABLE = regex(r"\$\{(\w+)\}")
_DEEPEST = 8


class _Block(NamedTuple):
    name: Located
    texts: dict[str, str]
    lists: dict[str, list[str]]


def parse(source: Source) -> list[ImageBuild]:
    """The targets that name an image. Functions and matrices of HCL are not evaluated: what they make is unknown."""
    targets: dict[str, _Block] = {}
    variables: dict[str, str] = {}
    for kind, block in _blocks(source):
        if kind == "target":
            targets[str(block.name)] = block
        elif "default" in block.texts:
            variables[str(block.name)] = block.texts["default"]
    return list(_builds(targets, variables))


def _blocks(source: Source) -> Iterator[tuple[str, _Block]]:
    openings = list(_BLOCK.finditer(source.text))
    ends = [opening.start() for opening in openings[1:]] + [len(source.text)] * bool(openings)
    for opening, end in zip(openings, ends, strict=True):
        body = source.text[opening.end() : end]
        lists = {match[1]: _WORD.findall(match[2]) for match in _LIST.finditer(body)}
        yield opening[1], _Block(source.located(*opening.span(2)), dict(_TEXT.findall(body)), lists)


def _builds(targets: dict[str, _Block], variables: dict[str, str]) -> Iterator[ImageBuild]:
    def expanded(text: str) -> str:
        return _VARIABLE.sub(lambda match: variables.get(match[1], match[0]), text)

    for block in targets.values():
        names = tuple(expanded(name) for name in block.lists.get("tags", ()))
        if names:
            texts = _inherited(block, targets)
            context, dockerfile, target = (expanded(texts.get(key, "")) for key in ("context", "dockerfile", "target"))
            yield ImageBuild(names, context, dockerfile, target, block.name)


def _inherited(block: _Block, targets: dict[str, _Block], depth: int = 0) -> dict[str, str]:
    """The settings of a target, those of the targets that it inherits below its own."""
    found: dict[str, str] = {}
    if depth < _DEEPEST:
        for name in block.lists.get("inherits", ()):
            if name in targets:
                found |= _inherited(targets[name], targets, depth + 1)
    return found | block.texts
