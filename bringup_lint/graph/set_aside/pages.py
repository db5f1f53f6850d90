"""Copies in a folder of documentation."""

from __future__ import annotations

from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.graph.set_aside.texts import is_copy
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_DOCUMENTATION = regex(r"(?i)(?:^|/)(?:docs?|documentations?)/")
_ALIKE = 50
"""Files of one name with which a page is compared."""


class CopiedPages:
    """Asked for a source: whether it is a copy that shows people a file of the tree."""

    def __init__(self, files: Files, texts: Texts) -> None:
        self._files = files
        self._texts = texts

    @memo
    def have(self, source: Source) -> bool:
        """Whether a file of the documentation has the name of one outside of it, which is the one that is used."""
        path = self._texts.path_of(source.absolute)
        if not _DOCUMENTATION.search(path):
            return False
        used = self._outside_of_documentation.get((source.kind, source.basename), ())
        if not any(is_copy(source.text, each.text) for each in used[:_ALIKE]):
            return False
        place = "/".join(path.split("/")[-2:])
        return not any(place in each.text for each in self._texts.saying(source.basename, source))

    @cached_property
    def _outside_of_documentation(self) -> dict[tuple[str, str], list[Source]]:
        found: dict[tuple[str, str], list[Source]] = {}
        for each in self._files.sources:
            if not _DOCUMENTATION.search(self._texts.path_of(each.absolute)):
                found.setdefault((each.kind, each.basename), []).append(each)
        return found
