"""Pairs of ``--output-format`` and ``--output-file``, in the order in which they are on the command line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from bringup_lint.cli.reports import Output
from bringup_lint.report import FORMATS


class PairedOptions(click.Command):
    """Remembers the order of the output options, which click gathers by name."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        _, _, order = self.make_parser(ctx).parse_args(args=list(args))
        remaining = super().parse_args(ctx, args)
        values = {name: iter(ctx.params.get(name) or ()) for name in ("output_format", "output_file")}
        ctx.meta["outputs"] = pair([(param.name, next(values[param.name])) for param in order if param.name in values])
        return remaining


def pair(options: list[tuple[str, Any]]) -> list[Output]:
    """A file belongs to the format before it; a file without one gets the format that comes next, or text."""
    outputs: list[Output] = []
    waiting: Path | None = None
    for name, value in options:
        if name == "output_format":
            outputs.append(Output(value, waiting))
            waiting = None
        elif outputs and outputs[-1].file is None:
            outputs[-1] = outputs[-1]._replace(file=value)
        elif waiting is None:
            waiting = value
        else:
            raise click.UsageError("each --output-file needs an --output-format of its own")
    if waiting is not None:
        outputs.append(Output("text", waiting))
    if sum(output.file is None for output in outputs) > 1:
        raise click.UsageError("only one report can go to standard output; give the others an --output-file")
    return outputs or [Output("text", None)]


format_option = click.option(
    "--output-format",
    type=click.Choice(FORMATS),
    multiple=True,
    help="How to report; give it several times, each with its own --output-file. [default: text]",
)
file_option = click.option(
    "--output-file",
    type=click.Path(dir_okay=False, path_type=Path),
    multiple=True,
    help="Where the report of the --output-format before it goes. [default: standard output]",
)
