"""``bringup-lint explain RULE|LOG LINE``: the documentation, offline."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest
from pathlib import Path

import click

from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import rules_option
from bringup_lint.cli.streams import complain
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.finish import doc_of
from bringup_lint.log_lines import Answer
from bringup_lint.log_lines import OtherCause
from bringup_lint.log_lines import explained
from bringup_lint.log_lines import speaker_of
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.report.columns import printable
from bringup_lint.report.docs import PROSE
from bringup_lint.report.docs import plain
from bringup_lint.report.wrap import wrap
from bringup_lint.spelling import meant


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
    text = " ".join(what)
    registry = Registry.of(rule_folders)
    if text in registry.paths:
        return _print(registry[text], colour)
    rules = list(registry.all())
    named = [rule for rule in rules if text in (rule.id.partition("/")[2], *rule.meta.aliases)]
    answer = Answer() if named else explained(text, rules)
    found = named or [match.rule for match in answer.matches]
    if len(found) == 1:
        _print(found[0], colour)
    elif named:
        _list(f"{len(named)} rules are called '{text}':", named)
    elif found:
        _list(_heading(_shown(text), len(found)), found, [match.symptom for match in answer.matches])
    elif answer.other:
        _print_other(_shown(text), answer.other)
    else:
        complain(_unknown(_shown(text), registry))
        ctx.exit(2)


def _print(rule: Rule, colour: bool | None) -> None:
    painted = wants_colour(colour)
    click.echo(plain(doc_of(rule), terminal_width(), painted), nl=False, color=painted)


def _shown(line: str) -> str:
    """The line as it may be printed: without its secrets."""
    from bringup_lint.finding.redact import mask_of
    from bringup_lint.source import Source

    source = Source("log", line)
    mask = mask_of((), (source,))
    return printable(mask.source(source).text if mask else line)


def _heading(line: str, count: int) -> str:
    speaker = speaker_of(line)
    written = f", a line of {speaker.program}" if speaker else ""
    return f"{count} rules explain '{line}'{written}. The most likely first:"


def _list(heading: str, found: Sequence[Rule], symptoms: Sequence[str] = ()) -> None:
    click.echo(f"{heading}\n")
    for rule, symptom in zip_longest(found, symptoms):
        click.echo(f"  {rule.id}\n      {rule.title}")
        if symptom:
            click.echo(f"      log line: {symptom}")
    click.echo("\nbringup-lint explain RULE prints one of them.")


def _print_other(line: str, cause: OtherCause) -> None:
    judged = "The cause is outside of the files that are checked" if cause.outside else "Not a configuration defect"
    click.echo("\n".join(wrap(f"'{line}': {judged}. {cause.reason}", min(terminal_width(), PROSE))))


def _unknown(text: str, registry: Registry) -> str:
    if any(text == family.name for family in registry.families):
        return f"'{text}' is a family; bringup-lint rules {text} lists its rules"
    near = meant(text, registry.paths)
    return f"no rule and no known log line matches '{text}'" + (f"; did you mean {near}?" if near else "")
