"""``bringup-lint fleet``: inventories, and what is said about several robots."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bringup_lint.report import fleet as reports
from tests.conftest import PROJECT
from tests.lint import lint

SCHEMA = Path(reports.__file__).parent / "json.schema.json"
KEYS = PROJECT / "fixtures/fleet/same_ssh_host_key/bad"


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")


def judged(*arguments: str, cwd: Path) -> dict:
    run = lint("fleet", "--workers", "1", "--output-format", "json", *arguments, cwd=cwd)
    assert run.code in (0, 1), run.stderr
    return json.loads(run.stdout)


def test_json_is_as_its_schema_says() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    report = judged("robots/alpha", "robots/beta", "robots/gamma", cwd=KEYS)
    jsonschema.validate(report, json.loads(SCHEMA.read_text("utf-8")))
    assert [found["robots"] for found in report["findings"]] == [["alpha", "beta"]]


def test_text_names_the_robots_and_the_places() -> None:
    run = lint("fleet", "--workers", "1", "robots/alpha", "robots/beta", cwd=KEYS)
    assert run.code == 1
    assert "error[fleet/same-ssh-host-key]: 2 robots have the same SSH host key (ed25519): alpha and beta;" in " ".join(
        run.stdout.split()
    )
    assert "--> beta: robots/beta/etc/ssh/ssh_host_ed25519_key.pub:1" in run.stdout
    assert "Fleet of 2 robots: 1 error, 0 warnings, 0 info." in run.stdout


def test_a_robot_is_checked_as_by_itself(tmp_path: Path) -> None:
    unit = "[Unit]\nAfter=network.target\n\n[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch rover up.launch.py\n"
    write(tmp_path, {"alpha/etc/systemd/system/rover.service": unit})
    alone = json.loads(lint("--output-format", "json", "alpha", cwd=tmp_path).stdout)["findings"]
    together = judged("alpha", cwd=tmp_path)["robots"][0]["findings"]
    assert alone
    assert [each["fingerprint"] for each in together] == [each["fingerprint"] for each in alone]


def test_workers_find_what_one_process_finds() -> None:
    paths = ["robots/alpha", "robots/beta", "robots/gamma"]
    one, two = (lint("fleet", "--workers", n, "--output-format", "json", *paths, cwd=KEYS) for n in ("1", "2"))
    assert one.stdout == two.stdout


def test_an_inventory_names_roles_and_accepts_what_is_meant(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "one/etc/machine-id": "0" * 32 + "\n",
            "two/etc/machine-id": "0" * 32 + "\n",
            "fleet.toml": """
[[robot]]
name = "a"
role = "scout"
root = "one"

[[robot]]
name = "b"
site = "hall"
root = "two"

[[accept]]
rule = "fleet/same-machine-id"
reason = "two snapshots of one robot"
""",
        },
    )
    report = judged(".", cwd=tmp_path)
    assert [(robot["name"], robot["role"], robot["site"]) for robot in report["robots"]] == [
        ("a", "scout", ""),
        ("b", "robot", "hall"),
    ]
    assert [found["accepted"] for found in report["findings"]] == ["two snapshots of one robot"]
    assert report["summary"]["exit_code"] == 0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[[robot]]\noverlay = "a"\n', "unknown key 'overlay'; did you mean 'overlays'?"),
        ('[[robot]]\nname = "a"\n', "robot 'a' has neither root nor overlays"),
        ('[[robot]]\nname = "a"\nroot = "none"\n', "there is no 'none'"),
        ("[[robot]]\nname = 3\n", "name is not of type str"),
        ('[site.x]\ndomains = "some"\n', "domains is one of shared, separate"),
        ("[[robot]\n", "fleet.toml:1: "),
        ('[[accept]]\nrule = "fleet/same-machine-id"\n', "needs a rule and a reason"),
    ],
)
def test_mistakes_in_an_inventory_are_said(tmp_path: Path, text: str, said: str) -> None:
    write(tmp_path, {"fleet.toml": text})
    run = lint("fleet", ".", cwd=tmp_path)
    assert run.code == 2
    assert said in run.stderr


def test_folders_without_a_file_of_a_robot_are_refused(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("no robot\n")
    run = lint("fleet", ".", cwd=tmp_path)
    assert (run.code, run.stdout) == (2, "")
    assert "no file of a robot was found: give a folder or a tar archive" in run.stderr


@pytest.mark.parametrize(
    ("files", "said"),
    [
        (
            {"a/etc/hostname": "a\n", "b/etc/hostname": "b\n"},
            "a folder of 2 (a and b): name each of them, such as all/a",
        ),
        ({"inventory.yml": "all:\n", "a/etc/hostname": "a\n"}, "hosts of its inventory, name all/inventory.yml"),
        ({"etc/hostname": "a\n", "b/etc/hostname": "b\n"}, ""),
        ({"rootfs/etc/hostname": "a\n"}, ""),
    ],
)
def test_a_folder_of_robots_is_not_taken_for_one_in_silence(tmp_path: Path, files: dict[str, str], said: str) -> None:
    unit = "[Unit]\nDescription={0}\n[Service]\nExecStart=/bin/true {0}\n"
    write(tmp_path / "all", files)
    for top in {name.partition("etc/")[0] for name in files if "etc/" in name}:
        write(tmp_path / "all", {f"{top}etc/systemd/system/otter.service": unit.format(top or "own")})
    run = lint("fleet", "--workers", "1", "all", cwd=tmp_path)
    assert run.code == 0
    assert "Fleet of 1 robot: 0 errors, 0 warnings, 0 info." in run.stdout
    assert (said in run.stderr) and bool(said) == bool(run.stderr)


def test_two_robots_of_one_name_are_refused(tmp_path: Path) -> None:
    write(tmp_path, {"one/robot/etc/hostname": "a\n", "two/robot/etc/hostname": "b\n"})
    run = lint("fleet", "one/robot", "two/robot", cwd=tmp_path)
    assert run.code == 2
    assert "two robots are called 'robot'" in run.stderr


def test_no_secret_is_in_any_output(tmp_path: Path) -> None:
    hashed = "$6$saltsalt$" + "Q" * 60
    for name in ("one", "two", "three"):
        write(tmp_path, {f"{name}/etc/shadow": f"robot:{hashed}:19000:0:99999:7:::\n"})
    for output_format in reports.FORMATS:
        run = lint("fleet", "--workers", "1", "--output-format", output_format, "one", "two", "three", cwd=tmp_path)
        assert "Q" * 8 not in run.stdout


def test_an_ansible_inventory_with_host_vars(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "alpha/etc/hostname": "alpha\n",
            "beta/etc/hostname": "beta\n",
            "hosts.yml": """
all:
  vars:
    bringup_lint_site: hall
  children:
    scouts:
      hosts:
        alpha: {bringup_lint_root: alpha, bringup_lint_domain: 7}
        beta:
""",
            "host_vars/beta.yml": "bringup_lint_root: beta\nbringup_lint_site: yard\n",
            "group_vars/scouts.yml": "bringup_lint_role: scout\n",
        },
    )
    from bringup_lint.fleet.inventory import read_inventory

    members = read_inventory([str(tmp_path / "hosts.yml")]).members
    assert [(each.name, each.role, each.site, each.domain) for each in members] == [
        ("alpha", "scout", "hall", 7),
        ("beta", "scout", "yard", None),
    ]


def test_the_folder_of_a_robot_is_not_left_out(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "images/one/etc/machine-id": "0" * 32 + "\n",
            "images/two/etc/machine-id": "0" * 32 + "\n",
            "bringup-lint.toml": 'exclude = ["/images/"]\n',
        },
    )
    report = judged("images/one", "images/two", cwd=tmp_path)
    assert [found["rule"] for found in report["findings"]] == ["fleet/same-machine-id"]
