"""A service without root runs a command that only root may run.

## What it finds
A system service with a `User=` other than root, or `DynamicUser=`, whose command line or script
- sets up an interface (`ip link set`, `ip addr add`, `ip route add`, `ifconfig can0 up`, `slcand`, `tc qdisc add`),
- loads a module, writes a kernel parameter (`modprobe`, `sysctl -w`), or writes below `/proc/sys`, `/sys/module`,
  `/sys/kernel` or `/sys/devices/system/cpu`,
- changes the owner or mode of a node in /dev,
- starts, stops or enables units (`systemctl restart rover`), in a tree that has and writes no files of polkit,
- sets the clocks of the board (`nvpmodel -m`, `jetson_clocks`, `cpufreq-set`, `cpupower frequency-set`).

Silent for commands after `sudo`, in scripts that start themselves again with `sudo`, with the prefix `+` or `!`, of
services with `AmbientCapabilities=` or `PermissionsStartOnly=`, and where a failure is expected (`||`, `2>/dev/null`,
`-`).

## Why it matters on a robot
It works in the shell of whoever is root, or types `sudo`. In the service it ends with "Operation not permitted": the
CAN interface stays down, the motors do not answer, or the service does not start.

## Bad
```ini
User=heron
ExecStartPre=/sbin/ip link set can0 up type can bitrate 500000
```

## Good
```ini
User=heron
ExecStartPre=+/sbin/ip link set can0 up type can bitrate 500000
```

## When to ignore it
When the program has file capabilities, or a udev rule gives the file to the user.

## References
- systemd.service(5), "Command lines": the prefix `+`
- capabilities(7): CAP_NET_ADMIN, CAP_SYS_MODULE, CAP_FOWNER
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit

OF_IP = regex(
    r"ip (?:-\S+ )*(?:l|li|lin|link) (?:set|add|del|delete) .*"
    r"|ip (?:-\S+ )*(?:a|addr|address|r|ro|route|ru|rule) (?:add|del|delete|flush|replace|change) .*"
    r"|ifconfig \S+ \S.*|(?:slcand|slcan_attach) .*|tc qdisc (?:add|replace|del) .*"
    r"|(?:modprobe|insmod|rmmod) .*|sysctl (?:.* )?-w .*|nvpmodel (?:.* )?-m .*|jetson_clocks(?: --fan)?"
    r"|cpufreq-set .*|cpupower (?:.* )?frequency-set .*|(?:chmod|chown|chgrp) (?:\S+ )+/dev/(?!shm/|mqueue/|pts/)\S.*"
)
OF_MANAGER = regex(
    r"systemctl (?!(?:.* )?--user)(?:-\S+ )*(?:re)?(?:start|load|stop|enable|disable|mask|unmask|daemon-reload)(?: .*)?"
)
POLKIT = regex(r"(?:^|/)polkit(?:-1)?/|\.pkla$", hints="polkit .pkla")
POLKIT_WRITTEN = regex(r"/polkit-1/|\.pkla\b", hints="polkit-1 .pkla")
OF_ROOT = regex(r"/proc/sys/.*|/sys/(?:module|kernel|devices/system/cpu)/.*")
RAISED = ("sudo", "doas", "pkexec", "su", "setpriv", "capsh", "docker", "podman", "ssh", "nsenter")


class Refused(NamedTuple):
    process: Process
    step: Step
    where: Located
    what: str


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "RTNETLINK answers: Operation not permitted",
        "modprobe: ERROR: could not insert '*': Operation not permitted",
        "tee: /sys/*: Permission denied",
        "sysctl: permission denied on key *",
        "Failed to restart *: Interactive authentication required.",
    ],
)
def root_needed(robot: Robot) -> Iterator[Finding]:
    asks = not any(True for _ in robot.tree.like(POLKIT)) and not robot.mentions(POLKIT_WRITTEN)
    for unit in robot.units.services:
        if unit.manager != "system" or unit.identity.is_root is not False or not unit.complete:
            continue
        if unit.has("AmbientCapabilities") or unit.flag("PermissionsStartOnly") or unit.has("PAMName"):
            continue
        found = list(_refused(robot, unit, asks))
        if found:
            yield _finding(unit, *found)


def _refused(robot: Robot, unit: Unit, asks: bool) -> Iterator[Refused]:
    for process in robot.units.processes(unit):
        if any(prefix in process.prefixes for prefix in "+!-"):
            continue
        for step in process.steps:
            refused = _of(step.command, asks)
            if refused is not None and not (step.script and robot.scripts.raises_itself(step.script)):
                yield Refused(process, step, refused, program_name(step.command.words[0]))


def _of(command: Command, asks: bool) -> Located | None:
    """What of a command the kernel refuses to others than root."""
    words = command.words
    if not words or command.ends == "||" or command.depth or any(program_name(word) in RAISED for word in words[:3]):
        return None
    if any(each.target == "/dev/null" and each.descriptor == "2" for each in command.redirects):
        return None
    line = " ".join((program_name(words[0]), *words[1:]))
    if OF_IP.fullmatch(line) or (asks and OF_MANAGER.fullmatch(line)):
        return words[0]
    written = [each.target for each in command.redirects if each.writes and each.target is not None]
    written += words[1:] if program_name(words[0]) == "tee" else ()
    return next((target for target in written if OF_ROOT.fullmatch(target)), None)


def _finding(unit: Unit, first: Refused, *others: Refused) -> Finding:
    user = unit.identity.user
    who = f"User={user}" if user else "DynamicUser="
    at = user or (unit.identity.dynamic.at if unit.identity.dynamic else None)
    direct = not first.step.shell and first.process.key in ("ExecStartPre", "ExecStart")
    return finding(
        first.where,
        f"Only root may do this, and {unit.name} has {who}: {first.what} "
        + ("fails, and the service does not start" if direct else "fails"),
        advice="prefix this one command with '+', or move it to a service of its own",
        severity="error" if direct else None,
        related=[
            *([note(at, "the user")] if at else []),
            *([note(first.process.program, f"{unit.name} starts the script here")] if first.step.script else []),
            *(note(other.where, "nor this") for other in others),
        ],
    )
