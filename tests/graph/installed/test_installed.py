"""The files that scripts write, joined as what they become on the robot."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.discover.walk import discover
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.installed.script import runs
from bringup_lint.robot import Robot
from bringup_lint.source import Source

RULE = 'SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", SYMLINK+="imu"'


def robot_of(folder: Path, **files: str) -> Robot:
    for name, text in files.items():
        path = folder / name.replace("__", "/").replace("_sh", ".sh").replace("_rules", ".rules")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Robot(discover([str(folder)]))


def written(folder: Path, script: str) -> dict[str | None, Source]:
    robot = robot_of(folder, setup_sh=script)
    return {source.robot_path: source for source in robot.sources if source.origin is not None}


@pytest.mark.parametrize(
    ("script", "text"),
    [
        ("cat > /etc/sysctl.d/1.conf <<'EOF'\na=$B\nEOF\n", "a=$B\n"),
        ("B=2\ncat > /etc/sysctl.d/1.conf <<EOF\na=$B\nEOF\n", "a=2\n"),
        ("cat > /etc/sysctl.d/1.conf <<EOF\na=$B\nEOF\n", "a={{ B }}\n"),
        ("cat > /etc/sysctl.d/1.conf <<EOF\na=\\$B\nEOF\n", "a=$B\n"),
        ("cat > /etc/sysctl.d/1.conf <<-EOF\n\t\ta=1\n\tEOF\n", "a=1\n"),
        ("sudo tee /etc/sysctl.d/1.conf > /dev/null <<EOF\na=1\nEOF\n", "a=1\n"),
        ("cat <<EOF | sudo tee /etc/sysctl.d/1.conf\na=1\nEOF\n", "a=1\n"),
        ("echo 'a=1' | $SUDO tee -a /etc/sysctl.d/1.conf\n", "a=1\n"),
        ("echo -e 'a=1\\nb=2' > /etc/sysctl.d/1.conf\n", "a=1\nb=2\n"),
        ("printf 'a=%s\\n' 1 > /etc/sysctl.d/1.conf\n", "a=1\n"),
        ("sudo bash -c 'echo \"a=1\" > /etc/sysctl.d/1.conf'\n", "a=1\n"),
        ("{ echo a=1; echo b=2; } > /etc/sysctl.d/1.conf\n", "a=1\nb=2\n"),
        ("echo a=1 > /etc/sysctl.d/1.conf\necho b=2 >> /etc/sysctl.d/1.conf\n", "a=1\nb=2\n"),
        ("NAME=1\necho a=1 > /etc/sysctl.d/$NAME.conf\n", "a=1\n"),
        ("echo a=1 > $ROOTFS/etc/sysctl.d/1.conf\n", "a=1\n"),
        ("echo a=1 > /tmp/1.conf\nsudo mv /tmp/1.conf /etc/sysctl.d/\n", "a=1\n"),
        ("write() {\n  echo a=1 > /etc/sysctl.d/1.conf\n}\nwrite\n", "a=1\n"),
    ],
)
def test_texts(tmp_path: Path, script: str, text: str) -> None:
    assert written(tmp_path, script)["/etc/sysctl.d/1.conf"].text == text


@pytest.mark.parametrize(
    "script",
    [
        "generate > /etc/sysctl.d/1.conf\n",
        "echo a=1 2> /etc/sysctl.d/1.conf\n",
        "echo a=1 > /etc/sysctl.d/1.conf\nsed -i s/1/2/ /etc/sysctl.d/1.conf\n",
        "echo a=1 > $NAME\n",
        "# echo a=1 > /etc/sysctl.d/1.conf\n",
    ],
)
def test_not_known(tmp_path: Path, script: str) -> None:
    assert not written(tmp_path, script)


def test_places_are_in_the_script(tmp_path: Path) -> None:
    source = written(tmp_path, f"A=0403\ncat > /etc/udev/rules.d/9.rules <<EOF\n{RULE.replace('0403', '$A')}\nEOF\n")
    found = source["/etc/udev/rules.d/9.rules"]
    assert found.origin is not None
    start = found.text.index("imu")
    assert found.origin.span(start, start + 3).text == "imu"
    start = found.text.index("0403")
    assert found.origin.span(start, start + 4).text == "$A"


@pytest.mark.parametrize(
    ("script", "certain"),
    [
        ("echo a=1 > /etc/sysctl.d/1.conf", True),
        ("if test -e x; then echo a=1 > /etc/sysctl.d/1.conf; fi", False),
        ("test -e x && echo a=1 > /etc/sysctl.d/1.conf", False),
        ("true && echo a=1 > /etc/sysctl.d/1.conf", True),
        ("f() { echo a=1 > /etc/sysctl.d/1.conf; }", False),
        ("f() { echo a=1 > /etc/sysctl.d/1.conf; }; f", True),
    ],
)
def test_conditions(tmp_path: Path, script: str, certain: bool) -> None:
    found = written(tmp_path, script)["/etc/sysctl.d/1.conf"]
    assert found.origin is not None and found.origin.certain is certain


@pytest.mark.parametrize(
    "command",
    [
        "cp files/imu.rules /etc/udev/rules.d/",
        'sudo cp "$DIR/files/imu.rules" /etc/udev/rules.d',
        "install -m 0644 files/imu.rules /etc/udev/rules.d/imu.rules",
        "sudo ln -sf $PWD/files/imu.rules /etc/udev/rules.d/imu.rules",
        "cp files/*.rules /etc/udev/rules.d/",
    ],
)
def test_a_copied_file_knows_its_path_on_the_robot(tmp_path: Path, command: str) -> None:
    robot = robot_of(tmp_path, setup_sh=command, files__imu_rules=RULE + "\n")
    (source,) = robot.of_kind("udev-rules")
    assert source.robot_path == "/etc/udev/rules.d/imu.rules"


@pytest.mark.parametrize(
    ("target", "place"),
    [("/etc/udev/rules.d/", "/etc/udev/rules.d/imu.rules"), ("/tmp/kept/", "/etc/imu.rules")],
)
def test_a_script_knows_better_than_the_name_of_a_folder(tmp_path: Path, target: str, place: str) -> None:
    robot = robot_of(tmp_path, setup_sh=f"cp deploy/etc/imu.rules {target}", deploy__etc__imu_rules=RULE + "\n")
    (source,) = robot.of_kind("udev-rules")
    assert source.robot_path == place


def test_a_copy_that_is_kept_aside_leaves_the_file_where_it_is(tmp_path: Path) -> None:
    folder = tmp_path / "rootfs/etc/systemd/system/robot.service.d"
    folder.mkdir(parents=True)
    (folder / "own.conf").write_text("[Service]\nUser=robot\n")
    robot = robot_of(tmp_path, setup_sh="cp rootfs/etc/systemd/system/robot.service.d/own.conf /opt/kept/own.conf\n")
    (source,) = robot.of_kind("systemd-dropin")
    assert source.robot_path == "/etc/systemd/system/robot.service.d/own.conf"


def test_a_file_that_only_its_place_makes_one_of_a_kind(tmp_path: Path) -> None:
    robot = robot_of(tmp_path, setup_sh="cp files/imu.rules /etc/udev/rules.d/", files__imu_rules='"KERNEL==x\n')
    assert [source.robot_path for source in robot.of_kind("udev-rules")] == ["/etc/udev/rules.d/imu.rules"]


@settings(deadline=None)
@given(
    st.lists(
        st.sampled_from(
            [
                "echo ",
                "a",
                "> /etc/x",
                "<<E\n",
                "E\n",
                "$",
                "{",
                "}",
                "'",
                '"',
                "(",
                ")",
                ";",
                "|",
                "\\",
                "\n",
                "f() {",
                "tee /e ",
            ]
        )
    ).map("".join)
)
def test_never_raises_and_every_piece_lies_in_the_script(script: str) -> None:
    for did in runs(Source("setup.sh", script)):
        if isinstance(did, Written) and did.text is not None:
            assert all(0 <= piece.start <= piece.end <= len(script) for piece in did.text.pieces)


def test_a_unit_has_the_name_under_which_it_is_installed(tmp_path: Path) -> None:
    robot = robot_of(
        tmp_path,
        setup_sh="cp files/base.unit /etc/systemd/system/rover.service",
        **{"files__base.unit": "[Service]\nExecStart=/opt/base\n"},
    )
    assert [unit.name for unit in robot.units.all] == ["rover.service"]


def test_ansible_and_cloud_init(tmp_path: Path) -> None:
    play = (
        f"- name: rule\n  copy:\n    dest: /etc/udev/rules.d/1.rules\n    content: |\n      {RULE}\n"
        "- name: unit\n  template:\n    src: base.service.j2\n    dest: /etc/systemd/system/rover.service\n"
        "  become: true\n"
    )
    data = f"#cloud-config\nwrite_files:\n  - path: /etc/udev/rules.d/2.rules\n    content: |\n      {RULE}\n"
    files = {
        "roles__tasks__main.yml": play,
        "user-data": data,
        "roles__templates__base.service.j2": "[Service]\nExecStart=/opt/base\n",
    }
    robot = robot_of(tmp_path, **files)
    assert [source.robot_path for source in robot.of_kind("udev-rules")] == [
        "/etc/udev/rules.d/1.rules",
        "/etc/udev/rules.d/2.rules",
    ]
    assert all(source.text == RULE + "\n" and source.origin for source in robot.of_kind("udev-rules"))
    assert [unit.name for unit in robot.units.all] == ["rover.service"]


@pytest.mark.parametrize(
    ("variables", "names"),
    [
        ("unit: rover", ["rover.service"]),
        ("unit: 'rover-{{ robot }}'", ["{{ unit }}.service"]),
        ("other: rover", ["{{ unit }}.service"]),
    ],
)
def test_ansible_knows_the_variables_of_its_file(tmp_path: Path, variables: str, names: list[str]) -> None:
    play = (
        f"- hosts: all\n  vars:\n    {variables}\n  tasks:\n    - name: unit\n      copy:\n"
        "        dest: '/etc/systemd/system/{{ unit }}.service'\n        content: |\n"
        "          [Service]\n          ExecStart=/opt/base --name {{ unit }}\n"
    )
    robot = robot_of(tmp_path, **{"roles__tasks__main.yml": play})
    assert [unit.name for unit in robot.units.all] == names


def test_a_script_with_unknown_values_is_not_joined(tmp_path: Path) -> None:
    script = "cat > /usr/local/bin/env.sh <<EOF\nexport ROS_DOMAIN_ID=$ID\nEOF\n"
    assert not written(tmp_path, script)
    assert written(tmp_path, script.replace("$ID", "4"))["/usr/local/bin/env.sh"].kind == "shell-script"
