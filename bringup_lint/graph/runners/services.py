"""Compose services as runners, with what their image says where its Dockerfile is in the tree."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.containers import container_line
from bringup_lint.graph.runners.containers import copied
from bringup_lint.graph.runners.containers import image_environment
from bringup_lint.graph.runners.containers import image_stop
from bringup_lint.graph.runners.containers import image_user
from bringup_lint.graph.runners.containers import in_image
from bringup_lint.graph.runners.containers import mounted
from bringup_lint.graph.runners.containers import user_name
from bringup_lint.graph.runners.containers import words_of
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Stop
from bringup_lint.model.compose import Service
from bringup_lint.model.dockerfile import Stage
from bringup_lint.parsers.env_file import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

DEFAULT_GRACE = 10.0
"""Seconds that docker waits between the stop signal and the kill."""


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    compose = layers.compose()
    for service in compose.services:
        if service.source.judged:
            yield _of(files, compose, service)


def _of(files: Files, compose: Compose, service: Service) -> Runner:
    stage = compose.stage(service)

    def reads(path: str) -> Source | None:
        whole = in_image(stage, path, service.scalar("working_dir"))
        if whole is None:
            return None
        return mounted(files, service, whole) or (copied(files, stage, whole) if stage is not None else None)

    line = container_line(_words(service, stage), reads)
    lines = [] if line is None else [line]
    starts_ros = any(line.ros for line in lines)
    return Runner(
        RunnerKind.SERVICE,
        f"service '{service.name}'",
        service.name.span,
        _environment(compose, service, stage),
        lines=lines,
        main=lines,
        runs_ros=service.is_ros or starts_ros,
        system=service.source.name,
        user=user_name(service.user) if service.user else image_user(stage, _pulled(service)),
        stop=_stop(service, stage),
        restarts=service.restarts,
        asks_status=service.restarts_failures,
        environment_files=tuple(_environment_files(files, service)),
        purpose=files.purpose(service.name, str(service.name), *map(str, service.items("profiles"))),
        extent=service.body.span,
        service=service,
        stage=stage,
        reads=reads,
        certain=service.build is not None or stage is not None,
    )


def _environment_files(files: Files, service: Service) -> Iterator[tuple[Located, Source]]:
    for path in service.env_files:
        source = files.tree.beside(service.source, str(path))
        if source is not None:
            yield path, source


def _words(service: Service, stage: Stage | None) -> list[Located]:
    """Entrypoint and command; an entrypoint of the service's own drops the CMD of the image."""
    entrypoint = list(service.entrypoint) or words_of(stage.last("ENTRYPOINT") if stage else None)
    command = list(service.command)
    if not command and not service.entrypoint:
        command = words_of(stage.last("CMD") if stage else None)
    return [*entrypoint, *command]


def _pulled(service: Service) -> Located | None:
    """The image of a service that builds none."""
    return service.image if service.build is None else None


def _stop(service: Service, stage: Stage | None) -> Stop:
    seconds = service.stop_grace or DEFAULT_GRACE
    own = service.scalar("stop_signal")
    if own is not None:
        return Stop(str(own), seconds, own)
    return image_stop(stage, _pulled(service))._replace(seconds=seconds)


def _environment(compose: Compose, service: Service, stage: Stage | None) -> Environment:
    """Dockerfile ENV, then env files, then ``environment:``."""
    environment = image_environment(stage, _pulled(service))
    environment.complete &= not compose.extends_elsewhere(service)
    sources = compose.env_files(service)
    environment.complete &= len(sources) == len(service.env_files)
    for source in sources:
        for entry in parse(source).entries:
            text = None if source.template else str(entry.value)
            environment.set(Variable(str(entry.name), entry.value, text, "env_file:"))
    for name, variable in service.environment.items():
        value = variable.value
        if value is None:
            environment.set(Variable(name, variable.name, None, "environment:"))
        else:
            environment.set(Variable(name, value, None if "$" in value else str(value), "environment:"))
    return environment
