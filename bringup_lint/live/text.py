"""What was seen, as text that people read and ``parsers.observed`` reads again: YAML, one node or endpoint a line."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import Any

from bringup_lint.pattern import regex

_PLAIN = regex(r"[A-Za-z/_][A-Za-z0-9/_]*")
_WORDS = frozenset("y n yes no on off true false null".split())
_SHORT = {"liveliness": "automatic"}
"""Policies that are left out where they are like this."""


def graph_text(
    seen: dict[str, Any],
    elsewhere: Iterable[dict[str, Any]],
    domain_from: str,
    secured: bool,
    units: Iterable[dict[str, str]] = (),
) -> str:
    """``seen`` and each of ``elsewhere`` is what ``observe`` prints about a domain, ``units`` what systemd says."""
    return "\n".join([*_lines(seen, elsewhere, domain_from, secured), *_units(units)]) + "\n"


def _units(units: Iterable[dict[str, str]]) -> Iterator[str]:
    for number, unit in enumerate(units):
        if not number:
            yield "units:"
        yield f"- {_flow(unit)}"


def _lines(seen: dict[str, Any], elsewhere: Iterable[dict[str, Any]], domain_from: str, secured: bool) -> Iterator[str]:
    yield "# A running ROS graph, as bringup-lint live saw it."
    yield f"domain: {seen['domain']}"
    if domain_from:
        yield f"domain_from: {_scalar(domain_from)}"
    yield f"rmw: {_scalar(seen['rmw'])}"
    yield f"secured: {str(secured).lower()}"
    yield f"nodes:{'' if seen['nodes'] else ' []'}"
    yield from (f"- {_node(name, enclave, seen['states'])}" for name, enclave in seen["nodes"])
    parameters = seen.get("parameters")
    if parameters:
        yield "parameters:"
        yield from (f"- {_flow({'node': node, 'name': name, 'value': value})}" for node, name, value in parameters)
    yield f"endpoints:{'' if seen['endpoints'] else ' []'}"
    yield from (f"- {_endpoint(each)}" for each in seen["endpoints"])
    others = list(elsewhere)
    if others:
        yield "elsewhere:"
    for other in others:
        yield f"- domain: {other['domain']}"
        yield f"  nodes:{'' if other['nodes'] else ' []'}"
        yield from (f"  - {_node(name, enclave, {})}" for name, enclave in other["nodes"])


def _node(name: str, enclave: str, states: dict[str, str]) -> str:
    return _flow({"name": name, "enclave": enclave, "state": states.get(name)})


def _endpoint(each: dict[str, Any]) -> str:
    qos = {key: value for key, value in each["qos"].items() if value != _SHORT.get(key)}
    return _flow({"topic": each["topic"], each["role"]: each["node"], "type": each["type"], **qos})


def _flow(values: dict[str, Any]) -> str:
    return "{" + ", ".join(f"{key}: {_scalar(value)}" for key, value in values.items() if value is not None) + "}"


def _scalar(value: Any) -> str:
    """Names on the network may be anything; what is not a plain name is quoted."""
    if isinstance(value, str):
        plain = _PLAIN.fullmatch(value) and value.lower() not in _WORDS
        return value if plain else '"' + "".join(map(_escaped, value)) + '"'
    return f"{value:g}"


def _escaped(char: str) -> str:
    code = ord(char)
    if 0xD800 <= code < 0xE000:
        return "\\uFFFD"
    return char if " " <= char <= "~" and char not in '"\\' else f"\\U{code:08X}"
