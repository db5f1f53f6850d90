"""Compose services as nodes: what they run, what they read, what they wait for, and which units start them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.systemd import own_units
from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.model.compose import Service
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.systemd.units import Units

_NAMES = ("compose.yaml", "compose.yml", "docker-compose.yaml", "docker-compose.yml")


def service_node(service: Service) -> Node:
    return Node("compose-service", str(service.name), service.source.name)


def compose_edges(tree: Tree, compose: Compose, runners: Runners) -> Iterator[Edge]:
    """``runs``, ``loads-env``, ``requires`` and ``orders`` of the services."""
    named: dict[Source, dict[str, Service]] = {}
    for service in (each for file in compose.files for each in file.services):
        named.setdefault(service.source, {})[service.name] = service
    for service in _services(compose):
        here = service_node(service)
        names = named.get(service.source, {})
        for needed in _needed(service):
            if needed in names:
                yield Edge("requires", here, service_node(names[needed]), needed.span, "depends_on:")
                yield Edge("orders", service_node(names[needed]), here, needed.span, "depends_on:")
        for path in service.env_files:
            found = tree.beside(service.source, path)
            if found is not None:
                yield Edge("loads-env", here, file_node("env-file", found), path.span, "env_file:")
            elif path.startswith("/") and is_plain(path):
                yield Edge("loads-env", here, Node("env-file", str(path)), path.span, "env_file:")
    for command in runners.launches:
        if command.runner.service is not None and command.file is not None:
            target = file_node("launch-file", command.file.source)
            yield Edge("runs", service_node(command.runner.service), target, command.target.span, "command:")


def compose_places(compose: Compose) -> Iterator[tuple[Node, Span]]:
    for service in _services(compose):
        start = service.name.span
        yield service_node(service), start._replace(end=max(service.body.span.end, start.end))
        stage = compose.stage(service)
        if stage is not None:
            yield service_node(service), file_place(stage.start.keyword.span.source)
        for found in compose.env_files(service):
            yield file_node("env-file", found), file_place(found)


def starting_units(tree: Tree, compose: Compose, units: Units) -> Iterator[Edge]:
    """``runs`` from units that start the services of a compose file of the tree."""
    for unit, node in own_units(units):
        for process in units.processes(unit):
            if process.key not in ("ExecStart", "ExecStartPre"):
                continue
            for step in process.steps:
                source = _composed(tree, step.command.words, unit.get("WorkingDirectory"))
                if source is None:
                    continue
                for service in _services(compose):
                    if service.source is source:
                        where = process.line.span if step.script is None else step.command.words[0].span
                        yield Edge("runs", node, service_node(service), where, f"{process.key}=")


def _composed(tree: Tree, words: tuple[Located, ...], folder: Located | None) -> Source | None:
    """The compose file of ``docker compose -f FILE up``."""
    names = [word.rpartition("/")[2] for word in words]
    if "up" not in names or not {"docker-compose", "compose"} & set(names):
        return None
    for option, following in pairwise(words):
        if option in ("-f", "--file"):
            return tree.find(following) if following.startswith("/") and is_plain(following) else None
    if not folder or not is_plain(folder):
        return None
    found = (tree.find(f"{folder}/{name}") for name in _NAMES)
    return next((source for source in found if source is not None), None)


def _services(compose: Compose) -> list[Service]:
    return [service for service in compose.services if service.source.judged]


def _needed(service: Service) -> Iterator[Located]:
    node = service.get("depends_on")
    if isinstance(node, Sequence):
        yield from (scalar.value for scalar in node.scalars)
    elif isinstance(node, Mapping):
        yield from (key.value for key, _ in node.entries)
