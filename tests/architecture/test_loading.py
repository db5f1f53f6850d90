"""Heavy libraries load only where they are needed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.conftest import PROJECT

HEAVY = ("libcst", "networkx", "yaml", "pathspec", "click", "jsonschema", "lxml")


def loaded_after(code: str) -> set[str]:
    script = f"{code}\nimport sys; print(' '.join(m for m in {HEAVY!r} if m in sys.modules))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=PROJECT, check=True)
    return set(run.stdout.splitlines()[-1].split())


def test_version_loads_nothing_heavy() -> None:
    code = "import sys; sys.argv = ['bringup-lint', '--version']\nfrom bringup_lint.__main__ import main; main()"
    assert loaded_after(code) == set()


def test_one_unit_loads_no_xml_yaml_or_graph_library(tmp_path: Path) -> None:
    unit = tmp_path / "robot.service"
    unit.write_text("[Service]\nExecStart=/bin/true\n")
    code = f"""from bringup_lint.cli import dispatch
try: dispatch([{str(unit)!r}])
except SystemExit: pass"""
    assert loaded_after(code) <= {"click"}


def test_an_ordering_cycle_is_found_without_a_graph_library(tmp_path: Path) -> None:
    for name, other in (("one", "two"), ("two", "one")):
        unit = f"[Unit]\nAfter={other}.service\n\n[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch rover {name}.py\n"
        (tmp_path / f"{name}.service").write_text(unit)
    code = f"""from bringup_lint.cli import dispatch
try: dispatch(["--select", "systemd/ordering-cycle", {str(tmp_path)!r}])
except SystemExit: pass"""
    assert "networkx" not in loaded_after(code)
