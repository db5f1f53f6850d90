"""Dataclasses whose methods are made late are as Python's own."""

from __future__ import annotations

import dataclasses
import re
from dataclasses import FrozenInstanceError
from functools import cached_property

import pytest

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from tests.architecture.imports import paths


@dataclass(frozen=True)
class Interface:
    name: str
    addresses: tuple[str, ...] = ()

    @cached_property
    def length(self) -> int:
        return len(self.name)


@dataclass(eq=False, slots=True)
class Node:
    name: str
    topics: list[str] = field(default_factory=list)
    count: int = 1


@dataclass(eq=False, slots=True, kw_only=True)
class Composable(Node):
    plugin: str


@dataclass
class Note:
    text: str
    seen: int | None = field(default=None, init=False)


@dataclass
class Bridge:
    members: list[str] = field(default_factory=list)


def test_objects_are_as_those_of_dataclasses() -> None:
    one, other = Interface("eth0", ("10.0.0.1",)), Interface("eth0", addresses=("10.0.0.1",))
    assert one == other and hash(one) == hash(other)
    assert repr(one) == "Interface(name='eth0', addresses=('10.0.0.1',))"
    assert one.length == 4
    assert dataclasses.replace(one, name="eth1") == Interface("eth1", ("10.0.0.1",))
    with pytest.raises(FrozenInstanceError):
        one.name = "eth1"  # type: ignore[misc]


def test_python_knows_the_fields() -> None:
    one = Node("camera", count=2)
    assert dataclasses.asdict(one) == {"name": "camera", "topics": [], "count": 2}
    assert [each.name for each in dataclasses.fields(Composable)] == ["name", "topics", "count", "plugin"]
    assert replace(one, name="lidar").name == dataclasses.replace(one, name="lidar").name == "lidar"
    match one:
        case Node(name, _, count):
            assert (name, count) == ("camera", 2)


def test_values_that_are_not_given() -> None:
    note = Note("seen")
    assert (note.text, note.seen, Note.seen) == ("seen", None, None)
    with pytest.raises(TypeError):
        Note("seen", seen=1)  # type: ignore[call-arg]


def test_slots_and_inheritance() -> None:
    node = Composable(name="camera", plugin="rover::Camera")
    assert (node.name, node.topics, node.count, node.plugin) == ("camera", [], 1, "rover::Camera")
    assert not hasattr(node, "__dict__")
    assert node != Composable(name="camera", plugin="rover::Camera")
    assert Node("a").topics is not Node("b").topics
    with pytest.raises(TypeError):
        Node()  # type: ignore[call-arg]


def test_equality_without_a_hash() -> None:
    assert Bridge(["eth0"]) == Bridge(["eth0"])
    with pytest.raises(TypeError):
        hash(Bridge())


def test_the_package_has_no_other_dataclasses() -> None:
    for path in paths():
        text = path.read_text("utf-8")
        if path.name != "dataclass.py":
            assert not re.search(r"from dataclasses import (?:dataclass|field|replace)\n", text), path


def test_post_init_follows_the_values() -> None:
    @dataclass(frozen=True)
    class Topic:
        name: str

        def __post_init__(self) -> None:
            object.__setattr__(self, "name", self.name.lstrip("/"))

    assert Topic("/scan").name == "scan"
    assert replace(Topic("scan"), name="//odom").name == "odom"
