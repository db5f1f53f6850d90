"""Services that wait for the health of others, and whether anything checks it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.base_images import has_no_healthcheck
from bringup_lint.model.compose import Service
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose


class Unchecked(NamedTuple):
    """A service that waits for another one whose health nothing checks."""

    waiting: Service
    needed: Service
    condition: Located


def unchecked_health(compose: Compose) -> Iterator[Unchecked]:
    """What waits with ``service_healthy`` in vain."""
    checked = {(_folder(service), str(service.name)) for service in compose.services if _checks(service)}
    for file in compose.files:
        if not file.source.judged or file.source.template or not file.yaml.complete:
            continue
        named = {str(service.name): service for service in file.services}
        for service in file.services:
            for name, condition in _waits(service):
                needed = named.get(str(name))
                if needed is not None and _has_none(compose, needed, checked):
                    yield Unchecked(service, needed, condition)


def _waits(service: Service) -> Iterator[tuple[Located, Located]]:
    """The services that have to be healthy, each with the word that says so."""
    node = service.get("depends_on")
    if not isinstance(node, Mapping):
        return
    for name, settings in node.merged:
        condition = settings.scalar("condition") if isinstance(settings, Mapping) else None
        required = settings.scalar("required") if isinstance(settings, Mapping) else None
        if required is not None and required.boolean is False:
            continue
        if condition is not None and condition.value == "service_healthy":
            yield name.value, condition.value


def _folder(service: Service) -> str:
    """Files that are given together lie in one folder."""
    return os.path.dirname(service.source.name)


def _checks(service: Service) -> bool:
    check = service.get("healthcheck")
    disabled = check.scalar("disable") if isinstance(check, Mapping) else None
    return check is not None and (disabled is None or disabled.boolean is not True)


def _has_none(compose: Compose, service: Service, checked: set[tuple[str, str]]) -> bool:
    """Whether neither the service, another file that may be given with it, nor its image has a check."""
    if service.get("extends") is not None or (_folder(service), str(service.name)) in checked:
        return False
    if service.get("healthcheck") is not None:
        return True
    stage = compose.stage(service)
    if stage is None:
        return service.build is None and service.image is not None and has_no_healthcheck(service.image)
    return not _has_check(stage) and not compose.images.is_chosen(stage, tag=False)


def _has_check(stage: Stage) -> bool:
    """Whether an image may have a check: its own, or one that a base gives to what is built on it."""
    later = (str(each.value).upper() for link in stage.chain for each in link.all("ONBUILD"))
    own = stage.last("HEALTHCHECK") is not None or any(each.startswith("HEALTHCHECK") for each in later)
    return own or not has_no_healthcheck(stage.origin)
