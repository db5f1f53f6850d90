"""Names of containers that two services of a compose file have."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.questions.ports import start_together
from bringup_lint.model.compose import is_variable
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Located


class SharedName(NamedTuple):
    """The name that a second service gives to its container as well."""

    name: Located
    first: Located
    owner: Service
    other: Service


def shared_names(files: Files, compose: Compose) -> Iterator[SharedName]:
    """The names of containers that ``docker compose up`` is to start twice, each pair of services of one file once."""
    for file in compose.files:
        named = [(each, each.scalar("container_name")) for each in file.services]
        known = [(each, name) for each, name in named if name is not None and not is_variable(name)]
        if not file.source.judged or file.source.template:
            continue
        for (owner, first), (other, name) in combinations(known, 2):
            is_kept = name == first and not any(_is_renamed(compose, each) for each in (owner, other))
            if name and is_kept and start_together(files, owner, other):
                yield SharedName(name, first, owner, other)


def _is_renamed(compose: Compose, service: Service) -> bool:
    """Whether a file that changes the service gives its container another name."""
    others = (each for each in compose.services_called(service.name) if not each.is_whole)
    return any(each.get("container_name") is not None for each in others)
