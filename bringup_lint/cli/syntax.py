"""The syntax of the command line: what completion and the manual page are made from."""

from __future__ import annotations

import importlib
from collections.abc import Iterator

import click

from bringup_lint.cli import COMMANDS
from bringup_lint.cli.options import names
from bringup_lint.named_tuple import NamedTuple

ANY, FILE, FOLDER, NAMES, RULES, FAMILIES, FLAG = "any", "file", "folder", "names", "rules", "families", "flag"
_ARGUMENTS = {"explain": RULES, "rules": FAMILIES}


class Option(NamedTuple):
    """An option of a command."""

    spellings: tuple[str, ...]
    takes: str
    """What its value is: one of the constants above, or words between blanks."""
    help: str


class Command(NamedTuple):
    """A command, with what its arguments are: a constant, or words between blanks."""

    name: str
    help: str
    options: tuple[Option, ...]
    takes: str


def loaded(name: str) -> click.Command:
    """The command of this name."""
    module = importlib.import_module(f"bringup_lint.cli.commands.{name.replace('-', '_')}")
    command: click.Command = module.command
    return command


def commands() -> Iterator[Command]:
    """Every command, ``check`` first."""
    for name, text in COMMANDS.items():
        command = loaded(name)
        params = command.get_params(click.Context(command, **command.context_settings))
        options = tuple(_option(param) for param in params if isinstance(param, click.Option) and not param.hidden)
        arguments = [param for param in params if isinstance(param, click.Argument)]
        takes = _ARGUMENTS.get(name) or (_takes(arguments[0]) if arguments else ANY)
        yield Command(name, text, options, takes)


def _option(param: click.Option) -> Option:
    spellings = (*param.opts, *param.secondary_opts)
    return Option(tuple(sorted(spellings, key=len, reverse=True)), _takes(param), param.help or "")


def _takes(param: click.Parameter) -> str:
    if isinstance(param, click.Option) and (param.is_flag or param.count):
        return FLAG
    if param.callback is names:
        return NAMES
    if isinstance(param.type, click.Choice):
        return " ".join(map(str, param.type.choices))
    if isinstance(param.type, click.Path):
        return FILE if param.type.file_okay else FOLDER
    return ANY
