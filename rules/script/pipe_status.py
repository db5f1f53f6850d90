"""The status of a command is asked for, and is that of `tee` or `echo`.

## What it finds
- `$?` right after a pipeline that ends with `tee`, `sed`, `cat`, `ts` or another command that only passes on what it
  reads, in a script without `pipefail`;
- a test of `$?` right after `echo`, `printf` or `sleep` that write to no file.

## Why it matters on a robot
The status of a pipeline is that of its last command, and `$?` that of the command right before. `tee` and `echo`
succeed: a failed build, flash or calibration counts as done, and the robot goes on with the old one.

## Bad
```sh
colcon build 2>&1 | tee build.log
if [ $? -ne 0 ]; then exit 1; fi
```

## Good
```sh
set -o pipefail
colcon build 2>&1 | tee build.log
if [ $? -ne 0 ]; then exit 1; fi
```

## When to ignore it
When the status of the last command is what counts.

## References
- bash(1), "Pipelines" and PIPESTATUS
"""

from collections.abc import Iterator
from itertools import islice
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import shell_commands

PASSES = (
    "tee",
    "sed",
    "cat",
    "ts",
    "logger",
    "tr",
    "cut",
    "tail",
    "head",
    "sort",
    "uniq",
    "column",
    "nl",
    "fold",
    "pv",
)
MAKES = ("echo", "printf", "cat", "ls", "yes", "true")
"""Programs whose own failure hardly matters."""
REPORTS = ("echo", "printf", "sleep")
TESTS = ("[", "[[", "test")
STATUS = regex(r"\$\?|\$\{\?\}")


@rule("warning", silent="the command counts as successful")
def pipe_status(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "$?" in source.text:
            yield from _after_report(shell_blocks(source))
            if "pipefail" not in source.text:
                yield from _of(source)


def _of(source: Source) -> Iterator[Finding]:
    commands = list(shell_commands(source))
    threes = zip(commands, islice(commands, 1, None), islice(commands, 2, None))
    for first, last, asks in threes:
        if first.ends != "|" or last.ends not in ("", "\n", ";") or last.name not in PASSES or first.name in MAKES:
            continue
        status = _status(asks)
        if status is not None:
            yield finding(
                status,
                f"This is the status of {last.name}, which succeeds also when {first.name} fails",
                advice="write set -o pipefail, or ask for ${PIPESTATUS[0]}",
                related=[note(first.words[0], "its status is lost in the pipe")],
            )


def _after_report(blocks: tuple[Block, ...]) -> Iterator[Finding]:
    """Tests of a status that is always 0."""
    for before, block in pairwise(blocks):
        report = before.command
        asks = next(iter(block.condition), block).command
        if report is None or asks is None or report.name not in REPORTS or report.ends not in ("\n", ";"):
            continue
        if any(each.writes for each in report.redirects):
            continue  # the file may not be writable
        status = _status(asks) if asks.name in TESTS and block.kind in ("command", "branches") else None
        if status is not None:
            yield finding(
                status,
                f"This is the status of {report.name}, which succeeds whatever the command before it did",
                advice=f"ask before {report.name}, or write 'if ! COMMAND; then'",
                related=[note(report.words[0], "sets $? anew")],
            )
    for block in blocks:
        for body in block.bodies:
            yield from _after_report(body)


def _status(command: Command) -> Located | None:
    words = (*command.assignments, *command.words)
    return next((word.part(*match.span()) for word in words if (match := STATUS.search(word))), None)
