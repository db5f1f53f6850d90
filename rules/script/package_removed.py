"""apt is told to install a package that the Ubuntu of the robot no longer has.

## What it finds
Packages that a release of Ubuntu dropped, in images and scripts for that release or a later one: the packages of
Python 2 (`python-pip`, `python-serial`), `python3-distutils`, `libgl1-mesa-glx` and `gazebo` on 24.04,
`qt5-default` on 22.04. The release is that of the base image, which is 24.04 or later for `ros:rolling`, or that of
the ROS distribution of the robot. What no supported release has is found without it, also in lists of packages; it is a
warning then, and info where a file or the README names Debian 10 (buster) or an older release, which may have it: no
Debian that is supported does.

Silent where a command may fail (`||`), only runs under a condition, or another repository is added.

## Why it matters on a robot
apt installs all or nothing: "Package has no installation candidate" for one, and every other package of the command is
missing, too. The build of the image stops.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get update && apt-get install -y libgl1-mesa-glx python3-opencv
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get update && apt-get install -y libgl1 python3-opencv
```

## When to ignore it
When a repository of one's own has the package.

## References
- https://packages.ubuntu.com
- https://discourse.ubuntu.com/t/ubuntu-24-04-lts-noble-numbat-release-notes
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of
from bringup_lint.api.docker import oldest_codename
from bringup_lint.api.host import removed_package
from bringup_lint.api.ros import codename_of
from bringup_lint.api.shell import unwrapped

APTS = ("apt", "apt-get")
TESTS = ("[", "[[", "test")
OTHER_SOURCES = regex(
    r"add-apt-repository|sources\.list|ppa:|\bdeb \[|mongodb\.org"
    r"|\b(?:lsb_release|VERSION_CODENAME|VERSION_ID|os-release)\b"
)
"""What brings other packages, or lets a script ask which release it runs on."""
LINE = regex(r"^[ \t]*(?P<name>[a-z0-9][a-z0-9.+-]*)[ \t]*$", re.M)
OF_APT = regex(r"^(?:python3-[a-z0-9-]+|lib[a-z0-9.+-]+-dev|build-essential)[ \t]*$", re.M)
"""What a list of packages for apt has, and one for pip has not."""
OLD_DEBIAN = regex(
    r"\b(?:buster|stretch|jessie|wheezy)\b|\b(?:debian|raspbian|raspberry[ \t]{1,4}pi[ \t]{1,4}os)\b"
    r"(?:[ \t]{1,4}gnu/linux)?[ \t:]{1,4}(?:version[ \t]{1,4})?(?:[789]|10)\b",
    re.I,
    hints="buster stretch jessie wheezy debian raspb",
)
"""The releases of Debian that may have what no supported Ubuntu has, and no supported Debian."""
NOR_DEBIAN = ", and no supported Debian (12 or later) has it"
"""Of what all supported releases of Ubuntu lack; which older Debian, and so Raspberry Pi OS, has it differs."""
PAGE = regex(r"(?:^|/)README[^/]*$")
MOST = 200_000


@rule("error", symptoms=["E: Package '*' has no installation candidate", "E: Unable to locate package *"])
def package_removed(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            codename = oldest_codename(stage.origin)
            if codename and not file.source.says(OTHER_SOURCES) and not robot.compose.images.is_chosen(stage, tag=True):
                yield from _findings(robot, _of_stage(stage), codename, [note(stage.start.value, "the image")])
    codename = codename_of(robot.target.ros) if robot.target.ros is not None else ""
    words: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run(*APTS):
        if run.certain and run.command.ends != "||" and not run.command.hides_errors:
            words.setdefault(source, []).extend(_installed(run.words))
    for source, named in words.items():
        if not source.says(OTHER_SOURCES):
            yield from _findings(robot, named, codename, [])
    for source in robot.of_kind("pip-requirements"):
        if source.judged and source.says(OF_APT):
            yield from _findings(robot, _lines(source), codename, [])


def _findings(robot: Robot, words: Iterable[Located], codename: str, related: list[Related]) -> Iterator[Finding]:
    """One finding for all packages that a stage or script names, at the one that is gone for longest."""
    gone = [(word, found) for word in words if (found := removed_package(str(word), codename)) is not None]
    if gone:
        (word, (since, instead)), *others = sorted(gone, key=lambda each: each[1][0])
        none = f"From Ubuntu {since} on there is no {word}{'' if codename else NOR_DEBIAN}"
        yield finding(
            word,
            f"{none}: apt installs none of the packages that are named with it",
            advice=f"install {instead}" if instead else "leave it out",
            severity=None if codename else "info" if _may_be_old_debian(robot) else "warning",
            related=[*related, *(note(other, f"nor {other}, from {when} on") for other, (when, _) in others)],
        )


def _may_be_old_debian(robot: Robot) -> bool:
    return robot.mentions(OLD_DEBIAN) or robot.tree.says(PAGE, MOST, OLD_DEBIAN)


def _of_stage(stage: Stage) -> Iterator[Located]:
    """What the steps install that run whatever the image is, and that may not fail."""
    guarded = False
    for command in commands_of(stage):
        if not command.depth and not guarded and command.ends != "||":
            yield from _installed(unwrapped(command.words))
        guarded = command.ends == "&&" and (guarded or command.name in TESTS)


def _installed(words: Sequence[Located]) -> Iterator[Located]:
    if words and words[0] in APTS and "install" in words[:5]:
        yield from words[1:]


def _lines(source: Source) -> Iterator[Located]:
    return (source.located(*found.span("name")) for found in LINE.finditer(source.text))
