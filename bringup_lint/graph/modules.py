"""The Python modules of a tree that are neither nodes nor launch files: web servers, tools and parts of packages."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from bringup_lint.dataclass import replace
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

MODULES = 2_000
"""Python modules of one tree that are read besides its nodes."""
TEXT = 500_000
"""Code points of such a module."""
TEST = regex(r"(?:^|/)(?:tests?|examples?|samples?)/|(?:^|/)(?:test_[^/]*|[^/]*_test)\.")
_LAUNCH = regex(r"[._-]launch\.py$|/launch/|/(?:setup|conftest)\.py$")
_FOREIGN = regex(r"/(?:site-packages|dist-packages|\.?venv|env|node_modules|build|install|third_?party|vendor)/")


def modules(files: Files) -> Iterator[Source]:
    """The judged modules, at most so many; tests, examples and what others wrote are left out. Python knows other
    encodings than UTF-8: no module is refused for its own."""
    known = {source.absolute for source in files.sources}
    paths = (path for path in sorted(files.tree.paths) if path.endswith(".py") and path not in known)
    own = (path for path in paths if not (TEST.search(path) or _LAUNCH.search(path) or _FOREIGN.search(path)))
    for path in islice(own, MODULES):
        source = files.tree.read(path, judged=False) if files.tree.judges(path) else None
        if source is not None and len(source.text) <= TEXT:
            yield replace(source, judged=True)
