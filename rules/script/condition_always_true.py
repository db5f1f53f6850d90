"""A condition of a script is true whatever the value is.

## What it finds
`!=` (or `-ne`) twice on the same variable or `$(COMMAND)` with two different literal values, joined with `||` or `-o`.

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
from bringup_lint.api import finding
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
