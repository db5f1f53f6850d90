"""Subscriptions to a type of the tree's own that all publishers of the tree send under other names."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.apart import ends_of
from bringup_lint.graph.topics.questions.apart import may_be_left
from bringup_lint.graph.topics.questions.apart import named_in_sources
from bringup_lint.graph.topics.questions.unmatched import BY_HAND
from bringup_lint.graph.topics.questions.unmatched import FIRMWARE_TYPES
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.topics.questions.apart import End
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_SIZE = 200_000
_REMAPS = ":="
_WORD = regex(r"(?<![\w.])\w+(?![\w./])")
_GENERIC = regex(r"\bcreate_generic_publisher\b", hints="create_generic_publisher")
_SHORTEST = 4
"""Letters of a word that says whose packages are."""
_PUBLISHES_NOTHING = tuple(
    (
        ".png .jpg .jpeg .gif .svg .ico .pdf .stl .dae .obj .step .stp .glb .mtl .pgm .bag .db3 .mcap .mp4 .zip .gz"
        " .xz .so .a .bin .hex .elf .onnx .pt .pth .engine .npy .npz .pkl .csv .pcd .ply .las .ttf .woff .woff2 .msg"
        " .srv .action .css .wav .mp3 .lock"
    ).split()
)
"""Endings of files that neither publish under a name nor remap to it, and are often large."""


class Unpublished(NamedTuple):
    subscription: End
    publishers: list[End]
    """All of its type, under other names."""


def unpublished(topics: Topics) -> Iterator[Unpublished]:
    """Each subscription once. The last part of its name is in no other file of the tree, and that of no publisher. A
    type is the tree's own by its package, or by the first word of it, which both packages that use it share."""
    made = [(source, each) for source, _, each in named_in_sources(topics)]
    if not any(each.role == "subscription" and _is_own(topics, each.type, source) for source, each in made):
        return
    publishers = [each for _, each in made if each.role == "publisher"]
    if any(found.source.matches(_GENERIC) for found in topics.nodes.cpp) or any(
        each.type is None and each.name is None for each in publishers
    ):
        return
    unsaid = {each.type for each in publishers if each.name is None or each.parameter is not None}
    chosen = {each.span for _, each in made if each.conditional}
    by_type: dict[str, list[End]] = {}
    for end in ends_of(topics, everything=True):
        if end.type is not None and end.type not in unsaid and _is_own(topics, end.type, end.where.source):
            by_type.setdefault(end.type, []).append(end)
    untyped = {tail(each.name) for each in publishers if each.type is None and each.name}
    alone = [each for ends in by_type.values() for each in _alone(topics, ends, chosen, untyped)]
    yield from _unmentioned(topics, alone)


def _alone(topics: Topics, ends: list[End], chosen: set[Span], untyped: set[str]) -> Iterator[Unpublished]:
    publishers = [each for each in ends if each.role == "publisher"]
    sent = {tail(each.topic) for each in publishers} | untyped
    said: set[Span] = set()
    for each in ends:
        if each.role == "publisher" or not each.is_for_robot or each.where in said or each.where in chosen:
            continue
        others = [other for other in publishers if are_together(topics, other.where.source, each.where.source)]
        if not any(other.is_for_robot for other in others) or tail(each.topic) in sent or BY_HAND.search(each.topic):
            continue
        said.add(each.where)
        if not may_be_left(each.where) and _WORD.fullmatch(tail(each.topic)):
            yield Unpublished(each, others)


def _is_own(topics: Topics, type_: str | None, source: Source) -> bool:
    """Whether no program that is not in the tree sends a type, as far as packages tell."""
    workspace = topics.launch.workspace
    package = (type_ or "").partition("/")[0]
    if f"{package}/".startswith(FIRMWARE_TYPES) or package in workspace.ambiguous:
        return False
    if package in workspace.packages:
        return not workspace.is_vendored(workspace.packages[package].manifest.source)
    owner, word = workspace.owner(source), package.partition("_")[0]
    return owner is not None and len(word) >= _SHORTEST and owner.name.partition("_")[0] == word


def _unmentioned(topics: Topics, found: list[Unpublished]) -> Iterator[Unpublished]:
    """Those whose names no other file than their own may use, as a whole or as the last part of one. Their own may
    remap them. Each file is looked through once for all names."""
    if not found:
        return
    tree = topics.files.tree
    wanted = {tail(each.subscription.topic) for each in found}
    spoken: dict[str, set[str]] = {name: set() for name in wanted}
    for path in tree.paths:
        if not path.endswith(_PUBLISHES_NOTHING):
            for name in wanted.intersection(_WORD.findall(tree.head(path, _SIZE))):
                spoken[name].add(path)
    for each in found:
        name, own = tail(each.subscription.topic), each.subscription.where.source.absolute
        text = tree.head(own, _SIZE)
        if spoken[name] <= {own} and not (name in text and _REMAPS in text):
            yield each
