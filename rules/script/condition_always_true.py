"""A condition of a script is true whatever the value is.

## What it finds
`!=` (or `-ne`) twice on the same variable or `$(COMMAND)` with two different literal values, joined with `||` or `-o`.
And, as a warning, `[ "$NAME" ]`, `[ -n "$NAME" ]` and `[ ! "$NAME" ]` of a variable that the script sets to `true` and
to `false`, or to other such pairs of words, and to nothing else: the word `false` is not empty either.

## Why it matters on a robot
No value is equal to both, so that one of the two halves is always true. The branch for a missing or switched-off part
runs on every robot: a set-up script writes an empty sensor into `.bashrc`, a boot script starts a driver for hardware
that is not there.

## Bad
```sh
if [[ "$LIDAR" != "none" || "$LIDAR" != "" ]]; then
```

## Good
```sh
if [[ "$LIDAR" != "none" && "$LIDAR" != "" ]]; then
```

## When to ignore it
Never: write the branch without the condition if it is meant for all values.

## References
- bash(1), "CONDITIONAL EXPRESSIONS"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

_VALUE = r"(?:\"[^\"$`\n]*\"|'[^'\n]*'|[\w./:+-]+)"
_IS_NOT = r"\"? {1,4}(?:!=|-ne) {1,4}"
_OR = r" {0,4}\]{0,2}[ \t]{0,4}(?:\|\||-o)(?:[ \t]{0,8}\\?\n)?[ \t]{0,16}\[{0,2} {0,4}"
NEITHER = regex(
    r"^(?P<before>[^#\n]*?)(?P<both>\"?\$(?P<name>\w+|\{\w+\}|\([^()\n]{1,80}\))"
    rf"{_IS_NOT}(?P<one>{_VALUE}){_OR}\"?\$(?P=name){_IS_NOT}(?P<other>{_VALUE})) {{0,4}}(?:\]|\|\||-o )",
    re.M,
    hints="!= -ne",
)
NARROWED = regex(r"&&|[ \t]-a[ \t]|\[[ \t]+![ \t]")
"""What comes before the two halves may make the first one false, or turn its answer around."""

FLAG = regex(
    r"^(?P<before>[^#\n]*?(?<![\w$]))(?P<asked>\[\[?[ \t]+(?P<not>![ \t]+)?(?:-n[ \t]+)?\"?\$(?:(?P<name>[A-Za-z_]\w*)"
    r"|\{(?P<braced>[A-Za-z_]\w*)\})\"?[ \t]+\]\]?)",
    re.M,
    hints="[ ",
)
"""Asks whether a variable is empty."""
ASSIGNED = regex(r"(?<![\w${-])([A-Za-z_]\w*)(\+?=)((?:\"[^\"\n]*\"|'[^'\n]*'|[^\s;&|)(\"'])*)", hints="=")
OTHERWISE = regex(r"\b(?:unset|read|for|getopts|mapfile|printf[ \t]+-v|source|\.|eval)[ \t]([^\n;]*)")
"""What may give a variable another value."""
UNKNOWN = regex(
    r"(?:^|[;&|{]|\bthen|\bdo|\belse)[ \t]*(?:(?:source|\.)[ \t]+(?!\S*\b(?:local_)?setup\.)"
    r"|(?:export|declare|eval)[ \t]+\"?\$)",
    re.M,
)
"""What may set any variable: a file that is read, or a name that is put together."""
WORD = regex(r"\w+")
TRUE = ("false", "False", "no", "off", "0", "true", "True", "yes", "on", "1")
PAIRS = ({"true", "false"}, {"True", "False"}, {"yes", "no"}, {"on", "off"}, {"1", "0"})


@rule("error", silent="the condition is valid for the shell")
def condition_always_true(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template:
            continue
        for found in NEITHER.finditer(source.text):
            one, other = (found[name].strip("\"'") for name in ("one", "other"))
            if one != other and not NARROWED.search(found["before"]):
                yield finding(
                    source.located(*found.span("both")),
                    f"This is always true: ${found['name'].strip('{}')} cannot be {one!r} and {other!r} at once",
                    advice="join the two halves with &&",
                )
        yield from _flags(source)


def _flags(source: Source) -> Iterator[Finding]:
    """The conditions that ask whether a variable is empty that only ever has one of two words."""
    asked = list(FLAG.finditer(source.text))
    if not asked or UNKNOWN.search(source.text):
        return
    values: dict[str, dict[str, tuple[int, int]]] = {}
    for match in ASSIGNED.finditer(source.text):
        value = match[3].strip("\"'") if match[2] == "=" else ""
        values.setdefault(match[1], {}).setdefault(value, match.span(1))
    otherwise = {word for match in OTHERWISE.finditer(source.text) for word in WORD.findall(match[1])}
    for match in asked:
        name = match["name"] or match["braced"]
        given = values.get(name, {})
        if (
            len(given) != 2
            or set(given) not in PAIRS
            or name in otherwise
            or not _is_set_first(source, given, match.start())
        ):
            continue
        one, other = given
        answer = "false" if match["not"] else "true"
        yield finding(
            source.located(*match.span("asked")),
            f"This is always {answer}: ${name} is {one!r} or {other!r}, and neither is empty",
            advice=f'write [ "${name}" {"!=" if match["not"] else "="} {max(given, key=TRUE.index)} ]',
            related=[note(source.located(*given[value]), f"set to {value!r}") for value in (one, other)],
            severity="warning",
        )


def _is_set_first(source: Source, given: dict[str, tuple[int, int]], asked: int) -> bool:
    """Whether the script sets the variable before it asks, outside of blocks, so that nobody else gives it."""
    first = min(start for start, _ in given.values())
    line = source.line_before(first)
    return first < asked and line in ("", "export ", "readonly ", "declare ")
