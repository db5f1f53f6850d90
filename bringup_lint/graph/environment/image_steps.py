"""What the steps of a container image may bring unseen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.containers.ros_in_image import distro_of
from bringup_lint.graph.memo import memo
from bringup_lint.named_tuple import NamedTuple
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
_FETCHES = regex(r"\bgit\b[^\n;&]{0,300}\bclone\b|\b(?:curl|wget)\b[^\n;&]{0,300}\.(?:tar|zip|tgz)")
_ROSDEP = regex(r"\brosdep\b[^\n;&]{0,300}\binstall\b", hints="rosdep")
_SCRIPT = regex(r"(?<![\w.-])(?P<name>[\w.-]{1,80}\.(?:sh|bash|py))(?![\w.-])")
_OF_SHELL = regex(r"\.?(?:(?:local_)?setup|bashrc|profile|entrypoint)\.?(?:ba|z)?(?:sh|rc)?")
_OF_ROS = regex(r"(?:^|/)opt(?:/|$)|(?:^|[/_-])(?:ws|install|overlay|underlay)(?:/|$)|\bros2?\b|^/$|^/\s")
_WORKSPACE = regex(r"(?!/opt/ros(?:/|$))(?:[^/\s]{0,80}/){0,9}(?:install|[\w-]{0,60}ws)(?:/|$)")
_MOST = 64 * 1024
"""Characters of a script that are read."""


class _Steps(NamedTuple):
    """What a stage is made by."""

    said: str
    """Its commands, without what brings nothing."""
    is_open: bool
    """Whether an instruction may bring packages of ROS from an image or an archive."""


def may_bring(package: str, stage: Stage, images: Images, tree: Tree) -> bool:
    """Whether the steps of a stage name a Debian package of a middleware, without its distribution, or may bring it
    unseen."""
    steps = _steps(images, stage)
    if steps.is_open:
        return True
    known = any(tree.named("package.xml")) and not _FETCHES.search(steps.said)
    is_named = package in steps.said.replace("_", "-")
    return is_named or bool(_ROSDEP.search(steps.said) and not known) or _may_fetch(steps.said, tree)


@memo
def _steps(images: Images, stage: Stage) -> _Steps:
    file = next((each for each in images.dockerfiles if stage in each.stages), None)
    instructions = [each for one in stage.chain for each in one.instructions]
    return _Steps(_commands(instructions), _is_open(instructions, file, images.tree))


def _is_open(instructions: list[Instruction], file: Dockerfile | None, tree: Tree) -> bool:
    """Whether an instruction brings packages of ROS from an image or an archive; a workspace that another stage builds
    brings the packages of its sources alone."""
    known: set[Stage] = set()
    built: list[Instruction] = []
    for each in instructions:
        if each.name == "ADD":
            return True
        origin = next((flag[7:] for flag in each.flags if flag.startswith("--from=")), None)
        words = each.value.split()
        if each.name != "COPY" or origin is None or not any(map(_OF_ROS.search, words)):
            continue
        stage = file.taken(origin) if file is not None and all(map(_WORKSPACE.match, words[:-1])) else None
        if stage is None or (stage not in known and not distro_of(stage)):
            return True
        for one in stage.chain:
            if one in known:
                break
            known.add(one)
            built += one.instructions
    return any(map(_takes, built)) or (bool(known) and _may_fetch(_commands(built), tree))


def _takes(instruction: Instruction) -> bool:
    """Whether an instruction brings files from an archive or another image."""
    return instruction.name == "ADD" or any("from=" in flag for flag in instruction.flags)


def _commands(instructions: list[Instruction]) -> str:
    """The commands that build a stage, without what brings nothing."""
    steps = (each for each in instructions if each.name == "RUN")
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
