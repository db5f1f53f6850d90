"""Values that are a letter away from the words with which a program compares them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.fixed_words import PARAMS
from bringup_lint.facts.ros.fixed_words import FixedWords
from bringup_lint.facts.ros.fixed_words import fixed_words
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter

_LINE = regex(
    r"^[ \t]*(?:-[ \t]+)?(\w{1,60}):[ \t]+(['\"]?)([A-Za-z_][\w/:]{0,100})\2[ \t]*(?:#[^\n]*)?\r?$",
)
_ENDINGS = (".yaml", ".yml")
_HEAD = 20_000
"""Characters of a file that are looked at."""
_SHORTEST = 4
"""Letters of a word that is misspelt by no accident: ``rad`` may be for what is not ``raw``."""


class MisspeltValue(NamedTuple):
    value: Located
    name: str
    meant: str
    ends: bool
    effect: str


def misspelt_words(params: Params) -> Iterator[MisspeltValue]:
    """In parameter files, then in other YAML files that a program reads itself."""
    rows: dict[str, list[FixedWords]] = {}
    for each in fixed_words():
        if each.where == (PARAMS,):
            rows.setdefault(each.name, []).append(each)
    for _, parameter in params.parameters:
        for fixed in rows.get(parameter.name.rpartition(".")[2], ()):
            if not fixed.beside or _has_beside(parameter, fixed.beside):
                yield from _of_parameter(params, parameter, fixed)
    yield from _of_files(params.files)


def _of_parameter(params: Params, parameter: Parameter, fixed: FixedWords) -> Iterator[MisspeltValue]:
    for item in params.items(parameter):
        at = item.span.text.find(item.text)
        start = item.span.start + at
        word = item.span.source.located(start, start + len(item.text)) if at >= 0 else Located(item.text, item.span)
        found = _misspelt(word, fixed)
        if found is not None:
            yield found


def _has_beside(parameter: Parameter, name: str) -> bool:
    section = parameter.name.rpartition(".")[0]
    beside = f"{section}.{name}" if section else name
    return any(each.name == beside for each in parameter.block.parameters)


def _of_files(files: Files) -> Iterator[MisspeltValue]:
    tree = files.tree
    for path in tree.paths:
        lowered = path.lower()
        if not lowered.endswith(_ENDINGS):
            continue
        rows = [each for each in fixed_words() if each.where != (PARAMS,) and any(w in lowered for w in each.where)]
        head = tree.head(path, _HEAD) if rows else ""
        rows = [each for each in rows if f"{each.name}:" in head]
        source = tree.at(path) if rows else None
        if source is not None and source.judged:
            yield from _of_source(source, {each.name: each for each in rows})


def _of_source(source: Source, rows: dict[str, FixedWords]) -> Iterator[MisspeltValue]:
    for start in source.line_starts:
        match = _LINE.match(source.text[start : start + 300].partition("\n")[0])
        if match is not None and match[1] in rows:
            found = _misspelt(source.located(start + match.start(3), start + match.end(3)), rows[match[1]])
            if found is not None:
                yield found


def _misspelt(value: Located, fixed: FixedWords) -> MisspeltValue | None:
    text = str(value)
    if len(text) < _SHORTEST or text.lower() in map(str.lower, fixed.words):
        return None
    near = [each for each in nearest(text, fixed.words, 1) if not numbered(each, text)]
    return MisspeltValue(value, fixed.name, near[0], fixed.ends, fixed.effect) if len(near) == 1 else None
