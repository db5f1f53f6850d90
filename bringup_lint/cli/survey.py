"""What a tree says about the configuration that it needs: settings that change something, each with its evidence."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.config import ROS_DISTROS
from bringup_lint.discover.gitignore import escaped
from bringup_lint.facts.ros.simulation import is_simulator
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_path
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers import package_xml
from bringup_lint.pattern import regex
from bringup_lint.plural import counted
from bringup_lint.toml import holds

if TYPE_CHECKING:
    from bringup_lint.robot import Robot
    from bringup_lint.source import Source


class Setting(NamedTuple):
    """An entry of the configuration."""

    table: str
    """The key, or the table that the entry is in."""
    name: str
    """The path in a table; empty for a key of its own."""
    value: str
    why: str
    """What the tree says for it."""
    folder: str = ""
    """The folder that is left out, or has a purpose of its own."""
    errors: int = 0
    """How many errors in this folder are no longer reported as such."""
    warnings: int = 0


PLACES = {
    "systemd-unit": "/etc/systemd/system",
    "udev-rules": "/etc/udev/rules.d",
    "netplan": "/etc/netplan",
    "logrotate": "/etc/logrotate.d",
    "sysctl": "/etc/sysctl.d",
    "tmpfiles": "/etc/tmpfiles.d",
    "sysusers": "/etc/sysusers.d",
    "sudoers": "/etc/sudoers.d",
}
"""Where files of a kind go, by the manual of their reader."""

_OTHERS = regex(r"(?i)^(?:README|LICENSE|COPYING|\.git(?:keep|ignore)|CMakeLists\.txt|.*\.md)$")
_VENDORED = regex(r"(?i)^(?:third[_-]?part(?:y|ies)|3rd[_-]?party|vendor|vendored|externals?|extern|submodules)$")
_INPUTS = regex(r"(?i)^(?:fixtures?|test[_-]?data|testdata|golden|snapshots?)$")
_WORKFLOW = regex(r"(?:^|/)\.github/workflows/[^/]+\.ya?ml$|(?:^|/)\.gitlab-ci\.yml$")
_DISTRO = regex(rf"\b(?:{'|'.join(ROS_DISTROS)})\b", re.I)
_PURPOSES = (
    (Purpose.DEVELOPMENT, regex(r"(?i)^(?:sandbox|playground|scratch|experiments?|wip|prototypes?|notebooks?|spike)$")),
    (Purpose.ARCHIVE, regex(r"(?i)^(?:outdated|stale|graveyard|trash|do_?not_?use|previous|superseded)$")),
    (
        Purpose.EXAMPLE,
        regex(
            r"(?i)^(?:skeletons?|boilerplate|.*cookiecutter.*|(?:.*[_-])?(?:package|pkg|project)[_-]templates?"
            r"|templates?[_-](?:package|pkg|project)s?)$"
        ),
    ),
    (Purpose.TEST, regex(r"(?i)^(?:benchmarks?|hil|e2e)$")),
)
_OF_BUILDROOT = "external.desc"
"""At the top of a Buildroot external tree, which holds what a project adds to Buildroot."""
_HEAD = 64 * 1024
"""Bytes of a workflow that are read."""


def settings(robot: Robot) -> list[Setting]:
    """The settings of a tree, those of one table together."""
    left_out = list(_exclude(robot))
    kept = [source for source in robot.sources if source.judged and not _is_in(source, left_out)]
    purposes = list(_purposes(robot, kept))
    deployed = [source for source in kept if not _is_in(source, purposes)]
    found = [*_target(robot), *left_out, *_deploy(robot, deployed), *purposes]
    return [each for each in found if holds(each.name + each.value + each.why)]


def _is_in(source: Source, folders: Iterable[Setting]) -> bool:
    return any(source.name.startswith(each.folder) for each in folders)


def _target(robot: Robot) -> Iterator[Setting]:
    """The ROS distribution, where exactly one is named: by the tree, or where it names none by CI."""
    target = robot.target
    if target.ros:
        yield Setting("target-ros", "", target.ros, f"{target.ros_why}; set here, it also holds for a part of the tree")
    elif not target.ros_named:
        yield from _target_of_ci(robot)


def _target_of_ci(robot: Robot) -> Iterator[Setting]:
    """The one distribution that workflows name: on a line about ROS, and no other one on any line, as in a matrix."""
    named: dict[str, str] = {}
    anywhere: set[str] = set()
    for path in filter(_WORKFLOW.search, robot.tree.paths):
        text = robot.tree.head(path, _HEAD).lower()
        anywhere.update(_DISTRO.findall(text))
        for name in (name for line in text.splitlines() if "ros" in line for name in _DISTRO.findall(line)):
            named.setdefault(name, os.path.relpath(path))
    if len(named) == 1 and len(anywhere) == 1:
        ((name, path),) = named.items()
        yield Setting("target-ros", "", name, f"named in {path}")


def _exclude(robot: Robot) -> Iterator[Setting]:
    """The topmost folders that hold files which are not the robot's own."""
    submodules = {os.path.relpath(path) for path in robot.tree.submodules}
    found: dict[str, str] = {}
    for source in robot.sources:
        if not source.judged or source.robot_path is not None:
            continue
        for folder in _folders(source.name):
            why = found.get(folder) or _why_excluded(robot, folder, submodules)
            if why:
                found[folder] = why
                break
    for folder, why in sorted(found.items()):
        count = sum(source.judged and source.name.startswith(f"{folder}/") for source in robot.sources)
        why = f"{why}; {counted(count, 'file')} of a known kind"
        yield Setting("exclude", "", f"/{escaped(folder)}/", why, f"{folder}/")


def _why_excluded(robot: Robot, folder: str, submodules: set[str]) -> str:
    name = folder.rpartition("/")[2]
    if folder in submodules:
        return "a git submodule"
    if _VENDORED.match(name) and not os.path.lexists(os.path.join(folder, _OF_BUILDROOT)):
        return "by its name, code of others"
    if _INPUTS.match(name):
        return "by its name, inputs of tests"
    return "left out by .gitignore" if robot.tree.is_left_out(folder) else ""


def _folders(path: str) -> Iterator[str]:
    """The folders above a file, from the top down."""
    parts = path.split("/")[:-1]
    for count in range(1, len(parts) + 1):
        if not os.path.isabs(path) and parts[0] != "..":
            yield "/".join(parts[:count])


def _purposes(robot: Robot, sources: list[Source]) -> Iterator[Setting]:
    """The folders whose path does not say what they are for, but their name or package does."""
    folders = {folder for source in sources for folder in _folders(source.name)}
    unsaid = (folder for folder in folders if by_path(f"{folder}/") is Purpose.ROBOT)
    found = {folder: purpose for folder in unsaid for purpose in _purpose_of(robot, folder)}
    for folder, (purpose, why) in sorted(found.items()):
        if not any(folder.startswith(f"{other}/") for other in found):
            yield Setting("purpose", f"{folder}/", purpose.value, why, f"{folder}/")


def _purpose_of(robot: Robot, folder: str) -> Iterator[tuple[Purpose, str]]:
    name = folder.rpartition("/")[2]
    for purpose, pattern in _PURPOSES:
        if pattern.match(name) and not (purpose is Purpose.EXAMPLE and _is_of_ansible(robot, folder)):
            yield purpose, "by its name"
            return
    manifest = next((each for each in robot.of_kind("ros-package") if each.name == f"{folder}/package.xml"), None)
    if manifest is None:
        return
    package = package_xml.parse(manifest)
    purpose = by_path(f"{package.name}/") if package.name else Purpose.ROBOT
    simulators = [str(depend) for _, depend in package.depends if is_simulator(depend)]
    if purpose is Purpose.SIMULATION and simulators:
        yield purpose, f"package {package.name}, which depends on {simulators[0]}"


def _is_of_ansible(robot: Robot, folder: str) -> bool:
    """Whether a folder lies in an Ansible role, or beside playbooks or below: what it holds is deployed."""
    if "roles" in folder.split("/")[:-1]:
        return True
    above = {os.path.dirname(folder), *_folders(folder)}
    return any(os.path.dirname(source.name) in above for source in robot.of_kind("ansible"))


def _deploy(robot: Robot, sources: list[Source]) -> Iterator[Setting]:
    """The folders of files whose place on the robot follows from their kind, or from the unit that names them."""
    mine = [
        source
        for source in sources
        if source.robot_path is None and robot.purpose(source) is Purpose.ROBOT and not os.path.isabs(source.name)
    ]
    for kind, place in PLACES.items():
        names = [source.name for source in mine if source.kind == kind and not source.template]
        yield from _placed(robot, names, place, f"{kind.replace('-', ' ')} files")
    referred: dict[str, list[tuple[str, str]]] = defaultdict(list)
    for used in robot.env_files:
        path = str(used.readers[0].value).lstrip("-")
        if used.source in mine and path.endswith(f"/{used.source.basename}"):
            referred[os.path.dirname(path)].append((used.source.name, used.readers[0].unit.name))
    for place, pairs in sorted(referred.items()):
        yield from _placed(robot, [name for name, _ in pairs], place, f"read there by {pairs[0][1]}")


def _placed(robot: Robot, names: list[str], place: str, why: str) -> Iterator[Setting]:
    """The one folder of the files, where it holds nothing else, or the one file; two folders may be of two robots."""
    folders = Counter(os.path.dirname(name) for name in names)
    if len(folders) != 1:
        return
    (folder,) = folders
    beside = (os.path.relpath(path) for path in robot.tree.paths)
    others = [path for path in beside if path.startswith(f"{folder}/") and path not in names]
    if folder and not any(not _belongs(path[len(folder) + 1 :]) for path in others):
        yield Setting("deploy", folder, place, why)
    elif len(names) == 1:
        yield Setting("deploy", names[0], f"{place}/{os.path.basename(names[0])}", why)


def _belongs(path: str) -> bool:
    """Whether a file goes with the others of its folder: a drop-in or a link of units, or nothing that is deployed."""
    return bool(_OTHERS.match(path.rpartition("/")[2])) or path.split("/")[0].endswith((".d", ".wants", ".requires"))
