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


PLAIN = """\
[Unit]
Description=Camera server
After=network.target

[Service]
ExecStart=/usr/bin/camera-server
Restart=on-failure

[Install]
WantedBy=multi-user.target
"""
OF_OTHER_FILES = (
    *("inspect", "dataclasses", "ast", "pathlib", "shlex", "traceback", "typing", "urllib"),
    *(f"bringup_lint.{name}" for name in ("api.launch", "graph.launch", "model.launch", "parsers.logrotate")),
    *(f"bringup_lint.discover.kinds.{name}" for name in ("params", "shell", "udev")),
)
"""Modules that nothing in a tree of one unit asks for."""
MOST_MODULES = 235
"""Of our own that one plain unit loads: some more than now, for new rules about units."""
MOST_RULES = 90


def test_one_unit_loads_what_units_need(tmp_path: Path) -> None:
    (tmp_path / "camera.service").write_text(PLAIN)
    code = f"""import sys
from bringup_lint import registry
loaded, load = [], registry._module
registry._module = lambda *about: (loaded.append(about), load(*about))[1]
from bringup_lint.cli import dispatch
try: dispatch([{str(tmp_path)!r}])
except SystemExit: pass
print(len(loaded), *sys.modules)"""
    run = subprocess.run(
        [sys.executable, "-ISc", f"import sys; sys.path[:0] = {sys.path!r}\n{code}"],
        capture_output=True,
        text=True,
        cwd=PROJECT,
        check=True,
    )
    rules, *modules = run.stdout.splitlines()[-1].split()
    assert not set(OF_OTHER_FILES) & set(modules)
    assert sum(name.startswith("bringup_lint") for name in modules) <= MOST_MODULES
    assert int(rules) <= MOST_RULES


def test_the_process_ends_with_the_code_of_the_run(tmp_path: Path) -> None:
    (tmp_path / "camera.service").write_text(PLAIN)
    for words, code in (([], 0), (["--fail-on", "info", "--min-severity", "info"], 1), (["--select", "nothing"], 2)):
        command = [sys.executable, "-m", "bringup_lint", *words, str(tmp_path)]
        run = subprocess.run(command, capture_output=True, text=True, cwd=PROJECT, check=False)
        assert run.returncode == code
        assert run.stdout.endswith("\n") or code == 2
        assert bool(run.stderr) == (code == 2)


def test_an_ordering_cycle_is_found_without_a_graph_library(tmp_path: Path) -> None:
    for name, other in (("one", "two"), ("two", "one")):
        unit = f"[Unit]\nAfter={other}.service\n\n[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch rover {name}.py\n"
        (tmp_path / f"{name}.service").write_text(unit)
    code = f"""from bringup_lint.cli import dispatch
try: dispatch(["--select", "systemd/ordering-cycle", {str(tmp_path)!r}])
except SystemExit: pass"""
    assert "networkx" not in loaded_after(code)
