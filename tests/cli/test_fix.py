"""``--fix``, ``--diff`` and fixes of standard input."""

from __future__ import annotations

import io
import sys
from collections import Counter
from pathlib import Path

import pytest

from bringup_lint.cli.fixing import LISTED
from bringup_lint.cli.fixing import _tell_left
from tests.lint import lint

UNIT = "[Service]\nStartLimitInterval=200\nExecStart=/bin/x\nWIFI_PASSWORD=hunter22hunter\n"
FIXED = "[Unit]\nStartLimitIntervalSec=200\n\n" + UNIT.replace("StartLimitInterval=200\n", "")


@pytest.fixture
def unit(tmp_path: Path) -> Path:
    path = tmp_path / "robot.service"
    path.write_text(UNIT)
    return path


def test_diff_shows_what_fix_would_do_and_changes_nothing(unit: Path) -> None:
    run = lint("--diff", "--select", "systemd/legacy-key", cwd=unit.parent)
    assert run.code == 1
    assert unit.read_text() == UNIT
    assert "-StartLimitInterval=200\n" in run.stdout
    assert "+StartLimitIntervalSec=200\n" in run.stdout


def test_diff_shows_all_rounds(tmp_path: Path) -> None:
    text = "[Service]\nStartLimitInterval=200\nStartLimitBurst=3\nStandardOutput=syslog\nExecStart=/bin/x\n"
    path = tmp_path / "robot.service"
    path.write_text(text)
    run = lint("--diff", "--select", "systemd/legacy-key", cwd=tmp_path)
    assert path.read_text() == text
    assert "Would fix 3 findings" in run.stderr
    shown = [line for line in run.stdout.splitlines() if line.startswith(("+", " ")) and not line.startswith("+++")]
    lint("--fix", "--select", "systemd/legacy-key", cwd=tmp_path)
    assert [line[1:] for line in shown] == path.read_text().splitlines()
    assert lint("--diff", "--select", "systemd/legacy-key", cwd=tmp_path).stdout == ""


def test_diff_with_exit_zero(unit: Path) -> None:
    run = lint("--diff", "--exit-zero", "--select", "systemd/legacy-key", cwd=unit.parent)
    assert run.code == 0
    assert "+StartLimitIntervalSec=200\n" in run.stdout


def test_diff_shows_no_secret(unit: Path) -> None:
    run = lint("--diff", "--select", "systemd/legacy-key", cwd=unit.parent)
    assert " WIFI_PASSWORD=**************\n" in run.stdout


def test_diff_without_a_change(tmp_path: Path) -> None:
    (tmp_path / "robot.service").write_text("[Service]\nExecStart=/bin/x\n")
    run = lint("--diff", cwd=tmp_path)
    assert (run.code, run.stdout) == (0, "")


def test_summary_names_the_rules(unit: Path) -> None:
    run = lint("--fix", "--select", "systemd/legacy-key", cwd=unit.parent)
    assert "  1 systemd/legacy-key\n" in run.stderr


def test_summary_says_what_is_unsafe(tmp_path: Path) -> None:
    (tmp_path / "robot.service").write_text(
        "[Unit]\nAfter=network.target\n[Service]\nExecStart=/usr/bin/ros2 launch a b\n"
    )
    run = lint("--fix", "--select", "systemd/network-target", cwd=tmp_path)
    assert "Not fixed: 1 systemd/network-target (unsafe: --unsafe-fixes)\n" in run.stderr
    assert "Fixed" not in run.stderr


def test_summary_counts_the_rules_when_many_are_left(capsys: pytest.CaptureFixture[str]) -> None:
    _tell_left("unsafe", Counter({f"site/r{number}": 2 for number in range(LISTED + 1)}))
    assert capsys.readouterr().err == "Not fixed: 18 findings of 9 rules (unsafe)\n"


def test_standard_input_is_fixed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(UNIT.encode())))
    run = lint("--stdin-filename", "robot.service", "--fix", "--select", "systemd/legacy-key", cwd=tmp_path)
    assert run.stdout == FIXED
    assert run.code == 0
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("bom", ["", "\ufeff"])
def test_line_ends_and_byte_order_mark_stay(tmp_path: Path, end: str, bom: str) -> None:
    path = tmp_path / "robot.service"
    text = bom + "[Service]\nStartLimitInterval=200\nExecStart=/usr/bin/ros2 launch a b.launch.py\n".replace("\n", end)
    path.write_bytes(text.encode())
    lint("--fix", "--unsafe-fixes", cwd=tmp_path)
    fixed = path.read_bytes().decode()
    assert fixed != text
    assert fixed.startswith(bom + "[")
    assert fixed.count("\ufeff") == len(bom)
    assert fixed.count("\n") == fixed.count(end)


@pytest.mark.parametrize(
    "text",
    [
        "[Unit]\nSlice=calibration.service\n\nTTYReset=1%\n[Service]\nExecStart=/opt/x\n\n[Install]\nWantedBy=multi-user.target\n",
        "[Service]\rUser=robot\rExecStart=/usr/bin/ros2 launch a b.launch.py\r",
    ],
)
def test_fixing_ends(tmp_path: Path, text: str) -> None:
    path = tmp_path / "robot.service"
    path.write_bytes(text.encode())
    lint("--fix", "--unsafe-fixes", cwd=tmp_path)
    once = path.read_bytes()
    lint("--fix", "--unsafe-fixes", cwd=tmp_path)
    assert path.read_bytes() == once
    assert len(once) < 2 * len(text)


def test_two_xml_declarations_are_fixed_in_bounded_rounds(tmp_path: Path) -> None:
    path = tmp_path / "dds.xml"
    path.write_text(
        '\n\n<!-- c --><?xml version="1.0"?><?xml version="1.0"?>\n'
        '<dds xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles"><profiles/></dds>\n'
    )
    before = len(path.read_text())
    lint("--fix", "--unsafe-fixes", cwd=tmp_path)
    assert len(path.read_text()) < 2 * before


@pytest.mark.parametrize("end", ["", "</package", "</package><package>", "<exec_depend>d</exec_depend></packag>"])
def test_a_broken_manifest_does_not_grow(tmp_path: Path, end: str) -> None:
    manifest = tmp_path / "package.xml"
    manifest.write_text(f"<package format='3'>\n  <name>a_bringup</name>\n  <exec_depend>c</exec_depend>\n{end}\n")
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch/a.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n    return LaunchDescription([Node(package='b', executable='c')])\n"
    )
    before = manifest.read_text()
    for _ in range(2):
        assert lint("--fix", "--unsafe-fixes", "--min-severity", "info", cwd=tmp_path).code in (0, 1)
    missing = ("b", "launch", "launch_ros")
    assert all(manifest.read_text().count(f"<exec_depend>{name}<") <= 1 for name in missing)
    assert manifest.read_text().count("<exec_depend>") <= before.count("<exec_depend>") + len(missing)


def test_a_line_is_not_moved_beside_another_one_of_its_key(tmp_path: Path) -> None:
    text = "[Unit]\nDescription=One\nExecStart=/bin/a\n\n[Service]\nExecStart=/bin/b\n"
    (tmp_path / "robot.service").write_text(text)
    lint("--fix", "--unsafe-fixes", "--select", "systemd", cwd=tmp_path)
    assert "ExecStart=/bin/a\n\n[Service]\nExecStart=/bin/b\n" in (tmp_path / "robot.service").read_text()
    assert "systemd/exec-multiple" not in lint("--select", "systemd", "--output-format", "concise", cwd=tmp_path).stdout


def test_an_enclave_is_found_in_a_command_that_a_shell_runs(tmp_path: Path) -> None:
    text = (
        "[Service]\nUser=robot\nEnvironment=ROS_DISTRO=jazzy\n"
        "ExecStart=/opt/ros/jazzy/bin/ros2 run d e --ros-args --enclave /lawn/driver\n"
    )
    (tmp_path / "robot.service").write_text(text)
    lint("--fix", "--unsafe-fixes", "--select", "env/ros2-not-sourced", cwd=tmp_path)
    assert "--enclave /lawn/driver'\n" in (tmp_path / "robot.service").read_text()
    assert lint("--select", "sros2", "--min-severity", "info", "--output-format", "concise", cwd=tmp_path).stdout == ""


def test_only_blanks_of_ascii_divide_names(tmp_path: Path) -> None:
    text = "[Unit]\nDescription=One\nBindsTo=dev-li\u2028dar.device\n\n[Service]\nExecStart=/bin/x\n"
    (tmp_path / "robot.service").write_text(text, "utf-8")
    lint("--fix", "--unsafe-fixes", "--select", "systemd/requires-without-after", cwd=tmp_path)
    assert (tmp_path / "robot.service").read_text("utf-8") == text


PLAYBOOK = """\
- name: unit
  copy:
    dest: /etc/systemd/system/rover.service
    content: |
{margin}[Unit]
{margin}After=network.target

{margin}[Service]
{margin}StartLimitInterval=10
{margin}ExecStart=/usr/bin/ros2 launch a b.launch.py
{margin}Restart=always
"""
SCRIPT = """\
cat > /etc/systemd/system/rover.service <<-'EOF'
{margin}[Unit]
{margin}After=network.target

{margin}[Service]
{margin}StartLimitInterval=10
{margin}ExecStart=/usr/bin/ros2 launch a b.launch.py
{margin}Restart=always
{margin}EOF
"""
WRITTEN = "systemd/network-target,systemd/restart-unlimited,systemd/legacy-key"


@pytest.mark.parametrize(
    ("name", "text", "margin"),
    [
        ("tasks/main.yml", PLAYBOOK, "      "),
        ("tasks/main.yml", PLAYBOOK, "         "),
        ("install.sh", SCRIPT, "\t"),
        ("install.sh", SCRIPT.replace("<<-", "<<"), ""),
    ],
)
def test_lines_have_the_margin_of_the_file_that_writes_them(tmp_path: Path, name: str, text: str, margin: str) -> None:
    path = tmp_path / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(text.format(margin=margin))
    lint("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", WRITTEN, cwd=tmp_path)
    start = "[Unit]\nAfter=network-online.target\nWants=network-online.target\nStartLimitIntervalSec=10\n"
    rest = "\n[Service]\nExecStart=/usr/bin/ros2 launch a b.launch.py\nRestart=always\n"
    lines = "".join(margin + line if line.strip() else line for line in (start + rest).splitlines(keepends=True))
    assert lines in path.read_text()


@pytest.mark.parametrize(
    "text",
    [
        PLAYBOOK.format(margin="      ").replace("content: |", "content: >"),
        "- name: unit\n  copy:\n    dest: /etc/systemd/system/rover.service\n"
        '    content: "[Unit]\\nAfter=network.target\\n[Service]\\nExecStart=/usr/bin/ros2 launch a b.launch.py\\n"\n',
    ],
)
def test_no_lines_are_added_where_lines_are_folded_or_quoted(tmp_path: Path, text: str) -> None:
    path = tmp_path / "tasks" / "main.yml"
    path.parent.mkdir()
    path.write_text(text)
    lint("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", WRITTEN, cwd=tmp_path)
    assert path.read_text() == text


def test_no_keyword_is_written_twice(tmp_path: Path) -> None:
    text = "from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n    return [{}]\n"
    text = text.format("Node(package='a', executable='b', node_executable='b')")
    (tmp_path / "robot.launch.py").write_text(text)
    run = lint("--diff", "--select", "launch/removed-keyword", cwd=tmp_path)
    assert (run.stdout, run.stderr) == ("", "")
    shown = lint("--select", "launch/removed-keyword", "--output-format", "json", cwd=tmp_path).stdout
    assert "remove it: executable= is there, too" in shown


def test_a_device_is_not_left_to_root_alone(tmp_path: Path) -> None:
    path = tmp_path / "99-robot.rules"
    path.write_text('SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", MODE="0666"\n')
    run = lint("--diff", "--unsafe-fixes", "--select", "udev/mode-world-writable", cwd=tmp_path)
    assert (run.stdout, run.stderr) == ("", "")
    shown = lint("--select", "udev/mode-world-writable", "--output-format", "json", cwd=tmp_path).stdout
    assert r"write 0660 and add GROUP=\"dialout\"" in shown


@pytest.mark.parametrize(("there", "is_fixed"), [("Restart=always", False), ("Type=simple", True)])
def test_a_misspelt_key_does_not_take_the_place_of_the_right_one(tmp_path: Path, there: str, is_fixed: bool) -> None:
    path = tmp_path / "robot.service"
    path.write_text(f"[Service]\n{there}\nExecStart=/bin/x\nRestrat=no\n")
    lint("--fix", "--unsafe-fixes", "--select", "systemd/unknown-key", cwd=tmp_path)
    assert ("Restart=no\n" in path.read_text()) is is_fixed


@pytest.mark.parametrize("comment", ["# a\r# ::error::b\n", "# a\r\n# b\r# ::error::c\r\n"])
def test_diff_shows_nothing_of_a_file_with_a_carriage_return_alone(tmp_path: Path, comment: str) -> None:
    path = tmp_path / "compose.yaml"
    path.write_bytes(f"{comment}services:\n  driver:\n    image: a\n    user: 1000\n".encode())
    before = path.read_bytes()
    run = lint("--diff", "--select", "compose/invalid-value", cwd=tmp_path)
    assert (run.code, run.stdout) == (0, "")
    assert "(its file is a link, not UTF-8, or ends its lines with CR alone)" in run.stderr
    assert path.read_bytes() == before
