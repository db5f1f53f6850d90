"""A line of limits.conf has no effect.

## What it finds
A line in `limits.conf` or `limits.d` that pam_limits drops: one without its four words, with a type that is not `soft`,
`hard` or `-`, or with an item that does not exist, such as `rt_prio` for `rtprio`.

## Why it matters on a robot
The control loop asks for real-time priority or locked memory and gets "Operation not permitted". Most programs go on
without, and the arm trembles only when the computer is busy.

## Bad
```
@realtime rtprio 95
@realtime - rt_prio 95
```

## Good
```
@realtime - rtprio 95
```

## When to ignore it
Never: nothing reads the line.

## References
- limits.conf(5)
- pam_limits(8)
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

TYPES = ("soft", "hard", "-")
ITEMS = (
    "core data fsize memlock nofile rss stack cpu nproc as maxlogins nonewprivs maxsyslogins priority locks sigpending"
    " msgqueue nice rtprio chroot"
).split()


@rule("error", symptoms=["pam_limits(*): invalid line", "pam_limits(*): unknown limit item", "unknown limit type"])
def limits_invalid(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("limits-conf"):
        if source.judged and not source.template:
            for words in _lines(source):
                yield from _judged(words)


def _lines(source: Source) -> Iterator[list[Located]]:
    start = 0
    for text in source.text.splitlines(keepends=True):
        words = list(source.located(start, start + len(text.partition("#")[0].rstrip())).words())
        start += len(text)
        if words and not any(mark in word for word in words for mark in "${<"):
            yield words


def _judged(words: Sequence[Located]) -> Iterator[Finding]:
    if len(words) == 2 and words[1] == "-":
        return
    if len(words) < 4:
        lacking = "the type (soft, hard or -)" if len(words) == 3 and words[1].lower() in ITEMS else "a word"
        yield finding(
            words[0],
            f"This line lacks {lacking}: pam_limits drops it, and nobody gets the limit",
            advice="write four words: who, soft or hard or -, item, value",
        )
    elif words[1].lower() not in TYPES:
        yield finding(
            words[1], f"There is no type '{words[1]}': pam_limits drops the line", advice="write soft, hard or -"
        )
    elif words[2].lower() not in ITEMS:
        meant = nearest(words[2].replace("_", ""), ITEMS)
        yield finding(
            words[2],
            f"There is no limit '{words[2]}': pam_limits drops the line",
            advice=f"write {meant[0]}" if meant else "see limits.conf(5) for the items",
        )
