"""Questions about one file take work that grows as the file does: calls are counted, nothing is timed."""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest

from bringup_lint.discover.walk import discover_text
from bringup_lint.graph.dds.cyclonedds_names import first_named
from bringup_lint.graph.params.values import taken_back
from bringup_lint.model.params import matches
from bringup_lint.model.schema import Code
from bringup_lint.parsers.cyclonedds import parse as parse_cyclonedds
from bringup_lint.parsers.params import parse as parse_params
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.scenarios.test_growth import LOGARITHM
from tests.scenarios.test_growth import counted
from tests.scenarios.test_growth import excess

SIZES = (300, 900, 2700)


def blocks(count: int) -> Callable[[], object]:
    """Nodes, and as many patterns, each of which means one of them."""
    nodes = "".join(f"/n{n}:\n  ros__parameters:\n    a: {n}\n" for n in range(count))
    patterns = "".join(f"/**/n{n}:\n  ros__parameters:\n    a: -1\n" for n in range(count))
    file = parse_params(Source("a.yaml", nodes + patterns))
    assert file.accepted
    return lambda: list(taken_back(file))


def repeated(count: int) -> Callable[[], object]:
    """A setting that is given again and again, after many others."""
    peers = '<Peer Address="10.0.0.1"/>' * count
    values = "<MaxMessageSize>64kB</MaxMessageSize>" * count
    groups = f"<Discovery><Peers>{peers}</Peers></Discovery><General>{values}</General>"
    text = f"<CycloneDDS><Domain>{groups}</Domain></CycloneDDS>"
    configuration = parse_cyclonedds(Source("cyclonedds.xml", text, "dds-profile"), "0.10")
    remarks = [each for each in configuration.all_remarks if each.code == Code.DUPLICATE]
    assert len(remarks) >= count - 1
    return lambda: [first_named(configuration, each) for each in remarks]


def asking(count: int) -> Callable[[], object]:
    """Installations that nobody answers, of packages that each have another name."""
    text = "FROM ros:jazzy-ros-base\n" + "".join(f"RUN apt-get install ros-jazzy-p{n}\n" for n in range(count))
    robot = Robot(discover_text("Dockerfile", text.encode()))
    apt_asks = Registry.of()["script/apt-asks"]
    assert list(apt_asks.check(Robot(discover_text("Dockerfile", text.encode()))))
    return lambda: list(apt_asks.check(robot))


def lines_of(work: Callable[[], object]) -> int:
    """How many lines run: a loop in one function makes no calls."""
    count = 0

    def note(frame: object, event: str, argument: object) -> object:
        nonlocal count
        count += event == "line"
        return note

    sys.settrace(note)
    try:
        work()
    finally:
        sys.settrace(None)
    return count


@pytest.mark.slow
@pytest.mark.parametrize("shape", [blocks, repeated, asking])
def test_work_grows_as_the_file_does(shape: Callable[[int], Callable[[], object]]) -> None:
    lines = [lines_of(shape(size)) for size in SIZES]
    assert excess(*lines) <= LOGARITHM
    calls = [sum(counted(shape(size)).values()) for size in SIZES]
    assert excess(*calls) <= LOGARITHM


def test_a_value_is_taken_back_by_the_last_pattern() -> None:
    text = "/n:\n  ros__parameters:\n    a: 1\n    b: 1\n" + "".join(
        f"{key}:\n  ros__parameters:\n    a: {value}\n" for key, value in (("/*", 2), ("/**", 3))
    )
    pairs = list(taken_back(parse_params(Source("a.yaml", text))))
    assert [(str(lost.text), str(wins.text)) for lost, wins in pairs] == [("1", "3")]


@pytest.mark.parametrize(
    ("key", "name", "meant"),
    [
        ("/**", "/a/b", True),
        ("/**/b", "/a/b", True),
        ("/**/b", "/b", True),
        ("/a/**/c", "/a/b/b/c", True),
        ("/a/**/c", "/b/b/c", False),
        ("/*/**", "/a", True),
        ("/*/*/**", "/a", False),
        ("/x/**", "/a/b", False),
        ("/**/**/a", "/a/a/a", True),
    ],
)
def test_patterns_of_nodes(key: str, name: str, meant: bool) -> None:
    assert matches(key, name) is meant
