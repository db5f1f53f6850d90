"""One report in which everything occurs that a format has to show."""

from __future__ import annotations

from bringup_lint.finding import Applicability
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.report import Notification
from bringup_lint.report import Report
from bringup_lint.report import RuleDoc
from bringup_lint.report import Target
from bringup_lint.source import Source
from bringup_lint.source import Span

PASSWORD = "orange-lighthouse"

UNIT = Source(
    "etc/systemd/system/mower.service",
    f"""[Unit]
Description=Mower bring-up
After=network.target blade.service

[Service]
User=root
Environment=WIFI_PASSWORD={PASSWORD}
ExecStart=/bin/bash -c "source /opt/ros/jazzy/setup.bash && \\
    ros2 launch mower_bringup \\
    mower.launch.py"
Restart=always
RestartSec=5
""",
    "systemd-unit",
)
BLADE = Source("etc/systemd/system/blade.service", "[Unit]\nAfter=mower.service\n", "systemd-unit")
NETPLAN = Source(
    "etc/netplan/10 mower.yaml",
    "network:\n  ethernets:\n    eth0:\n      dhcp4: true\n      optional: true\n",
    "netplan",
)
RULES = Source(
    "/srv/image/99-mower.rules",
    "# " + "mäher " * 40 + 'KERNEL=="ttyUSB0"' + " drive" * 40 + '\n\tSYMLINK+=\t"草刈り" \x1b[31m\n',
    "udev-rules",
)
EMPTY = Source("config/empty.xml", "", "dds-profile")


def at(source: Source, text: str) -> Span:
    """Where the text first stands in a file."""
    start = source.text.index(text)
    return source.span(start, start + len(text))


FINDINGS = (
    Finding(
        "network.target is reached before eth0 has an address: DDS starts 3 s too early and binds to nothing",
        at(UNIT, "network.target"),
        "systemd/network-target",
        Severity.WARNING,
        advice="write After=network-online.target and Wants=network-online.target",
        related=(
            Related(at(NETPLAN, "eth0"), "eth0 gets its address from DHCP"),
            Related(at(NETPLAN, "optional: true"), "and boot does not wait for it, whatever the units say"),
        ),
        fix=Fix(
            "write network-online.target",
            (
                Edit(at(UNIT, "network.target"), "network-online.target"),
                Edit(
                    UNIT.span(at(UNIT, "After=").start, at(UNIT, "After=").start),
                    "Wants=network-online.target\n",
                ),
            ),
        ),
    ),
    Finding(
        "The units wait for each other: systemd drops one of them at every boot",
        at(UNIT, "blade.service"),
        "systemd/ordering-cycle",
        Severity.ERROR,
        chain=(
            Related(at(UNIT, "blade.service"), "mower.service starts after blade.service"),
            Related(at(BLADE, "mower.service"), "blade.service starts after mower.service: the circle is closed"),
        ),
    ),
    Finding(
        "All 14 nodes run as root",
        at(UNIT, "root"),
        "systemd/root-user",
        Severity.ERROR,
        advice="create a user for the robot and name it:\n[Service]\nUser=mower",
        related=(Related(at(UNIT, "ExecStart"), "starts the nodes"),),
    ),
    Finding(
        f"The password {PASSWORD} stands in a unit that everyone can read",
        at(UNIT, f"WIFI_PASSWORD={PASSWORD}"),
        "systemd/secret-in-unit",
        Severity.ERROR,
        secrets=(at(UNIT, PASSWORD),),
    ),
    Finding(
        "The shell stays between systemd and the nodes: a stop reaches it alone",
        UNIT.span(UNIT.text.index("ExecStart"), UNIT.text.index("Restart=")),
        "systemd/shell-wrapper",
        Severity.WARNING,
        confidence=Confidence.MEDIUM,
        fix=Fix("write exec before ros2", (Edit(at(UNIT, "ros2"), "exec ros2"),), Applicability.UNSAFE),
    ),
    Finding(
        "5 restarts × 5 s = 25 s > 10 s: the start limit never trips",
        at(UNIT, "5"),
        "systemd/restart-unlimited",
        Severity.WARNING,
        suppression=Suppression(at(UNIT, "Restart=always"), "the blade must come back"),
    ),
    Finding(
        "ttyUSB0 is another device after the next boot",
        at(RULES, 'KERNEL=="ttyUSB0"'),
        "udev/unstable-name",
        Severity.WARNING,
    ),
    Finding(
        "No node ever opens this link",
        at(RULES, "草刈り"),
        "udev/unused-link",
        Severity.INFO,
        related=(Related(at(RULES, "SYMLINK"), "made here"),),
    ),
    Finding("The file is empty", EMPTY.whole, "lint/unreadable", Severity.ERROR),
)

NETWORK_TARGET = RuleDoc(
    "systemd/network-target",
    """network.target does not mean that the network is up.

## What it finds
A unit that is ordered `After=network.target` and not after `network-online.target`, while what it starts
needs an address:

- a launch file that starts **DDS** participants, whichever middleware they use, as long as it is not
  confined to the loopback interface
- a program that binds to a [multicast group](https://www.rfc-editor.org/rfc/rfc1112)

## Why it matters on a robot
The participant binds to nothing, and stays so.

## Bad
```ini
[Unit]
After=network.target
```

## Good
```ini
[Unit]
Wants=network-online.target
After=network-online.target
```

## References
- systemd.special(7), "network-online.target"
""",
    Severity.WARNING,
    fix="safe",
    since="0.1",
    symptoms=("does not match an available interface",),
    aliases=("systemd/no-network",),
    uri="https://example.org/rules/systemd/network-target.md",
)
ROOT_USER = RuleDoc(
    "systemd/root-user",
    "Programs of the robot run as root.\n\n## What it finds\nA unit without `User=` that starts nodes.\n",
    Severity.ERROR,
    since="0.1",
    tags=("CWE-250",),
    uri="https://example.org/rules/systemd/root-user.md",
)


def sample(**changes: object) -> Report:
    """The report, with some of its fields set otherwise."""
    fields = {
        "findings": FINDINGS,
        "rules": {rule.id: rule for rule in (NETWORK_TARGET, ROOT_USER)},
        "kinds": {"systemd-unit": 2, "netplan": 1, "udev-rules": 1, "dds-profile": 1},
        "root": "/home/robot/mower",
        "cwd": "/home/robot/mower",
        "version": "0.1.0",
        "target": Target("jazzy", 255, "/opt/ros/jazzy in mower.service:8", "the default of Ubuntu 24.04"),
        "command": ("bringup-lint", "--output-format", "text", "."),
        "started": 1760000000.0,
        "ended": 1760000000.25,
        "exit_code": 3,
        "notifications": (Notification("error", "rule udev/unused-link failed: KeyError", "udev/unused-link"),),
        "below": {Severity.INFO: 4},
        "known": FINDINGS[:2],
    }
    return Report(**{**fields, **changes})


def clean(**changes: object) -> Report:
    """A report without findings."""
    return sample(findings=(), notifications=(), below={}, known=(), exit_code=0, **changes)
