"""The status of a command is asked for, and is that of `tee` or `echo`.

## What it finds
- `$?` right after a pipeline that ends with `tee`, `sed`, `cat`, `ts` or another command that only passes on what it
  reads, or with a shell that runs what `curl` or `wget` brings, in a script without `pipefail`;
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

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SHELLS
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import shell_input
from bringup_lint.api.shell import unwrapped

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
ANSWERS = regex(r"(?:[^\n]*[/\d$;{ ])?[qQ] ?\d+[ ;}]*|-[cC]|--check(?:=\S*)?")
"""What makes the status of sed, or of sort, an answer of its own."""
LOADS = ("curl", "wget")
ENDS = ("", "\n", ";")
REPORTS = ("echo", "printf", "sleep")
TESTS = ("[", "[[", "test")
STATUS = regex(r"\$\?|\$\{\?\}")


SOURCES = regex(r"(?m)(?:^|[;&])[ \t]*(?:source|\.)[ \t]+(?![\"']?(?:/etc/|/opt/ros/|~/\.|\$HOME/\.))")
"""A file that may be one of the tree."""
PIPEFAIL = regex(r"\bpipefail\b", hints="pipefail")


@rule("warning", silent="the command counts as successful")
def pipe_status(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "$?" in source.text:
            strict = "pipefail" in source.text or (SOURCES.search(source.text) and robot.mentions(PIPEFAIL))
            yield from _of(shell_blocks(source), bool(strict))


def _of(blocks: tuple[Block, ...], strict: bool) -> Iterator[Finding]:
    for first, last, block in zip((None, *blocks), blocks, blocks[1:]):
        asks = next(iter(block.condition), block).command
        status = _status(asks) if asks is not None and block.kind in ("command", "branches") else None
        before, report = first.command if first is not None else None, last.command
        if status is None or asks is None or report is None:
            continue
        if before is not None and before.ends in ("|", "|&"):
            if not strict and _passes_on(before, report) and asks.name != "trap":
                yield finding(
                    status,
                    f"This is the status of {_program(report)}, which succeeds also when {_program(before)} fails",
                    advice="write set -o pipefail, or ask for ${PIPESTATUS[0]}",
                    related=[note(before.words[0], "its status is lost in the pipe")],
                )
        elif _only_reports(report) and asks.name in TESTS and (before is None or before.ends not in ("&&", "||")):
            yield finding(
                status,
                f"This is the status of {report.name}, which succeeds whatever the command before it did",
                advice=f"ask before {report.name}, or write 'if ! COMMAND; then'",
                related=[note(report.words[0], "sets $? anew")],
            )
    for block in blocks:
        for body in block.bodies:
            yield from _of(body, strict)


def _passes_on(first: Command, last: Command) -> bool:
    """Whether the last command succeeds also when the first one fails: a shell that reads nothing does nothing."""
    if last.ends not in ENDS or not first.words:
        return False
    if _program(last) in SHELLS:
        return _program(first) in LOADS and shell_input(unwrapped(last.words)[1:]) is None
    return last.name in PASSES and first.name not in MAKES and not any(map(ANSWERS.fullmatch, last.words))


def _program(command: Command) -> str:
    words = unwrapped(command.words)
    return program_name(words[0]) if words else ""


def _only_reports(command: Command) -> bool:
    """Whether a command writes to the terminal or waits, so that it does not fail."""
    plain = command.name == "echo" or not any("$" in word or word == "-v" for word in command.words)
    shown = all(each.operator == ">&" and each.target == "2" for each in command.redirects)
    return command.name in REPORTS and command.ends in ("\n", ";") and plain and shown


def _status(command: Command) -> Located | None:
    words = (*command.assignments, *command.words)
    return next((word.part(*match.span()) for word in words if (match := STATUS.search(word))), None)
