"""A script takes one active unit for all of them.

## What it finds
`systemctl is-active --quiet` (or `is-enabled`) with several units, where the script stops or reports an error if it
fails: before `||`, and alone on a line under `set -e`. A condition of `if` may mean any of the units.

## Why it matters on a robot
systemctl asks whether any of the units is active, and succeeds with the first one. A check before the start passes
while the bus of the motors or the camera is down, and nobody sees it.

## Bad
```sh
systemctl is-active --quiet docker.service ethercat.service || exit 1
```

## Good
```sh
for unit in docker.service ethercat.service; do
    systemctl is-active --quiet "$unit" || exit 1
done
```

## When to ignore it
When one of the units is enough.

## References
- systemctl(1), is-active: "Returns an exit code 0 if at least one is active"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Run

ASKS = {"is-active": "active", "is-enabled": "enabled"}
STOPS = regex(STRICT, re.M)
BEFORE = regex(r"(?:^|[;{(]|\b(?:then|do|else)\b)[ \t]*(?:sudo[ \t]+)?$")
"""What may be in front of a command whose own failure counts."""
ALONE = ("", "\n", ";")


@rule("warning", confidence="medium", silent="systemctl succeeds with the first unit that is active")
def units_any_active(robot: Robot) -> Iterator[Finding]:
    for source, run in robot.scripts.run("systemctl"):
        words = [word for word in run.words[1:] if not word.startswith("-")]
        if len(words) < 3 or str(words[0]) not in ASKS or not _counts(run, strict=source.says(STOPS)):
            continue
        state = ASKS[str(words[0])]
        yield finding(
            words[0],
            f"This succeeds as soon as one of the {len(words) - 1} units is {state}: the others may be down",
            advice="ask for each unit by itself",
            related=[note(words[1], f"when this one is {state}, nothing is asked of the next")],
        )


def _counts(run: Run, *, strict: bool) -> bool:
    """Whether the script stops or goes another way where the command fails, and not where it succeeds."""
    if not any(word in ("-q", "--quiet") for word in run.words):
        return False
    place = run.command.words[0].span
    if BEFORE.search(place.source.line_before(place.start)) is None:
        return False
    return run.command.ends == "||" or (strict and run.command.ends in ALONE)
