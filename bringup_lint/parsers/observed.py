"""The running ROS graph as text: what ``bringup-lint live`` writes about what it saw, and reads again."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.node_source import INFINITE
from bringup_lint.model.node_source import Qos
from bringup_lint.model.observed import Endpoint
from bringup_lint.model.observed import ObservedGraph
from bringup_lint.model.observed import RunningNode
from bringup_lint.model.observed import RunningParameter
from bringup_lint.model.observed import RunningUnit
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers import yaml_nodes
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

KIND = "observed-graph"


def parse(source: Source) -> ObservedGraph:
    """Read a graph. Problems: those of YAML, and ``not-a-graph``."""
    file = yaml_nodes.parse(source)
    root = file.root
    domain = _integer(root, "domain") if isinstance(root, Mapping) else None
    if not isinstance(root, Mapping) or domain is None:
        return ObservedGraph(source, 0, problems=(*file.problems, Problem("not-a-graph", source.whole)))
    return ObservedGraph(
        source,
        domain,
        str(_text(root, "domain_from") or ""),
        str(_text(root, "rmw") or ""),
        _text(root, "secured") == "true",
        tuple(_nodes(root)),
        tuple(_endpoints(root)),
        tuple(_elsewhere(root)),
        tuple(file.problems),
        tuple(_units(root)),
        tuple(_parameters(root)),
    )


def _parameters(root: Mapping) -> Iterator[RunningParameter]:
    for item in _items(root, "parameters"):
        values = _values(item)
        if values.keys() >= {"node", "name", "value"}:
            yield RunningParameter(values["node"], values["name"], values["value"])


def _units(root: Mapping) -> Iterator[RunningUnit]:
    for item in _items(root, "units"):
        values = _values(item)
        if "unit" in values:
            told = (values.get(key) for key in ("load", "active", "result", "reload", "fragment"))
            yield RunningUnit(values["unit"], *told)


def _text(mapping: Mapping, key: str) -> Located | None:
    scalar = mapping.scalar(key)
    return scalar.value if scalar is not None and not scalar.is_null else None


def _integer(mapping: Mapping, key: str) -> int | None:
    scalar = mapping.scalar(key)
    return scalar.integer if scalar is not None else None


def _items(mapping: Mapping, key: str) -> Iterator[Mapping]:
    for item in mapping.sequence(key) or ():
        if isinstance(item, Mapping):
            yield item


def _values(item: Mapping) -> dict[str, Located]:
    found = ((str(key.value), value) for key, value in item.entries)
    return {key: value.value for key, value in found if isinstance(value, Scalar) and not value.is_null}


def _nodes(mapping: Mapping) -> Iterator[RunningNode]:
    for item in _items(mapping, "nodes"):
        values = _values(item)
        if "name" in values:
            yield RunningNode(values["name"], values.get("enclave"), values.get("state"))


def _endpoints(root: Mapping) -> Iterator[Endpoint]:
    for item in _items(root, "endpoints"):
        values = _values(item)
        node = values.get("publisher") or values.get("subscription")
        if node is not None and "topic" in values and "type" in values:
            yield Endpoint(
                values["topic"], node, bool(values.get("publisher")), values["type"], _qos(item.span, values)
            )


def _qos(where: Span, values: dict[str, Located]) -> Qos:
    """What is not written is the default: no deadline, automatic liveliness, no lease."""
    return Qos(
        where,
        _upper(values.get("reliability")),
        _upper(values.get("durability")),
        deadline=_seconds(values.get("deadline")),
        liveliness=_upper(values.get("liveliness")) or "AUTOMATIC",
        lease=_seconds(values.get("lease")),
    )


def _upper(text: Located | None) -> str | None:
    return text.upper() if text else None


def _seconds(text: Located | None) -> float:
    try:
        return float(text or INFINITE)
    except ValueError:
        return INFINITE


def _elsewhere(root: Mapping) -> Iterator[tuple[int, tuple[RunningNode, ...]]]:
    for item in _items(root, "elsewhere"):
        domain = _integer(item, "domain")
        if domain is not None:
            yield domain, tuple(_nodes(item))
