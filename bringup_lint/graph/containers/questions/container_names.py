"""Names of containers that two services of a compose file have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.questions.started_together import start_together
from bringup_lint.model.compose import is_variable
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Located

_MOST = 100
"""Services of one name that are compared with another one."""


class SharedName(NamedTuple):
    """The name that a second service gives to its container as well."""

    name: Located
    first: Located
    owner: Service
    other: Service


def shared_names(files: Files, compose: Compose) -> Iterator[SharedName]:
    """The names of containers that ``docker compose up`` is to start twice, each service of a file that has
    the name of an earlier one once."""
    renamed = _renamed(compose)
    for file in compose.files:
        if not file.source.judged or file.source.template:
            continue
        named = [(each, each.scalar("container_name")) for each in file.services]
        known = [(each, name) for each, name in named if name is not None and not is_variable(name)]
        by_name: dict[str, list[tuple[Service, Located]]] = {}
        for other, name in known:
            if not name or str(other.name) in renamed:
                continue
            before = by_name.setdefault(str(name), [])
            found = next((each for each in before if start_together(files, each[0], other)), None)
            if found is not None:
                yield SharedName(name, found[1], found[0], other)
            if len(before) < _MOST:
                before.append((other, name))


def _renamed(compose: Compose) -> set[str]:
    """The services to whose containers a file that changes them gives a name."""
    changed = (each for each in compose.services if not each.is_whole)
    return {str(each.name) for each in changed if each.get("container_name") is not None}
