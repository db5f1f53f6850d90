"""What udev rules match: patterns, jumps, disjoint rules, shadowing, links."""

from __future__ import annotations

from fnmatch import fnmatchcase

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.udev.overlap import may_both_fire
from bringup_lint.graph.udev.patterns import matches
from bringup_lint.graph.udev.patterns import may_overlap
from bringup_lint.graph.udev.udev import Udev
from bringup_lint.graph.udev.udev import effective
from bringup_lint.parsers.udev import parse
from bringup_lint.source import Source


def udev(*files: tuple[str, str]) -> Udev:
    return effective(
        parse(Source(path.lstrip("/"), text, robot_path=path if path.startswith("/") else None)) for path, text in files
    )


def rules(text: str):
    return udev(("99-robot.rules", text)).rules


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        ("ttyUSB*", "ttyACM*", False),
        ("ttyUSB*", "tty*", True),
        ("1-1.2*", "1-1.2:1.0", True),
        ("1-1.2", "1-1.2:1.0", False),
        ("*a", "*b", False),
        ("a*c", "ab*", True),
        ("000[13]", "0003", True),
        ("000[13]", "0002", False),
        ("[!0-9]*", "5", False),
        ("?*", "", False),
    ],
)
def test_overlap_of_patterns(one: str, other: str, expected: bool) -> None:
    assert may_overlap(one, other) is expected
    assert may_overlap(other, one) is expected


@given(st.text("ab*?[]!", max_size=6), st.text("ab*?[]!", max_size=6), st.text("ab", max_size=4))
def test_patterns_that_match_one_text_overlap(one: str, other: str, text: str) -> None:
    if matches(one, text) and matches(other, text):
        assert may_overlap(one, other)


@given(st.text("ab*?", max_size=6), st.text("ab", max_size=5))
def test_matching_is_that_of_fnmatch(pattern: str, text: str) -> None:
    assert matches(pattern, text) is fnmatchcase(text, pattern)


def test_a_guard_tells_the_subsystem_of_the_rules_behind_it() -> None:
    guarded, behind = rules(
        'SUBSYSTEM!="tty", GOTO="end"\nATTRS{serial}=="A1", SYMLINK+="robot/imu"\nLABEL="end"\nSYMLINK+="x"\n'
    )[1::2]
    assert guarded.subsystems == {"tty"}
    assert guarded.actions[0] == "add"
    assert not behind.subsystems


def test_a_jump_into_the_guarded_lines_takes_its_knowledge_away() -> None:
    inner, after = rules(
        'KERNEL=="x", GOTO="middle"\nSUBSYSTEM!="tty", GOTO="end"\nSYMLINK+="a"\n'
        'LABEL="middle"\nSYMLINK+="b"\nLABEL="end"\n'
    )[2:5:2]
    assert inner.subsystems == {"tty"}
    assert not after.subsystems


def test_lines_that_only_one_jump_leads_to_have_its_conditions() -> None:
    text = 'SUBSYSTEM=="tty", GOTO="tty"\n{}LABEL="tty"\nSYMLINK+="robot/imu"\nLABEL="end"\n'
    assert rules(text.format('GOTO="end"\n'))[3].subsystems == {"tty"}
    assert not rules(text.format('KERNEL=="x", GOTO="end"\n'))[3].subsystems


def test_rules_behind_an_unconditional_jump_are_unreachable() -> None:
    assert [rule.is_unreachable for rule in rules('GOTO="end"\nSYMLINK+="a"\nLABEL="end"\n')] == [
        False,
        True,
        False,
    ]


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        ('ATTRS{serial}=="A"', 'ATTRS{serial}=="B"', False),
        ('ATTRS{serial}=="A"', 'KERNELS=="1-1.2"', True),
        ('ATTRS{idVendor}=="0403"', 'ENV{ID_VENDOR_ID}=="10c4"', False),
        ('SUBSYSTEM=="tty"', 'KERNEL=="video*"', False),
        ('ATTR{index}=="0"', 'ATTR{index}!="0"', False),
        ('ACTION=="add"', 'ACTION!="remove"', True),
        ('ATTRS{idProduct}=="60??"', 'ATTRS{idProduct}=="6014"', True),
    ],
)
def test_disjoint_rules(one: str, other: str, expected: bool) -> None:
    left, right = rules(f'{one}, SYMLINK+="x"\n{other}, SYMLINK+="x"\n')
    assert may_both_fire(left, right) is expected


def test_a_rule_that_was_jumped_over_does_not_fire_too() -> None:
    first, second, _ = rules(
        'ATTRS{serial}=="A", SYMLINK+="x", GOTO="end"\nATTRS{idVendor}=="0403", SYMLINK+="x"\nLABEL="end"\n'
    )
    assert not may_both_fire(first, second)


def test_files_are_sorted_by_name_and_the_higher_directory_wins() -> None:
    found = udev(
        ("/usr/lib/udev/rules.d/60-serial.rules", 'SYMLINK+="vendor"\n'),
        ("/etc/udev/rules.d/99-robot.rules", 'SYMLINK+="robot"\n'),
        ("/etc/udev/rules.d/60-serial.rules", 'SYMLINK+="own"\n'),
        ("/usr/lib/udev/rules.d/70-late.rules", 'SYMLINK+="late"\n'),
    )
    assert [link.path for link in found.links] == ["/dev/own", "/dev/late", "/dev/robot"]
    assert [(file.source.name, by.source.name) for file, by in found.sets[0].shadowed] == [
        ("usr/lib/udev/rules.d/60-serial.rules", "etc/udev/rules.d/60-serial.rules")
    ]


def test_links() -> None:
    (rule,) = rules(
        'SUBSYSTEM=="tty", ATTRS{idVendor}=="10C4", SYMLINK+="robot/lidar /dev/rplidar by/$attr{serial}-%%"\n'
    )
    assert [link.path for link in rule.links] == ["/dev/robot/lidar", "/dev/rplidar", "/dev/by/*-%"]
    assert [link.is_fixed for link in rule.links] == [True, True, False]


def test_stable_names_for_a_kernel_path() -> None:
    found = udev(
        (
            "99-robot.rules",
            'KERNEL=="ttyACM*", SYMLINK+="robot/base"\nSUBSYSTEM=="tty", SYMLINK+="robot/imu"\n',
        ),
    )
    assert [link.path for link in found.stable_names("/dev/ttyUSB0")] == ["/dev/robot/imu"]
    assert [link.path for link in found.links_to("/dev/robot/base")] == ["/dev/robot/base"]
    assert found.stable_names("/dev/video0") == []


@pytest.mark.parametrize(
    ("match", "wanted", "expected"),
    [
        ('SUBSYSTEM=="tty"', ("tty",), True),
        ('SUBSYSTEM=="tty"', ("tty", "video4linux"), True),
        ('SUBSYSTEM=="tty|usb"', ("tty",), False),
        ('SUBSYSTEM=="tty|usb"', ("tty", "usb"), True),
        ('SUBSYSTEM=="usb"', ("tty",), False),
        ('ATTRS{idVendor}=="0403"', ("tty",), False),
    ],
)
def test_a_rule_is_for_subsystems_when_it_fires_for_no_other(
    match: str, wanted: tuple[str, ...], expected: bool
) -> None:
    (rule,) = rules(f'{match}, SYMLINK+="sensor"\n')
    assert rule.is_for(*wanted) is expected
