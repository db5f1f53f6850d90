r"""udev cannot read a line of a rules file.

## What it finds
Text that udev cannot parse: an unknown key, a value without double quotes, a space after the backslash that
continues a line, a missing brace, a byte order mark, an attribute for a key that has none, or a `\` at the
end of the file. An unknown option, an empty value and a second jump on one line are warnings, because udev
keeps the rest of the line, and so are words without any key; a line of stray marks is an info.

## Why it matters on a robot
udev drops the whole line, with all keys on it, and reports that only in the journal. The device does not get
its link and its permissions, and the driver waits for a path that never appears.

## Bad
```udev
SUBSYTEM=="tty", ATTRS{idVendor}=='0403', SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", SYMLINK+="robot/imu"
```

## When to ignore it
If the file is meant for an older udev that still supports the key, such as `BUS` or `SYSFS`. Otherwise never:
the line has no effect.

## References
- udev(7), "Rules Files"
- `udevadm verify` of systemd 254 and newer reports the same lines
"""

from collections.abc import Iterator
from typing import Literal

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_ADVICE = {
    "no-operator": ('This is not KEY=="value"', "write a key, an operator and a value in double quotes"),
    "unquoted-value": ("The value has no double quotes", "put the value in double quotes"),
    "single-quoted-value": ("The value is in single quotes", "use double quotes"),
    "value-not-closed": ("The closing double quote is missing", "close the value"),
    "attribute-not-closed": ("The closing brace is missing", "close the attribute with }}"),
    "bad-escape": ("udev does not know this escape", "write the character itself or a C escape"),
    "blank-after-backslash": ("A space after the backslash ends the rule here", "delete the space"),
    "end-of-file-in-rule": ("The file ends inside a continued rule", "delete the last backslash"),
    "line-too-long": ("The rule is longer than the 16 KiB that udev reads", "split it into several rules"),
    "byte-order-mark": (
        "A byte order mark makes the first key unknown",
        "save the file without a byte order mark",
    ),
    "invalid-attribute": ("This key does not accept the attribute '{where}'", "write one of {detail}"),
    "missing-attribute": ("{where} needs an attribute name in braces", "write {where}{{name}}"),
    "unexpected-attribute": ("This key does not accept an attribute in braces", "delete the braces"),
    "bad-test-mode": ("TEST accepts an octal mode in its braces", "write octal digits"),
    "assignment-of-any-case": ("The prefix i is valid only with == and !=", "delete the prefix"),
    "any-case-not-allowed": ("This key does not accept the prefix i", "delete the prefix"),
    "unknown-builtin": ("udev has no such builtin", "name a builtin that udev(7) lists"),
    "bad-option-value": ("udev cannot read the value of this option", "write a number, or a log level"),
    "name-without-effect": ("udev rejects this NAME, which would change nothing", "delete the assignment"),
}
_KEPT = {
    "unknown-option": ("udev does not know this option and ignores it", "delete it"),
    "empty-value": ("udev rejects an empty value here", "write a value or delete the key"),
    "second-jump": ("udev uses only one key of this kind on a line", "delete the other one"),
}


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Invalid key/value pair, ignoring",
        "Invalid key",
        "Unexpected EOF after line continuation",
        "Invalid attribute for",
    ],
)
def syntax(robot: Robot) -> Iterator[Finding]:
    for problem, _ in robot.udev.problems(*_ADVICE):
        what, advice = (text.format(where=problem.where, detail=problem.detail) for text in _ADVICE[problem.code])
        yield finding(
            problem.where,
            f"{what}: udev drops the whole line",
            advice=advice,
            fix=_fix(problem),
            severity=_severity(problem),
        )
    for problem, _ in robot.udev.problems("unknown-key", "removed-key"):
        yield _unknown_key(problem)
    for problem, _ in robot.udev.problems(*_KEPT):
        what, advice = _KEPT[problem.code]
        yield finding(problem.where, what, advice=advice, severity="warning")


def _severity(problem: Problem) -> Literal["info", "warning"] | None:
    """By what udev loses with the line: nothing but a stray mark, some words, or a key."""
    place = problem.where if isinstance(problem.where, Span) else problem.where.span
    line = place.source.line_text(place.line)
    if "=" in line:
        return None
    return "warning" if any(character.isalnum() for character in line) else "info"


def _unknown_key(problem: Problem) -> Finding:
    if problem.code == "removed-key":
        advice = f"write {problem.detail}" if problem.detail else "delete it"
        return finding(
            problem.where,
            f"udev no longer supports the key {problem.where}: it drops the whole line",
            advice=advice,
        )
    advice = f"did you mean {problem.detail}?" if problem.detail else "write a key that udev(7) lists"
    change = fix(f"write {problem.detail}", (problem.where, problem.detail)) if problem.detail else None
    return finding(
        problem.where, f"Unknown key '{problem.where}': udev drops the whole line", advice=advice, fix=change
    )


def _fix(problem: Problem) -> Fix | None:
    if problem.code == "single-quoted-value":
        return fix("use double quotes", (problem.where, f'"{problem.where[1:-1]}"'))
    if problem.code == "blank-after-backslash":
        return fix("delete the space", (problem.where, "\\"))
    return None
