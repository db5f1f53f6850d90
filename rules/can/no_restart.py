"""A CAN bus stays off after an error.

## What it finds
A CAN interface with a bit rate and without `restart-ms` or `RestartSec=`, in scripts, units and `.network` files, where
nothing of the tree restarts a bus. Silent for serial adapters (slcan), which cannot be restarted so. It is an info
where a document of the tree says that `restart-ms` is left out on purpose or by a specification.

## Why it matters on a robot
A loose plug, a short circuit or a controller that loses its power makes the CAN controller count errors, until it goes
"bus-off" and takes no more part. By default the kernel leaves it there: the motors do not answer again before somebody
takes the interface down and up.

## Bad
```sh
ip link set can0 up type can bitrate 500000
```

## Good
```sh
ip link set can0 up type can bitrate 500000 restart-ms 100
```

## When to ignore it
When a person is to look at the bus before the robot goes on, or the driver restarts it.

## References
- https://docs.kernel.org/networking/can.html, "Bus-off recovery"
- systemd.network(5), "[CAN] Section Options"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

RESTARTS = regex(r"\brestart[-_]ms\b|\btype[ \t]+can[ \t]+restart\b|\bRestartSec=", hints="estart")
DOCUMENT = regex(r"\.(?:md|rst|txt|adoc)$")
NAMES = regex(r"\brestart[-_]ms\b")
LEAVES_OUT = regex(r"\b(?:no|not|without|omit\w*|leaves?|left|unset|never)\b", re.I)
ON_PURPOSE = regex(
    r"\b(?:on purpose|deliberate(?:ly)?|intentional(?:ly)?|by design"
    r"|(?:per|by) (?:the )?(?:\w{1,40} )?spec(?:ification)?)\b",
    re.I,
)
SENTENCES = regex(r"(?<=[.!?])\s+|\n[ \t]*\n")
MOST = 512 * 1024
"""Bytes of a document that is read."""
SETS = regex(r"\bip[ \t]+link[ \t]+set\b[^\n;&|]{0,100}\btype[ \t]+can\b[^\n;&|]{0,100}\bbitrate\b")


@rule("warning", symptoms=["bus-off", "state BUS-OFF"])
def no_restart(robot: Robot) -> Iterator[Finding]:
    found = list(_set_up(robot))
    if not found or any(RESTARTS.search(each.text) for each in robot.of_kind("shell-script", "networkd")):
        return
    first, *others = found
    yield finding(
        first,
        "After a bus-off, this CAN bus stays off until somebody takes the interface down and up again",
        advice="add RestartSec=100ms" if first.span.source.kind == "networkd" else "add restart-ms 100",
        related=[note(other, "stays off, too") for other in others[:20]],
        severity="info" if any(map(_leaves_it_out, robot.tree.pages(DOCUMENT, MOST))) else None,
    )


def _leaves_it_out(page: str) -> bool:
    """Whether a sentence says that the time to the restart is left out on purpose."""
    sentences = SENTENCES.split(page) if NAMES.search(page) else ()
    return any(all(each.search(sentence) for each in (NAMES, LEAVES_OUT, ON_PURPOSE)) for sentence in sentences)


def _set_up(robot: Robot) -> Iterator[Located]:
    """Where CAN interfaces get their bit rate."""
    for file in robot.can.files:
        yield from file.values("CAN", "BitRate")
    for source, run in robot.scripts.run("ip"):
        if "type" in run.words and "can" in run.words and "slcan" not in source.text:
            yield from (word for word in run.words if word == "bitrate")
    for unit in robot.units.judged:
        for key in ("ExecStartPre", "ExecStart", "ExecStartPost"):
            for value in unit.values(key, unit.section):
                match = SETS.search(value)
                if match is not None and not RESTARTS.search(value):
                    yield value.part(*match.span())
