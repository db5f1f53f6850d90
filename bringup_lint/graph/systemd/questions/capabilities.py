"""File capabilities that scripts and build files of the tree give to programs: setcap(8)."""

from __future__ import annotations

import re

from bringup_lint.graph.files import Files
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_SETCAP = regex(
    r"\bsetcap\b[ \t]+(?:-\w+[ \t]+)*[\"']?(cap_\w+(?:,cap_\w+)*,?)[=+][epi+]+[\"']?[ \t]+[\"']?([^\s\"';&|]+)",
    re.I,
    hints="setcap",
)
_SCRIPTS = regex(r"\.(?:sh|bash|cmake|mk|ya?ml)$|(?:^|/)(?:CMakeLists\.txt|Makefile|Dockerfile[^/]*|postinst|[^/.]+)$")
_FILES = 3000


def file_capabilities(files: Files) -> dict[str, list[tuple[str, Span]]]:
    """Name of a program -> the capabilities (``CAP_NET_RAW``) that it is given, each with the place that says so."""
    found: dict[str, list[tuple[str, Span]]] = {}
    paths = [path for path in files.tree.paths if _SCRIPTS.search(path)]
    for path in paths[:_FILES]:
        source = files.tree.read(path, judged=False)
        if source is None:
            continue
        for match in _SETCAP.finditer(source.text):
            name = match[2].rpartition("/")[2]
            for capability in match[1].split(","):
                if capability and "$" not in name:
                    found.setdefault(name, []).append((capability.upper(), source.span(*match.span())))
    return found
