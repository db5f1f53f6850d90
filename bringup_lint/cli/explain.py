"""``bringup-lint explain RULE|LOG LINE``: the documentation, offline."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import click

from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import rules_option
from bringup_lint.cli.reporting import terminal_width
from bringup_lint.cli.reporting import wants_colour
from bringup_lint.finish import doc_of
from bringup_lint.pattern import regex
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.report.docs import plain
from bringup_lint.spelling import meant

_WORD = regex(r"[A-Za-z0-9_./=-]{2,}")
_COMMON = frozenset(
    "no such the and for with was not has been from this that are error failed failure warning info to of in on at "
    "is it by "
    "service unit node process systemd ros2 launch start started".split()
)


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
    found = [registry[text]] if text in registry.paths else _found(text, list(registry.all()))
    if len(found) > 1:
        _list(text, found)
    elif found:
        painted = wants_colour(colour)
        click.echo(plain(doc_of(found[0]), terminal_width(), painted), nl=False, color=painted)
    else:
        click.echo(f"bringup-lint: {_unknown(text, registry)}", err=True)
        ctx.exit(2)


def _found(text: str, rules: list[Rule]) -> list[Rule]:
    """The rules of a name, else those of a log line."""
    named = [rule for rule in rules if text in (rule.id.partition("/")[2], *rule.meta.aliases)]
    return named or matching(text, rules)


def matching(line: str, rules: Iterable[Rule]) -> list[Rule]:
    """The rules one of whose symptoms a log line holds, or shares its telling words with; the best first."""
    scores = []
    words = _telling(line)
    for rule in rules:
        score = max((_score(line, words, symptom) for symptom in rule.meta.symptoms), default=0.0)
        if score:
            scores.append((-score, rule.id, rule))
    scores.sort(key=lambda item: item[:2])
    best = -scores[0][0] if scores else 0
    return [rule for negative, _, rule in scores if -negative >= best * 0.75]


def _score(line: str, words: set[str], symptom: str) -> float:
    if symptom.lower() in line.lower() or (len(line) > 8 and line.lower() in symptom.lower()):
        return 2.0
    telling = _telling(symptom)
    shared = telling & words
    share = len(shared) / len(telling) if telling else 0
    return share if share >= 0.6 and len(shared) >= 2 else 0.0


def _telling(text: str) -> set[str]:
    return {word.lower() for word in _WORD.findall(text)} - _COMMON


def _list(text: str, found: list[Rule]) -> None:
    click.echo(f"{len(found)} rules explain '{text}':\n")
    for rule in found:
        click.echo(f"  {rule.id}\n      {rule.title}")
    click.echo("\nbringup-lint explain RULE prints one of them.")


def _unknown(text: str, registry: Registry) -> str:
    if any(text == family.name for family in registry.families):
        return f"'{text}' is a family; bringup-lint rules {text} lists its rules"
    near = meant(text, registry.paths)
    return f"no rule and no known log line matches '{text}'" + (f"; did you mean {near}?" if near else "")
