"""What a rule finds and why, and the rules behind a log line."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Sequence
from itertools import zip_longest
from pathlib import Path

from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import put
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.registry import doc_of
from bringup_lint.report.columns import printable
from bringup_lint.report.docs import PROSE
from bringup_lint.report.docs import plain as as_text
from bringup_lint.report.wrap import wrap
from bringup_lint.spelling import meant
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.cache.answers import Question
    from bringup_lint.log_lines import OtherCause

JUDGED = {
    "no": "Not a configuration defect",
    "outside": "The cause is outside of the files that are checked",
    "unjudged": "A defect of the configuration that no rule finds",
}
"""What the configuration has to do with a line that no rule explains."""
NAMED = 5
"""Rules that are named when a word is no rule."""


def plain(what: tuple[str, ...], question: Question | None) -> int:
    """Explain without options."""
    return explain(what, (), None)


def explain(what: tuple[str, ...], rule_folders: Iterable[Path], colour: bool | None) -> int:
    """Print what a rule says of itself, or the rules for a line of a log; returns the exit code."""
    text = " ".join(what)
    registry = Registry.of(rule_folders)
    if text in registry.family_of:
        _print(registry[text], colour)
        return 0
    from bringup_lint.log_lines import Answer
    from bringup_lint.log_lines import explained

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
        return 2
    return 0


def _print(rule: Rule, colour: bool | None) -> None:
    painted = wants_colour(colour)
    put(as_text(doc_of(rule), terminal_width(), painted))


def _shown(line: str) -> str:
    """The line as it may be printed: without its secrets."""
    from bringup_lint.finding.redact import mask_of
    from bringup_lint.source import Source

    source = Source("log", line)
    mask = mask_of((), (source,))
    return printable(mask.source(source).text if mask else line)


def _heading(line: str, count: int) -> str:
    from bringup_lint.log_lines import speaker_of

    speaker = speaker_of(line)
    written = f", a line of {speaker.program}" if speaker else ""
    return f"{count} rules explain '{line}'{written}. The most likely first:"


def _list(heading: str, found: Sequence[Rule], symptoms: Sequence[str] = ()) -> None:
    put(f"{heading}\n\n")
    for rule, symptom in zip_longest(found, symptoms):
        put(f"  {rule.id}\n      {rule.title}\n")
        if symptom:
            put(f"      log line: {symptom}\n")
    put("\nbringup-lint explain RULE prints one of them.\n")


def _print_other(line: str, cause: OtherCause) -> None:
    said = f"'{line}': {JUDGED[cause.configuration]}. {cause.reason}"
    put("".join(f"{line}\n" for line in wrap(said, min(terminal_width(), PROSE))))


def _unknown(text: str, registry: Registry) -> str:
    if any(text == family.name for family in registry.families):
        return f"'{text}' is a family; bringup-lint rules {text} lists its rules"
    near = meant(text, registry.family_of)
    hint = f"did you mean {near}?" if near else _named_like(text, registry)
    return f"no rule and no known log line matches '{text}'" + (f"; {hint}" if hint else "")


def _named_like(text: str, registry: Registry) -> str:
    """The rules with this word in their names; empty for other text."""
    found = sorted(rule for rule in registry.family_of if text.lower() in rule.partition("/")[2].split("-"))
    if not found:
        return ""
    more = f" and {len(found) - NAMED} more" if len(found) > NAMED else ""
    return f"rules with this word in their names: {', '.join(found[:NAMED])}{more}"
