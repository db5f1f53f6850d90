"""The DDS interface may not be up when ROS starts.

## What it finds
Cyclone DDS names an interface that the robot's netplan marks `optional: true`, so the boot does not wait for
it. No unit that reads the file waits for the interface itself: through its device unit, with wait-online, or
in a script. `presence_required="false"` is not reported if other interfaces are listed too.
It is a warning when netplan says nothing of a Wi-Fi interface, and a system unit that reads the file at boot is ordered
after nothing of the network; both may be templates of Ansible. A unit that is always started again, without a limit
that stops it, gets there by itself.

## Why it matters on a robot
The interface does not exist yet when the nodes start: `does not match an available interface`, and no node
starts. Started by hand minutes later, everything works. Participants never pick up an interface that appears
later.

## Bad
```xml
# netplan
eth0:
  optional: true
```

## Good
```xml
# netplan
eth0:
  optional: false
```

## When to ignore it
If the service restarts until the interface is up (`Restart=on-failure`) and that delay is acceptable.

## References
- netplan YAML reference, "optional"
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- https://github.com/tier4/edge-auto-jetson/pull/82
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Configuration
from bringup_lint.api.cyclonedds import Setting
from bringup_lint.api.dds import interface_of_device
from bringup_lint.api.dds import named_interfaces
from bringup_lint.api.systemd import RestartPolicy
from bringup_lint.api.systemd import Unit

LATE = regex(r"network|\.device$|^dhcp|wpa_|hostapd|\.service$|graphical")
"""Units that start late enough, or may."""
WAITING = regex(r"\b(?:sleep|until|while|nm-online|ping|wait)\b")
WIRELESS = regex(r"wl(?:an\d+|[opxs]\w+)$")


@rule("error", confidence="medium", symptoms=["does not match an available interface"])
def interface_not_waited_for(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        names = list(named_interfaces(domain))
        for setting in names:
            name = str(setting.effective)
            required = domain.of(setting.owner, "presence_required")
            if required is not None and (required.effective or "false").lower() == "false" and len(names) > 1:
                continue
            if robot.dds.waits_for(configuration, name):
                continue
            interface = interface_of_device(plan, name) if plan is not None else None
            optional = interface.optional if interface is not None else None
            if optional is not None and optional.value:
                yield finding(
                    setting.value,
                    f"The boot does not wait for {setting.effective}: if ROS starts first, no node starts",
                    advice="delete optional, and start ROS after network-online.target",
                    related=[note(optional.where, "netplan does not wait for it"), *_order(robot, configuration)],
                    chain=robot.provenance.chain_to(setting.value, f"DDS uses {setting.effective}"),
                )
            elif interface is None and WIRELESS.match(name):
                yield from _at_once(robot, configuration, setting)


def _at_once(robot: Robot, configuration: Configuration, setting: Setting) -> Iterator[Finding]:
    """A Wi-Fi interface, and the first unit that reads the file at boot without an order after the network."""
    for reader in robot.dds.readers(configuration):
        unit = reader.process.unit
        line = reader.process.line
        if unit is None or line is None or not _starts_at_boot(unit) or _waits(unit, line.texts):
            continue
        if _starts_again(robot.units.restart(unit)):
            continue
        yield finding(
            setting.value,
            f"{unit.name} starts before {setting.effective} is associated: 'does not match an available interface', "
            "and no node starts",
            advice="add After= and Wants=network-online.target to the unit",
            related=[note(unit.where, "ordered after nothing of the network")],
            chain=robot.provenance.chain_to(setting.value, f"DDS uses {setting.effective}"),
            severity="warning",
        )
        return


def _starts_again(policy: RestartPolicy) -> bool:
    """Whether a unit is started until the interface is there, when each start takes a second."""
    return policy.restart == "always" and policy.known and (not policy.limited or policy.loop(1.0) > policy.interval)


def _starts_at_boot(unit: Unit) -> bool:
    return unit.manager == "system" and bool(unit.words("WantedBy", "Install"))


def _waits(unit: Unit, texts: list[str]) -> bool:
    """Whether a unit is ordered after another one that may wait, or a command waits for anything."""
    ordered = [word for key in ("After", "Requires", "BindsTo") for word in unit.words(key)]
    before = unit.has("ExecStartPre") or unit.has("ExecCondition")
    return before or any(map(LATE.search, ordered)) or any(map(WAITING.search, texts))


def _order(robot: Robot, configuration: Configuration) -> list[Related]:
    """What the units that read the file wait for instead."""
    found = [reader.process.unit for reader in robot.dds.readers(configuration)]
    units = {unit.name: unit for unit in found if unit is not None}
    words = [(unit, word) for unit in units.values() for word in unit.words("After") if "network" in word]
    return [note(word, f"{unit.name} waits for {word} only") for unit, word in words[:3]]
