"""``bringup-lint init``: the configuration that a tree needs."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

import click

from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import say
from bringup_lint.config import FILE_NAME
from bringup_lint.config import schema
from bringup_lint.plural import counted
from bringup_lint.toml import quoted
from bringup_lint.writing import NotWritten
from bringup_lint.writing import create

if TYPE_CHECKING:
    from bringup_lint.cli.survey import Setting

HEAD = """\
# The configuration of bringup-lint for this tree. Each setting has an effect, and the comment says what it comes from:
# delete what is wrong. bringup-lint init --schema prints all keys.
"""
NOTHING = "# Nothing in this tree calls for a setting.\n"


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--schema", "print_schema", is_flag=True, help="Print the JSON schema of the configuration instead.")
@click.option("--print", "print_only", is_flag=True, help="Print the configuration, and write nothing.")
@click.pass_context
def command(ctx: click.Context, print_schema: bool, print_only: bool) -> None:
    """Look at the current folder and write the bringup-lint.toml that it needs.

    The ROS distribution, what to leave out, where files go on the robot and what folders are for: each setting with
    the file that it comes from and the findings that it takes away, and none without effect.
    """
    if print_schema:
        click.echo(json.dumps(schema(), indent=2))
        return
    if os.path.lexists(FILE_NAME) and not print_only:
        complain(f"{FILE_NAME}: is there already")
        ctx.exit(2)
    found = _surveyed()
    text = document(found)
    if print_only:
        click.echo(text, nl=False)
        return
    path = Path(FILE_NAME)
    try:
        create(path, text.encode("utf-8"))
    except NotWritten as error:
        complain(error)
        ctx.exit(2)
    say(f"Wrote {path}: {_told(found)}.")
    if taken := _taken(sum(each.errors for each in found), sum(each.warnings for each in found)):
        say(f"It takes away {taken}: the comments say where.")


def _surveyed() -> list[Setting]:
    from bringup_lint.cli.losses import with_losses
    from bringup_lint.cli.reading import read_robot
    from bringup_lint.cli.run_options import RunOptions
    from bringup_lint.cli.survey import settings
    from bringup_lint.config import Config

    robot = read_robot((".",), Config(), RunOptions())
    return with_losses(settings(robot), robot)


def document(found: Iterable[Setting]) -> str:
    """The text of a configuration."""
    parts = [_table(table, list(group)) for table, group in groupby(found, key=lambda each: each.table)]
    return "\n".join([HEAD, *parts] if parts else [HEAD + NOTHING])


def _table(table: str, group: list[Setting]) -> str:
    return "".join(f"{line}\n" for line in _lines(table, group))


def _lines(table: str, group: list[Setting]) -> Iterator[str]:
    if table == "exclude":
        yield "exclude = ["
        yield from (f"    {quoted(each.value)},  # {_why(each)}" for each in group)
        yield "]"
        return
    if group[0].name:
        yield f"[{table}]"
    for each in group:
        yield f"{quoted(each.name) if each.name else table} = {quoted(each.value)}  # {_why(each)}"


def _why(setting: Setting) -> str:
    """What a setting comes from, and what it costs."""
    taken = _taken(setting.errors, setting.warnings)
    return _plain(f"{setting.why}; takes away {taken}" if taken else setting.why)


def _taken(errors: int, warnings: int) -> str:
    counts = (("error", errors), ("warning", warnings))
    return " and ".join(counted(count, name) for name, count in counts if count)


def _plain(text: str) -> str:
    """A comment; no name of a file can end it."""
    return "".join(char if char.isprintable() else "?" for char in text)


def _told(found: list[Setting]) -> str:
    counts = [(table, len(list(group))) for table, group in groupby(found, key=lambda each: each.table)]
    named = (table if count == 1 else f"{table} ({count})" for table, count in counts)
    return ", ".join(named) or "nothing in this tree calls for a setting"
