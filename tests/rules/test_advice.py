"""Advice, fixes and related places must reach the report as they are written: the concise output leaves them out."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.lint import lint
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import folder_of


def findings(rule_id: str, name: str = "bad") -> list[dict[str, Any]]:
    case = folder_of(rule_id) / name
    options = ("--isolated",) if not command(rule_id) else command(rule_id)
    run = lint(*options, "--select", rule_id, "--output-format", "json", *arguments(case), cwd=case)
    return json.loads(run.stdout)["findings"]


def test_the_escape_of_a_space_in_fstab_is_printed() -> None:
    assert any("\\040" in finding["advice"] for finding in findings("fstab/field-count"))


def test_commands_on_the_host_need_no_list_of_devices() -> None:
    found = {each["message"].split("'")[1]: each["advice"] for each in findings("compose/privileged")}
    assert found["console"].startswith("let it ask for a password")
    assert found["tool"] == "let a systemd unit of the host run them instead"


def test_a_link_of_another_kind_of_device_is_advised_with_a_condition() -> None:
    found = {each["location"]["path"]: each["advice"] for each in findings("device/unstable-path", "bad_link")}
    assert found["config/lidar.yaml"] == "use /dev/kestrel/lidar"
    assert found["config/claw.yaml"].startswith("use /dev/kestrel/lidar or /dev/kestrel/winch if that is the device")


def test_the_name_of_the_robot_is_not_that_of_a_device() -> None:
    found = {each["location"]["path"]: each["advice"] for each in findings("device/unstable-path", "bad_robot_word")}
    assert found["tern_bringup/config/gps.yaml"] == "use /dev/tern_gps"
    assert found["tern_bringup/config/lidar.yaml"].startswith("use /dev/tern_gps if that is the device")


def test_a_container_does_not_listen_on_its_own_loopback_address() -> None:
    found = [each["advice"] for each in findings("host/unauthenticated-service", "bad_container")]
    assert len(found) == 4
    assert all("publish the port of its container" in advice for advice in found)


def test_a_container_that_shares_a_network_publishes_no_port_of_its_own() -> None:
    found = {
        each["message"].split()[0]: each["advice"] for each in findings("host/unauthenticated-service", "bad_shared")
    }
    assert found["mosquitto"] == "use password_file, or bind it to 127.0.0.1"
    assert found["Flask"].startswith("remove debug=True, and publish the port of its container")


def test_a_script_that_ends_at_once_must_wait_before_another_killmode() -> None:
    short = findings("systemd/kill-mode", "bad_short")
    assert len(short) == 3
    assert all(each["advice"].startswith("end the script with wait") and not each.get("fix") for each in short)
    assert {each["advice"] for each in findings("systemd/kill-mode", "bad_lasting")} == {"set KillMode=mixed"}


def test_a_build_in_a_pipe_or_subshell_must_end_the_script_too() -> None:
    found = {each["location"]["path"]: each["advice"] for each in findings("script/build-unchecked", "bad_inside")}
    pipe = "write 'set -o pipefail' before the build, and '|| exit 1' after the "
    assert found == {
        "braces.sh": "write '|| exit 1' after the build",
        "both.sh": f"{pipe}pipe and after the subshell",
        "dash.sh": f"run the script with bash, {pipe}pipe",
        "first.sh": "write '|| exit 1' after the build",
        "group.sh": f"{pipe}build and after the pipe",
        "nested.sh": "write '|| exit 1' after the build and after the subshell",
        "subshell.sh": "write '|| exit 1' after the build and after the subshell",
        "text.sh": "write '|| exit 1' after the build and after the text of bash -c",
    }


def test_a_program_stays_executable() -> None:
    found = [each["advice"].rpartition("with ")[2] for each in findings("script/world-writable", "bad_programs")]
    program = "mode 775, or 664 if nobody runs it"
    assert found[:3] == [program, "mode 664 or 640", "chmod g+w,o-w"]
    assert found[3:] == [program, *["mode u=rwX,g=rwX,o=rX"] * 2, "mode g+w,o-w", "mode 2775 or 750"]


@pytest.mark.parametrize(
    ("rule_id", "advice"),
    [
        ("netplan/bad-top-level", ["rename it to network"]),
        ("script/world-writable", ["give the folder to a group that needs it, with mode 2775 or 750"]),
        ("sros2/policy-grants-nothing", ["write /lawn", 'write publish="ALLOW"']),
        ("systemd/install-bad-target", ["did you mean multi-user.target?", "did you mean multi-user.target?"]),
        ("systemd/shell-wrapper-no-exec", ["start the command with exec", "start the command with exec"]),
        ("systemd/syslogidentifier-missing", ["set SyslogIdentifier=base"]),
    ],
)
def test_advice(rule_id: str, advice: list[str]) -> None:
    assert [finding["advice"] for finding in findings(rule_id)][: len(advice)] == advice


@pytest.mark.parametrize(
    ("rule_id", "related"),
    [
        (
            "cyclonedds/interface-not-waited-for",
            ["netplan does not wait for it", "robot.service waits for network.target only"],
        ),
        ("device/link-undefined", ["a rule for /dev/robot is here"]),
        ("live/topic-typo", ["/lidar/driver publishes /scan_filtered", "subscribed", "published"]),
    ],
)
def test_related_places(rule_id: str, related: list[str]) -> None:
    assert [each["message"] for each in findings(rule_id)[0]["related"]] == related


def test_numbers_that_are_not_decimal_have_no_fix() -> None:
    """``[0x1F, 1.0]``: to write ``0x1F.0`` would make it worse."""
    found = {finding["message"].split("'")[1]: finding["fix"] for finding in findings("params/mixed-list")}
    assert found["gains"] is not None
    assert found["hex"] is None


def test_the_fix_of_an_optional_file_takes_the_dash_alone() -> None:
    (edit,) = findings("systemd/envfile-optional")[0]["fix"]["edits"]
    place = edit["location"]
    assert (place["start"]["column"], place["end"]["column"], edit["text"]) == (17, 18, "")


@pytest.mark.parametrize(("also", "is_fixed"), [("", True), ('WATCHED = ["basse"]\n', False)])
def test_a_name_that_a_file_has_twice_is_not_corrected_once(tmp_path: Path, also: str, is_fixed: bool) -> None:
    tree = shutil.copytree(folder_of("node/heartbeat-unknown-node") / "bad", tmp_path / "tree", symlinks=True)
    (watching,) = (file for file in tree.rglob("*") if file.is_file() and "basse" in file.read_text())
    watching.write_text(watching.read_text() + also)
    run = lint("--isolated", "--select", "node/heartbeat-unknown-node", "--output-format", "json", ".", cwd=tree)
    found = json.loads(run.stdout)["findings"]
    assert [bool(each["fix"]) for each in found if "'basse'" in each["message"]] == [is_fixed]


def test_no_topic_is_the_right_one_without_evidence() -> None:
    said = findings("node/topic-typo")[0]
    assert (said["advice"], said["fix"]) == ("write the same name on both sides, or remap one of them", None)
