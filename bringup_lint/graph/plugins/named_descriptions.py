"""Whether another file names a robot description."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.source import Source


def is_used(files: Files, source: Source) -> bool:
    """Whether a launch file or another description names a description."""
    return is_named(files, source, "urdf", *LAUNCH)


def is_named(files: Files, source: Source, *kinds: str) -> bool:
    """Whether another file of these kinds names a description."""
    name = re.compile(rf"(?<![\w.-]){re.escape(source.basename)}(?![\w.-])")
    others = (each for each in files.of_kind(*kinds) if each.name != source.name)
    return any(source.basename in each.text and name.search(each.text) for each in others)
