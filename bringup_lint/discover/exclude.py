"""Which paths a run leaves out."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Sequence


def exclusion(folder: str, patterns: Sequence[str], named: Iterable[str] = ()) -> Callable[[str], bool]:
    """A test for paths (folders end in ``/``): does one of the gitignore patterns, relative to ``folder``, match?

    A pattern that leaves out one of the absolute paths that a user has ``named`` does not count.
    """
    if not patterns:
        return lambda path: False
    from bringup_lint.discover.gitignore import Patterns

    def below(path: str) -> str:
        return os.path.relpath(path, folder) + "/" * path.endswith("/")

    asked = [below(path) for path in named]
    counting = [pattern for pattern in patterns if not any(map(Patterns.of([pattern]).match, asked))]
    rules = Patterns.of(counting)

    def excluded(path: str) -> bool:
        relative = below(path)
        return not relative.startswith("..") and rules.match(relative)

    return excluded


def noting(excluded: Callable[[str], bool], met: set[str]) -> Callable[[str], bool]:
    """The same test, which keeps the paths that it leaves out."""

    def noted(path: str) -> bool:
        if not excluded(path):
            return False
        met.add(path)
        return True

    return noted
