"""An image installs packages of a ROS distribution that its Ubuntu does not have.

## What it finds
`apt install ros-DISTRO-...` in an image whose Ubuntu is not the one that the distribution is built for: Foxy for 20.04,
Humble for 22.04, Jazzy for 24.04. The Ubuntu is known for images of Ubuntu, of ROS, of CUDA (`-ubuntu22.04`) and of
NVIDIA for Jetson (`l4t-jetpack:r36.4.0` is 22.04). A compose service that gives another base image to the build by an
ARG is judged, too.

Silent where the image adds another repository with packages of ROS, such as that of Isaac ROS.

## Why it matters on a robot
packages.ros.org has every distribution for one Ubuntu only. apt ends with "Unable to locate package", and the image for
the robot cannot be built, often only the variant for the Jetson while the one for the laptop is fine.

## Bad
```dockerfile
FROM nvcr.io/nvidia/l4t-jetpack:r36.4.0
RUN apt-get update && apt-get install -y ros-jazzy-ros-base
```

## Good
```dockerfile
FROM nvcr.io/nvidia/l4t-jetpack:r36.4.0
RUN apt-get update && apt-get install -y ros-humble-ros-base
```

## When to ignore it
When a repository of one's own has the packages.

## References
- REP 2000, releases and target platforms
- https://docs.nvidia.com/jetson/archives: Jetson Linux and its root file systems
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of
from bringup_lint.api.docker import substituted
from bringup_lint.api.docker import ubuntu_codename
from bringup_lint.api.ros import codename_of
from bringup_lint.api.shell import unwrapped

PACKAGE = regex(r"ros-(?P<distro>[a-z]+)-[a-z][\w*.=-]*")
TESTS = ("[", "[[", "test")
OTHER_SOURCES = regex(
    r"isaac|ppa:|\bconda\b|robostack|\bextrepo\b|\bsed\b[^\n]*sources\.list|\bdebs?/"
    r"|(?<![\w.])deb (?:\[[^\]\n]{0,200}\] ?)?(?:file|copy|ftp|https?)"
    r":(?!//(?:packages\.ros\.org|repo\.ros2\.org|[\w-]{1,40}(?:\.[\w-]{1,40}){0,3}\.ubuntu\.com|mirrors?\.))"
)
"""What may bring packages that packages.ros.org does not have for this Ubuntu."""
SOURCES = regex(r"sources\.list(?:\.d)?(?:/[\w.-]*)?[\s\"\]]*$")
"""The target of COPY and ADD."""


@rule("error", symptoms=["E: Unable to locate package ros-*"])
def packages_of_other_ubuntu(robot: Robot) -> Iterator[Finding]:
    seen: set[Stage] = set()
    for file in robot.dockerfiles:
        for stage in file.stages:
            if not seen.isdisjoint(stage.chain):
                continue
            codename = ubuntu_codename(stage.origin)
            if not codename or robot.compose.images.is_chosen(stage, tag=True):
                continue
            package = _foreign(stage, codename)
            if package is not None:
                seen.add(stage)
                yield _finding(package, stage.start.value, codename, package)
    yield from _of_services(robot)


def _of_services(robot: Robot) -> Iterator[Finding]:
    """The services that choose the base image by an ARG of the build."""
    for runner in robot.runners.all:
        if runner.service is None or runner.stage is None:
            continue
        given = runner.service.build_arguments
        bottom = list(runner.stage.chain)[-1]
        chosen = next((value for name, value in given.items() if value and name in bottom.image), None)
        if chosen is None:
            continue
        image = substituted(bottom.image, {name: value for name, value in given.items() if value})
        codename = ubuntu_codename(image)
        package = next((each for one in runner.stage.chain if (each := _foreign(one, codename))), None)
        if codename and package is not None:
            yield _finding(chosen, package, codename, package)


def _finding(place: Located, other: Located, codename: str, package: Located) -> Finding:
    distro = _distro(package)
    return finding(
        place,
        f"{distro.capitalize()} has packages for {codename_of(distro)} only, and this image is {codename}: "
        f"apt finds no {package}, and the build stops",
        advice="use an image of that Ubuntu, or the distribution of this one",
        related=[note(other, "the image" if place is package else "installs them")],
    )


def _foreign(stage: Stage, codename: str) -> Located | None:
    """The first package of a distribution for another Ubuntu that a step surely installs."""
    texts = (str(each.value) for one in stage.chain for each in one.all("RUN", "COPY", "ADD"))
    copied = (str(each.value) for one in stage.chain for each in one.all("COPY", "ADD"))
    if any(map(OTHER_SOURCES.search, texts)) or any(map(SOURCES.search, copied)):
        return None
    for words in _unconditional(stage):
        if words and "install" in words[:4] and words[0].startswith("apt"):
            for word in words:
                distro = _distro(word)
                if distro and distro != "rolling" and codename_of(distro) != codename:
                    return word
    return None


def _unconditional(stage: Stage) -> Iterator[Sequence[Located]]:
    """The commands of the steps that run whatever the image is, and that may not fail."""
    guarded = False
    for command in commands_of(stage):
        if not command.depth and not guarded and command.ends != "||":
            yield unwrapped(command.words)
        guarded = command.ends == "&&" and (guarded or command.name in TESTS)


def _distro(word: Located) -> str:
    """The distribution in the name of a package; empty for other words."""
    package = PACKAGE.fullmatch(word)
    return package["distro"] if package is not None and codename_of(package["distro"]) else ""
