"""What rules match, against ``udevadm test`` on a made-up sysfs: random rules fire when we say so."""

from __future__ import annotations

import itertools
import os
import random
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

from bringup_lint.graph.udev.conditions import Condition
from bringup_lint.graph.udev.overlap import may_both_fire
from bringup_lint.graph.udev.rule import UdevRule
from bringup_lint.graph.udev.udev import effective
from bringup_lint.model.udev import PARENT_KEYS
from bringup_lint.parsers.udev import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles import udevadm
from tests.oracles.answers import Oracle
from tests.oracles.udevadm import FOLDER

DEVICES = read_toml((Path(__file__).parent / "udev/devices.toml").read_text("utf-8"))["device"]
BY_PATH = {device["path"]: device for device in DEVICES}
LEAVES = [device["path"] for device in DEVICES if device.get("leaf")]
MATCHES = [
    'SUBSYSTEM=="tty"',
    'SUBSYSTEM=="video4linux"',
    'SUBSYSTEM=="usb"',
    'SUBSYSTEM=="tty|usb"',
    'SUBSYSTEM!="tty"',
    'SUBSYSTEM!="usb"',
    'KERNEL=="ttyUSB*"',
    'KERNEL=="ttyACM[0-9]*"',
    'KERNEL=="video*|ttyUSB?"',
    'KERNEL=="1-1"',
    'KERNEL!="video0"',
    'KERNEL!="tty*"',
    'ACTION=="add"',
    'ACTION=="change"',
    'ACTION!="remove"',
    'ACTION=="add|change"',
    'ACTION!="add"',
    'ATTRS{idVendor}=="0403"',
    'ATTRS{idVendor}=="0c45|0483"',
    'ATTRS{idProduct}=="6001"',
    'ATTRS{idProduct}=="57*"',
    'ATTRS{serial}=="A5XK3RJT"',
    'ATTRS{serial}=="C1"',
    'ATTRS{serial}!="C1"',
    'ATTRS{bInterfaceNumber}=="00"',
    'ATTRS{latency_timer}=="16"',
    'KERNELS=="1-1"',
    'KERNELS=="1-1:1.0"',
    'KERNELS=="1-2*"',
    'KERNELS=="1-?:*"',
    'KERNELS=="ttyUSB0"',
    'KERNELS!="1-1"',
    'DRIVERS=="usb"',
    'DRIVERS=="ftdi_sio"',
    'DRIVERS=="cdc_acm|uvcvideo"',
    'SUBSYSTEMS=="usb"',
    'SUBSYSTEMS=="usb-serial"',
    'SUBSYSTEMS=="tty"',
    'SUBSYSTEMS=="pci"',
    'ATTR{index}=="0"',
    'ATTR{index}!="0"',
    'ATTR{idVendor}=="0403"',
    'ATTR{name}=="F*"',
    'ENV{DEVTYPE}=="usb_device"',
    'ENV{DEVTYPE}==""',
    'ENV{DEVNAME}=="/dev/tty*"',
    'ENV{MAJOR}=="188"',
    'ENV{MAJOR}!="188"',
    'DRIVER=="usb"',
]
FILES = 45
LINES = 14


def tool() -> str:
    """The folder of ``fetch_udev.sh``, whose udevadm needs root for chroot."""
    there = FOLDER and Path(FOLDER, "usr/bin/udevadm").exists() and os.geteuid() == 0
    return udevadm.tool() if there else "udevadm"


def machine(root: Path) -> Path:
    """A root folder with udev and a made-up /sys."""
    shutil.copytree(FOLDER, root, symlinks=True, dirs_exist_ok=True)
    shutil.rmtree(root / "usr/lib/udev/rules.d")
    for name, target in (("bin", "usr/bin"), ("lib", "usr/lib"), ("lib64", "usr/lib64")):
        (root / name).symlink_to(target)
    for name in ("etc/udev/rules.d", "run", "proc", "dev", "tmp"):
        (root / name).mkdir(parents=True, exist_ok=True)
    for device in DEVICES:
        _make(root, device)
    return root


def _make(root: Path, device: dict) -> None:
    folder = root / "sys/devices" / device["path"]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "uevent").write_text("".join(f"{line}\n" for line in device.get("uevent", [])))
    for name, value in device.get("attributes", {}).items():
        (folder / name).write_text(f"{value}\n")
    subsystem = device.get("subsystem")
    if subsystem:
        kind = "class" if subsystem in ("tty", "video4linux") else "bus"
        place = root / "sys" / kind / subsystem
        place.mkdir(parents=True, exist_ok=True)
        (folder / "subsystem").symlink_to(os.path.relpath(place, folder))
        if "driver" in device:
            driver = place / "drivers" / device["driver"]
            driver.mkdir(parents=True, exist_ok=True)
            (folder / "driver").symlink_to(os.path.relpath(driver, folder))


def fired(root: Path, device: str, action: str) -> set[str]:
    """The links that the real udev makes."""
    command = [
        "chroot",
        str(root),
        "/usr/bin/udevadm",
        "test",
        f"--action={action}",
        f"/sys/devices/{device}",
    ]
    environment = {**os.environ, "SYSTEMD_DEVICE_VERIFY_SYSFS": "0", "LC_ALL": "C"}
    run = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    links = re.search(r"^\s*DEVLINKS=(.*)$", run.stdout + run.stderr, re.M)
    assert "Properties:" in run.stdout + run.stderr, run.stderr[-2000:]
    return {path.removeprefix("/dev/") for path in links[1].split()} if links else set()


def chain(device: str) -> list[dict]:
    """The device and its parents: those folders above it that are devices."""
    parts = device.split("/")
    paths = ("/".join(parts[:count]) for count in range(len(parts), 0, -1))
    return [BY_PATH[path] for path in paths if path in BY_PATH]


def value(device: dict, key: str, attribute: str, action: str) -> str | None:
    properties = dict(line.split("=", 1) for line in device.get("uevent", []))
    if key == "ENV":
        found = properties.get(attribute, "")
        return f"/dev/{found}" if attribute == "DEVNAME" and found else found
    return {
        "ACTION": action,
        "KERNEL": device["path"].rpartition("/")[2],
        "SUBSYSTEM": device.get("subsystem", ""),
        "DRIVER": device.get("driver", ""),
        "ATTR": device.get("attributes", {}).get(attribute),
    }[key]


def holds(conditions: tuple[Condition, ...], device: str, action: str) -> bool:
    """Whether a device fulfils all; the parent keys of one line must hold on one device."""
    devices = chain(device)
    own = [one for one in conditions if one.key not in PARENT_KEYS]
    parents = [one for one in conditions if one.key in PARENT_KEYS]
    if not all(_holds(one, devices[0], action) for one in own):
        return False
    return not parents or any(all(_holds(one, parent, action) for one in parents) for parent in devices)


def _holds(condition: Condition, device: dict, action: str) -> bool:
    key = condition.key[:-1] if condition.key in PARENT_KEYS else condition.key
    found = value(device, key, condition.attribute, action)
    return found is not None and condition.accepts(found)


def predicted(rule: UdevRule, device: str, action: str) -> bool:
    jumped = any(holds(jump, device, action) for jump in rule.conditions.jumps)
    return holds(rule.conditions.positive, device, action) and not jumped


def random_rules(rng: random.Random) -> str:
    lines = []
    label = 0
    for number in range(LINES):
        matches = ", ".join(rng.sample(MATCHES, rng.choice((1, 1, 2, 2, 3, 4))))
        if label and rng.random() < 0.4:
            lines.append(f'LABEL="end{label}"')
            label = 0
        elif not label and rng.random() < 0.3:
            label = number + 1
            lines.append(f'{matches}, GOTO="end{label}"')
        lines.append(f'{matches if rng.random() < 0.3 else ", ".join(rng.sample(MATCHES, 2))}, SYMLINK+="l{number}"')
    return "\n".join([*lines, f'LABEL="end{label}"', ""])


def links_made(root: Path, texts: list[str]) -> list[dict[str, list[str]]]:
    """Device and action to the links that the real udev makes under these rules."""
    answers = []
    for text in texts:
        (root / "etc/udev/rules.d/50-random.rules").write_text(text)
        answers.append({f"{device} {action}": sorted(fired(root, device, action)) for device, action in events()})
    return answers


def events() -> Iterator[tuple[str, str]]:
    return itertools.product(LEAVES, ("add", "change"))


def test_random_rules(answers: Oracle, tmp_path: Path) -> None:
    rng = random.Random(257)
    texts = [random_rules(rng) for _ in range(FILES)]
    given = answers.of("udev/links", tool(), texts, lambda texts: links_made(machine(tmp_path / "machine"), texts))
    made = 0
    wrong = []
    for text, links_of in given.pairs:
        rules = [rule for rule in effective([parse(Source("50-random.rules", text))]).rules if rule.links]
        for device, action in events():
            links = links_of[f"{device} {action}"]
            fired_rules = [rule for rule in rules if rule.links[0].name in links]
            made += len(fired_rules)
            wrong += [
                f"{device} {action} fired={rule in fired_rules}: {rule.line.span.text}"
                for rule in rules
                if predicted(rule, device, action) != (rule in fired_rules)
            ]
            for rule in fired_rules:
                wrong += [f"{claim}: {rule.line.span.text}" for claim in false_claims(rule, device, action)]
            wrong += claims_on_pairs(fired_rules)
    assert made > 1000
    assert not wrong, "\n".join(wrong[:20])


def false_claims(rule: UdevRule, device: str, action: str) -> list[str]:
    """What the linter would say of a rule, all of it untrue when the rule has fired for the device."""
    subsystem = BY_PATH[device]["subsystem"]
    claims = {
        "unreachable": rule.is_unreachable,
        "impossible parents": rule.impossible_parents is not None,
        "contradiction": bool(rule.contradictions),
        "other subsystem": bool(rule.subsystems) and subsystem not in rule.subsystems,
        "other action": action not in rule.actions,
        "attribute of the parent": rule.is_for("tty", "video4linux") and "ATTR{idVendor}==" in rule.line.span.text,
    }
    return [claim for claim, made in claims.items() if made]


def claims_on_pairs(rules: list[UdevRule]) -> list[str]:
    """Rules that fired for one device and that we call disjoint. Parent keys are left out: they are taken to
    speak of one device in both rules, so that rules for an adapter and for its hub count as disjoint."""
    by_itself = [rule for rule in rules if not any(one.key in PARENT_KEYS for one in rule.conditions.positive)]
    return [
        f"disjoint: {one.line.span.text} / {other.line.span.text}"
        for index, other in enumerate(by_itself)
        for one in by_itself[:index]
        if not may_both_fire(one, other)
    ]
