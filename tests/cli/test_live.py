"""``bringup-lint live`` as far as it needs no ROS: what is missing or hangs, what was saved, and how it is told."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.cli.commands.live import command
from bringup_lint.live import observe
from bringup_lint.live import run as live_run
from bringup_lint.live.text import graph_text
from bringup_lint.model.node_source import INFINITE
from bringup_lint.parsers.observed import parse
from bringup_lint.registry import Registry
from bringup_lint.source import Source
from tests.conftest import PROJECT
from tests.lint import lint

BAD = PROJECT / "fixtures/live/qos_incompatible/bad"
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription({})
"""
SEEN = {
    "domain": 42,
    "rmw": "rmw_fastrtps_cpp",
    "nodes": [["/a", "/"], ["/no\n- {name: /injected}", "/"], ["/yes", "/robot"]],
    "states": {"/a": "no answer"},
    "endpoints": [
        {
            "topic": "/scan",
            "role": "publisher",
            "node": "/a",
            "type": "sensor_msgs/msg/LaserScan",
            "qos": {
                "reliability": "reliable",
                "durability": "volatile",
                "deadline": 0.5,
                "liveliness": "automatic",
                "lease": None,
            },
        }
    ],
}


@pytest.fixture
def stub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder whose ``rclpy.py`` is found instead of the real one, and an empty tree to check."""
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    for name in ("ROS_DOMAIN_ID", "RMW_IMPLEMENTATION", "ROS_DISTRO"):
        monkeypatch.delenv(name, raising=False)
    (tmp_path / "tree").mkdir()
    return tmp_path / "rclpy.py"


@pytest.mark.parametrize(("file", "said"), [("/dev/zero", "a character device"), ("fifo", "a FIFO")])
def test_what_is_loaded_is_a_bounded_file(tmp_path: Path, file: str, said: str) -> None:
    os.mkfifo(tmp_path / "fifo")
    run = lint("live", "--load", file, cwd=tmp_path)
    assert (run.code, run.stdout) == (2, "")
    assert f"{file}: not a regular file but {said}" in run.stderr


def test_without_rclpy_it_says_how_to_get_it(stub: Path) -> None:
    stub.write_text("raise ModuleNotFoundError(\"No module named 'rclpy'\")\n")
    run = lint("live", cwd=stub.parent / "tree")
    assert run.code == 2
    assert run.stdout == ""
    *_, line = run.stderr.splitlines()
    assert line == (
        "bringup-lint: the running graph cannot be looked at without rclpy (No module named 'rclpy'); "
        "pip install 'bringup-lint[live] @ git+https://github.com/bringup-lint/bringup-lint', "
        "or: source /opt/ros/jazzy/setup.bash"
    )


def test_the_python_of_a_sourced_ros_is_tried_too(stub: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stub.write_text("raise ModuleNotFoundError(\"No module named 'rclpy'\")\n")
    python = stub.parent / "bin/python3"
    python.parent.mkdir()
    python.write_text(f"#!/bin/sh\nprintf '%s\\n' '{observe.MARK}{json.dumps({**SEEN, 'states': {}})}'\n")
    python.chmod(0o755)
    monkeypatch.setenv("PATH", f"{python.parent}:{os.environ['PATH']}")
    run = lint("live", "--save", "graph.yaml", cwd=stub.parent / "tree")
    assert run.code == 0, run.stderr
    assert "- {name: /a, enclave: /}\n" in (stub.parent / "tree/graph.yaml").read_text()


def test_a_broken_middleware_is_told_in_one_line(stub: Path) -> None:
    stub.write_text("raise RuntimeError('librmw_example.so: cannot open shared object file')\n")
    run = lint("live", cwd=stub.parent / "tree")
    assert run.code == 2
    assert run.stderr.splitlines()[1:] == [
        "bringup-lint: the ROS graph cannot be joined: librmw_example.so: cannot open shared object file"
    ]


def test_a_crash_of_the_middleware_is_told_in_one_line(stub: Path) -> None:
    stub.write_text("import os, sys\nprint('terminate called', file=sys.stderr, flush=True)\nos.kill(os.getpid(), 6)\n")
    run = lint("live", cwd=stub.parent / "tree")
    assert run.code == 2
    assert run.stderr.splitlines()[1:] == ["bringup-lint: the middleware crashed with signal 6: terminate called"]


def test_a_middleware_that_hangs_is_given_up(stub: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(live_run, "SLACK", 0.2)
    monkeypatch.setattr(observe, "LONGER", 0.2)
    stub.write_text("import time\ntime.sleep(600)\n")
    run = lint("live", "--wait", "0.3", cwd=stub.parent / "tree")
    assert run.code == 2
    assert run.stderr.splitlines()[1:] == ["bringup-lint: the middleware did not answer within 0.7 s"]


def test_a_middleware_that_hangs_does_not_outlive_its_limit(stub: Path) -> None:
    stub.write_text("import time\ntime.sleep(600)\n")
    task = {"domain": 0, "wait": 1, "enclave": None, "limit": 1}
    run = subprocess.run([sys.executable, observe.__file__, json.dumps(task)], timeout=10, check=False)
    assert run.returncode == -signal.SIGALRM


def test_what_was_seen_is_read_again() -> None:
    text = graph_text(SEEN, [{"domain": 0, "nodes": [["/b", "/"]]}], "ros.env:1", True)
    observed = parse(Source("graph.yaml", text))
    assert observed.problems == ()
    assert (observed.domain, observed.domain_from, observed.rmw, observed.secured) == (
        42,
        "ros.env:1",
        "rmw_fastrtps_cpp",
        True,
    )
    assert [(node.name, node.enclave, node.state) for node in observed.nodes] == [
        ("/a", "/", "no answer"),
        ("/no\n- {name: /injected}", "/", None),
        ("/yes", "/robot", None),
    ]
    (endpoint,) = observed.endpoints
    assert endpoint.publishes
    qos = endpoint.qos
    assert (qos.reliability, qos.durability, qos.deadline) == ("RELIABLE", "VOLATILE", 0.5)
    assert (qos.liveliness, qos.lease) == ("AUTOMATIC", INFINITE)
    assert [(domain, [node.name for node in nodes]) for domain, nodes in observed.elsewhere] == [(0, ["/b"])]


def test_a_node_that_appears_late_is_not_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    node = "Node(package='otter', executable='{0}', name='{0}')"
    (tmp_path / "otter.launch.py").write_text(LAUNCH.format(f"[{node.format('sea')}, {node.format('land')}]"))
    looks = iter((["/sea"], ["/land"]))
    waits = []

    def look(domains, wait, **how):
        waits.append(wait)
        return [
            {**SEEN, "domain": each, "states": {}, "nodes": [[n, "/"] for n in next(looks, [])]} for each in domains
        ]

    monkeypatch.setattr(live_run, "look", look)
    run = lint("live", "--domain-id", "3", "--wait", "1", "--output-format", "concise", ".", cwd=tmp_path)
    assert (run.stdout, run.code) == ("", 0)
    assert waits == [1, live_run.AGAIN]
    assert "Looking longer, for what is not there, and at 0 ..." in run.stderr


def test_a_second_look_adds_to_the_first() -> None:
    first = {**SEEN, "nodes": [["/a", "/"], ["/b", "/"]], "states": {"/a": "active", "/b": "no answer"}}
    second = {
        **SEEN,
        "nodes": [["/a", "/"], ["/c", "/"]],
        "states": {"/a": "no answer", "/c": "inactive"},
        "endpoints": [],
    }
    both = live_run.merged(first, second)
    assert both["nodes"] == [["/a", "/"], ["/b", "/"], ["/c", "/"]]
    assert both["states"] == {"/a": "active", "/b": "no answer", "/c": "inactive"}
    assert both["endpoints"] == []


@pytest.mark.slow
@given(
    st.lists(st.tuples(st.text(), st.text()), max_size=4),
    st.lists(st.tuples(st.text(), st.text(), st.text(), st.sampled_from((None, 0.25, 1e6))), max_size=4),
)
def test_whatever_names_are_on_the_network_they_are_read_as_they_are(
    nodes: list[tuple[str, str]], ends: list[tuple[str, str, str, float | None]]
) -> None:
    qos = {"reliability": "best_effort", "durability": "volatile", "liveliness": "automatic", "lease": None}
    endpoints = [
        {"topic": topic, "role": "subscription", "node": node, "type": type_, "qos": {**qos, "deadline": deadline}}
        for topic, node, type_, deadline in ends
    ]
    text = graph_text({**SEEN, "nodes": nodes, "states": {}, "endpoints": endpoints}, [], "", False)
    observed = parse(Source("graph.yaml", text))
    assert observed.problems == ()
    assert [(node.name, node.enclave) for node in observed.nodes] == nodes
    read = [(end.topic, end.node, end.type, end.qos.deadline) for end in observed.endpoints]
    assert read == [(*names, INFINITE if deadline is None else deadline) for *names, deadline in ends]


@given(
    st.text() | st.from_regex(r"domain: [0-9]\n(nodes|endpoints|elsewhere):(\n- [a-z{}:,\[\] /]*)*\n", fullmatch=True)
)
def test_no_text_makes_the_reader_raise(text: str) -> None:
    parse(Source("graph.yaml", text))


@pytest.mark.parametrize("text", ["", "[]", "nodes: []\n", "domain: many\n", "domain: [\n"])
def test_another_file_is_no_graph(text: str, tmp_path: Path) -> None:
    (tmp_path / "graph.yaml").write_text(text)
    run = lint("live", "--load", "graph.yaml", cwd=tmp_path)
    assert run.code == 2
    assert run.stderr == "bringup-lint: graph.yaml: not a graph that bringup-lint live --save wrote\n"


def test_a_static_run_never_loads_the_rules() -> None:
    run = lint("--output-format", "json", ".", cwd=BAD)
    assert "live/" not in run.stdout


def test_only_the_rules_on_the_graph_run() -> None:
    run = lint("live", "--load", "graph.yaml", "--output-format", "sarif", ".", cwd=BAD)
    rules = json.loads(run.stdout)["runs"][0]["tool"]["driver"]["rules"]
    assert {rule["id"].partition("/")[0] for rule in rules} == {"live"}


def test_what_was_launched_is_taken_from_the_command_line(tmp_path: Path) -> None:
    for name in ("sea", "land"):
        node = f"Node(package='otter', executable='{name}', name='{name}')"
        (tmp_path / f"{name}.launch.py").write_text(LAUNCH.format(f"[{node}]"))
    (tmp_path / "graph.yaml").write_text("domain: 3\nnodes: []\n")
    options = ("--load", "graph.yaml", "--output-format", "concise", ".")
    silent = lint("live", *options, cwd=tmp_path)
    assert (silent.stdout, silent.code) == ("", 0)
    assert "name it with --launch" in silent.stderr
    run = lint("live", "--launch", "sea.launch.py", *options, cwd=tmp_path)
    assert "error[live/node-missing] /sea is not running on domain 3" in run.stdout
    unknown = lint("live", "--launch", "air.launch.py", *options, cwd=tmp_path)
    assert unknown.code == 2
    assert unknown.stderr == "bringup-lint: --launch 'air.launch.py': this is not one launch file of the tree\n"


def test_suppression_and_baseline_count(tmp_path: Path) -> None:
    node = "[\n        Node(package='otter', executable='sea', name='sea'),{}\n    ]"
    launch = tmp_path / "otter.launch.py"
    launch.write_text(LAUNCH.format(node.format("")))
    (tmp_path / "graph.yaml").write_text("domain: 3\nnodes:\n- {name: /other, enclave: /}\n")
    options = ("live", "--load", "graph.yaml", "--output-format", "concise")
    assert lint(*options, ".", cwd=tmp_path).stdout.count("\n") == 2
    assert lint(*options, "--write-baseline", "known.json", ".", cwd=tmp_path).code == 0
    assert lint(*options, "--baseline", "known.json", ".", cwd=tmp_path).stdout == ""
    launch.write_text(LAUNCH.format(node.format("  # bringup-lint: ignore[live/node-missing] -- in repair")))
    assert "node-missing" not in lint(*options, ".", cwd=tmp_path).stdout
    assert lint("--output-format", "concise", "--select", "lint", ".", cwd=tmp_path).stdout == ""


def test_rclpy_is_imported_by_one_module_only() -> None:
    code = {path.name: path.read_text("utf-8") for path in (PROJECT / "bringup_lint").rglob("*.py")}
    pattern = re.compile(r"^\s*(?:import|from) rclpy\b", re.MULTILINE)
    assert [name for name, text in code.items() if pattern.search(text)] == ["observe.py"]


def test_the_page_names_every_rule() -> None:
    page = (PROJECT / "docs/live.md").read_text("utf-8")
    rules = {rule_id for rule_id in Registry.of().paths if rule_id.startswith("live/")}
    assert set(re.findall(r"^\| `(live/[a-z-]+)` \|", page, re.MULTILINE)) == rules


def test_the_page_says_how_long_it_takes() -> None:
    page = (PROJECT / "docs/live.md").read_text("utf-8")
    (wait,) = [option.default for option in command.params if option.name == "wait"]
    assert f"`--wait` seconds ({wait:g}), up to {observe.LONGER:g} more" in page
    assert f"{observe.ANSWER:g} more\nat most" in page
    assert f"`{observe.NAME}`" in page
    assert f"for {live_run.AGAIN:g} times as long" in page


def test_a_graph_that_is_no_file_goes_with_the_sarif_report(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(live_run, "look", lambda domains, *_, **__: [{**SEEN, "domain": each} for each in domains])
    (tmp_path / "robot.env").write_text("ROS_DOMAIN_ID=42\nROS_SECURITY_ENABLE=true\n")
    run = lint("live", "--domain-id", "42", "--output-format", "sarif", ".", cwd=tmp_path)
    assert run.code == 1, run.stderr
    log = json.loads(run.stdout)
    (graph,) = [each for each in log["runs"][0]["artifacts"] if each.get("properties") == {"kind": "observed-graph"}]
    assert graph["contents"]["text"].startswith("# A running ROS graph")
