"""The services of compose files that give a file of the tree to their containers."""

from __future__ import annotations

import os

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.model.compose import Service
from bringup_lint.source import Source
from bringup_lint.source import Span


def mounting_service(compose: Compose, source: Source) -> Service | None:
    """A service that mounts a file, or the folder that it is in, by a path from its compose file."""
    places = (source.absolute, os.path.dirname(source.absolute))
    for service in compose.services:
        folder = os.path.dirname(service.source.absolute)
        paths = (str(volume.source) for volume in service.volumes if volume.source is not None)
        if any(os.path.normpath(os.path.join(folder, path)) in places for path in paths if path.startswith(".")):
            return service
    return None


def services_with(compose: Compose, place: Span) -> list[Service]:
    """The services that a place of a file is about: those around it, one that mounts the file, and those whose image
    is built in the folder of the file by a Dockerfile that names it."""
    source = place.source
    mounting = mounting_service(compose, source)
    found = [] if mounting is None else [mounting]
    for service in compose.services:
        body = service.body.span
        stage = compose.stage(service)
        built = stage.start.keyword.span.source if stage is not None else source
        beside = built is not source and os.path.dirname(built.absolute) == os.path.dirname(source.absolute)
        if (body.source is source and body.start <= place.start < body.end) or (
            beside and source.basename in built.said
        ):
            found.append(service)
    return found
