"""Images that are run alone: the final stages of Dockerfiles that no compose service builds."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.containers import container_line
from bringup_lint.graph.runners.containers import copied
from bringup_lint.graph.runners.containers import image_environment
from bringup_lint.graph.runners.containers import image_stop
from bringup_lint.graph.runners.containers import image_user
from bringup_lint.graph.runners.containers import in_image
from bringup_lint.graph.runners.containers import words_of
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Stage
from bringup_lint.source import Source


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    compose = layers.compose()
    used = set(_used(compose))
    for file in compose.images.dockerfiles:
        stage = file.final
        if stage is not None and file.source.judged and not used & set(file.stages):
            yield _of(files, file, stage)


def _used(compose: Compose) -> Iterator[Stage]:
    """The stages that services run, and those that other Dockerfiles build on."""
    for service in compose.services:
        stage = compose.stage(service)
        if stage is not None:
            yield stage
    for file in compose.images.dockerfiles:
        for stage in file.stages:
            if stage.base is not None and stage.base not in file.stages:
                yield stage.base


def _of(files: Files, file: Dockerfile, stage: Stage) -> Runner:
    def reads(path: str) -> Source | None:
        whole = in_image(stage, path)
        return copied(files, stage, whole) if whole is not None else None

    line = container_line([*words_of(stage.last("ENTRYPOINT")), *words_of(stage.last("CMD"))], reads)
    lines = [] if line is None else [line]
    return Runner(
        RunnerKind.IMAGE,
        f"the image of {file.source.basename}",
        stage.start.keyword.span,
        image_environment(stage),
        lines=lines,
        main=lines,
        runs_ros=any(line.ros for line in lines),
        system=file.source.name,
        user=image_user(stage),
        stop=image_stop(stage),
        purpose=files.purpose(file.source),
        stage=stage,
        reads=reads,
    )
