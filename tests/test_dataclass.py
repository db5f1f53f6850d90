"""Dataclasses whose methods are made late are as Python's own."""

from __future__ import annotations

import dataclasses
from dataclasses import FrozenInstanceError
from dataclasses import field
from functools import cached_property

import pytest

from bringup_lint.dataclass import dataclass
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
            assert "from dataclasses import dataclass\n" not in text, path
