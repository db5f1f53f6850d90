"""Whether the sources of a package end a thread that one of them starts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_source import LateJoin
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode

FILES = 400
"""Source files of one package that are read."""
_ENDS = regex(
    r"\b(?P<own>\w+)(?=\s{0,8}(?:\[[^\]]{0,80}\])?\s{0,8}\)?\s{0,40}(?:\.|->)\s{0,4}"
    r"(?:join|detach|swap|release|begin|get)\b)"
    r"|\b(?:move|ref|swap|exchange)\s{0,4}\(\s{0,40}(?:this->)?(?=(?P<given>\w+))|&\s{0,4}(?:this->)?(?=(?P<pointed>\w+))"
    r"|[^:]:\s{0,4}(?:this->)?(?=(?P<looped>\w+)\s{0,4}\))|\breturn\s{1,40}(?=(?P<returned>\w+))"
)
"""What ends a thread or may; only the name itself is taken, as one may follow another: ``copy.swap(thread_)``."""
_BROUGHT_DOWN = regex(
    r"nav2|hardware_interface|controller_interface|\bon_shutdown\s{0,4}\(\s{0,4}[\[s]|shutdown_callback"
)
_RUNS_STEPS = regex(
    r"\bdeactivate\s{0,4}\(\s{0,4}\)|\btrigger_transition\s{0,4}\("
    r"|\b\w{0,64}node\w{0,64}(?:->|\.)\s{0,4}(?:cleanup|shutdown)\s{0,4}\(\s{0,4}\)",
    hints="deactivate trigger_transition node",
)
"""What a program runs the transitions of a node with, as after its spin."""
_KEEPS = regex(r"\b(?:push_back|emplace_back|emplace|insert)\s{0,4}\(")
_WORD = regex(r"\w+")
_STATEMENT = 2000
"""Characters in which a statement ends."""


def ends_thread(nodes: Nodes, source: Source, name: str) -> bool:
    """Whether the package of a C++ source joins or detaches a thread, or hands it to something that may. True where too
    much is there to be read."""
    sources = package_sources(nodes, source)
    return any(each is None or name in _ended(each, name) for each in sources)


def late_join(nodes: Nodes, source: CppNode, name: str) -> LateJoin | None:
    """The joins of a thread in callbacks, where nothing else of the package ends it."""
    found = next((each for each in source.late_joins if each.thread == name), None)
    if found is not None and found.is_step:
        sources = package_sources(nodes, source.source)
        runs = any(each is not None and each.matches(_RUNS_STEPS) for each in sources)
        if runs or not _is_left(nodes, source.source):
            return None
    return None if found is not None and _is_joined_elsewhere(nodes, source.source, found) else found


@memo
def _is_left(nodes: Nodes, source: Source) -> bool:
    """Whether a source and its header are about a lifecycle node that nothing brings down when a signal comes: others
    run the transitions of controllers and hardware, and nodes of Nav2 do it themselves."""
    text = with_header(nodes, source)
    return "LifecycleNode" in text and not _BROUGHT_DOWN.search(text)


def _is_joined_elsewhere(nodes: Nodes, source: Source, late: LateJoin) -> bool:
    """Whether the package ends a thread in other ways than by the joins in callbacks."""
    sources = list(package_sources(nodes, source))
    if None in sources:
        return True
    ends = [place for each in sources if each is not None for place in _ended(each, late.thread).get(late.thread, ())]
    return len(ends) != len(late.joins)


def _ended(source: Source, name: str) -> dict[str, set[int]]:
    """Name -> the places of a source that end a thread of that name, or hand it to something that may; nothing where
    the source does not have ``name``, the one that is asked for."""
    return source.once(_ended, lambda: _found(source)) if name in source.text else {}


def _found(source: Source) -> dict[str, set[int]]:
    found: dict[str, set[int]] = {}
    text = plain_of(source)
    for match in _ENDS.finditer(text):
        kind = str(match.lastgroup)
        found.setdefault(match[kind], set()).add(match.start(kind))
    for match in _KEEPS.finditer(text):
        for word in _WORD.finditer(text, match.end(), _end_of_statement(text, match.end())):
            found.setdefault(word[0], set()).add(word.start())
    return found


def _end_of_statement(text: str, start: int) -> int:
    end = text.find(";", start, start + _STATEMENT)
    return end if end >= 0 else min(len(text), start + _STATEMENT)


def package_sources(nodes: Nodes, source: Source) -> Iterator[Source | None]:
    """The file and the others of its package; None where these are too many, or not known."""
    files, package = nodes.files, nodes.launch.workspace.owner(source)
    yield source
    if package is None:
        yield None
        return
    inside = [each for each in files.tree.walked_below(package.folder) if each.endswith(CPP)]
    if len(inside) > FILES:
        yield None
        return
    for path in inside:
        found = files.tree.read(path, judged=False)
        if found is not None and found.absolute != source.absolute:
            yield found
