"""A service waits for the network that it is to make.

## What it finds
A service that wants `network-online.target` and is ordered after it, and whose command, or a script of the tree that it
starts, connects to a wifi or opens an access point: `nmcli device wifi connect`, `nmcli device wifi hotspot`,
`nmcli connection up`, `hostapd`, `create_ap`, `wpa_supplicant` or `dhclient`. VPNs are not reported: they
need a network.

## Why it matters on a robot
In the workshop the target is reached in seconds. Where no known network is in reach, as in the field, `systemd-
networkd-wait-online` gives up only after two minutes. Until then the robot has no access point, and whoever switched
it on believes that it is broken. It is an info with `nmcli`: the wait service of NetworkManager ends as soon as all
known connections have been tried.

## Bad
```ini
[Unit]
Wants=network-online.target
After=network-online.target
[Service]
ExecStart=/usr/sbin/hostapd /etc/hostapd/field.conf
```

## Good
```ini
[Unit]
Wants=sys-subsystem-net-devices-wlan0.device
After=sys-subsystem-net-devices-wlan0.device
[Service]
ExecStart=/usr/sbin/hostapd /etc/hostapd/field.conf
```

## When to ignore it
When the service brings up a second network on top of the first, such as a bridge to the wired one.

## References
- systemd.special(7), "network-online.target"
- systemd-networkd-wait-online.service(8), `--timeout=`; nm-online(1), `--wait-for-startup`
"""

import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

ONLINE = "network-online.target"
MAKERS = ("hostapd", "create_ap", "wpa_supplicant", "dhclient")
CONNECTS = regex(r"( -\S+)* (d|dev|device) (w|wifi) (c|connect|h|hotspot)\b.*|( -\S+)* (c|con|connection) up\b.*")
"""Arguments of nmcli."""
ON_TOP = regex(r"vpn|wireguard|tailscale|zerotier|%[iI]|\bwg|\btun\d|\btap\d", re.I)
"""A connection that needs another one, or that only the instance of the unit names."""


@rule("warning", symptoms=["A start job is running for Wait for Network to be Configured"])
def network_online_maker(robot: Robot) -> Iterator[Finding]:
    for runner in robot.runners.all:
        unit = runner.unit
        if unit is None or unit.uncertain or not any(True for _ in unit.naming("Wants", ONLINE)):
            continue
        maker = next(_makers(runner), None)
        for _, word in unit.naming("After", ONLINE):
            if maker is not None:
                yield finding(
                    word,
                    f"{unit.name} makes the network and waits for it: without a known one it starts when "
                    "the wait service gives up",
                    advice="order it after NetworkManager.service, or with Wants= after the device of the interface",
                    related=[note(maker, "this makes a network")],
                    confidence="medium",
                    severity="info" if maker == "nmcli" or maker.endswith("/nmcli") else None,
                )


def _makers(runner: Runner) -> Iterator[Located]:
    """The programs of the start of a unit that connect it or open an access point."""
    for line in runner.main:
        for step in line.steps:
            words = unwrapped(step.command.words)
            if words and _makes(words):
                yield words[0]


def _makes(words: Sequence[Located]) -> bool:
    program = program_name(words[0])
    if program == "nmcli":
        arguments = "".join(f" {each}" for each in words[1:])
        return bool(CONNECTS.fullmatch(arguments)) and not ON_TOP.search(arguments)
    return program in MAKERS
