"""A line that logrotate cannot parse: it skips the stanza or the rest of the file.

## What it finds
A syntax error in a logrotate file:

- a line that begins with neither a word nor a path;
- a directive that runs into the next character;
- quotes that are not closed;
- lines that end in CR LF;
- text after `}`, as a warning.

## Why it matters on a robot
Inside a stanza, logrotate skips the whole stanza. Outside, it skips the rest of the file. Nothing is rotated,
and the disk fills up.

## Bad
```
/var/log/ros2/*.log {
    - weekly
}
```

## Good
```
/var/log/ros2/*.log {
    weekly
}
```

## When to ignore it
Never: logrotate does not apply the file as written.

## References
- logrotate(8)
- logrotate: "lines must begin with a keyword or a filename (possibly in double quotes)"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WHAT = {
    "not-separated": "'{text}' runs into the next character",
    "bad-line-start": "'{text}' is neither a directive nor a path",
    "bad-quotes": "The quotes around the paths are not closed",
    "text-after-brace": "logrotate ignores the text after '}}'",
}


@rule("error", symptoms=["lines must begin with a keyword", "not properly separated", "unexpected text after }"])
def syntax(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        dos = "\r\n" in file.source.text
        for problem in file.problems:
            if problem.code not in WHAT:
                continue
            if dos and problem.code in ("bad-line-start", "text-after-brace"):
                yield finding(
                    problem.where,
                    "The lines end in CR LF: logrotate reads the CR as text and skips the stanzas",
                    advice="save the file with LF line endings",
                )
                break
            inside = any(s.header.start < problem.span.start and s.skipped for s in file.stanzas)
            cost = "logrotate skips the stanza" if inside else "logrotate skips the rest of the file"
            what = WHAT[problem.code].format(text=problem.where[:40])
            alone = problem.code == "text-after-brace"
            yield finding(
                problem.where,
                what if alone else f"{what}: {cost}",
                advice="begin each line with a directive or a path",
                severity="warning" if alone else None,
            )
