"""Modules beside a Python program that CMake installs, and that it leaves in the source."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dependencies.imports import imported
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.package import Install


class LeftBeside(NamedTuple):
    """A module that a program imports from its own folder, and that CMake does not install there."""

    module: Located
    path: str
    """From the folder of the package."""
    program: Install


def left_beside(tree: Tree, package: Package) -> Iterator[LeftBeside]:
    """What the scripts that CMake installs as programs import, each module at its first use."""
    if not package.installs_known or any(build.installs_python for build in package.builds):
        return
    found: set[str] = set()
    for build in package.builds:
        for install in build.installs:
            path = os.path.normpath(os.path.join(os.path.dirname(build.source.absolute), install.source))
            is_program = not install.tree and install.destination.strip("/") == f"lib/{package.name}"
            source = tree.at(path) if is_program and path.endswith(".py") else None
            if source is None or "sys.path" in source.text:
                continue
            for module in imported(source):
                name = module.partition(".")[0]
                beside = os.path.join(os.path.dirname(path), f"{name}.py")
                if name in found or name in sys.stdlib_module_names or not tree.is_file(beside):
                    continue
                found.add(name)
                if not any(package.origins(f"lib/{package.name}/{name}.py")):
                    yield LeftBeside(module, os.path.relpath(beside, package.folder), install)
