r"""A line of a udev rules file cannot be read.

## What it finds
Tokens that are not `KEY=="value"`: unknown keys, values without double quotes, a blank after a continuing
backslash, a missing brace, a byte order mark, an attribute where none belongs. A `\` that ends the file
counts too.

## Why it matters on a robot
udev drops the whole line, with all keys on it, and says so only in the journal. The device stays without its
link and its permissions, and the driver looks for a path that never appears.

## Bad
```udev
SUBSYTEM=="tty", ATTRS{idVendor}=='0403', SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", SYMLINK+="robot/imu"
```

## References
- udev(7), "Rules Files"
- `udevadm verify` of systemd 254 and newer reports the same lines
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_ADVICE = {
    "no-operator": ('This is no KEY=="value"', "write a key, an operator and a value in double quotes"),
    "unquoted-value": ("The value has no double quotes", "put the value in double quotes"),
    "single-quoted-value": ("The value stands in single quotes", "use double quotes"),
    "value-not-closed": ("The closing double quote is missing", "close the value"),
    "attribute-not-closed": ("The closing brace is missing", "close the attribute with }"),
    "bad-escape": ("udev does not know this escape", "write the character itself or a C escape"),
    "blank-after-backslash": ("A blank behind the backslash ends the rule here", "delete the blank"),
    "end-of-file-in-rule": ("The file ends inside a continued rule", "delete the last backslash"),
    "line-too-long": ("The rule is longer than the 16 KiB that udev reads", "split it into several rules"),
    "byte-order-mark": (
        "A byte order mark makes the first key unknown",
        "save the file without a byte order mark",
    ),
    "invalid-attribute": ("udev does not accept the braces here", ""),
    "bad-test-mode": ("TEST takes an octal mode in its braces", "write octal digits"),
    "assignment-of-any-case": ("The prefix i is for == and != only", "delete the prefix"),
    "any-case-not-allowed": ("This key takes no prefix i", "delete the prefix"),
    "unknown-builtin": ("udev has no such builtin", "name a builtin that udev(7) lists"),
    "bad-option-value": ("udev cannot read the value of this option", "write a number, or a log level"),
    "name-without-effect": ("udev refuses this NAME, which would change nothing", "delete the assignment"),
}
_KEPT = {
    "unknown-option": ("udev does not know this option and passes over it", "delete it"),
    "empty-value": ("udev refuses an empty value here", "write a value or delete the key"),
    "second-jump": ("Only one key of this kind counts on a line", "delete the other one"),
}


@rule(
    "error",
    fix="safe",
    symptoms=[
        "Invalid key/value pair, ignoring",
        "Invalid key",
        "Unexpected EOF after line continuation",
        "Invalid attribute for",
    ],
)
def syntax(robot: Robot):
    for problem, _ in robot.udev.problems(*_ADVICE):
        what, advice = _ADVICE[problem.code]
        if problem.code == "invalid-attribute":
            what, advice = _attribute(problem)
        yield finding(problem.where, f"{what}: udev drops the whole line", advice=advice, fix=_fix(problem))
    for problem, _ in robot.udev.problems("unknown-key", "removed-key"):
        yield _unknown_key(problem)
    for problem, _ in robot.udev.problems(*_KEPT):
        what, advice = _KEPT[problem.code]
        yield finding(problem.where, what, advice=advice, severity="warning")


def _unknown_key(problem):
    if problem.code == "removed-key":
        advice = f"write {problem.detail}" if problem.detail else "delete it"
        return finding(
            problem.where,
            f"udev no longer knows the key {problem.where}: it drops the whole line",
            advice=advice,
        )
    advice = f"did you mean {problem.detail}?" if problem.detail else "write a key that udev(7) lists"
    change = fix(f"write {problem.detail}", (problem.where, problem.detail)) if problem.detail else None
    return finding(
        problem.where, f"Unknown key '{problem.where}': udev drops the whole line", advice=advice, fix=change
    )


def _attribute(problem):
    if problem.detail == "missing":
        return f"{problem.where} needs the name of an attribute in braces", f"write {problem.where}{{name}}"
    if problem.detail == "unexpected":
        return "This key takes nothing in braces", "delete the braces"
    return f"This key does not know the attribute '{problem.where}'", f"write one of {problem.detail}"


def _fix(problem):
    if problem.code == "single-quoted-value":
        return fix("use double quotes", (problem.where, f'"{problem.where[1:-1]}"'))
    if problem.code == "blank-after-backslash":
        return fix("delete the blank", (problem.where, "\\"))
    return None
