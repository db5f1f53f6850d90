"""The firewall does not open the ports of the DDS domain.

## What it finds
UDP ranges that are opened for DDS (they begin at a port of some domain) but do not contain the ports of the domain
that the tree sets with `ROS_DOMAIN_ID`. These are 7400 + 250 × domain, +0 and +1 for multicast, +10 + 2p and +11 +
2p for participant p. Not reported: rules that admit a whole subnet or interface, trees with several domains, and
robots whose processes all read a DDS file with its own ports.

A script that enables ufw and opens no port for DDS is reported where a process of the robot is told of other machines:
by `ROS_STATIC_PEERS`, peers of a Cyclone DDS file or initial peers of Fast DDS.

## Why it matters on a robot
The firewall drops discovery: everything works on the robot itself, but other machines see no topics.

## Bad
```sh
# ROS_DOMAIN_ID=42
ufw allow 7400:7700/udp
```

## Good
```sh
# ROS_DOMAIN_ID=42: 7400 + 250 * 42 = 17900
ufw allow 17900:17999/udp
```

## When to ignore it
When no other machine should take part in the robot's domain, and the open range is for something else.

## References
- DDSI-RTPS 2.5, section 9.6.2, "Port mapping"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.environment import RosProcess

REACHED = regex(r"\btailscale\b|DEFAULT_INPUT_POLICY")
RULES = regex(r"\b(?:ufw|iptables|nft|firewall-cmd)\b(?s:.){0,400}?\b(?:udp|7[4-9]\d\d)\b")


@rule("warning", symptoms=["[UFW BLOCK] * PROTO=UDP * DPT=74*"])
def dds_ports(robot: Robot) -> Iterator[Finding]:
    yield from _closed(robot)
    domain = robot.dds_domain
    if domain is None:
        return
    if not uses_default_ports(robot):
        return
    number, place = domain
    base = 7400 + 250 * number
    for firewall in robot.firewalls:
        ranges = [each for each in firewall.udp if each.last > each.first or each.first >= 7400]
        for_dds = [each for each in ranges if each.first >= 7400 and (each.first - 7400) % 250 <= 11]
        uncertain = any(not each.certain and each.protocol != "tcp" for each in firewall.openings)
        if not for_dds or firewall.opens_all or uncertain or not robot.same_robot(firewall.source, place):
            continue
        needed = (base, base + 1, base + 10, base + 11)
        missing = [port for port in needed if not any(each.first <= port <= each.last for each in ranges)]
        if missing:
            opened = ", ".join(f"{e.first}-{e.last}" if e.last > e.first else f"{e.first}" for e in ranges)
            yield finding(
                for_dds[0].where,
                f"The firewall opens {opened}, but domain {number} needs {base} to {base + 11} and up",
                advice=f"open {base}:{base + 99}/udp",
                related=[note(place, "the domain is set here")],
            )


def _closed(robot: Robot) -> Iterator[Finding]:
    """Firewalls that let nothing of DDS in, where a process is told of other machines."""
    for firewall in robot.firewalls:
        if not firewall.is_closed_ufw or any(each.last >= 7400 for each in firewall.udp):
            continue
        near = (each for each in robot.ros.processes if robot.same_robot(firewall.source, each.where.source))
        if any(_may_open(each, firewall.source) and robot.same_robot(firewall.source, each) for each in robot.sources):
            continue
        direct = (each for each in near if not _is_apart(each))
        peer = next((peer for process in direct for peer in robot.dds.machines_of(process)), None)
        if peer is not None and uses_default_ports(robot):
            yield finding(
                firewall.tools["ufw"],
                f"ufw lets in no UDP port of DDS: {peer} sees no topic of the robot",
                advice=f"add: ufw allow from {peer} proto udp",
                related=[note(peer, "the other machine is listed here")],
            )


def _is_apart(process: RosProcess) -> bool:
    """Whether a process speaks to the machines that are listed in another way, or not at all."""
    text = process.environment.text
    return text("RMW_IMPLEMENTATION") == "rmw_zenoh_cpp" or text("ROS_AUTOMATIC_DISCOVERY_RANGE") == "OFF"


def _may_open(source: Source, script: Source) -> bool:
    """Whether a file lets packets in beside the script: a tunnel, another policy, or rules for UDP of its own."""
    text = source.text
    return REACHED.search(text) is not None or (source is not script and RULES.search(text) is not None)


def uses_default_ports(robot: Robot) -> bool:
    """Whether a process surely keeps to the usual ports: every file with others is read by other processes."""
    if any("portBase" in source.said for source in robot.of_kind("fastdds")):
        return False
    own = [each for each in robot.dds.configurations if "<Ports" in each.source.said]
    readers = [robot.dds.readers(each) for each in own]
    elsewhere = {reader.process.unit for group in readers for reader in group}
    usual = any(process.unit and process.unit not in elsewhere for process in robot.ros.processes)
    return not own or (all(readers) and usual)
