"""Addresses, ports and hosts."""

from __future__ import annotations

import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint import addresses

WRITTEN = st.text("0123456789abf.:%", max_size=20) | st.ip_addresses().map(str)


@given(WRITTEN)
def test_a_plain_address_is_what_the_c_library_takes(text: str) -> None:
    for family, number in ((socket.AF_INET, 4), (socket.AF_INET6, 6)):
        assert addresses.is_plain_address(text, number) == _is_taken(family, text)


def _is_taken(family: int, text: str) -> bool:
    try:
        socket.inet_pton(family, text)
    except (OSError, ValueError):
        return False
    return True


@pytest.mark.parametrize("text", ["127.0.0.1", "127.3.0.9", "localhost", "LOCALHOST", "::1", "[::1]"])
def test_this_computer(text: str) -> None:
    assert addresses.is_loopback(text)
    assert not addresses.is_wildcard(text)
    assert not addresses.is_elsewhere(text)


@pytest.mark.parametrize("text", ["0.0.0.0", "::", "[::]", "*", ""])
def test_all_interfaces(text: str) -> None:
    assert addresses.is_wildcard(text)
    assert not addresses.is_loopback(text)
    assert not addresses.is_elsewhere(text)


@pytest.mark.parametrize(
    ("text", "elsewhere"), [("10.0.0.2", True), ("fd00::2", True), ("239.255.0.1", False), ("base", False)]
)
def test_another_computer(text: str, elsewhere: bool) -> None:
    assert addresses.is_elsewhere(text) is elsewhere


@pytest.mark.parametrize(
    ("text", "host", "port"),
    [
        ("base", "base", None),
        ("base:7400", "base", "7400"),
        ("10.0.0.2:", "10.0.0.2", ""),
        ("[fd00::2]:7400", "[fd00::2]", "7400"),
        ("fd00::2", "fd00::2", None),
    ],
)
def test_a_host_and_its_port(text: str, host: str, port: str | None) -> None:
    assert addresses.split_port(text) == (host, port)


def test_ports() -> None:
    assert [text for text in ("0", "1", "65535", "65536", "-1", "", "x", "9" * 30) if addresses.is_port(text)] == [
        "1",
        "65535",
    ]


def test_four_numbers_with_dots() -> None:
    assert addresses.quad("10.0.0.300") == (10, 0, 0, 300)
    assert addresses.quad("10.0.0") is None


def test_prefixes() -> None:
    assert [addresses.is_prefix_length("33", family) for family in (4, 6)] == [False, True]
    assert addresses.parse_interface("10.0.0.1") is None
    assert str(addresses.parse_network("10.0.0.1/24")) == "10.0.0.0/24"
