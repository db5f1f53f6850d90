"""Programs that scripts and images fetch for another processor than that of the robot."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.dockerfile import substituted
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.shell import Command
    from bringup_lint.source import Located

_NAMED = regex(
    r"(?<![A-Za-z\d])(?:(?P<amd64>amd64|x86[_-]64|linux-?x64|linux64|x64)|(?P<arm>arm64|aarch64|armhf|armv[78]l?))"
    r"(?![A-Za-z\d])"
)
_ARTIFACT = regex(r"\.(?:deb|whl|AppImage|run|tar\.\w{2,3}|tgz|zip|xz|bin)\b|/releases/|^deb \[")
_FETCHERS = frozenset("wget curl dpkg gdebi apt apt-get pip pip3 tar unzip aria2c gh ADD".split())
_LISTS = frozenset(("echo", "printf", "add-apt-repository"))
_CHOOSES = regex(
    r"\buname\b|(?<!arch=\$\()\bdpkg --print|\bTARGET(?:ARCH|PLATFORM)\b|\bBUILDPLATFORM\b|\$\(arch\)|\blscpu\b"
    r"|\bHOSTTYPE\b|/device-tree/model|/proc/cpuinfo|--add-architecture|\bqemu|\bcross|\bdebootstrap\b|\bbinfmt|\bARCH\b",
    hints="uname dpkg TARGET BUILDPLATFORM $(arch) lscpu HOSTTYPE /device-tree/ /proc/cpuinfo --add-arch qemu cross "
    "debootstrap binfmt ARCH",
)
"""The file asks for the processor (not only for the line of a package source), or works for another one on purpose."""
_PLATFORM = regex(r"(?:--platform=)?linux/(?P<name>amd64|x86_64|arm64|aarch64|arm)\b")
_ARM_IMAGE = regex(r"^(?:arm(?:64v8|32v7)/|dustynv/)|\bl4t\b|/l4t-|\bjetpack\b|\b(?:rpi|raspberrypi\w*|raspbian)[-/:]")
_AMD_IMAGE = regex(r"^amd64/")
_OF_BOARD = regex(
    r"/boot/(?:firmware/)?config\.txt|\braspi-config\b|\bnvpmodel\b|\bjetson_clocks\b|/etc/nv_tegra_release"
    r"|/etc/nv_boot_control|\brpi-eeprom-\w+|\blinux-(?:modules-extra-)?raspi\b"
)
"""What only a script on a Raspberry Pi or a Jetson does."""

_ELSEWHERE = ("[", "[[", "test", "ssh", "sshpass")
"""Commands that ask where they are, or tell another computer."""
_NOT_RUN = regex(r"\.img\b|sysroot|rootfs|firmware|\.bin$|_all\.deb$")
"""What is for another computer also where its processor is the same, or for all."""


class Foreign(NamedTuple):
    word: Located
    """What is fetched."""
    processor: str
    """That of the program, ``amd64`` or ``arm``."""
    why: Located
    """What shows the processor of the robot."""


def foreign_programs(files: Files, compose: Compose) -> Iterator[Foreign]:
    """The first one of each script and stage."""
    for source in files.of_kind("shell-script"):
        if source.judged and not source.template and not _CHOOSES.search(source.text):
            commands = shell_commands(source)
            here = (each for each in commands if each.name not in _ELSEWHERE)
            board = next((word for each in here for word in each.words if _OF_BOARD.search(word)), None)
            if board is not None:
                yield from _fetched(commands, "arm", board)
    for file in compose.images.dockerfiles:
        if file.source.judged and not _CHOOSES.search(file.source.text):
            for stage in file.stages:
                found = _of_stage(compose, stage)
                if found is not None:
                    added = [Added((each.keyword, *each.value.words())) for each in stage.all("ADD")]
                    yield from _fetched([*commands_of(stage), *added], *found)


class Added(NamedTuple):
    """An ADD instruction, as if it were a command."""

    words: tuple[Located, ...]
    depth: int = 0


def _fetched(commands: Iterable[Command | Added], own: str, why: Located) -> Iterator[Foreign]:
    for command in commands:
        words = unwrapped(command.words)
        name = program_name(words[0]) if words else ""
        if command.depth or (name not in _FETCHERS and name not in _LISTS):
            continue
        for word in words[1:]:
            named = list(_NAMED.finditer(word))
            is_list = word.startswith("deb [")
            if named and _ARTIFACT.search(word) and not _NOT_RUN.search(word) and is_list == (name in _LISTS):
                processors = {str(each.lastgroup) for each in named}
                if own not in processors:
                    yield Foreign(word, processors.pop(), why)
                    return


def _of_stage(compose: Compose, stage: Stage) -> tuple[str, Located] | None:
    """The processor of an image, and what says it."""
    for link in stage.chain:
        for flag in link.start.flags:
            match = _PLATFORM.search(flag)
            if match is not None:
                return _processor(match["name"]), flag
    bottom = list(stage.chain)[-1]
    if _ARM_IMAGE.search(bottom.resolved):
        return "arm", bottom.image
    if _AMD_IMAGE.search(bottom.resolved):
        return "amd64", bottom.image
    for service in compose.users(stage):
        given = service.build_arguments
        if "$" in bottom.image and _ARM_IMAGE.search(substituted(bottom.image, given)):
            return "arm", next(value for value in given.values() if value is not None and _ARM_IMAGE.search(value))
    platforms = [service.scalar("platform") for service in compose.users(stage)]
    known = [platform for platform in platforms if platform is not None and _PLATFORM.match(platform)]
    found = {_processor(platform.rpartition("/")[2]) for platform in known}
    return (found.pop(), known[0]) if len(found) == 1 and len(known) == len(platforms) else None


def _processor(name: str) -> str:
    return "amd64" if name in ("amd64", "x86_64") else "arm"
