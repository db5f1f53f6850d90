"""Whether the sources of a package end a thread that one of them starts."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import LateJoin
from bringup_lint.model.cpp_text import blanked
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package

SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".h", ".hxx", ".ipp", ".tpp", ".inl")
FILES = 400
"""Source files of one package that are read."""


def ends_thread(files: Files, package: Package | None, source: Source, name: str) -> bool:
    """Whether a source joins or detaches a thread, or hands it to something that may. True where too much is there to
    be read."""
    sources = package_sources(files, package, source)
    return any(each is None or next(_ends(each, name), None) is not None for each in sources)


def is_joined_elsewhere(files: Files, package: Package | None, source: Source, late: LateJoin) -> bool:
    """Whether the package ends a thread in other ways than by the joins in callbacks."""
    sources = package_sources(files, package, source)
    found = [place for each in sources for place in (_ends(each, late.thread) if each is not None else (None,))]
    return len(found) != len(late.joins)


def _ends(source: Source, name: str) -> Iterator[re.Match[str]]:
    """The places of a source that end a thread, or hand it to something that may."""
    written = re.escape(name)
    ends = re.compile(
        rf"\b{written}\s*(?:\[[^\]]*\])?\s*\)?\s*(?:\.|->)\s*(?:join|detach|swap|release|begin|get)\b"
        rf"|\b(?:move|ref|swap|exchange)\s*\(\s*(?:this->)?{written}\b|&\s*(?:this->)?{written}\b"
        rf"|\b(?:push_back|emplace_back|emplace|insert)\s*\([^;]*\b{written}\b|[^:]:\s*(?:this->)?{written}\s*\)"
        rf"|\breturn\s+{written}\b"
    )
    return ends.finditer(blanked(source.text)) if name in source.text else iter(())


def package_sources(files: Files, package: Package | None, source: Source) -> Iterator[Source | None]:
    """The file and the others of its package; None where these are too many, or not known."""
    yield source
    if package is None:
        yield None
        return
    inside = [each for each in files.tree.walked_below(package.folder) if each.endswith(SUFFIXES)]
    if len(inside) > FILES:
        yield None
        return
    for path in inside:
        found = files.tree.read(path, judged=False)
        if found is not None and found.absolute != source.absolute:
            yield found
