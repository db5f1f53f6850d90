"""A synthetic fleet with planted defects and known answers: ``python benchmarks/fleet.py 50`` writes one, runs the
command over it and says what was found, what was expected and what came on top.
"""

from __future__ import annotations

import base64
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import robot

UNIT = """\
[Unit]
Description=Rover
Wants=network-online.target
After=network-online.target

[Service]
User=robot
Environment=ROS_DOMAIN_ID={domain}
Environment=RMW_IMPLEMENTATION={middleware}
{profiles}ExecStart=/opt/ros/jazzy/bin/ros2 launch rover_bringup rover.launch.py robot:={name}
Restart=on-failure
RestartSec={pause}

[Install]
WantedBy=multi-user.target
"""
NETWORK = """\
network:
  version: 2
  wifis:
    wlan0:
      addresses: [10.7.{high}.{low}/16]
"""
PROFILES = """\
<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">
  <participant profile_name="rover" is_default_profile="true">
    <rtps>
      <port>
        <portBase>7500</portBase>
      </port>
    </rtps>
  </participant>
</profiles>
"""
Answer = tuple[str, tuple[str, ...]]
"""A rule, and the robots that it is to name."""


def _bytes(seed: str) -> bytes:
    return hashlib.sha256(seed.encode()).digest()


def files(number: int, like: int, odd: bool) -> Iterator[tuple[str, str]]:
    """The files of a robot. ``like`` is the robot that it was cloned from, else itself; ``odd`` has drifted."""
    name = f"rover-{number:05}"
    blob = b"\0\0\0\x0bssh-ed25519\0\0\0 " + _bytes(f"ssh {like}")
    key = base64.b64encode(_bytes(f"vpn {like}")).decode()
    yield "etc/ssh/ssh_host_ed25519_key.pub", f"ssh-ed25519 {base64.b64encode(blob).decode()} root@{name}\n"
    yield "etc/machine-id", _bytes(f"id {like}").hex()[:32] + "\n"
    yield "etc/hostname", f"{name}\n"
    yield "etc/wireguard/wg0.conf", f"[Interface]\nPrivateKey = {key}\n"
    yield "etc/netplan/10-robot.yaml", NETWORK.format(high=like // 250, low=like % 250 + 1)
    yield "etc/sysctl.d/60-dds.conf", f"net.core.rmem_max = {212992 if odd else 2147483647}\n"
    middleware = "rmw_fastrtps_cpp" if odd else "rmw_cyclonedds_cpp"
    profiles = "Environment=FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml\n" if odd else ""
    values = {"domain": 7, "middleware": middleware, "profiles": profiles, "name": name}
    yield "etc/systemd/system/rover.service", UNIT.format(pause=20 if odd else 2, **values)
    if odd:
        yield "etc/robot/fastdds.xml", PROFILES
    else:
        yield "etc/systemd/system/rover-watchdog.service", UNIT.format(pause=1, **values)


def plant(folder: Path, robots: int, size: int = 0) -> list[Answer]:
    """Write a fleet of one role with one clone and one robot that has drifted; returns the answers."""
    clone, original, odd = 1, 0, robots - 1
    inventory = ['[site.hall]\ndomains = "shared"\n']
    for number in range(robots):
        name = f"rover-{number:05}"
        for place, text in files(number, original if number == clone else number, number == odd):
            path = folder / name / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8")
        if size:
            robot.generate(folder / name, size)
        inventory.append(f'[[robot]]\nname = "{name}"\nrole = "rover"\nsite = "hall"\nroot = "{name}"\n')
    (folder / "fleet.toml").write_text("\n".join(inventory), "utf-8")
    pair, last = (f"rover-{original:05}", f"rover-{clone:05}"), (f"rover-{odd:05}",)
    shared = ("same-ssh-host-key", "same-machine-id", "same-network-key", "same-address")
    return sorted(
        [
            *((f"fleet/{rule}", pair) for rule in shared),
            ("fleet/different-middleware", last),
            ("fleet/different-middleware", last),
            ("fleet/drift", last),
            ("fleet/drift", last),
            ("fleet/missing-from-role", last),
        ]
    )


def answers(report: dict) -> list[Answer]:
    return sorted((found["rule"], tuple(found["robots"])) for found in report["findings"])


class Sample(NamedTuple):
    """What a process needed until now."""

    peak: int
    """MiB."""
    busy: float
    """Seconds of CPU."""
    ready: float
    """Seconds in which it ran, or waited for a processor that something else had."""
    lives: float
    """Seconds since it started."""


def sample(process: int) -> Sample | None:
    """None when the process is gone."""
    try:
        status = Path(f"/proc/{process}/status").read_text()
        times = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        ran, waited, _ = map(int, Path(f"/proc/{process}/schedstat").read_text().split())
    except OSError:
        return None
    lives = time.clock_gettime(time.CLOCK_BOOTTIME) - int(times[19]) / os.sysconf("SC_CLK_TCK")
    peak = re.search(r"VmHWM:\s+(\d+)", status)
    return Sample(int(peak[1]) // 1024, ran / 1e9, (ran + waited) / 1e9, lives) if peak else None


def watched(run: subprocess.Popen[bytes]) -> tuple[list[Sample], dict[int, Sample]]:
    """The gathering process over time, and at last each worker."""
    gathering: list[Sample] = []
    workers: dict[int, Sample] = {}
    while run.poll() is None:
        now = sample(run.pid)
        if now is not None:
            gathering.append(now)
        for child in _children(run.pid):
            found = sample(child)
            if found is not None:
                workers[child] = found
        time.sleep(0.2)
    return gathering, workers


def _children(process: int) -> list[int]:
    try:
        return [int(word) for word in Path(f"/proc/{process}/task/{process}/children").read_text().split()]
    except OSError:
        return []


def measure(robots: int, size: int, workers: int) -> None:
    with tempfile.TemporaryDirectory() as name:
        expected = plant(Path(name), robots, size)
        command = [sys.executable, "-m", "bringup_lint", "fleet", "--output-format", "json", "--workers", str(workers)]
        result = Path(name, "report.json")
        started = time.perf_counter()
        run = subprocess.Popen([*command, "--output-file", result, name])
        gathering, others = watched(run)
        seconds = time.perf_counter() - started
        report = json.loads(result.read_text("utf-8"))
    found = answers(report)
    extra = [answer for answer in found if answer not in expected]
    missing = [answer for answer in expected if answer not in found]
    print(f"{robots} robots, {workers} workers: {len(expected) - len(missing)} of {len(expected)}, {len(extra)} extra")
    print(f"  {seconds:.1f} s, {robots / seconds:.1f} robots a second")
    half, last = gathering[len(gathering) // 2], gathering[-1]
    print(
        f"  gathering process: {half.peak} MiB after half of the time, {last.peak} at the end, {last.busy:.1f} s of CPU"
    )
    for worker in others.values():
        if worker.busy > 1:
            share = f"ready {worker.ready / worker.lives:.0%} of its {worker.lives:.1f} s"
            print(f"  worker: {worker.peak} MiB, {worker.busy:.1f} s of CPU, {share}")
    for answer in (*missing, *extra):
        print("  ", "missing" if answer in missing else "extra", *answer)


if __name__ == "__main__":
    given = [int(word) for word in sys.argv[1:]]
    measure(*given, *(50, 0, 2)[len(given) :])
