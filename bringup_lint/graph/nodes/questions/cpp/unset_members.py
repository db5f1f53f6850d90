"""Members of C++ nodes that callbacks read before they have a value, in one file or with a header."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.threads import package_sources
from bringup_lint.graph.nodes.sources.with_header import headers
from bringup_lint.model.cpp_source import UnsetMember
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode


def unset_members(nodes: Nodes) -> Iterator[list[UnsetMember]]:
    """Those of one class together, each with the place that declares it."""
    for node in nodes.cpp:
        by_owner: dict[str, list[UnsetMember]] = {}
        for member in node.unset_members:
            declared = member.declared or _in_header(nodes, node, member)
            if declared is not None and not _is_named_elsewhere(nodes, node, member, declared.source):
                by_owner.setdefault(member.owner, []).append(member._replace(declared=declared))
        yield from by_owner.values()


def _in_header(nodes: Nodes, node: CppNode, member: UnsetMember) -> Span | None:
    """The declaration in the one header of a source, which gives the member no value and names it nowhere else."""
    found = headers(nodes, node.source)
    if len(found) != 1:
        return None
    bare = (each for each in found[0].bare_members if each.owner == member.owner)
    return next((each.declared.span for each in bare if each.declared == member.name), None)


def _is_named_elsewhere(nodes: Nodes, node: CppNode, member: UnsetMember, declaring: Source) -> bool:
    """Whether another source of the package, as that of a derived class, may set the member: it names the member and
    the class, or one that builds on it, and has no class of that name itself."""
    owner, name = re.escape(member.owner), re.escape(member.name)
    builds = re.compile(rf"\b(?:class|struct)[ \t]+(\w+)[ \t]*(?:final[ \t]*)?:[^;{{:][^;{{]{{0,300}}?\b{owner}\b")
    sources = [node.source, declaring, *(each for each in package_sources(nodes, node.source) if each is not None)]
    derived = {found for source in sources if member.owner in source.text for found in builds.findall(source.text)}
    names = re.compile(rf"\b(?:{'|'.join(map(re.escape, (member.owner, *sorted(derived))))})\b")
    known = {node.source.absolute, declaring.absolute}
    for each in package_sources(nodes, node.source):
        if each is None or each.absolute in known:
            continue
        if re.search(rf"\b{name}\b", each.text) and names.search(each.text):
            if not re.search(rf"\b(?:class|struct)\s+{owner}\b\s*(?:final\s*)?[:{{]", each.text):
                return True
    return False
