"""What the steps of a container image may bring unseen."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.ros_in_image import distro_of
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.images import Images
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Instruction
    from bringup_lint.model.dockerfile import Stage

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
_WORKSPACE = regex(r"(?!/opt/ros(?:/|$))(?:[^/\s]{0,80}/){0,9}(?:install|[\w-]{0,60}ws)(?:/|$)")
_MOST = 64 * 1024
"""Characters of a script that are read."""


def may_bring(package: str, stage: Stage, images: Images, tree: Tree) -> bool:
    """Whether the steps of a stage name a Debian package of a middleware, without its distribution, or may bring it
    unseen."""
    file = next((each for each in images.dockerfiles if stage in each.stages), None)
    if any(_is_unknown(each, file, tree) for each in _instructions(stage)):
        return True
    said = _commands(stage)
    known = any(tree.named("package.xml")) and not _FETCHES.search(said)
    return package in said.replace("_", "-") or bool(_ROSDEP.search(said) and not known) or _may_fetch(said, tree)


def _instructions(stage: Stage) -> Iterator[Instruction]:
    return (each for one in stage.chain for each in one.instructions)


def _is_unknown(instruction: Instruction, file: Dockerfile | None, tree: Tree) -> bool:
    """Whether an instruction may bring packages of ROS from an image or an archive; a workspace that another stage
    builds brings the packages of its sources alone."""
    if instruction.name == "ADD":
        return True
    origin = next((flag[7:] for flag in instruction.flags if flag.startswith("--from=")), None)
    words = instruction.value.split()
    if instruction.name != "COPY" or origin is None or not any(map(_OF_ROS.search, words)):
        return False
    stage = file.taken(origin) if file is not None and all(map(_WORKSPACE.match, words[:-1])) else None
    if stage is None or not distro_of(stage):
        return True
    return any(map(_takes, _instructions(stage))) or _may_fetch(_commands(stage), tree)


def _takes(instruction: Instruction) -> bool:
    """Whether an instruction brings files from an archive or another image."""
    return instruction.name == "ADD" or any("from=" in flag for flag in instruction.flags)


def _commands(stage: Stage) -> str:
    """The commands that build a stage, without what brings nothing."""
    steps = (each for each in _instructions(stage) if each.name == "RUN")
    return _OWN.sub("ros-x-", "\n".join(text for each in steps for text in (each.value, *each.heredocs)))


def _may_fetch(said: str, tree: Tree) -> bool:
    """Whether commands use lists of packages, programs or scripts that may bring a middleware."""
    scripts = {match["name"] for match in _SCRIPT.finditer(said)}
    own = (name for name in scripts if not _OF_SHELL.fullmatch(name))
    return bool(_OPAQUE.search(said)) or any(_is_opaque_script(name, tree) for name in own)


def _is_opaque_script(name: str, tree: Tree) -> bool:
    """Whether a script that a step runs may bring one: it is not in the tree, or it names one or what is opaque."""
    texts = [tree.head(path, _MOST) for path in tree.named(name)]
    return not texts or any("rmw" in text or _OPAQUE.search(text) or _ROSDEP.search(text) for text in texts)
