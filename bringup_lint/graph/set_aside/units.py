"""Units that nothing installs or starts, while others beside them are."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections import defaultdict
from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import FEWEST
from bringup_lint.graph.set_aside.texts import WORD
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.templates import final_name

_UNIT = regex(r"\.(?:service|timer|socket|path|target)$")
_BRINGS = regex(
    r"\b(?:cp|ln|mv|install|rsync|scp|link\w{0,20}|symlink\w{0,20}|copy|COPY|ADD|src|put|enabled?|start|restart"
    r"|PROGRAMS|FILES|template|tee)\b"
)
_WHOLE = regex(
    r"\b(?:cp|ln|mv|install|rsync|scp|copy|COPY|ADD|src|DIRECTORY|glob|iglob|listdir|iterdir|for|find|tar)\b"
)
_EVERY_UNIT = regex(r"\*\.(?:(?:service|timer|socket|path|target)(?P<ending>\.[a-z]\w{0,20})?|\{|\$)")
_STARTS = regex(r"\bsystemctl\b|\bdh_installsystemd\b[^\n]*--name\b", hints="systemctl dh_installsystemd")
_MATCHED = regex(r"(?<![\w-])([\w-]{1,80})@?\.[*{]")
"""The stem of a name whose ending is a pattern."""
_STARTS_ANY = regex(r"\bsystemctl\b[^\n]*\$")
"""Starts a unit whose name a variable has."""
_SUFFIX = regex(r"[\]}\"'%)*s]\.(?:service|timer|socket|path|target)\b")
"""Of a name that is put together from its stem."""
_PLACE = regex(r"/systemd/(?:system|user)/[^/]+$")
"""A folder from which systemd loads units: such a tree is copied as a whole."""
_ANY = regex("")
_OF_UNIT = regex(r"\.(?:service|timer|socket|path|target)\b")


class IdleUnits:
    """Asked for a unit: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, texts: Texts) -> None:
        self._files = files
        self._texts = texts

    @memo
    def have(self, source: Source) -> bool:
        """Whether nothing installs, links or starts a unit, while others beside it are, each by its name."""
        if not _UNIT.search(final_name(source.basename)) or _PLACE.search(source.absolute):
            return False
        folder = os.path.dirname(self._texts.path_of(source.absolute))
        if self._brought_units[folder] < FEWEST or self._uses(source):
            return False
        own = self._texts.path_of(source.absolute)
        return not any(path != own for path in self._taking(folder))

    def _is_brought(self, unit: Source) -> bool:
        """Whether a line installs or starts a unit by its name."""
        own = self._texts.path_of(unit.absolute)
        return any(path != own for path in self._bringing.get(final_name(unit.basename), ()))

    @cached_property
    def _units(self) -> defaultdict[str, list[Source]]:
        """The units of each folder."""
        found: defaultdict[str, list[Source]] = defaultdict(list)
        for each in self._files.of_kind("systemd-unit"):
            if each.origin is None:
                found[os.path.dirname(self._texts.path_of(each.absolute))].append(each)
        return found

    @cached_property
    def _brought_units(self) -> Counter[str]:
        """How many units of each folder a line installs or starts by their names."""
        return Counter({folder: sum(map(self._is_brought, units)) for folder, units in self._units.items()})

    @cached_property
    def _bringing(self) -> dict[str, set[str]]:
        """The names of units in lines that install or start something, each with the files that have them."""
        return self._behind(_BRINGS, _OF_UNIT)

    @cached_property
    def _asking(self) -> dict[str, set[str]]:
        """The words of lines that start units, each with the files that have them."""
        return self._behind(_STARTS, _ANY)

    def _behind(self, pattern: re.Pattern[str], lines: re.Pattern[str]) -> dict[str, set[str]]:
        """The words that follow a pattern in lines, with and without the ending, each with the files that have them."""
        found: dict[str, set[str]] = {}
        for each in (one for one in self._texts.all if lines.search(one.text) and pattern.search(one.text)):
            for line in filter(lines.search, each.text.splitlines()):
                match = pattern.search(line)
                if match is None:
                    continue
                for word in WORD.findall(line, match.end()):
                    for part in (word, word.rpartition(".")[0], word.partition("@")[0]):
                        found.setdefault(part, set()).add(each.path)
        return found

    @memo
    def _uses(self, unit: Source) -> bool:
        """Whether anything of the tree may install or start a unit, or pull it in."""
        name, own = final_name(unit.basename), self._texts.path_of(unit.absolute)
        stem = name.rpartition(".")[0].rstrip("@")
        if next(self._texts.saying(name, unit), None) is not None or stem in self._matched:
            return True
        if any(path != own for path in self._asking.get(stem, ())) or ("@" in name and stem in self._instances):
            return True
        return any(each.path in self._putting_together for each in self._texts.saying(stem, unit))

    @cached_property
    def _putting_together(self) -> frozenset[str]:
        """The files that put the name of a unit together from its stem."""
        return frozenset(
            each.path for each in self._texts.all if _SUFFIX.search(each.text) or _STARTS_ANY.search(each.text)
        )

    @cached_property
    def _matched(self) -> frozenset[str]:
        """The stems of names of which a pattern has the ending."""
        return frozenset(stem for each in self._texts.all for stem in _MATCHED.findall(each.text))

    @cached_property
    def _instances(self) -> frozenset[str]:
        """The stems of templates of which an instance is named."""
        parts = (word.partition("@") for word in self._texts.by_word)
        return frozenset(stem for stem, _, name in parts if name and not name.startswith("."))

    @memo
    def _taking(self, here: str) -> list[str]:
        """The files with a line that takes a whole folder of units, and not one of their names."""
        names = {final_name(each.basename) for each in self._units[here]}
        folder = os.path.basename(here) or os.path.basename(self._texts.top.rstrip("/"))
        place = re.compile(
            rf"(?<![\w.-]){re.escape(folder)}(?:/?[\"']?(?:[\s,)\]}}:]|$)|/[\"']?(?:\*|\$|\{{|\.(?![\w.])))"
        )
        found = [each.path for each in self._texts.by_folder.get(here, ()) if self._takes_every(each.text, here)]
        for each in self._texts.by_word.get(folder, ()):
            lines = (line for line in each.text.splitlines() if folder in line and place.search(line))
            if self._takes_every(each.text, here) or any(
                _WHOLE.search(line) and names.isdisjoint(map(final_name, WORD.findall(line))) for line in lines
            ):
                found.append(each.path)
        return found

    def _takes_every(self, text: str, here: str) -> bool:
        """Whether a pattern for all units of a folder is in a text: one with an ending is for templates alone."""
        endings = tuple({match["ending"] or "" for match in _EVERY_UNIT.finditer(text)})
        return any(each.basename.endswith(endings) for each in self._units[here])
