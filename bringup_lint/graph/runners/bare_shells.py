"""Commands of ROS in shells that read no login file: those of cron, and the ones that ssh starts."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.installed.script import Run
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.source import Located

_WHEN = r"(?:@[a-z]+|[\d*/,-]+(?:[ \t]+[\d*/,-]+){4})[ \t]+"
_JOB = regex(rf"^[ \t]*{_WHEN}[a-z_][\w-]*[ \t]+(?P<command>[^\n]*\bros2[ \t][^\n]*)", re.M)
_ADDED = regex(rf"^{_WHEN}(?P<command>[^\n]*\bros2[ \t][^\n]*)", re.M)
"""A line that a script adds to the crontab of its user, where no user is named."""
_SET = regex(r"AMENT_PREFIX_PATH|BASH_ENV")
_VERBS = ("launch", "run", "bag", "topic", "service", "node", "param", "lifecycle", "action")
_VALUED = frozenset("-b -c -D -E -e -F -i -I -J -L -l -m -O -o -p -Q -R -S -W -w".split())
"""Options of ssh that take a value (ssh(1))."""


class Bare(NamedTuple):
    program: Located
    shell: str
    """``cron`` or ``ssh``."""


def bare_shells(files: Files, scripts: Scripts) -> Iterator[Bare]:
    for source in files.of_kind("cron"):
        if source.judged and not source.template and not _SET.search(source.text):
            for line in _JOB.finditer(source.text):
                yield from _in(source.located(*line.span("command")), "cron")
    for _, run in scripts.run("echo", "printf"):
        for word in run.words[1:]:
            job = _ADDED.search(word) if "crontab" in word.span.source.text else None
            if job is not None and not _SET.search(word.span.source.text):
                yield from _in(word.part(*job.span("command")), "cron")
    for _, run in scripts.run("ssh"):
        yield from _remote(run)


def _remote(run: Run) -> Iterator[Bare]:
    """What ssh starts on the other computer: one word is a text for its shell, several are one command."""
    at = 1
    while at < len(run.words) and run.words[at].startswith("-"):
        at += 2 if run.words[at] in _VALUED else 1
    rest = run.words[at + 1 :]
    if len(rest) == 1:
        yield from _in(rest[0], "ssh")
    elif len(rest) > 1 and rest[0] == "ros2" and rest[1] in _VERBS:
        yield Bare(rest[0], "ssh")


def _in(text: Located, shell: str) -> Iterator[Bare]:
    """The first command of ROS in a text, where nothing before it sets the environment."""
    for command in commands(text):
        words = unwrapped(command.words)
        name = program_name(words[0]) if words else ""
        if name == "ros2" and len(words) > 1 and words[1] in _VERBS:
            yield Bare(words[0], shell)
            return
        if name in (".", "source", "export", "eval"):
            return
