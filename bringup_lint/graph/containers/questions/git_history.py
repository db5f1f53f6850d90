"""Steps of images that ask git for the version of a repository whose history is not in the build context."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Stage

_ASKS = regex(r"\bgit[ \t]+(?P<verb>describe|rev-parse|rev-list|log|show)\b", hints="git")
_BRINGS = regex(r"\bgit[ \t](?:[^\n]{0,80}[ \t])?(?:clone|init|fetch)\b|\.git\b|\bvcs[ \t]+import\b")
"""What else gives an image a repository."""
_IGNORED = regex(r"^[ \t]*(?:\*\*/|/)?\.git/?[ \t\r]*$", re.M)
_TAKEN_BACK = regex(r"^[ \t]*!(?:[ \t]*/)?(?:\*\*/)?(?:\.git\b|\*|\.[ \t\r]*$)", re.M)
_WHOLE = (".", "./", "/")


class NoHistory(NamedTuple):
    """One question that git cannot answer."""

    where: Located
    verb: str
    ignoring: Located
    """The line that leaves the history out."""


def without_history(files: Files, compose: Compose) -> Iterator[NoHistory]:
    """The first question of each stage that copies its whole context, which lacks ``.git``."""
    for file in compose.images.dockerfiles:
        if not file.source.judged or not _ASKS.search(file.source.said):
            continue
        ignoring = _ignoring(files, file)
        if ignoring is None:
            continue
        for stage in file.stages:
            asked = ((step.value, match) for step in stage.all("RUN") if (match := _ASKS.search(step.value)))
            value, match = next(asked, (None, None))
            if value is not None and match is not None and _has_only_context(stage):
                yield NoHistory(value.part(*match.span()), match["verb"], ignoring)


def _has_only_context(stage: Stage) -> bool:
    """Whether a stage copies its whole context, and nothing else brings a repository to that place."""
    if any(_BRINGS.search(step.value) for each in stage.chain for step in each.instructions):
        return False
    places: dict[bool, set[str]] = {True: set(), False: set()}
    for instruction in stage.all("COPY", "ADD"):
        words = [str(word) for word in instruction.value.words()]
        from_stage = any(flag.startswith("--from") for flag in instruction.flags)
        if from_stage or any(word in _WHOLE for word in words[:-1]):
            places[from_stage].update(word.rstrip("/") for word in words[-1:])
    return bool(places[False]) and not places[True] & (places[False] | {".", ""})


def _ignoring(files: Files, file: Dockerfile) -> Located | None:
    """The line of the only file that may decide on what the context holds, where it leaves the history out."""
    folder = os.path.dirname(file.source.absolute)
    paths = [f"{file.source.absolute}.dockerignore", os.path.join(folder, ".dockerignore")]
    paths += [os.path.join(os.path.dirname(folder), ".dockerignore")]
    there = [path for path in paths if files.tree.is_file(path)]
    source = files.tree.read(there[0], judged=False) if len(there) == 1 else None
    line = _IGNORED.search(source.text) if source is not None else None
    if source is None or line is None or _TAKEN_BACK.search(source.text):
        return None
    return source.located(*line.span()).strip_located()
