"""Ports of the host that two services of a compose project publish."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from bringup_lint.addresses import is_wildcard
from bringup_lint.graph.containers.questions.started_together import start_together
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.compose import Service
from bringup_lint.model.compose_ports import Published
from bringup_lint.model.compose_ports import published
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import ComposeFile

_DEFAULT = ("compose", "docker-compose")
_MOST = 200
"""Entries of one project that are compared."""


class Taken(NamedTuple):
    """A port of the host for which two containers ask."""

    first: Published
    owner: Service
    second: Published
    other: Service
    port: int


def taken_ports(files: Files, compose: Compose) -> Iterator[Taken]:
    """Each port once, for services that one ``docker compose up`` starts together."""
    seen = set()
    for file in compose.files:
        if not file.source.judged or file.source.template:
            continue
        entries = _entries(files, [file, *_overriding(compose, file)])[:_MOST]
        for (owner, first), (other, second) in combinations(entries, 2):
            port = _common(first, second)
            if port is not None and port not in seen and start_together(files, owner, other):
                seen.add(port)
                yield Taken(first, owner, second, other, port)


def _entries(files: Files, project: list[ComposeFile]) -> list[tuple[Service, Published]]:
    """What the services of a project publish, each with the file that says what it runs."""
    found: dict[tuple[object, ...], tuple[Service, Published]] = {}
    named: dict[str, Service] = {}
    without = {str(each.name) for file in project for each in file.services if not _publishes(files, each)}
    for service in (each for file in project for each in file.services):
        name = str(service.name)
        known = named.setdefault(name, service)
        if service.profiles and not known.profiles:
            known = named[name] = service
            found = {key: (service if key[0] == name else each[0], each[1]) for key, each in found.items()}
        if _is_replaced(service):
            found = {key: each for key, each in found.items() if key[0] != name}
        if name not in without:
            for each in published(service):
                if each.host:
                    found.setdefault((name, each.address, each.host, each.inside, each.protocol), (known, each))
    return list(found.values())


def _publishes(files: Files, service: Service) -> bool:
    """Whether it is a service of the robot with a network of its own, of which a container is started."""
    deploy = service.get("deploy")
    replicas = deploy.scalar("replicas") if isinstance(deploy, Mapping) else None
    is_off = service.scalar("scale") == "0" or (replicas is not None and replicas.value == "0")
    is_placed = isinstance(deploy, Mapping) and deploy.get("placement") is not None
    own = service.network_mode in (None, "bridge") and not is_off
    return own and not is_placed and files.purpose(service.name, str(service.name)) is Purpose.ROBOT


def _is_replaced(service: Service) -> bool:
    """Whether the ports of the file before are dropped."""
    node = service.body.get("ports")
    return isinstance(node, (Scalar, Sequence)) and node.tag in ("!override", "!reset")


def _overriding(compose: Compose, file: ComposeFile) -> list[ComposeFile]:
    """The file that docker compose reads together with this one by itself."""
    stem = posixpath.splitext(file.source.basename)[0]
    if stem not in _DEFAULT:
        return []
    return [
        each
        for each in compose.by_folder[os.path.dirname(file.source.name)]
        if posixpath.splitext(each.source.basename)[0] == f"{stem}.override" and not each.source.template
    ]


def _common(first: Published, second: Published) -> int | None:
    """The lowest port of the host that both ask for on one address."""
    alike = first.address == second.address or (
        (is_wildcard(first.address) or is_wildcard(second.address))
        and ("" in (first.address, second.address) or (":" in first.address) == (":" in second.address))
    )
    if first.protocol != second.protocol or not alike:
        return None
    port = max(first.host.start, second.host.start)
    return port if port < min(first.host.stop, second.host.stop) else None
