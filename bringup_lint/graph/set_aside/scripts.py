"""Scripts for an image that no image runs, while others beside them are run."""

from __future__ import annotations

import os
import re
from collections import Counter
from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import FEWEST
from bringup_lint.graph.set_aside.texts import WORD
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_INSTALLS = regex(r"(?:install|setup|build)[-_]")
_IN_IMAGE = regex(r"^[ \t]*(?:COPY|ADD|RUN)\b(?:[^\n]*\\\n)*[^\n]*", re.M)


class IdleScripts:
    """Asked for a script: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, texts: Texts) -> None:
        self._files = files
        self._texts = texts

    @memo
    def have(self, source: Source) -> bool:
        """Whether nothing names a script that installs something, while a Dockerfile puts others beside it into its
        image, each by its name. Those in the folder of the Dockerfile itself are for people."""
        if not _INSTALLS.match(source.basename):
            return False
        folder = os.path.dirname(source.absolute)
        if folder in self._with_dockerfile or self._scripts_in_image[folder] < FEWEST:
            return False
        return next(self._texts.saying(source.basename, source), None) is None

    @cached_property
    def _with_dockerfile(self) -> frozenset[str]:
        return frozenset(os.path.dirname(each.absolute) for each in self._files.of_kind("dockerfile"))

    @cached_property
    def _scripts_in_image(self) -> Counter[str]:
        """How many scripts of each folder steps of images name."""
        steps = (step for each in self._files.of_kind("dockerfile") for step in _IN_IMAGE.findall(each.text))
        named = {word for step in steps for word in WORD.findall(step)}
        scripts = (each for each in self._files.of_kind("shell-script") if each.basename in named)
        return Counter(os.path.dirname(path) for path in {each.absolute for each in scripts})
