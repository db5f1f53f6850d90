"""Descriptions of plugins that no build exports to the ament index, where pluginlib looks for them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.xml import Element

_EXPORTS = regex(
    r"\b(?:pluginlib_export_plugin_description_file|ament_index_register_resource)\b\s*\([^()]*\$\{"
    r"|\binclude\([^()\n]*(?:/|\$)"
    r"|^[ \t]*(?!(?i:pluginlib_))\w{0,80}(?i:plugin)\w{0,80}[ \t]*\(",
    re.M,
)
"""What may export a file under any name."""
_INSTALLS = regex(r"(?i:\binstall)\s*\([^()]*\)")
"""Commands that only copy what they name."""
_END = regex(r"^[ \t]*(ament_(?:auto_)?package)[ \t]*\(", re.M)
_LIBRARY = regex(r"^(?:.*/)?(?:lib)?([^/]+?)(?:\.so)?$")
_OF_ROS1 = "nodelet::Nodelet"
"""The base of nodelets, which ROS 2 does not load."""
_MOST = 200_000
"""Characters of a source that are looked at."""


class Unexported(NamedTuple):
    name: Located
    """The class that pluginlib does not find."""
    base: str
    description: Source
    path: str
    """Of the description, relative to the package."""
    end: Span
    """``ament_package()``, above which the export belongs."""
    copied: Span | None
    """What installs the description as a file like others."""


def unexported(files: Files, package: Package) -> Iterator[Unexported]:
    """The first class of each description whose library a package builds, and which its build does not name."""
    builds = [build for build in package.builds if build.source.kind == "cmake"]
    text = "\n".join(build.source.text for build in builds).replace("${PROJECT_NAME}", package.name)
    end = _END.search(builds[0].source.text) if builds else None
    if end is None or not package.complete or _EXPORTS.search(text):
        return
    targets = {target for build in builds for target in build.targets}
    named = _INSTALLS.sub("", text)
    descriptions = (path for path in files.tree.walked_below(package.folder) if path.endswith(".xml"))
    unnamed = (path for path in descriptions if os.path.basename(path) not in named)
    described = [(path, found) for path in unnamed if (found := _first_class(files.tree.at(path), targets))]
    if not described or not _makes_plugins(files, package):
        return
    for path, found in described:
        place = found.get("name") or found.get("type")
        if place is not None:
            span, base = builds[0].source.span(*end.span(1)), str(found.get("base_class_type"))
            yield Unexported(place, base, place.span.source, _below(path, package), span, _copied(path, package))


def _makes_plugins(files: Files, package: Package) -> bool:
    """Whether the sources of a package name classes for pluginlib."""
    code = (path for path in files.tree.walked_below(package.folder) if path.endswith(CPP))
    return any("PLUGINLIB_EXPORT_CLASS" in files.tree.head(path, _MOST) for path in code)


def _below(path: str, package: Package) -> str:
    return os.path.relpath(path, package.folder)


def _copied(path: str, package: Package) -> Span | None:
    for build in package.builds:
        folder = os.path.dirname(build.source.absolute)
        for each in build.installs:
            if os.path.normpath(os.path.join(folder, each.source)) == os.path.abspath(path):
                return each.where
    return None


def _first_class(source: Source | None, targets: set[str]) -> Element | None:
    """The first class in one of the libraries; None when the file describes no plugins of them."""
    root = parse(source).root if source is not None and "base_class_type" in source.text else None
    if root is None:
        return None
    for element in root.walk():
        library = element.parent
        match = _LIBRARY.match(str(library.get("path") or "")) if library is not None else None
        base = element.get("base_class_type")
        if element.local == "class" and base and base != _OF_ROS1 and match and match[1] in targets:
            return element
    return None
