"""A comment after a value becomes part of the value.

## What it finds
A space and `#` after a value, or after its closing quote, in a file that a unit reads with EnvironmentFile=. A `#`
without a space before it, as in a URL or a colour, and a `#` in quotes are not reported.

## Why it matters on a robot
`ROS_DOMAIN_ID=42 # robot` sets the variable to the whole text, and every node refuses to start. Shells that source
the same file see 42, which makes the mistake hard to find.

## Bad
```sh
ROS_DOMAIN_ID=42  # the robot's domain
```

## Good
```sh
# the robot's domain
ROS_DOMAIN_ID=42
```

## When to ignore it
When the `#` is part of the value, for example in a title. Quotes around the value say so, and remove the finding.

## References
- systemd.exec(5), "EnvironmentFile=": comments are lines that start with # or ;
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Invalid domain ID", "ROS_DOMAIN_ID is not an integral number"])
def inline_comment(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for entry in file.entries:
            comment = file.comment(entry)
            if comment is None:
                continue
            start = entry.span.start
            text = file.source.text
            cut = comment.span.start
            while text[cut - 1] in " \t":
                cut -= 1
            edits = (
                (file.source.span(start, start), f"{comment}\n"),
                (file.source.span(cut, comment.span.end), ""),
            )
            yield finding(
                comment,
                f"Comments need their own line: '{_shortened(comment)}' becomes part of the value of {entry.name}",
                advice="put the comment on a separate line above",
                related=[note(file.readers[0].value, "the service reads it here")],
                fix=fix("move the comment above", *edits) if "\n" not in entry.span.text else None,
            )


def _shortened(text: Located) -> str:
    return text if len(text) <= 30 else f"{text[:27]}..."
