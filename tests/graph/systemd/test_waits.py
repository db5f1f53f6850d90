"""How long scripts may wait."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.walk import discover
from bringup_lint.graph.systemd.waits import longest_wait
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.robot import Robot


def wait(folder: Path, text: str, arguments: str = "") -> float:
    script = folder / "usr" / "local" / "bin" / "check"
    script.parent.mkdir(parents=True, exist_ok=True)
    script.write_text(f"#!/bin/bash\n{text}\n")
    (folder / "one.service").write_text(f"[Service]\nExecStart=/usr/local/bin/check {arguments}\n")
    robot = Robot(discover([str(folder)]))
    return longest_wait(robot.units.started(robot.units.services[0])[0], robot.files).seconds


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("sleep 5", 5),
        ("sleep 2m; /bin/sleep 0.5", 120.5),
        ("sleep $DELAY", 0),
        ("DELAY=3\nsleep ${DELAY}", 3),
        ('sleep "${DELAY:-7}"', 7),
        ("sleep 5 &", 0),
        ("for i in 1 2 3; do sleep 2; done", 6),
        ("for i in {1..30}; do [ -e /dev/imu ] && exit 0; sleep 1; done; exit 1", 30),
        ("for i in $(seq 20); do sleep 1; done", 20),
        ("for i in $(seq 0 2 10); do sleep 1; done", 6),
        ("for ((i = 0; i < 15; i++)); do sleep 2; done", 30),
        ("N=4; for ((i = 1; i <= N; i++)); do sleep 1; done", 4),
        ("until [ -e /dev/imu ]; do sleep 1; done", 0),
        ("i=0\nwhile [ ! -e /dev/imu ]; do\n sleep 1\n i=$((i + 1))\n [ $i -ge 40 ] && exit 1\ndone", 40),
        ("i=0; while [ ! -e /dev/imu ] && [ $i -lt 25 ]; do sleep 2; ((i++)); done", 50),
        ("i=0; while (( i <= 9 )); do sleep 1; let i+=1; done", 10),
        ("i=10; until (( i == 30 )); do sleep 1; : $((i++)); done", 20),
        ('left=5; while [ $left -gt 0 ]; do sleep 1; left=$((left - 1)); done', 0),
        ("if [ -e /dev/imu ]; then sleep 1; else sleep 9; fi", 9),
        ("case $1 in a) sleep 1 ;; b) sleep 4 ;; esac", 4),
        ("timeout 20 bash -c 'until [ -e /dev/imu ]; do sleep 1; done'", 20),
        ("wait_for() { local n=0; while [ ! -e $1 ]; do sleep 1; n=$((n+1)); [ $n -ge 30 ] && return 1; done; }\n"
         "wait_for /dev/a\nwait_for /dev/b", 60),
        ("function pause { sleep $1; }\npause 3; pause 4", 7),
        ("( sleep 2; sleep 3 )", 5),
        ("cat <<EOF\nsleep 100\nEOF\nsleep 1", 1),
    ],
)  # fmt: skip
def test_wait(tmp_path: Path, text: str, seconds: float) -> None:
    assert wait(tmp_path, text) == seconds


def test_a_script_gets_the_arguments_of_its_caller(tmp_path: Path) -> None:
    inner = tmp_path / "usr" / "local" / "bin" / "pause"
    inner.parent.mkdir(parents=True)
    inner.write_text("#!/bin/sh\nsleep $1\n")
    assert wait(tmp_path, "/usr/local/bin/pause 6\n/usr/local/bin/pause $2", "early 3") == 9


def test_a_limit_for_each_device(tmp_path: Path) -> None:
    script = """
DEVICES=(
  /dev/rover/camera   # front
  "/dev/rover/lidar"
  /dev/rover/imu
)
PATIENCE=30
STEP=2
for device in "${DEVICES[@]}"; do
    waited=0
    while [ ! -e "$device" ]; do
        if [ "$waited" -ge "$PATIENCE" ]; then
            echo "$device is missing" >&2
            exit 1
        fi
        sleep "$STEP"
        waited=$((waited + STEP))
    done
done
"""
    assert wait(tmp_path, script) == 90


def test_arguments_are_counted(tmp_path: Path) -> None:
    script = 'for device in "$@"; do for i in {1..10}; do sleep 1; done; done'
    assert wait(tmp_path, script, "/dev/a /dev/b") == 20


@given(
    st.lists(
        st.sampled_from(
            [
                "for",
                "while",
                "do",
                "done",
                "if",
                "then",
                "fi",
                "case",
                "esac",
                "in",
                ";;",
                ";",
                "(",
                ")",
                "((",
                "))",
                "{",
                "}",
                "|",
                "&",
                "&&",
                "x=1",
                "a=",
                "$i",
                "\n",
                "[",
                "]",
                "'",
                '"',
            ]
        )
    )
)
def test_no_text_makes_the_reader_fail(words: list[str]) -> None:
    blocks(nowhere(" ".join(words)))
