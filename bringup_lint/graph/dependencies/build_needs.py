"""What the builds and the C++ of a package ask of other packages."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP_SOURCES
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.graph.dependencies.needs import is_meant
from bringup_lint.graph.dependencies.required_packages import required_packages
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

_GENERATES, _RUNTIME = "rosidl_generate_interfaces", "rosidl_default_runtime"
_PREPROCESSOR = regex(
    r"^[ \t]*#[ \t]*(?:(?P<word>if|ifdef|ifndef|endif)\b|include[ \t]*[<\"](?P<folder>[a-z][a-z0-9_]*)/)", re.M, "#"
)
_UNGUARDED = (*CPP_SOURCES, ".c")
_SHARED = ("moveit",)
"""Folders of headers that several packages have, and not the one of that name, which has none (moveit2)."""


def of_builds(files: Files, launch: Launch) -> Iterator[Need]:
    """The packages that CMake must find in any case, or ends."""
    for package in launch.workspace.packages.values():
        for build in package.builds:
            if build.source.kind == "cmake" and os.path.dirname(build.source.absolute) == package.folder:
                for name, of_tests in required_packages(build.source):
                    yield Need("library", name, package, of_tests=of_tests)


def of_interfaces(files: Files, launch: Launch) -> Iterator[Need]:
    """What the messages, services and actions of a package need when nodes use them."""
    for package in launch.workspace.packages.values():
        generating = (
            _first_argument(build.source, _GENERATES) for build in package.builds if build.source.kind == "cmake"
        )
        where = next(filter(None, generating), None)
        if where is not None:
            yield Need("interfaces", Located(_RUNTIME, where), package)


def _first_argument(source: Source, name: str) -> Span | None:
    """The first argument of the first command of a name."""
    if name not in source.text:
        return None
    return next((each.arguments[0].span for each in commands(source) if each.name == name and each.arguments), None)


def of_headers(files: Files, launch: Launch) -> Iterator[Need]:
    """The packages whose headers the C++ of packages includes in any case."""
    for source in files.of_kind("cpp-node"):
        owner = launch.workspace.owner(source)
        if owner is None or not source.judged or not owner.builds or not is_meant(files, source, owner):
            continue
        for name in _included(source):
            if name in _SHARED:
                continue
            folders = (os.path.join(owner.folder, each, name) for each in ("include", "src", ""))
            package = launch.workspace.packages.get(str(name))
            if any(map(files.tree.exists, folders)) or (package is not None and not _offers(files, package, owner)):
                continue
            yield Need("header", name, owner)


def _offers(files: Files, package: Package, owner: Package) -> bool:
    """Whether another package of the workspace, which lies outside of the one that includes headers, has headers below
    its own name, or generates them."""
    folders = (os.path.join(package.folder, each) for each in (f"include/{package.name}", "msg", "srv", "action"))
    return not package.folder.startswith(f"{owner.folder}/") and any(map(files.tree.exists, folders))


def _included(source: Source) -> Iterator[Located]:
    """The first folders of the headers that no condition but an include guard surrounds, each once."""
    guards = 0 if source.name.endswith(_UNGUARDED) or "#pragma once" in source.text else 1
    depth, seen = 0, set[str]()
    for match in _PREPROCESSOR.finditer(source.text):
        if match["folder"] is None:
            depth += -1 if match["word"] == "endif" else 1
        elif depth <= guards and match["folder"] not in seen:
            seen.add(match["folder"])
            yield source.located(*match.span("folder"))
