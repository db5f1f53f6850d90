"""What the image of a Dockerfile is for: a robot, a shell to work in, a tool, a demonstration, or nothing any more."""

from __future__ import annotations

import os
from collections.abc import Iterable

from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_path
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Instruction
    from bringup_lint.model.dockerfile import Stage

_SHELLS = frozenset("bash sh zsh fish dash".split())
_TOOL = regex(r"(?:^|[/_.-])(?:builder|generator|toolchain)(?:\.?[Dd]ockerfile)?$")
_DESKTOP = regex(r"(?:^|[/-])(?:baseimage-)?(?:kasmvnc|novnc|guacamole|xrdp|webtop)(?=[:/-]|$)")
_RUNS = regex(r"\b(?:docker|podman|nerdctl)\s+(?:container\s+)?run\b")


def is_deployed(compose: Compose, file: Dockerfile) -> bool:
    """Whether the image may run on a robot by itself, as far as its files tell."""
    stage = file.final
    if stage is None:
        return False
    folder = os.path.dirname(file.source.name)
    if _TOOL.search(folder) or _TOOL.search(file.source.name) or _is_shown(stage):
        return False
    return not is_interactive(compose, stage) and not is_left_over(compose, file)


def _is_shown(stage: Stage) -> bool:
    """Whether the words of the command are those of a simulator or a demonstration."""
    words = (word for name in ("ENTRYPOINT", "CMD") for word in _words(stage.last(name)))
    return any(by_path(word) in (Purpose.SIMULATION, Purpose.EXAMPLE) for word in words)


def _words(instruction: Instruction | None) -> list[str]:
    if instruction is None:
        return []
    return instruction.exec_form or str(instruction.value).split()


def is_interactive(compose: Compose, stage: Stage) -> bool:
    """Whether all that the image starts is a shell in which somebody works."""
    shell = _starts_shell(stage)
    services = compose.users(stage)
    if services:
        return all(_is_entered(service, shell) for service in services)
    return shell and stage.last("CMD") is not None and not _is_run_beside(compose, stage)


def is_workplace(compose: Compose, service: Service) -> bool:
    """Whether a service only keeps a container open in which somebody works, with a terminal or a desktop."""
    if service.image is not None and _DESKTOP.search(service.image):
        return True
    if service.restarts or not (service.flag("tty") or service.flag("stdin_open")):
        return False
    stage = compose.stage(service)
    if stage is not None and _is_entered(service, _starts_shell(stage)):
        return True
    on_display = any("/tmp/.X11-unix" in (volume.source or "") for volume in service.volumes)
    return on_display and not service.command and not service.entrypoint


def is_entered_by_hand(service: Service) -> bool:
    """Whether all that a service starts is a shell in a terminal, which a restart brings back."""
    is_open = service.flag("tty") or service.flag("stdin_open")
    words = [word for words in service.command for word in _split(str(words))]
    return bool(is_open) and not service.entrypoint and bool(words) and _is_shell(words)


def _starts_shell(stage: Stage) -> bool:
    """Whether the command of the image, given by itself or by the official image below, is a shell."""
    entrypoint, command = _words(stage.last("ENTRYPOINT")), _words(stage.last("CMD"))
    if command:
        return _is_shell(command)
    return _is_shell(entrypoint) if entrypoint else True


def _is_entered(service: Service, shell: bool) -> bool:
    """Whether a service keeps a shell open for somebody."""
    if service.restarts or not (service.flag("tty") or service.flag("stdin_open")):
        return False
    if service.entrypoint or not service.command:
        return shell and not service.entrypoint
    return _is_shell([word for words in service.command for word in _split(str(words))])


def _split(text: str) -> list[str]:
    import shlex

    try:
        return shlex.split(text)
    except ValueError:
        return [text]


def _is_shell(words: Iterable[str]) -> bool:
    name, *rest = [*words, ""]
    return name.rpartition("/")[2] in _SHELLS and not any(rest)


def _is_run_beside(compose: Compose, stage: Stage) -> bool:
    """Whether a script or a compose file in the folder of the Dockerfile runs containers."""
    folder = os.path.dirname(stage.start.keyword.span.path)
    if any(os.path.dirname(file.source.name) == folder for file in compose.files):
        return True
    scripts = (each for each in compose.tree.sources if each.kind == "shell-script")
    return any(os.path.dirname(each.name) == folder and _RUNS.search(each.text) for each in scripts)


def is_left_over(compose: Compose, file: Dockerfile) -> bool:
    """Whether nothing of the tree builds or names a Dockerfile, and another one is built in its place."""
    return os.path.dirname(file.source.name) in compose.build_folders and not is_used(compose, file)


def is_used(compose: Compose, file: Dockerfile) -> bool:
    """Whether anything of the tree builds or names a Dockerfile."""
    return _is_built(compose, file) or compose.images.is_named(file.source)


def _is_built(compose: Compose, file: Dockerfile) -> bool:
    return not compose.built_stages.isdisjoint(file.stages)
