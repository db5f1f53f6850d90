"""A comment after a value becomes part of the value.

## What it finds
A blank and # or ; after a value, also in the files of systemd-networkd. systemd recognizes comments only on lines of
their own. Exec lines (where a shell may read the comment), descriptions and quoted values are exempt.

## Why it matters on a robot
The value is the whole rest of the line. `User=robot # the robot's account` names a user that does not exist,
and the service fails with status 217/USER. systemd ignores `RestartSec=5 # seconds`. Of a list, such as `After=`,
`Environment=` or `DNS=`, it ignores the words of the comment alone, with a line of the journal for each: a warning.

## Bad
```ini
[Service]
User=robot  # the service account
```

## Good
```ini
[Service]
# the service account
User=robot
```

## When to ignore it
Only when the # or ; belongs to the value.

## References
- systemd.syntax(7): comments are lines that start with # or ;
- journal: "Failed to determine user credentials: No such process"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import lift_comment

IN_NETWORK = regex(
    r"^(?!Description)(?P<key>[A-Z]\w{1,40})[ \t]{0,8}=[^\n#;\"']{1,200}?[ \t](?P<comment>[#;][^\n]*)", re.M, "="
)
LISTS = frozenset(
    "After Before Wants Requires Requisite BindsTo PartOf Upholds Conflicts OnFailure OnSuccess Environment DNS".split()
)
"""Keys of which systemd takes each word alone, and leaves out what is none of the kind."""
TAKEN = regex(r"\w[.=:/]\w")
"""What may be a unit, an assignment or an address after all."""


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Failed to add dependency on #, ignoring: Invalid argument",
        "Failed to parse",
        "status=217/USER",
    ],
)
def trailing_comment(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        comment = line.comment
        if comment is None:
            continue
        changes = lift_comment(line.assignment, comment)
        on_one_line = "\n" not in line.assignment.span.text and comment != line.value
        yield finding(
            comment,
            f"systemd has no trailing comments: {line.key}= takes '{_shortened(comment)}' as part of the value",
            advice="move the comment to a line of its own above",
            fix=fix("move the comment above", *changes) if on_one_line else None,
            severity=_severity(line.key, comment),
        )
    for source in robot.of_kind("networkd"):
        if source.judged and not source.template:
            for found in IN_NETWORK.finditer(source.text):
                comment = source.located(*found.span("comment"))
                taken = f"{found['key']}= takes '{_shortened(comment)}' as part of the value"
                yield finding(
                    comment,
                    f"systemd has no trailing comments: {taken}",
                    advice="move the comment to a line of its own above",
                    severity=_severity(found["key"], comment),
                )


def _severity(key: str, comment: Located) -> str | None:
    return "warning" if key in LISTS and not TAKEN.search(comment) else None


def _shortened(text: Located) -> str:
    return text if len(text) <= 40 else f"{text[:37]}..."
