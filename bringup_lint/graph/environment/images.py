"""Container images whose contents are known: official ROS images, and what a Dockerfile puts on top of them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.containers.base_images import variant_of
from bringup_lint.graph.containers.ros_in_image import distro_of
from bringup_lint.graph.environment.image_steps import may_bring
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.model.compose import Service
    from bringup_lint.model.compose import Volume
    from bringup_lint.model.dockerfile import Stage

RMW = "RMW_IMPLEMENTATION"
PACKAGES = {
    "rmw_cyclonedds_cpp": "rmw-cyclonedds-cpp",
    "rmw_zenoh_cpp": "rmw-zenoh-cpp",
    "rmw_connextdds": "rmw-connextdds",
    "rmw_gurumdds_cpp": "rmw-gurumdds-cpp",
}
"""Middlewares that no official image brings, with the end of their package's name."""

_COMMENT = regex(r"<!--(?:[^-]|-(?!-))*-->|(?m:^[ \t]*#.*$)")
"""Comments of XML, in which two dashes only end one, and lines of a comment elsewhere."""
_MOST = 64 * 1024
"""Characters of a list of repositories, a manifest or a script that are read."""


class MissingMiddleware(NamedTuple):
    """A middleware that is selected in an image without it."""

    variable: Variable
    image: Located
    package: str
    """The Debian package that would bring it."""


def missing_middleware(compose: Compose, processes: Iterable[RosProcess]) -> Iterator[MissingMiddleware]:
    """Every place that selects a middleware which the described image surely does not contain."""
    from bringup_lint.graph.runners.containers import image_variables

    if _holds_middleware(compose.tree):
        return
    found: dict[object, MissingMiddleware] = {}
    for process in processes:
        variable = process.environment.get(RMW)
        if process.service is not None and variable is not None:
            for each in _of_service(compose, process.service, variable):
                found.setdefault(each.variable.value.span, each)
    for service in compose.whole_services:
        for name, value in compose.variables(service, RMW):
            variable = Variable(name, value, None if "$" in value else str(value), "environment:")
            for each in _of_service(compose, service, variable):
                found.setdefault(each.variable.value.span, each)
    for dockerfile in compose.images.dockerfiles:
        stage = dockerfile.final
        if stage is None or any(compose.variables(service, RMW) for service in compose.users(stage)):
            continue
        variables = [each for one in reversed(list(stage.chain)) for each in image_variables(one)]
        selected = [each for each in variables if each.name == RMW]
        if not selected:
            continue
        for each in _of_stage(compose, stage, selected[-1]):
            found.setdefault(each.variable.value.span, each)
    yield from found.values()


def _holds_middleware(tree: Tree) -> bool:
    """Whether the workspace may build one, or one of its packages needs one."""
    manifests = list(tree.named("package.xml"))
    folders = [*tree.submodules, *map(os.path.dirname, manifests)]
    if any(os.path.basename(folder).startswith(("rmw_", "cyclonedds")) for folder in folders):
        return True
    lists = (path for path in tree.paths if path.endswith((".repos", ".rosinstall")))
    return any("rmw_" in _COMMENT.sub("", tree.head(path, _MOST)) for path in (*lists, *manifests))


def _of_service(compose: Compose, service: Service, variable: Variable) -> Iterator[MissingMiddleware]:
    own = " ".join(service.scripts)
    if re.search(r"\bapt|\bros-", own) or any(_may_bring_ros(compose.tree, service, each) for each in service.volumes):
        return
    stage = compose.stage(service)
    if stage is not None:
        yield from _of_stage(compose, stage, variable)
    elif service.build is None and service.image is not None and not compose.extends_elsewhere(service):
        yield from _lacks(service.image, variant_of(service.image), variable)


def _may_bring_ros(tree: Tree, service: Service, volume: Volume) -> bool:
    """Whether a volume may bring packages of ROS; the folders of the tree, which are known, bring none."""
    if volume.source is not None and re.match(r"\.{1,2}(?:/|$)", volume.source):
        folder = os.path.join(os.path.dirname(service.source.absolute), volume.source)
        if tree.exists(os.path.normpath(folder)):
            return False
    return bool(re.search(r"/opt(?:/|$)|ws(?:/|$)|install(?:/|$)", str(volume.target)))


def _of_stage(compose: Compose, stage: Stage, variable: Variable) -> Iterator[MissingMiddleware]:
    package = PACKAGES.get(variable.text or "", "")
    if package and not may_bring(package, stage, compose.images, compose.tree):
        yield from _lacks(list(stage.chain)[-1].image, distro_of(stage), variable)


def _lacks(place: Located, distro: str, variable: Variable) -> Iterator[MissingMiddleware]:
    if distro and variable.text in PACKAGES:
        yield MissingMiddleware(variable, place, f"ros-{distro}-{PACKAGES[variable.text]}")
