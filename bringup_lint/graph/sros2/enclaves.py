"""Who selects which enclave: ``--enclave`` in launch files and on the command lines of runners, and the override
variable."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import split
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners

OPTION = "--enclave"
OVERRIDE = "ROS_SECURITY_ENCLAVE_OVERRIDE"


def launched_processes(files: Files, launch: Launch) -> list[Started]:
    """Every process that the launch files start, each once."""
    if not files.of_kind(*LAUNCH):
        return []
    found: dict[Span, Started] = {}
    for node in launch.nodes:
        if not isinstance(node.action, ComposableNode):
            found.setdefault(node.span, node)
    return list(found.values())


def enclave_of(node: Started) -> tuple[bool, Located | None]:
    """Whether a node may select an enclave, and the one it does select, when that is known."""
    values = list(node.arguments)
    for at, value in enumerate(values):
        text = text_of(value)
        if text is None:
            return True, None
        words = split(text)
        if OPTION in words[:-1]:
            return True, None
        if OPTION in words:
            return True, literal_text(values[at + 1]) if at + 1 < len(values) else None
    return False, None


def in_words(words: Iterable[Located]) -> Iterator[Located]:
    """The enclaves that the words of a command name, quotes removed."""
    before = ""
    for word in words:
        if before == OPTION and "$" not in word and "{" not in word:
            yield word
        before = str(word)


def selected(files: Files, ros: RosEnvironment, runners: Runners, launch: Launch) -> Iterator[Located]:
    """Every enclave that something of the tree names, where it is written."""
    for node in launched_processes(files, launch):
        _, enclave = enclave_of(node)
        if enclave is not None:
            yield enclave
    for runner in runners.all:
        for command in runner.commands:
            yield from in_words(command.words)
    for command in _script_commands(files):
        yield from in_words(command.words)
    yield from (setting.value for setting in ros.of(OVERRIDE) if "$" not in setting.value)


def _script_commands(files: Files) -> Iterator[Command]:
    """The commands of the scripts of the tree, those too that no runner starts."""
    from bringup_lint.parsers.shell import shell_commands

    for source in files.of_kind("shell-script"):
        if OPTION in source.text and not source.template:
            yield from shell_commands(source)
