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
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.model.compose import Service
    from bringup_lint.model.compose import Volume
    from bringup_lint.model.dockerfile import Instruction
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
    r"xargs|ansible|\b(?:vcs|wstool|conda|mamba|micromamba|nix|pixi)\b|\|[ \t]*(?:sudo[ \t]+)?(?:ba|z)?sh\b"
    r"|rmw-[\w-]{0,20}\*|\*\.deb\b"
    r"|(?<![/\w.-])install[ \t][^\n;&]{0,900}\$(?!\{?ROS_DISTRO)|\bclone\b[^\n;&]{0,200}(?:rmw|dds|zenoh)"
    r"|(?:ros-[^\s-]{1,40}-|_)(?:turtlebot4|clearpath|irobot|rmf|autoware)"
)
"""What may bring a middleware unseen: lists of packages, programs that are fetched, and robots that need one."""
_OWN = regex(
    r"(?:\bsource|(?<!\S)\.)[ \t]+[\"']?[^\s;&|\"']+/(?:local_)?setup\.(?:ba|z)?sh"
    r"|\bros-\$\{?\w+\}?-|\$\{?ROS_DISTRO\}?"
)
"""What brings nothing else: the environment of ROS or of a workspace, and the part of a package's name that names the
distribution."""
_FETCHES = regex(r"\bgit\b[^\n;&]*\bclone\b|\b(?:curl|wget)\b[^\n;&]*\.(?:tar|zip|tgz)")
_ROSDEP = regex(r"\brosdep\b[^\n;&]*\binstall\b")
_SCRIPT = regex(r"(?<![\w.-])(?P<name>[\w.-]{1,80}\.(?:sh|bash|py))(?![\w.-])")
_OF_SHELL = regex(r"\.?(?:(?:local_)?setup|bashrc|profile|entrypoint)\.?(?:ba|z)?(?:sh|rc)?")
_OF_ROS = regex(r"(?:^|/)opt(?:/|$)|(?:^|[/_-])(?:ws|install|overlay|underlay)(?:/|$)|\bros2?\b|^/$|^/\s")


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
    chain = list(stage.chain)
    steps = [(one, each) for one in chain for each in one.instructions]
    if not package or any(_is_opaque_copy(one, each) for one, each in steps):
        return
    text = "\n".join(_said(each) for _, each in steps)
    if package in text.replace("_", "-") or _is_opaque(compose.tree, text):
        return
    yield from _lacks(chain[-1].image, distro_of(stage), variable)


def _said(instruction: Instruction) -> str:
    """The commands of a RUN without what brings nothing."""
    if instruction.name != "RUN":
        return ""
    return "\n".join([str(instruction.value), *map(str, instruction.heredocs)])


def _is_opaque_copy(stage: Stage, instruction: Instruction) -> bool:
    """Whether an instruction may bring packages of ROS from an image or an archive."""
    if instruction.name == "ADD":
        return True
    copies = instruction.name == "COPY" and any(flag.startswith("--from") for flag in instruction.flags)
    return copies and any(_OF_ROS.search(word) for word in instruction.value.split())


def _is_opaque(tree: Tree, text: str) -> bool:
    """Whether the steps of an image may bring a middleware that their text does not name."""
    said = _OWN.sub("ros-x-", text)
    known = any(tree.named("package.xml")) and not _FETCHES.search(said)
    if _OPAQUE.search(said) or (_ROSDEP.search(said) and not known):
        return True
    scripts = {match["name"] for match in _SCRIPT.finditer(said)}
    return any(_is_opaque_script(tree, name) for name in scripts if not _OF_SHELL.fullmatch(name))


def _is_opaque_script(tree: Tree, name: str) -> bool:
    """Whether a script that a step runs may bring one: it is not in the tree, or it names one or what is opaque."""
    found = list(tree.named(name))
    texts = [tree.head(path, _MOST) for path in found]
    return not texts or any("rmw" in text or _OPAQUE.search(text) or _ROSDEP.search(text) for text in texts)


def _lacks(place: Located, distro: str, variable: Variable) -> Iterator[MissingMiddleware]:
    if distro and variable.text in PACKAGES:
        yield MissingMiddleware(variable, place, f"ros-{distro}-{PACKAGES[variable.text]}")
