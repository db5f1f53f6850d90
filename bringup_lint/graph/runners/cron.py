"""The ``@reboot`` lines of crontabs: cron runs them once, after the boot, and starts nothing again."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.following import follow_text
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_REBOOT = regex(r"^[ \t]*@reboot[ \t]+(?P<user>[a-z_][\w-]*)[ \t]+(?P<command>\S[^\n]*)$", re.M)
_VARIABLE = regex(r"^[ \t]*(?P<name>[A-Za-z_]\w*)[ \t]*=[ \t]*(?P<value>(?:[^\n]*[^ \t\n])?)[ \t]*$", re.M)


LIMIT = 200
"""``@reboot`` lines of one crontab that are followed."""


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    for source in files.of_kind("cron"):
        if source.judged and not source.template:
            yield from _of(files, source)


def _of(files: Files, source: Source) -> Iterator[Runner]:
    environment, at = Environment(), 0
    for match in islice(_REBOOT.finditer(source.text), LIMIT):
        _set(environment, source, at, match.start())
        at = match.end()
        command = source.located(*match.span("command"))
        line = CommandLine(command, ())
        follow_text(line, command, lambda path: files.find(str(path), source) if path.startswith("/") else None)
        yield Runner(
            RunnerKind.CRON,
            f"the @reboot line of {source.basename}",
            command.span,
            environment.copy(),
            lines=[line],
            main=[line],
            runs_ros=bool(line.ros),
            system="cron",
            user=match["user"],
            restarts=False,
            reads=files.tree.find,
            purpose=files.purpose(source),
        )


def _set(environment: Environment, source: Source, start: int, end: int) -> None:
    """Set the variables of some lines; they count for the lines below, and cron adds hardly any."""
    for match in _VARIABLE.finditer(source.text, start, end):
        value = source.located(*match.span("value")).strip_located("\"'")
        environment.set(Variable(match["name"], value, str(value), "crontab"))
