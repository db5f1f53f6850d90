"""The services of compose files that give a file of the tree to their containers."""

from __future__ import annotations

import os

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.model.compose import Service
from bringup_lint.source import Source


def mounting_service(compose: Compose, source: Source) -> Service | None:
    """A service that mounts a file, or the folder that it is in, by a path from its compose file."""
    places = (source.absolute, os.path.dirname(source.absolute))
    for service in compose.services:
        folder = os.path.dirname(service.source.absolute)
        paths = (str(volume.source) for volume in service.volumes if volume.source is not None)
        if any(os.path.normpath(os.path.join(folder, path)) in places for path in paths if path.startswith(".")):
            return service
    return None
