"""The work grows as the tree does: calls are counted, layer by layer, over robots of 1, 3 and 9 times the size.

Nothing is timed. What is the same for every size falls out, because differences are compared: from three to nine times
the size a layer may make three times as many more calls as from one to three, and a logarithm above that.
"""

from __future__ import annotations

import importlib.util
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from types import ModuleType

import pytest

from tests.conftest import PROJECT
from tests.lint import lint

DRIVERS = 5
"""Of the smallest robot; ten files each."""
SIZES = (1, 3, 9)
LINEAR = 3.0
LOGARITHM = 1.4
NOTICED = 5_000
"""Calls that a layer makes more, before growth means something."""


def counted(work: Callable[[], object]) -> Counter[str]:
    """How many calls each layer makes: functions of its own, and of Python from it."""
    calls: Counter[str] = Counter()

    def note(frame: FrameType, event: str, argument: object) -> None:
        if event in ("call", "c_call"):
            calls[frame.f_code.co_filename] += 1

    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(None)
    layers: Counter[str] = Counter()
    for name, count in calls.items():
        layers[layer_of(name)] += count
    return layers


def layer_of(name: str) -> str:
    """``graph/systemd``, ``rules/params``; empty for a file of another project."""
    path = Path(name)
    if PROJECT not in path.parents:
        return ""
    parts = path.relative_to(PROJECT).parts
    inside = parts[1:] if parts[0] == "bringup_lint" else parts
    return "/".join(inside[:2])


def excess(small: int, middle: int, large: int) -> float:
    """How much more than linear the calls grow; 1 is linear."""
    if large - middle < NOTICED:
        return 0.0
    return (large - middle) / max(middle - small, 1) / LINEAR


def generator() -> ModuleType:
    """``benchmarks/robot.py``, which is no package."""
    spec = importlib.util.spec_from_file_location("generated_robot", PROJECT / "benchmarks/robot.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_every_layer_grows_as_the_tree_does(tmp_path: Path) -> None:
    tops = [generator().generate(tmp_path / str(size), DRIVERS * size) for size in SIZES]
    lint(".", cwd=tops[0])  # imports everything
    small, middle, large = (counted(lambda top=top: lint(".", cwd=top)) for top in tops)
    growth = {layer: excess(small[layer], middle[layer], large[layer]) for layer in large if layer}
    assert {layer: round(value, 2) for layer, value in growth.items() if value > LOGARITHM} == {}


def rules(folder: Path, count: int) -> None:
    """The rules of one udev file."""
    file = folder / "etc/udev/rules.d/99-robot.rules"
    file.parent.mkdir(parents=True)
    lines = (f'SUBSYSTEM=="tty", ATTRS{{serial}}=="A{n}", SYMLINK+="robot{n}"\n' for n in range(count))
    file.write_text("".join(lines))


def chain(folder: Path, count: int) -> None:
    """Units of which each requires the next one."""
    for n in range(count):
        unit = (
            f"[Unit]\nRequires=r{n + 1}.service\nAfter=r{n + 1}.service\n[Service]\nExecStart=/usr/bin/ros2 run a n\n"
        )
        (folder / f"r{n}.service").write_text(unit)


def images(folder: Path, count: int) -> None:
    """Services of compose with an image and a profile each, on two kinds of network."""
    services = []
    for n in range(count):
        image = folder / f"d{n}/Dockerfile"
        image.parent.mkdir()
        image.write_text(
            f"FROM ros:humble\nRUN apt-get install -y ros-humble-nav2\nCOPY a{n} /opt/a\nCMD ros2 run a n{n}\n"
        )
        network = "    network_mode: host\n" if n % 2 else "    environment:\n      - ROS_DOMAIN_ID=3\n"
        services.append(f"  s{n}:\n    build: d{n}\n    profiles: [p{n % 7}]\n    command: ros2 run a n{n}\n{network}")
    (folder / "compose.yaml").write_text("services:\n" + "".join(services))


def packages(folder: Path, count: int) -> None:
    """Packages with plugins, definitions of messages, nodes in C++ and files of no kind."""
    for n in range(count):
        top = folder / f"src/p{n}"
        for below in ("src", "msg", "notes"):
            (top / below).mkdir(parents=True)
        (top / "package.xml").write_text(MANIFEST.format(name=f"p{n}", build="ament_cmake"))
        (top / "CMakeLists.txt").write_text(f"project(p{n})\nadd_library(l{n} src/d{n}_0.cpp)\nament_package()\n")
        (top / "plugins.xml").write_text(
            f'<library path="l{n}"><class name="c{n}" type="C" base_class_type="B"/></library>\n'
        )
        (top / "msg/Count.msg").write_text("int32 count\n")
        for k in range(5):
            (top / f"src/d{n}_{k}.cpp").write_text(NODE.replace("Driver", f"Driver{n}_{k}"))
            (top / f"notes/{k}.txt").write_text("\n")


def modules(folder: Path, count: int) -> None:
    """Packages with modules, which setuptools installs."""
    for n in range(count):
        top = folder / f"src/m{n}"
        (top / f"m{n}").mkdir(parents=True)
        (top / "package.xml").write_text(MANIFEST.format(name=f"m{n}", build="ament_python"))
        scripts = f'entry_points={{"console_scripts": ["run = m{n}.f0:main"]}}'
        (top / "setup.py").write_text(
            f'from setuptools import setup\nsetup(name="m{n}", packages=["m{n}"], {scripts})\n'
        )
        (top / f"m{n}/__init__.py").touch()
        for k in range(10):
            (top / f"m{n}/f{k}.py").write_text("import os\n\n\ndef main():\n    print(os.getpid())\n")


def projects(folder: Path, count: int) -> None:
    """Compose files, each with its image and the script that its service starts."""
    for n in range(count):
        top = folder / f"d{n}"
        top.mkdir()
        (top / "Dockerfile").write_text(f'FROM ros:jazzy\nCOPY start_{n}.sh /\nUSER robot\nCMD ["/start_{n}.sh"]\n')
        (top / f"start_{n}.sh").write_text(f"#!/bin/bash\nset -e\nexec ros2 run a n{n}\n")
        (top / "compose.yaml").write_text(
            f"services:\n  s{n}:\n    build: .\n    volumes: [./data:/data]\n    devices: [/dev/d{n}]\n"
        )


def installers(folder: Path, count: int) -> None:
    """Scripts that install units and rules, each its own."""
    for n in range(count):
        (folder / f"robot-{n}.service").write_text(f"[Service]\nExecStart=/usr/bin/ros2 run a n{n}\n")
        (folder / f"70-robot-{n}.rules").write_text(f'SUBSYSTEM=="tty", ATTRS{{serial}}=="A{n}", SYMLINK+="robot{n}"\n')
        (folder / f"install_{n}.sh").write_text(
            f"#!/bin/bash\nset -e\nsudo cp robot-{n}.service /etc/systemd/system/\n"
            f"sudo cp 70-robot-{n}.rules /etc/udev/rules.d/\nsudo systemctl enable robot-{n}.service\n"
        )


MANIFEST = """\
<package format="3">
  <name>{name}</name><version>0.0.1</version><description>A package.</description>
  <maintainer email="a@b.c">a</maintainer><license>MIT</license>
  <export><build_type>{build}</build_type></export>
</package>
"""
NODE = """\
#include <rclcpp/rclcpp.hpp>
class Driver : public rclcpp::Node
{
public:
  Driver() : Node("driver") {}
};
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "count"),
    [
        (rules, 100),
        (chain, 30),
        (images, 30),
        (packages, 10),
        (modules, 10),
        (projects, 15),
        (installers, 15),
    ],
)
def test_every_layer_grows_as_one_kind_of_file_does(
    shape: Callable[[Path, int], None], count: int, tmp_path: Path
) -> None:
    tops = [tmp_path / str(size) for size in SIZES]
    for size, top in zip(SIZES, tops, strict=True):
        top.mkdir()
        shape(top, count * size)
    lint(".", cwd=tops[0])
    small, middle, large = (counted(lambda top=top: lint(".", cwd=top)) for top in tops)
    growth = {layer: excess(small[layer], middle[layer], large[layer]) for layer in large if layer}
    assert {layer: round(value, 2) for layer, value in growth.items() if value > LOGARITHM} == {}


def test_quadratic_work_is_noticed() -> None:
    small, middle, large = ((100 * size) ** 2 for size in SIZES)
    assert excess(small, middle, large) > LOGARITHM
    small, middle, large = (10_000 * size for size in SIZES)
    assert excess(small, middle, large) <= LOGARITHM
