"""pip is told to install a project that it cannot install, or another one than is meant.

## What it finds
In lists of requirements and in commands of scripts and images:

- names that PyPI does not have: `pkg_resources==0.0.0`, which pip of Debian once wrote into lists, modules that Python
  brings (`os`, `time`), modules of another project (`cv2`), packages of ROS (`rclpy`, `sensor_msgs`);
- projects whose newest release ends its own installation: `sklearn` without a version, `logging`;
- projects that are not the library whose module the programs of the tree import: `serial` in place of `pyserial`,
  `board` in place of `adafruit-blinka`; info where the same list or command installs the library, too, by its name or
  with another project that needs it: then the order decides whose module stays.

Silent where another index is named, for requirements with a condition, and for the third kind in a tree of which no
Python file imports the module.

## Why it matters on a robot
pip installs all or nothing: one such line, and every library of the list is missing on the new robot. Of the third kind
it installs a stranger's module of the same name, and the driver ends with "module 'serial' has no attribute 'Serial'".

## Bad
```
numpy
pkg_resources==0.0.0
serial
```

## Good
```
numpy
pyserial
```

## When to ignore it
When pip asks an index of one's own that has the project.

## References
- https://bugs.launchpad.net/ubuntu/+source/python-pip/+bug/1635463, pkg-resources==0.0.0 in pip freeze
- https://github.com/scikit-learn/sklearn-pypi-package
- https://pypi.org/project/serial
"""

import re
from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.ros import pip_names
from bringup_lint.api.shell import unwrapped

PIPS = ("pip", "pip3", "python", "python3", "uv")
NAME = regex(r"(?P<name>[A-Za-z0-9][\w.-]*)(?:\[[\w, -]{0,100}\])?(?P<version>[=<>!~][^#;\"']*)?$")
OTHER_INDEX = regex(r"(?:^|\s)(?:-i|-f|--(?:extra-)?index-url|--find-links)\b")
INDEX_IN_IMAGE = regex(r"PIP_(?:EXTRA_)?INDEX_URL|PIP_FIND_LINKS")
PINNED = regex(r"={2}|~=|<")
ALWAYS_REFUSED = ("logging", "multiprocessing")
VALUED = ("-r", "-c", "-e", "-t", "--requirement", "--constraint", "--editable", "--target", "--root", "--prefix")
PROGRAM = regex(r"\.py$")
MOST = 20_000
"""Characters of a program in which an import is looked for."""
DEBIAN = "pkg-resources"
BLINKA = "adafruit-blinka"
ON_BLINKA = "adafruit-circuitpython-"
"""Projects that need Blinka."""


@rule(
    "warning",
    symptoms=[
        "ERROR: Could not find a version that satisfies the requirement *",
        "ERROR: No matching distribution found for *",
        "The 'sklearn' PyPI package is deprecated, use 'scikit-learn'",
        "module 'serial' has no attribute 'Serial'",
    ],
)
def pip_name(robot: Robot) -> Iterator[Finding]:
    for group in _requirements(robot):
        found = [(word, version, re.sub(r"[-_.]+", "-", word.lower())) for word, version in group]
        installed = {name for _, _, name in found}
        for word, version, name in found:
            yield from _judged(robot, word, version, name, installed)


def _judged(robot: Robot, word: Located, version: str, name: str, installed: set[str]) -> Iterator[Finding]:
    """The finding for a project, beside the others of its list or command."""
    what, instead = pip_names().get(name, ("", ""))
    if what == "absent":
        yield finding(
            word,
            f"PyPI has no project {word}: pip stops, and installs none of the packages that are named with it",
            advice=_advice(name, instead),
        )
    elif what == "refused" and (name in ALWAYS_REFUSED or not PINNED.search(version)):
        yield finding(
            word,
            f"The project {word} of PyPI ends its own installation: pip stops, and installs none of the packages "
            "that are named with it",
            advice=_advice(name, instead),
        )
    elif what == "other":
        user = _user_of(robot, name)
        if user is not None:
            is_beside = _is_installed(instead, installed)
            effect = (
                f"it and {instead} overwrite each other" if is_beside else "they end with an error where they use it"
            )
            yield finding(
                word,
                f"The project {word} of PyPI is not the library whose module {name} the programs import: {effect}",
                advice="leave it out" if is_beside else f"write {instead}",
                related=[note(user, "imports the module")],
                severity="info" if is_beside else None,
            )


def _is_installed(project: str, installed: set[str]) -> bool:
    """Whether a project is installed by its name, or because others need it."""
    if project in installed:
        return True
    return project == BLINKA and any(name.startswith(ON_BLINKA) for name in installed)


def _advice(name: str, instead: str) -> str:
    if name == DEBIAN:
        return "leave the line out: pip of Debian wrote it by mistake, and setuptools has the module"
    if not instead:
        return "leave it out: Python brings the module"
    return f"write {instead}" if " of apt" not in instead else f"leave it out, and install {instead}"


def _requirements(robot: Robot) -> Iterator[Iterator[tuple[Located, str]]]:
    """The projects that each list and command names, each with what is said of its version."""
    for source in robot.of_kind("pip-requirements"):
        if source.judged and not OTHER_INDEX.search(source.text):
            yield _of_list(source)
    for source, run in robot.scripts.run(*PIPS):
        if not source.says(INDEX_IN_IMAGE):
            yield _of_command(run.words)
    for file in robot.dockerfiles:
        if "pip" in file.source.text and not file.source.says(INDEX_IN_IMAGE):
            for stage in file.stages:
                for command in commands_of(stage):
                    yield _of_command(unwrapped(command.words))


def _of_list(source: Source) -> Iterator[tuple[Located, str]]:
    at = 0
    for line in source.text.splitlines(keepends=True):
        found = NAME.match(line.partition("#")[0].strip())
        if found is not None:
            start = at + len(line) - len(line.lstrip())
            yield source.located(start, start + found.end("name")), found["version"] or ""
        at += len(line)


def _of_command(words: tuple[Located, ...]) -> Iterator[tuple[Located, str]]:
    if len(words) > 2 and words[1] == "-m" and words[2] == "pip":
        words = words[2:]
    elif len(words) > 1 and words[0] == "uv" and words[1] == "pip":
        words = words[1:]
    if len(words) < 2 or words[1] != "install" or words[0].rpartition("/")[2] not in ("pip", "pip3"):
        return
    if OTHER_INDEX.search(" ".join(words)):
        return
    for before, word in pairwise(words[1:]):
        found = NAME.match(word)
        if found is not None and before not in VALUED:
            yield word.part(0, found.end("name")), found["version"] or ""


def _user_of(robot: Robot, module: str) -> Source | None:
    """A program that imports a module which no file of the tree has."""
    if any(True for _ in robot.tree.named(f"{module}.py")):
        return None
    imports = re.compile(rf"^[ \t]*(?:import|from)[ \t]+{re.escape(module)}\b", re.M)
    for path in robot.tree.like(PROGRAM):
        if imports.search(robot.tree.head(path, MOST)):
            return robot.tree.at(path)
    return None
