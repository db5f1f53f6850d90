"""A script reports an error and ends with success.

## What it finds
`exit 0`, or `exit` alone, which gives the status of the message, directly after a message that speaks of an error: one
that begins with "error", says that something failed or could not be done, or is printed by a function such as
`log_error`.

Silent where the message says that something is skipped, already done or not needed.

## Why it matters on a robot
systemd, a Dockerfile, Ansible and `&&` look only at the exit status. With 0 the installation counts as complete, and
`Restart=on-failure` does not start the script again: the robot goes on without what just failed.

## Bad
```sh
if ! wget -q -O /tmp/arm.deb "$URL"; then
    echo "Error: the driver cannot be downloaded"
    exit 0
fi
```

## Good
```sh
if ! wget -q -O /tmp/arm.deb "$URL"; then
    echo "Error: the driver cannot be downloaded" >&2
    exit 1
fi
```

## When to ignore it
When whoever starts the script must not see the failure.

## References
- bash(1), "exit"
- systemd.service(5), "Restart="
"""

import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

PRINTS = ("echo", "printf")
REPORTS = {"err", "error", "fatal", "fail"}
"""Words of the names of functions that print an error."""
ERROR = regex(
    r"^[^\n]{0,30}\b(?:ERROR|Error|FATAL)\b"
    r"|\b(?:[Ff]ailed|[Ff]ailure|[Cc]ould ?n[o']t|[Cc]annot|[Cc]an't|[Uu]nable to)\b",
    hints="ERROR Error FATAL ailed ailure ould annot an't nable",
)
HARMLESS = regex(
    r"\b(?:[Ii]nvalid|[Uu]nknown)[ \t]{1,4}(?:\w{1,20}[ \t]{1,4})?(?:flag|option|argument)"
    r"|\b(?:skip\w*|already|ignor\w*|nothing|optional|not needed|warn\w*|no errors?|later|continu\w*)\b",
    re.I,
)


class Ending(NamedTuple):
    message: Located
    exit: Located


@rule("warning", confidence="medium", silent="the script ends with success")
def error_exits_zero(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "exit" not in source.text:
            continue
        if robot.purpose(source).value != "robot":
            continue
        found = list(_endings(shell_blocks(source)))
        if found:
            first, *others = found
            yield finding(
                first.exit,
                "The script has just reported an error, and ends with success: whoever started it takes it for done",
                advice="write exit 1",
                related=[
                    note(first.message, "the error"),
                    *(note(other.exit, "the same here") for other in others[:20]),
                ],
            )


def _endings(blocks: Sequence[Block]) -> Iterator[Ending]:
    """The ends of scripts behind a message of an error."""
    for at, block in enumerate(blocks):
        for body in (*block.bodies, block.condition):
            yield from _endings(body)
        message = _error(block)
        ended = _exit(blocks[at + 1]) if message is not None and at + 1 < len(blocks) else None
        if message is not None and ended is not None and not _is_in_subshell(message):
            yield Ending(message, ended)


def _is_in_subshell(message: Located) -> bool:
    """Whether `exit` ends no more than the parentheses around it."""
    return message.span.source.text[: message.span.start].rstrip().endswith("(")


def _error(block: Block) -> Located | None:
    command = block.command
    if command is None or len(command.words) == 1 or command.ends in ("||", "|", "&"):
        return None
    text = " ".join(command.words[1:])
    if command.name in PRINTS:
        said = ERROR.search(text) is not None
    else:
        said = not REPORTS.isdisjoint(re.split(r"[_-]", command.name.lower()))
    return command.words[0] if said and not HARMLESS.search(text) else None


def _exit(block: Block) -> Located | None:
    """`exit` that gives success."""
    words = block.command.words if block.command is not None else ()
    return words[0] if [str(word) for word in words] in (["exit"], ["exit", "0"]) else None
