"""The manual page, made from the commands and their options."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator

import click

from bringup_lint import __version__
from bringup_lint.cli import COMMANDS
from bringup_lint.cli.syntax import FLAG
from bringup_lint.cli.syntax import Command
from bringup_lint.cli.syntax import commands
from bringup_lint.cli.syntax import loaded

EXAMPLES = (
    ("bringup-lint", "Check the current folder."),
    ("bringup-lint /etc", "Check the robot that this is."),
    ("bringup-lint --root /mnt/image /etc", "Check a mounted image."),
    ("bringup-lint init", "Write the configuration that the current folder needs."),
    ('bringup-lint explain "status=217/USER"', "Find the rules that explain a line of a log."),
    ("bringup-lint graph --format html --output-file robot.html .", "Draw what starts what."),
)
EXIT = (
    (0, "Nothing at or above --fail-on."),
    (1, "Findings."),
    (2, "Wrong usage or configuration, or a file that cannot be written."),
    (3, "Something failed inside; everything else is still reported."),
    (130, "Interrupted."),
)
FILES = (
    ("bringup-lint.toml", "The configuration, in the folder that is checked or above it in its repository."),
    ("pyproject.toml", "The same in its table [tool.bringup-lint]."),
)
ENVIRONMENT = (
    ("NO_COLOR", "No colour."),
    ("FORCE_COLOR", "Colour also where standard output is not a terminal."),
    ("COLUMNS", "The width of the report, at most 100."),
    ("BRINGUP_LINT_TRACEBACK", "The traceback of what failed inside."),
)


def page() -> str:
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield f'.TH BRINGUP-LINT 1 "" "bringup-lint {__version__}" "User Commands"'
    yield ".SH NAME"
    yield r"bringup\-lint \- static configuration linter for ROS 2 robot bring\-up"
    yield ".SH SYNOPSIS"
    yield r".B bringup\-lint"
    yield _escaped("[OPTIONS] [PATH]...")
    yield ".br"
    yield r".B bringup\-lint"
    yield _escaped("COMMAND [OPTIONS] [ARGUMENT]...")
    yield ".SH DESCRIPTION"
    yield from _prose(loaded("check").help or "")
    yield ".SH OPTIONS"
    checking, *others = commands()
    yield from _options(checking)
    yield ".SH COMMANDS"
    for command in others:
        yield from _command(command)
    yield ".SH EXIT STATUS"
    yield from _terms((str(code), text) for code, text in EXIT)
    yield ".SH FILES"
    yield from _terms(FILES)
    yield ".SH ENVIRONMENT"
    yield from _terms(ENVIRONMENT)
    yield ".SH EXAMPLES"
    yield from _terms((example, text) for example, text in EXAMPLES)
    yield ".SH SEE ALSO"
    yield _escaped("systemd.unit(5), udev(7), netplan(5), https://bringup-lint.github.io/bringup-lint/")


def _command(command: Command) -> Iterator[str]:
    made = loaded(command.name)
    context = click.Context(made, info_name=command.name)
    pieces = " ".join(made.collect_usage_pieces(context))
    yield f".SS {_escaped(f'bringup-lint {command.name} {pieces}')}"
    yield from _prose(made.help or COMMANDS[command.name])
    yield from _options(command)


def _options(command: Command) -> Iterator[str]:
    for option in command.options:
        value = "" if option.takes == FLAG else f" {_value(option.takes)}"
        yield ".TP"
        yield ", ".join(rf"\fB{_escaped(each)}\fR" for each in option.spellings) + value
        yield _escaped(option.help)


def _value(takes: str) -> str:
    if " " in takes:
        return _escaped("|".join(takes.split()))
    return rf"\fI{ {'names': 'NAME,...', 'any': 'VALUE'}.get(takes, takes.upper()) }\fR"


def _prose(text: str) -> Iterator[str]:
    for number, paragraph in enumerate(inspect.cleandoc(text).split("\n\n")):
        if number:
            yield ".PP"
        verbatim = paragraph.startswith("\b")
        lines = map(_escaped, paragraph.removeprefix("\b").strip("\n").splitlines())
        yield from (".nf", *lines, ".fi") if verbatim else lines


def _terms(terms: Iterator[tuple[str, str]] | tuple[tuple[str, str], ...]) -> Iterator[str]:
    for term, text in terms:
        yield ".TP"
        yield rf"\fB{_escaped(term)}\fR"
        yield _escaped(text)


def _escaped(text: str) -> str:
    """Text in which roff reads no request, escape or typographic hyphen."""
    plain = re.sub(r"[\\\-]", lambda match: {"\\": r"\e", "-": r"\-"}[match[0]], text)
    return rf"\&{plain}" if plain.startswith((".", "'")) else plain
