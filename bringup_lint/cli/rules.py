"""``bringup-lint rules``: list the rules."""

from __future__ import annotations

import json
from itertools import groupby
from pathlib import Path

import click

from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import rules_option
from bringup_lint.cli.streams import complain
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.report.paint import painter
from bringup_lint.spelling import meant


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
    registry = Registry.of(rule_folders)
    unknown = set(families) - {family.name for family in registry.families}
    if unknown:
        name = sorted(unknown)[0]
        near = meant(name, [family.name for family in registry.families])
        hint = f"did you mean '{near}'?" if near else "bringup-lint rules lists all"
        complain(f"no family is called '{name}'; {hint}")
        ctx.exit(2)
    rules = [rule for rule in registry.all() if not families or rule.family in families]
    if output_format == "json":
        click.echo(json.dumps([_data(rule) for rule in rules], indent=2, ensure_ascii=False))
        return
    titles = {family.name: family.title for family in registry.families}
    colour = wants_colour(colour)
    paint = painter(colour)
    for family, group in groupby(rules, key=lambda rule: rule.family):
        members = list(group)
        width = max(len(rule.id) for rule in members)
        click.echo(paint("strong", f"{titles[family]} ({len(members)})"), color=colour)
        for rule in members:
            mark = {"safe": "*", "unsafe": "+"}.get(rule.meta.fix, " ")
            severity = paint(str(rule.severity), f"{rule.severity!s:<8}")
            click.echo(f"  {severity}{mark} {rule.id:<{width}}  {rule.title}", color=colour)
        click.echo()
    click.echo(f"{len(rules)} rules. * has a safe fix, + an unsafe one. bringup-lint explain RULE says more.")


def _data(rule: Rule) -> dict[str, object]:
    return {
        "id": rule.id,
        "title": rule.title,
        "severity": str(rule.severity),
        "confidence": str(rule.meta.confidence),
        "fix": rule.meta.fix,
        "since": rule.meta.since,
        "aliases": rule.meta.aliases,
        "tags": rule.meta.tags,
        "symptoms": rule.meta.symptoms,
    }
