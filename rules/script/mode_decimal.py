"""Ansible sets another mode than the one that is meant.

## What it finds
`mode: 644` in a task of Ansible that writes a file or makes a folder: a number without quotes and without a leading
zero. A decimal number that is a usual mode, such as 420 for 0644, is not reported. It is a warning where everybody may
read the file all the same, as with 644.

Modes that let the group or everybody read or write what the owner may not, such as 0577, are a warning.

## Why it matters on a robot
YAML reads 644 as six hundred and forty-four, which is 1204 in octal: the owner may only write, the group may read
nothing, and the sticky bit is set. A unit or udev rule of root works by chance. What a user of the robot reads, as the
configuration of DDS or the environment of a service, cannot be opened.

## Bad
```yaml
- ansible.builtin.copy: {src: cyclonedds.xml, dest: /etc/mower/cyclonedds.xml, mode: 644}
```

## Good
```yaml
- ansible.builtin.copy: {src: cyclonedds.xml, dest: /etc/mower/cyclonedds.xml, mode: "0644"}
```

## When to ignore it
Never.

## References
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/copy_module.html, "mode"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import file_modes
from bringup_lint.api.yaml import Scalar

MODE = regex(r"[1-7]?[0-7]{3}")
LARGEST = 0o7777
MEANT = (0o400, 0o600, 0o640, 0o644, 0o660, 0o664, 0o777)
"""Usual modes whose decimal numbers have octal digits only, such as 420."""
MOST = 20


ODD = regex(r"(?:0?[0-7])?(?P<owner>[0-7])(?P<group>[0-7])(?P<others>[0-7])")
READ_OR_WRITE = 6


@rule("error", fix="unsafe", silent="Ansible sets the wrong mode without a word")
def mode_decimal(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("ansible"):
        given = [each.mode for each in file_modes(source)] if source.judged and "mode" in source.text else []
        yield from map(_of_odd, filter(_is_odd, given))
        modes = list(filter(_is_decimal, given))
        if modes:
            first, *others = modes
            yield finding(
                first.value,
                _message(first),
                advice=f'write mode: "0{first.value}"',
                related=[note(other.value, "and this one") for other in others[:MOST]],
                fix=fix("write it in quotes", *((each.span, f'"0{each.value}"') for each in modes), safe=False),
                severity="warning" if all(map(_is_readable, modes)) else None,
            )


def _message(mode: Scalar) -> str:
    number = int(mode.value)
    if number > LARGEST:
        return f"mode {mode.value} is a decimal number to YAML, and no mode of a file: the task fails"
    return f"mode {mode.value} is a decimal number to YAML: the file gets {number:04o}"


def _is_readable(mode: Scalar) -> bool:
    """Whether everybody may read the file all the same, and nobody but its owner write it."""
    return int(mode.value) <= LARGEST and int(mode.value) & 0o026 == 0o004


def _of_odd(mode: Scalar) -> Finding:
    return finding(
        mode.value,
        f"mode {mode.value} lets others do what the owner of the file may not",
        advice='write mode: "0644", or "0755" for programs and folders',
        severity="warning",
    )


def _is_odd(mode: Scalar) -> bool:
    """Whether an octal mode gives the group or everybody a right that it takes from the owner."""
    match = ODD.fullmatch(mode.value)
    if match is None or not (mode.style or mode.value.startswith("0")):
        return False
    owner, group, others = (int(digit, 8) for digit in match.groups())
    return bool((group | others) & ~owner & READ_OR_WRITE)


def _is_decimal(mode: Scalar) -> bool:
    if mode.style or mode.tag or mode.value.startswith("0") or not MODE.fullmatch(mode.value):
        return False
    return int(mode.value) not in MEANT
