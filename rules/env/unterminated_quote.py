"""A quote that is not closed swallows the lines after it.

## What it finds
A quote at the start of a value in a file that a unit reads with EnvironmentFile=, when the quote is never closed,
or is closed only after lines that look like entries.

## Why it matters on a robot
All lines up to the closing quote, or to the end of the file, become part of one value. The variables that they
should set are missing.

## Bad
```sh
RMW_IMPLEMENTATION="rmw_cyclonedds_cpp
ROS_DOMAIN_ID=42
```

## Good
```sh
RMW_IMPLEMENTATION="rmw_cyclonedds_cpp"
ROS_DOMAIN_ID=42
```

## When to ignore it
When the value really has several lines that look like assignments, for example an embedded configuration file.

## References
- systemd.exec(5), "EnvironmentFile=": quoted values may span lines
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import UsedEnvFile


@rule("error", symptoms=["unexpected EOF while looking for matching", "Syntax error: Unterminated quoted string"])
def unterminated_quote(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for problem in file.model.problems:
            if problem.code == "unterminated-quote":
                yield _finding(file, problem.word.part(0, 1), file.swallowed_lines(problem.word))
        open_ended = {problem.word.span.end for problem in file.model.problems if problem.code == "unterminated-quote"}
        for entry in file.model.entries:
            count = file.swallowed_lines(entry.span) if entry.quoted and entry.span.end not in open_ended else 0
            if count:
                yield _finding(file, entry.name, count)


def _finding(file: UsedEnvFile, where: Located, count: int) -> Finding:
    rest = f"swallows the next {count} lines" if count > 1 else "swallows the next line" if count else "is never closed"
    return finding(
        where,
        f"The quote that opens in this line {rest}",
        advice="close the quote on its own line",
        related=[note(file.readers[0].value, "the service reads it here")],
    )
