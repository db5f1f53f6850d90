"""``bringup-lint rules``: list the rules."""

from __future__ import annotations

from pathlib import Path

import click

from bringup_lint.cli.listing import list_rules
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import rules_option


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("families", nargs=-1, metavar="[FAMILY]...")
@click.option(
    "--output-format", type=click.Choice(["text", "json"]), default="text", help="How to list. [default: text]"
)
@rules_option
@colour_option
@click.pass_context
def command(
    ctx: click.Context,
    families: tuple[str, ...],
    output_format: str,
    rule_folders: tuple[Path, ...],
    colour: bool | None,
) -> None:
    """List the rules, all or those of some families."""
    ctx.exit(list_rules(families, output_format, rule_folders, colour))
