"""What is said of real units about restarts, watchdogs, stopping, limits and sandboxes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bringup_lint.registry import Registry
from tests.lint import lint

pytestmark = pytest.mark.corpus

OWN = (
    "restart-missing restart-unlimited restartsec-too-short restart-on-failure-ros-launch "
    "onfailure-unreachable onfailure-template-missing start-limit-action-missing notify-ros-launch "
    "notify-nobody-notifies watchdog-without-notify watchdog-missing watchdog-no-restart "
    "timeout-start-short execstartpre-sleep execstartpre-missing-script device-check-missing "
    "kill-signal-not-sigint kill-mode shell-wrapper-no-exec shell-background-job execstop-async-kill "
    "final-kill-signal timeout-stop-vs-launch no-resource-limits memory-high-ge-max "
    "rt-limits-only-in-pam rt-starvation rt-restrict-conflict readwritepaths-missing "
    "protectsystem-log-dir protecthome-workspace privatetmp-redundant privatetmp-ipc private-devices "
    "private-network nnp-filecaps syslogidentifier-missing stdout-file-no-rotation log-flood"
).split()

FOUND = {
    "Kitjesen__MapPilot": {
        ("src/ota_daemon/deploy/ota_daemon.service", 34, "protecthome-workspace"),
        ("systemd/nav-slam.service", 16, "watchdog-without-notify"),
        ("systemd/nav-planning.service", 16, "watchdog-without-notify"),
        ("systemd/nav-grpc.service", 16, "watchdog-without-notify"),
        ("systemd/nav-grpc.service", 12, "restart-unlimited"),
    },
    "cedbossneo__mowglinext": {
        ("ros2/systemd/mowgli.service", 26, "kill-mode"),
        ("ros2/systemd/mowgli.service", 30, "restart-on-failure-ros-launch"),
    },
    "ClemensElflein__open_mower_ros": set(),
    "turtlebot__turtlebot4_setup": set(),
    "systemd__systemd-stable": set(),
    "canonical__netplan": set(),
    "clearpathrobotics__robot_upstart": set(),
    "mangdangroboticsclub__mini_pupper_ros": set(),
    "mangdangroboticsclub__mini_pupper_2_bsp": set(),
    "yutaka-m__underwater-drone-v3": set(),
}
"""Every warning and error, by repository; all were read and are true."""


def test_the_rules_exist() -> None:
    assert {f"systemd/{name}" for name in OWN} <= set(Registry.of().paths)


@pytest.mark.parametrize("repository", FOUND)
def test_warnings_and_errors(corpus: Path, repository: str) -> None:
    run = lint("--output-format", "json", ".", cwd=corpus / repository)
    places = {
        (item["location"]["path"], item["location"]["start"]["line"], item["rule"].removeprefix("systemd/"))
        for item in json.loads(run.stdout)["findings"]
        if item["rule"].removeprefix("systemd/") in OWN
    }
    assert places == FOUND[repository]
