"""Where an image has package lists of apt: steps that bring and remove them, and those that need them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.containers.base_images import has_no_package_lists
from bringup_lint.graph.containers.base_images import may_have_package
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.shell import flatten
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_PROGRAMS = ("apt", "apt-get", "aptitude")
_UPDATES = frozenset(
    "add-apt-repository apt-add-repository ansible-playbook unminimize nala make just curl wget bash sh source ."
    " python3 python".split()
)
"""What updates the lists itself, or may start what does."""
_ENVIRONMENT = regex(
    r"(?:^|.*/)(?:opt/ros/[^/]{1,40}|install(?:/[\w-]{1,80})?)/(?:local_)?setup\.(?:ba|z)?sh"
    r"|.*/bin/activate|/etc/(?:os|lsb)-release"
)
"""What only sets variables when a shell reads it."""
_COPIED = regex(r"/var(?:/lib(?:/apt(?:/lists)?)?)?/?[\"\]\s]*$|^/[\s,]+/$")
_LISTS = regex(r"/var/lib/apt(?:/lists)?(?:/\*?)?")
_CACHED = regex(r"--mount=(?:[^\s=]{1,40}=[^\s,]{0,200},){0,9}(?:target|dst)=/var/lib/apt")
_DRY = frozenset(("-s", "--simulate"))
_VALUED = ("-t", "-o", "-c", "--target-release", "--option")


class Unlisted(NamedTuple):
    """A package that a step installs without lists."""

    package: Located
    """``rosdep`` where that names the packages to apt."""
    removed: Located | None
    """What removed the lists; None where the image comes without them."""


class _Lists(NamedTuple):
    """What is known of the package lists at a step."""

    missing: bool = False
    removed: Located | None = None
    """The step that removed them."""


def first_unlisted(stage: Stage) -> Unlisted | None:
    """The first package of a stage that apt does not find."""
    lists = _Lists(missing=has_no_package_lists(stage.origin))
    for each in reversed(list(stage.chain)[1:]):
        for command in _commands(each):
            lists = _after(lists, command)
    before = None
    for command in _commands(stage):
        needed = lists.missing and (before is None or before.ends != "||")
        word = _installed(command, stage.origin) if needed else None
        if word is not None and (word != "rosdep" or lists.removed is None):
            return Unlisted(word, lists.removed)
        lists, before = _after(lists, command), command
    return None


def _commands(stage: Stage) -> Iterator[Command | None]:
    """The commands of a stage in order; None for a step of which the lists come from elsewhere."""
    for instruction in stage.all("RUN", "COPY", "ADD"):
        if instruction.name != "RUN":
            if _COPIED.search(instruction.value):
                yield None
        elif instruction.exec_form is not None or any(_CACHED.match(flag) for flag in instruction.flags):
            yield None
        else:
            for command in commands_of_run(instruction):
                yield from _inner(command)


def _inner(command: Command) -> Iterator[Command]:
    """The commands of the text that a shell is given, where its failure is that of the step; else the command."""
    words = unwrapped(command.words)
    is_shell = bool(words) and program_name(words[0]) in SHELLS and not command.depth
    read = shell_input(words[1:]) if is_shell and command.ends not in ("||", "|") else None
    if read is None or read.text is None:
        yield command
    else:
        yield from flatten(blocks(read.text))


def _after(lists: _Lists, command: Command | None) -> _Lists:
    if command is None:
        return _Lists()
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name in _PROGRAMS and "update" in words:
        return _Lists()
    if name in ("source", ".") and len(words) == 2 and _ENVIRONMENT.fullmatch(words[1]):
        return lists
    if name in _UPDATES or (words and ("/" in words[0] or "$" in words[0]) and name not in _PROGRAMS):
        return _Lists()
    if name == "rm" and not command.depth and command.ends != "||":
        removed = next((word for word in words[1:] if _LISTS.fullmatch(word)), None)
        return _Lists(True, removed) if removed is not None else lists
    return lists


def _installed(command: Command | None, image: str) -> Located | None:
    """The first package that a command takes from the lists, where its failure stops the build; ``rosdep`` itself,
    which takes those of the manifests. What the image may have already needs no list."""
    if command is None or command.depth or command.ends in ("||", "|"):
        return None
    words = unwrapped(command.words)
    if words and program_name(words[0]) == "rosdep":
        return words[0] if "install" in words and not _DRY.intersection(words) else None
    if not words or program_name(words[0]) not in _PROGRAMS:
        return None
    plain = [word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in _VALUED]
    if not plain or plain[0] != "install" or any("$" in word for word in plain):
        return None
    asked = (word for word in plain[1:] if "/" not in word and not word.endswith(".deb"))
    return next((word for word in asked if not may_have_package(image, word)), None)
