"""Programs of supervisord, which many containers use to run several processes.

supervisor, options.py and "Configuration File": the defaults are ``autorestart=unexpected``, ``stopsignal=TERM`` and
``stopwaitsecs=10``; without ``user`` a program keeps the user of supervisord; no shell reads the command.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.following import follow
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Stop
from bringup_lint.model.supervisord import Program
from bringup_lint.parsers.shell import words
from bringup_lint.parsers.supervisord import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_PAIR = regex(r"\b(?P<name>[A-Za-z_]\w*)\s*=\s*(?:\"(?P<double>[^\"]*)\"|'(?P<single>[^']*)'|(?P<bare>[^\s,;]*))")
_NO = ("false", "no", "off", "0")


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    sources = (source for source in files.of_kind("supervisord") if source.judged and not source.template)
    for programs in files.parsed(parse, sources):
        for program in programs:
            yield _of(files, program)


def _of(files: Files, program: Program) -> Runner:
    source = program.name.span.source
    lines = list(_lines(files, program, source))
    restarts = (program.get("autorestart") or "unexpected").lower()
    user, signal, wait = program.get("user"), program.get("stopsignal"), program.get("stopwaitsecs")
    return Runner(
        RunnerKind.PROGRAM,
        f"program '{program.name}'",
        program.name.span,
        _environment(program),
        lines,
        lines,
        runs_ros=any(line.mentions_ros for line in lines),
        system=source.name,
        user=str(user) if user else None,
        stop=Stop(_signal(signal), float(wait) if wait and wait.isdecimal() else 10.0, signal),
        restarts=restarts not in _NO,
        asks_status=restarts == "unexpected",
        purpose=files.purpose(source, str(program.name)),
        reads=files.tree.find,
    )


def _lines(files: Files, program: Program, source: Source) -> Iterator[CommandLine]:
    command = program.get("command")
    if not command or "%(" in command:
        return
    line = CommandLine(command, tuple(words(command)))
    if line.argv:
        follow(line, lambda path: files.find(str(path), source) if path.startswith("/") else None)
        yield line


def _environment(program: Program) -> Environment:
    """What ``environment=`` adds to the environment of supervisord, which is not known."""
    environment = Environment(complete=False)
    value = program.get("environment")
    if value is not None:
        for match in _PAIR.finditer(value):
            group = next(name for name in ("double", "single", "bare") if match[name] is not None)
            text = value.part(*match.span(group))
            environment.set(Variable(match["name"], text, None if "%(" in text else str(text), "environment="))
    return environment


def _signal(signal: Located | None) -> str:
    name = "TERM" if signal is None else str(signal).upper()
    return name if name.startswith("SIG") else f"SIG{name}"
