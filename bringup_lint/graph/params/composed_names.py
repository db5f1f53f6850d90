"""Parameter files whose names launch files put together: one for each model of a robot."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.pattern import regex

_WORD = regex(r"[\w.-]+")
_END = regex(r"(?<=[\"'})])[\w.-]*\.ya?ml", hints=".yaml .yml")
"""What follows a value that is put in, or begins a text."""
_JOINTS = (".", "_", "-")
_HOLES = ("}", ")")


class ComposedNames:
    """What the launch files of one package put together."""

    def __init__(self, texts: Iterable[str]) -> None:
        self._words: set[str] = set()
        ends: set[str] = set()
        for text in texts:
            found = set(_ends(text))
            ends |= found
            self._words.update(_WORD.findall(text) if found else ())
        self._ends = tuple(ends)

    def has(self, path: str) -> bool:
        """Whether a path in the package may be made of a value and one of the ends, in folders that are named."""
        *folders, name = path.split("/")
        return name.endswith(self._ends) and name not in self._ends and self._words.issuperset(folders)


def _ends(text: str) -> Iterator[str]:
    for match in _END.finditer(text):
        if text[match.start() - 1] in _HOLES or match[0].startswith(_JOINTS):
            yield match[0]
