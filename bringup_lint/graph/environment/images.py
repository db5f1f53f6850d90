"""Container images whose contents are known: official ROS images, and what a Dockerfile puts on top of them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.containers.base_images import variant_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage

RMW = "RMW_IMPLEMENTATION"
PACKAGES = {
    "rmw_cyclonedds_cpp": "rmw-cyclonedds-cpp",
    "rmw_zenoh_cpp": "rmw-zenoh-cpp",
    "rmw_connextdds": "rmw-connextdds",
    "rmw_gurumdds_cpp": "rmw-gurumdds-cpp",
}
"""Middlewares that no official image brings, with the end of their package's name."""

_OPAQUE = regex(
    r"rosdep|\$\(|`|xargs|ansible|\b(?:curl|wget|git|vcs|colcon|cmake|make|pip3?|conda|mamba|dpkg|tar|cp|source)\b|\.sh\b"
    r"|\.deb\b|<<|install[^\n;&]*\$(?!\{?ROS_DISTRO)"
)
"""What may bring a middleware unseen."""
_OWN = regex(
    r"(?:\bsource|(?<!\S)\.)[ \t]+[\"']?/opt/ros/[^\s;&|\"']+/setup\.(?:ba)?sh|\bcolcon[ \t]+build\b|\bros-\$\{?\w+\}?-"
)
"""What brings nothing else: the environment of ROS, the build of a workspace without a middleware, and the part of a
package's name that names the distribution."""


_MOST = 64 * 1024
"""Characters of a list of repositories that are read."""


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
    for dockerfile in compose.images.dockerfiles:
        stage = dockerfile.final
        if stage is None:
            continue
        variables = [each for one in reversed(list(stage.chain)) for each in image_variables(one)]
        selected = [each for each in variables if each.name == RMW]
        if not selected:
            continue
        for each in _of_stage(stage, selected[-1]):
            found.setdefault(each.variable.value.span, each)
    yield from found.values()


def _holds_middleware(tree: Tree) -> bool:
    """Whether the workspace may build one."""
    folders = [*tree.submodules, *map(os.path.dirname, tree.named("package.xml"))]
    if any(os.path.basename(folder).startswith(("rmw_", "cyclonedds")) for folder in folders):
        return True
    lists = (path for path in tree.paths if path.endswith((".repos", ".rosinstall")))
    return any("rmw_" in tree.head(path, _MOST) for path in lists)


def _of_service(compose: Compose, service: Service, variable: Variable) -> Iterator[MissingMiddleware]:
    own = " ".join(service.scripts)
    if re.search(r"apt|install/|ws/", own) or any(_hides_ros(str(each.target)) for each in service.volumes):
        return
    stage = compose.stage(service)
    if stage is not None:
        yield from _of_stage(stage, variable)
    elif service.build is None and service.image is not None and not compose.extends_elsewhere(service):
        yield from _lacks(service.image, str(service.image), variable)


def _hides_ros(target: str) -> bool:
    """Whether a volume may bring packages of ROS."""
    return bool(re.search(r"/opt(?:/|$)|ws(?:/|$)|install(?:/|$)", target))


def _of_stage(stage: Stage, variable: Variable) -> Iterator[MissingMiddleware]:
    package = PACKAGES.get(variable.text or "", "")
    for one in stage.chain:
        for instruction in one.instructions:
            if instruction.name == "ADD" or (instruction.name == "COPY" and instruction.flags):
                return
            text = str(instruction.value) if instruction.name == "RUN" else ""
            if package in text.replace("_", "-") or _OPAQUE.search(_OWN.sub("", text)):
                return
    yield from _lacks(list(stage.chain)[-1].image, stage.origin, variable)


def _lacks(place: Located, image: str, variable: Variable) -> Iterator[MissingMiddleware]:
    distro = variant_of(image)
    if distro and variable.text in PACKAGES:
        yield MissingMiddleware(variable, place, f"ros-{distro}-{PACKAGES[variable.text]}")
