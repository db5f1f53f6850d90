"""Commands of ROS in crontabs, whose shell reads no login file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.source import Located

_WHEN = r"(?:@[a-z]+|[\d*/,-]+(?:[ \t]+[\d*/,-]+){4})[ \t]+(?=\S)"
_JOB = regex(rf"^[ \t]*{_WHEN}(?!source\b)[a-z_][\w-]*[ \t]+(?=\S)(?P<command>[^\n]*\bros2[ \t][^\n]*)", re.M)
_ADDED = regex(rf"^{_WHEN}(?P<command>[^\n]*\bros2[ \t][^\n]*)", re.M)
"""A line that a script adds to the crontab of its user, where no user is named."""
_SET = regex(r"AMENT_PREFIX_PATH|BASH_ENV|^[ \t]*SHELL[ \t]*=(?![^\n]*/(?:ba|da|z)?sh\b)", re.M)
_QUESTIONS = frozenset(("-l", "-e", "-r"))
_VERBS = ("launch", "run", "bag", "topic", "service", "node", "param", "lifecycle", "action")


def in_crontabs(files: Files, scripts: Scripts) -> Iterator[Located]:
    for source in files.of_kind("cron"):
        if source.judged and not source.template and not _SET.search(source.text):
            for line in _JOB.finditer(source.text):
                yield from _in(source.located(*line.span("command")))
    installs = {
        run.words[0].span.source for _, run in scripts.run("crontab") if not _QUESTIONS.issuperset(run.words[1:])
    }
    for _, run in scripts.run("echo", "printf"):
        for word in run.words[1:]:
            job = _ADDED.search(word) if word.span.source in installs else None
            if job is not None and not _SET.search(word.span.source.text):
                yield from _in(word.part(*job.span("command")))


def _in(text: Located) -> Iterator[Located]:
    """The first command of ROS in a text, where nothing before it sets the environment."""
    for command in commands(text):
        words = unwrapped(command.words)
        name = program_name(words[0]) if words else ""
        if name == "ros2" and len(words) > 1 and words[1] in _VERBS:
            yield words[0]
            return
        if name in (".", "source", "export", "eval"):
            return
