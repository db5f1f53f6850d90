"""Images that are run alone: the final stages of Dockerfiles that no compose service builds."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.containers import container_line
from bringup_lint.graph.runners.containers import copied
from bringup_lint.graph.runners.containers import image_environment
from bringup_lint.graph.runners.containers import words_of
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Stop
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.dockerfile import runs_as_root
from bringup_lint.source import Source


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    compose = layers.compose()
    built = {compose.stage(service) for service in compose.services} if files.of_kind("compose") else set()
    for file in compose.dockerfiles():
        stage = file.final
        if stage is not None and file.source.judged and not built & set(file.stages):
            yield _of(files, file, stage)


def _of(files: Files, file: Dockerfile, stage: Stage) -> Runner:
    def reads(path: str) -> Source | None:
        return copied(files, stage, path) if path.startswith("/") else None

    line = container_line([*words_of(stage.last("ENTRYPOINT")), *words_of(stage.last("CMD"))], reads)
    lines = [] if line is None else [line]
    signal, user = stage.last("STOPSIGNAL"), stage.last("USER")
    return Runner(
        RunnerKind.IMAGE,
        f"the image of {file.source.basename}",
        stage.start.keyword.span,
        image_environment(stage),
        lines=lines,
        main=lines,
        runs_ros=any(line.ros for line in lines),
        system=file.source.name,
        user=str(user.value.partition(":")[0]) if user else "root" if runs_as_root(stage.origin) else None,
        stop=Stop(str(signal.value) if signal else "SIGTERM", None, signal.value if signal else None),
        purpose=files.purpose(file.source),
        stage=stage,
        reads=reads,
    )
