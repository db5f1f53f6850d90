"""What a unit really runs."""

from __future__ import annotations

import pytest

from tests.graph.systemd.test_units import load
from tests.graph.systemd.test_units import only


def process(tmp_path, monkeypatch, line, files=()):
    unit = f"[Service]\nExecStart={line}\n"
    units = load(tmp_path, {"a.service": unit, **dict(files)}, monkeypatch)
    (found,) = units.started(only(units, "a.service"))
    return found


@pytest.mark.parametrize(
    "line",
    [
        "/opt/ros/humble/bin/ros2 launch pkg main.launch.py a:=b",
        "/bin/bash -c 'source /opt/ros/humble/setup.bash && exec ros2 launch pkg main.launch.py a:=b'",
        "/bin/bash --login -eo pipefail -c 'ros2 launch pkg main.launch.py a:=b'",
        "/usr/bin/nice -n -5 /usr/bin/chrt -f 80 /usr/bin/taskset -c 0-3 ros2 launch pkg main.launch.py a:=b",
        "/usr/bin/sudo -E -u rover ros2 launch pkg main.launch.py a:=b",
        "/usr/bin/setpriv --reuid rover --init-groups -- ros2 launch pkg main.launch.py a:=b",
        "/usr/bin/env A=1 /usr/bin/timeout -k 5 60 ros2 launch pkg main.launch.py a:=b",
        "/opt/robot/entry.sh ros2 launch pkg main.launch.py a:=b",
    ],
)
def test_launch_is_found_behind_wrappers(tmp_path, monkeypatch, line):
    script = '#!/bin/bash\nset -e\nsource /opt/ros/humble/setup.bash\nexec "$@"\n'
    found = process(tmp_path, monkeypatch, line, {"opt/robot/entry.sh": script})
    ((_, ros),) = found.launches
    assert (ros.package, ros.target) == ("pkg", "main.launch.py")
    assert [str(argument) for argument in ros.arguments] == ["a:=b"]


def test_scripts_of_the_tree_are_followed(tmp_path, monkeypatch):
    files = {
        "opt/robot/one.sh": "#!/bin/bash\n. /opt/robot/common.sh\nexec /opt/robot/two.sh\n",
        "opt/robot/two.sh": "#!/bin/sh\nros2 run pkg node --ros-args -p x:=1\n",
        "opt/robot/common.sh": "source /opt/ros/jazzy/setup.bash\n",
    }
    found = process(tmp_path, monkeypatch, "/opt/robot/one.sh", files)
    ((step, ros),) = found.ros
    assert (step.script.name, step.shell, ros.kind) == ("opt/robot/two.sh", "sh", "run")
    assert [str(word) for _, word in found.setup_files] == ["/opt/ros/jazzy/setup.bash"]
    assert not found.opaque


def test_script_that_is_not_there_is_said(tmp_path, monkeypatch):
    found = process(tmp_path, monkeypatch, "/bin/bash /opt/robot/none.sh")
    assert found.opaque
    assert found.script_outside_tree == "/opt/robot/none.sh"


def test_program_of_the_system_is_not_a_script_outside_the_tree(tmp_path, monkeypatch):
    found = process(tmp_path, monkeypatch, "/usr/bin/socat TCP-LISTEN:1 TCP:x:2")
    assert found.opaque
    assert found.script_outside_tree is None
