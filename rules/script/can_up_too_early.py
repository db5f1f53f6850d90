"""A CAN bus is brought up before it has a bit rate.

## What it finds
`ip link set can0 up` before `ip link set can0 type can bitrate ...` of the same script, with nothing between them that
takes the bus down again.

Silent where another file of the tree has to do with a bit rate, or the script uses `ifup` or runs other scripts.

## Why it matters on a robot
The kernel refuses to bring up a bus without a bit rate: `RTNETLINK answers: Invalid argument`. With `set -e` the script
ends there; without it the bus gets its bit rate and stays down. On the developer's machine it worked, because the bus
had been set up by hand before.

## Bad
```sh
ip link set can0 up
ip link set can0 type can bitrate 250000
```

## Good
```sh
ip link set can0 type can bitrate 250000
ip link set can0 up
```

## When to ignore it
When something else has set the bit rate before the script runs.

## References
- https://docs.kernel.org/networking/can.html
- ip-link(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

OTHERS = regex(r"\bif(?:up|down|config)\b|\.sh\b")


@rule("error", silent="the kernel says only that an argument is invalid, as for a bus without any configuration")
def can_up_too_early(robot: Robot) -> Iterator[Finding]:
    if any(file.has_bit_rate for file in robot.can.files):
        return
    if sum("bitrate" in each.text for each in robot.sources) > 1:
        return
    known: dict[tuple[Source, str], Run] = {}
    for source, run in robot.scripts.run("ip"):
        if "link" not in run.words or not run.certain or OTHERS.search(source.text):
            continue
        for name in (str(word) for word in run.words if "can" in word.lower() and word != "can"):
            first = known.setdefault((source, name), run)
            if "down" in run.words:
                known[source, name] = run
            elif _gives_rate(run) and _only_brings_up(first):
                known[source, name] = run
                yield finding(
                    first.words[0],
                    f"{name} has no bit rate yet: the kernel refuses to bring it up",
                    advice="set the type and the bit rate first, then bring the bus up",
                    related=[note(run.words[0], "the bit rate is set here")],
                )


def _gives_rate(run: Run) -> bool:
    return "type" in run.words and "bitrate" in run.words


def _only_brings_up(run: Run) -> bool:
    """Whether a command needs a bit rate that it does not set, and its failure is not expected."""
    return (
        "up" in run.words
        and "type" not in run.words
        and run.command.ends not in ("||", "&&")
        and not run.command.hides_errors
    )
