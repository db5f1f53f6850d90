"""``bringup-lint explain RULE|LOG LINE``: the documentation, offline."""

from __future__ import annotations

from pathlib import Path

import click

from bringup_lint.cli.explaining import explain
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import rules_option


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("what", nargs=-1, required=True)
@rules_option
@colour_option
@click.pass_context
def command(ctx: click.Context, what: tuple[str, ...], rule_folders: tuple[Path, ...], colour: bool | None) -> None:
    """Print what a rule finds and why; or, for a line of a log, the rules that people met by it.

    \b
    bringup-lint explain systemd/network-target
    bringup-lint explain "does not match an available interface"
    """
    ctx.exit(explain(what, rule_folders, colour))
