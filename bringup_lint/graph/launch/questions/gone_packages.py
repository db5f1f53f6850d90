"""Public packages that launch files start or include from, and that the robot's distribution does not have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.public_programs import PublicPackage
from bringup_lint.facts.ros.public_programs import public_package
from bringup_lint.graph.launch.python_api import distribution_of
from bringup_lint.graph.launch.python_api import looks_at_distribution
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import literal
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch


class GonePackage(NamedTuple):
    name: Located
    package: PublicPackage
    distro: str | None
    """The distribution that no longer has it; None when none of ROS 2 has it."""
    always: bool
    """It is needed whenever the file is launched without arguments."""


def gone_packages(launch: Launch) -> Iterator[GonePackage]:
    """Each place once; files of ROS 1 are left out, because launch rejects them before."""
    seen = set()
    for name, file, always in (*_of_nodes(launch), *_of_includes(launch)):
        if name.span in seen or file.ros1 or looks_at_distribution(file):
            continue
        seen.add(name.span)
        package = public_package(name)
        distro = distribution_of(launch, file)
        in_tree = name in launch.workspace.packages or name in launch.workspace.ambiguous
        if package is not None and not in_tree and package.is_gone(distro):
            yield GonePackage(name, package, distro if package.last != "ros1" else None, always)


def _of_nodes(launch: Launch) -> Iterator[tuple[Located, LaunchFile, bool]]:
    for node in launch.nodes:
        name = literal_text(node.package)
        if name is not None:
            yield name, node.file, node.by_default is True


def _of_includes(launch: Launch) -> Iterator[tuple[Located, LaunchFile, bool]]:
    for file in launch.judged:
        for include in launch.expansion(file).includes:
            if include.source is not file or include.target is not None:
                continue
            for value in walk(include.file):
                name = literal(value.package) if isinstance(value, PackageShare) else None
                if name is not None:
                    yield name, file, not include.conditions
