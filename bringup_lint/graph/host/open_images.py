"""Images of servers that ask for no password as they are published, and the services that leave them so."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint import facts
from bringup_lint.addresses import is_loopback
from bringup_lint.model.compose_ports import published
from bringup_lint.model.image_build import image_name
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Span

_LONGEST = 4096
"""Characters of a word that are looked at."""
_LOGIN = regex(r"^[ \t]*[\"']?adminAuth\b", re.M)


def open_image(files: Files, service: Service) -> Iterator[tuple[str, str, Span]]:
    """What the image of a service gives to everybody who reaches its port, such as ``database``, with the name of the
    service and its image; nothing where a password may be asked for, or the port is not reached from outside."""
    if service.image is None or "$" in service.image or service.build is not None:
        return
    name = image_name(service.image)
    for row in facts.table("docker/open_images"):
        if not re.fullmatch(row["image"], name.repository) or not re.fullmatch(row["tag"] or ".*", name.tag):
            continue
        if row["kind"] == "flows" and _has_login(files, service):
            continue
        if is_reached(service, row["port"]) and _is_open(service, row["closed_by"], row["opened_by"]):
            yield row["kind"], f"service '{service.name}'", service.image.span


def is_reached(service: Service, port: str = "") -> bool:
    """Whether other computers reach a port of a service, or any that it publishes."""
    if service.is_on_host_network:
        return True
    outside = (each for each in published(service) if each.address != "localhost" and not is_loopback(each.address))
    return any(not port or int(port) in each.inside for each in outside)


def _is_open(service: Service, closed_by: str, opened_by: str) -> bool:
    words = list(_settings(service))
    if any(re.fullmatch(closed_by, word) for word in words):
        return False
    if opened_by:
        return any(re.fullmatch(opened_by, word) for word in words)
    return not (service.env_files or service.entrypoint or any("PASS" in name for name in service.environment))


def _settings(service: Service) -> Iterator[str]:
    """Its variables, as ``NAME=value``, the words of its command, and where its volumes are mounted."""
    for name, variable in service.environment.items():
        yield f"{name}={variable.value or ''}"[:_LONGEST]
    for script in service.scripts:
        yield from str(script)[:_LONGEST].split()
    for target in _mounted(service):
        yield target[:_LONGEST]


def _mounted(service: Service) -> Iterator[str]:
    """Where its volumes, and the files of ``configs``, are in the container."""
    for volume in service.volumes:
        yield str(volume.target or "")
    configs = service.get("configs")
    if isinstance(configs, Sequence):
        for each in configs.items:
            target = each.scalar("target") if isinstance(each, Mapping) else None
            yield str(target.value if target is not None else "")


def _has_login(files: Files, service: Service) -> bool:
    """Whether the settings of Node-RED may ask for a password: those in its mounted folder do, or are not known."""
    folder = next((each.source for each in service.volumes if (each.target or "").rstrip("/") == "/data"), None)
    if folder is None or not folder.startswith("."):
        return any("settings" in target for target in _mounted(service))
    settings = files.tree.beside(service.source, posixpath.join(str(folder), "settings.js"))
    return settings is None or _LOGIN.search(settings.text) is not None
