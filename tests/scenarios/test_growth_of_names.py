"""Rules that look at the names beside a misspelt one take work that grows as their file does: lines that run are
counted, nothing is timed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from bringup_lint.discover.walk import discover_text
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from tests.scenarios.test_growth import LOGARITHM
from tests.scenarios.test_growth import excess
from tests.scenarios.test_growth_of_questions import lines_of

SIZES = (200, 600, 1800)
NETPLAN = "network:\n  version: 2\n  ethernets:\n"
MULTICAST = "<AllowMultcast>true</AllowMultcast>"
TYPE, NAMES, IDS = 'type="b" ', 'nam#="b" ', 'i#="1" '
PARTICIPANT = '<participant profile_name="a"><rtps><nam>x</nam></rtps></participant>'


def numbered(text: str, count: int) -> str:
    """The text so many times, each with its number in place of the sign."""
    return "".join(text.replace("#", str(number)) for number in range(count))


def launch(inner: str) -> str:
    return f"<launch>{inner}</launch>"


def cyclonedds(inner: str) -> str:
    return f"<CycloneDDS>{inner}</CycloneDDS>"


def general(inner: str) -> str:
    return cyclonedds(f"<Domain><General>{inner}</General></Domain>")


def fastdds(inner: str) -> str:
    return f"<dds><profiles>{inner}</profiles></dds>"


SHAPES: list[tuple[str, str, Callable[[int], str]]] = [
    ("launch/ros1-construct", "a.launch.xml", lambda n: launch('<node pkg="a" type="b" name="c"/>' * n)),
    ("launch/ros1-construct", "a.launch.xml", lambda n: launch(f"<node {TYPE * n}/>")),
    ("launch/unknown-attribute", "a.launch.xml", lambda n: launch(f"<node {numbered(NAMES, n)}/>")),
    ("netplan/unknown-key", "netplan/a.yaml", lambda n: NETPLAN + "    a:\n" + numbered("      dhcp#x: true\n", n)),
    ("netplan/unknown-key", "netplan/a.yaml", lambda n: NETPLAN + numbered("    e#:\n      dchp4: true\n", n)),
    ("cyclonedds/unknown-element", "cyclonedds.xml", lambda n: general(MULTICAST * n)),
    ("cyclonedds/unknown-element", "cyclonedds.xml", lambda n: general(numbered("<AllowMultcast#/>", n))),
    ("cyclonedds/unknown-element", "cyclonedds.xml", lambda n: cyclonedds(f"<Domain>{MULTICAST}</Domain>" * n)),
    ("cyclonedds/unknown-attribute", "cyclonedds.xml", lambda n: cyclonedds(f"<Domain {numbered(IDS, n)}/>")),
    ("cyclonedds/abbreviated-name", "cyclonedds.xml", lambda n: general("<AllowMulti>true</AllowMulti>" * n)),
    ("fastdds/unknown-element", "fastdds.xml", lambda n: fastdds(PARTICIPANT * n)),
    (
        "fastdds/unknown-element",
        "fastdds.xml",
        lambda n: fastdds(f"<participant>{numbered('<nam#/>', n)}</participant>"),
    ),
]
"""A rule, and a file that gives it so many names."""


def work(rule_id: str, name: str, text: str) -> Callable[[], object]:
    rule = Registry.of()[rule_id]
    assert list(rule.check(Robot(discover_text(name, text.encode()))))
    robot = Robot(discover_text(name, text.encode()))
    return lambda: list(rule.check(robot))


@pytest.mark.slow
@pytest.mark.parametrize("number", range(len(SHAPES)), ids=[rule_id for rule_id, _, _ in SHAPES])
def test_work_grows_as_the_names_do(number: int) -> None:
    rule_id, name, text = SHAPES[number]
    assert excess(*[lines_of(work(rule_id, name, text(size))) for size in SIZES]) <= LOGARITHM
