"""Dockerfiles that nothing builds, and in whose place another one is built."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import cached_property

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_IMAGES = ("Dockerfile", "Containerfile")
_PUT_TOGETHER = regex(
    r"(?:Docker|Container)file[._-](?:[\"']?[ \t]*[$*{%+])|[$*}%][\w}]{0,40}[\"']?[._-](?:Docker|Container)file\b"
)
"""The name of a Dockerfile of which a variable or a pattern has a part."""


class LeftOverDockerfiles:
    """Asked for a Dockerfile: whether the tree keeps it and does not use it."""

    def __init__(self, texts: Texts, compose: Callable[[], Compose]) -> None:
        self._texts = texts
        self._compose = compose

    @memo
    def have(self, source: Source) -> bool:
        """Whether nothing builds a Dockerfile, and another one is built in its place. That of the top, people build."""
        from bringup_lint.graph.containers.questions.image_use import is_left_over

        path = self._texts.path_of(source.absolute)
        if path == "Dockerfile" or self._is_built(source, path):
            return False
        compose = self._compose()
        return any(is_left_over(compose, file) for file in compose.images.dockerfiles if file.source is source)

    def _is_built(self, source: Source, path: str) -> bool:
        """Whether a page, a script or a setting names a Dockerfile, or puts its name together."""
        folder, name = os.path.basename(os.path.dirname(path)), source.basename
        if name not in _IMAGES:
            return self._names_are_put_together or next(self._texts.saying(name, source), None) is not None
        built = re.compile(
            rf"\b(?:docker|podman)\b[^\n]*\bbuild\b[^\n]*[\s/\"']{re.escape(folder)}(?:[/\s\"',]|$)|[$}}*]/{name}\b",
            re.M,
        )
        return any(built.search(each.text) for each in self._texts.saying(folder, source))

    @cached_property
    def _names_are_put_together(self) -> bool:
        return any(_PUT_TOGETHER.search(each.text) for each in self._texts.all)
