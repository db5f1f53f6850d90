"""udevadm trigger leaves out the devices of the new rules.

## What it finds
`udevadm trigger` in a script or in the tasks of Ansible, with options by which no event reaches the devices of the
rules that the same script or role installs: `--subsystem-match=` of another subsystem, or no `--action=add` for rules
that match `ACTION=="add"` and set a mode, a group or a program. Links that such rules make belong to
udev/action-add-only-symlink.

It is an info in the tasks of a role that no playbook of the tree uses. Silent if a further trigger reaches the
devices, if the options choose devices in other ways, and if the script, or one that runs it, starts the computer again.

## Why it matters on a robot
The devices that are plugged in keep their old names and modes until somebody plugs them in anew or the robot is
started again: the camera works on the bench, and not directly after the installation.

## Bad
```sh
cp 70-rover-camera.rules /etc/udev/rules.d/       # SUBSYSTEM=="video4linux", SYMLINK+="front"
udevadm control --reload && udevadm trigger --subsystem-match=tty
```

## Good
```sh
cp 70-rover-camera.rules /etc/udev/rules.d/
udevadm control --reload && udevadm trigger
```

## When to ignore it
When the devices are plugged in after the installation, or the robot is started again.

## References
- udevadm(8), trigger: the default action is change
"""

import os
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import UdevRule

TRIGGER = regex(r"\budevadm[ \t]+trigger\b(?P<options>[^\n|;&\"'#)`]*)")
OPTION = regex(
    r"(?:--subsystem-match|-s)[= \t]*(?P<subsystem>[\w*?-]+)|(?:--action|-c)[= \t]*(?P<action>\w+)"
    r"|--type=devices|--settle|-w\b|--verbose|-v\b|--quiet|-q\b|-{0,1}\d?>\S*|[ \t]+"
)
RESTARTS = regex(r"\b(?:soft-)?reboot\b|shutdown[ \t]+-r")
SHOWN = regex(
    r"\b(?:echo|printf)\b(?:[^;&|\"']|\"[^\"]*(?:\"|$)|'[^']*(?:'|$))*$|^[ \t]*(?:-[ \t]+)?(?:name|msg):|#",
)
"""What comes before a trigger that is only text: the command of its own that prints it, a name or a comment."""
BEFORE = 400
"""Characters of the line before a trigger that are read."""
ROLE = regex(r"(?P<role>.*/)?(?:tasks|handlers)/[^/]+")
LINKS = ("SYMLINK", "TAG")
SETS = ("MODE", "GROUP", "OWNER", "RUN", *LINKS)


class Trigger(NamedTuple):
    """One ``udevadm trigger`` that gives events to the devices of some subsystems."""

    place: Span
    subsystems: frozenset[str]
    """Empty: all."""
    actions: frozenset[str]


@rule("warning", confidence="medium", symptoms=["No such file or directory: '/dev/", "Permission denied: '/dev/"])
def trigger_misses(robot: Robot) -> Iterator[Finding]:
    sources = (each for each in robot.of_kind("shell-script", "ansible") if "udevadm" in each.text)
    known = {source: _triggers(source) for source in sources}
    reaching_all = [source for source, triggers in known.items() if _reach_all(source, triggers)]
    files = {each.source for each in robot.udev.judged}
    for source, triggers in known.items():
        if not source.judged or not triggers or _restarts(robot, source):
            continue
        if source.kind == "ansible" and any(other is not source for other in reaching_all):
            continue
        installed = {file for file in files if _is_installed(source, file)}
        missed = [each for each in robot.udev.judged if each.source in installed and _misses(triggers, each)]
        if missed:
            yield _finding(triggers, missed, "info" if _is_unused_role(robot, source) else None)


def _is_unused_role(robot: Robot, source: Source) -> bool:
    """Whether a file is of a role of Ansible that no other file names, in a tree with playbooks."""
    found = ROLE.fullmatch(source.name)
    name = os.path.basename((found["role"] or "").rstrip("/")) if found is not None else ""
    if not name:
        return False
    named = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    others = [each.text for each in robot.of_kind("ansible") if each is not source]
    return any("hosts:" in text for text in others) and not any(map(named.search, others))


def _restarts(robot: Robot, source: Source) -> bool:
    """Whether the computer is started again by the script, or by one that runs it."""
    callers = (each for each in robot.of_kind("shell-script") if source.basename in each.text)
    return any(RESTARTS.search(each.text) for each in (source, *callers))


def _reach_all(source: Source, triggers: list[Trigger]) -> bool:
    """Whether a file of Ansible, whose tasks may follow those of another one, gives events to all devices."""
    return source.kind == "ansible" and any(not trigger.subsystems for trigger in triggers)


def _finding(triggers: list[Trigger], missed: list[UdevRule], severity: str | None) -> Finding:
    subsystems = sorted({name for each in missed for name in each.subsystems})
    reaching = next((each for each in triggers if _reaches(each, missed[0], links=True)), None)
    by_action = reaching is not None
    trigger = reaching or triggers[0]
    devices = f"the devices of {subsystems[0]}" if subsystems else "the devices of the new rules"
    return finding(
        trigger.place,
        f"This trigger sends change, and the new rules wait for add: {devices} keep their modes until the next boot"
        if by_action
        else f"This trigger leaves out {devices}: those that are there keep their names and modes until the next boot",
        advice="write udevadm trigger --action=add" if by_action else "write udevadm trigger without --subsystem-match",
        related=[note(each.line.tokens[0].key, "a rule that no event reaches") for each in missed[:5]],
        severity=severity,
    )


def _triggers(source: Source) -> list[Trigger]:
    """The triggers of a file; none where one of them chooses devices by what is not known here."""
    found = []
    for match in TRIGGER.finditer(source.text):
        if SHOWN.search(_before(source.text, match.start())):
            continue
        if OPTION.sub("", match["options"]).strip():
            return []
        options = list(OPTION.finditer(match["options"]))
        subsystems = frozenset(each["subsystem"] for each in options if each["subsystem"])
        actions = frozenset(each["action"] for each in options if each["action"]) or frozenset({"change"})
        found.append(Trigger(source.span(*match.span()), subsystems, actions))
    return found


def _before(text: str, at: int) -> str:
    """The text of the line before a place."""
    return text[max(0, at - BEFORE) : at].rpartition("\n")[2]


def _is_installed(source: Source, file: Source) -> bool:
    """Whether the script or role brings a file of rules."""
    if file.origin is not None:
        return file.origin.whole.source is source
    role = ROLE.fullmatch(source.name) if source.kind == "ansible" else None
    if role is not None and file.name.startswith((f"{role['role'] or ''}files/", f"{role['role'] or ''}templates/")):
        return True
    if file.basename not in source.text:
        return False
    return re.search(rf"(?<![\w.-]){re.escape(file.basename)}(?![\w-])", source.text) is not None


def _misses(triggers: list[Trigger], line: UdevRule) -> bool:
    sets = [token.key for token in line.line.tokens if not token.is_match]
    if not any(key in SETS for key in sets):
        return False
    if not line.subsystems and any(trigger.subsystems for trigger in triggers):
        return False
    return not any(_reaches(trigger, line, links=any(key in LINKS for key in sets)) for trigger in triggers)


def _reaches(trigger: Trigger, line: UdevRule, *, links: bool) -> bool:
    if (
        trigger.subsystems
        and not any("*" in name for name in trigger.subsystems)
        and not trigger.subsystems & line.subsystems
    ):
        return False
    return links or any(action in line.actions for action in trigger.actions)
