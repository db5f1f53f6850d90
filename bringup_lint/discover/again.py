"""What the answer to a question of a record is now."""

from __future__ import annotations

from bringup_lint.discover.record import TRACKED
from bringup_lint.discover.record import fact_of
from bringup_lint.discover.record import text_fact


def fact_now(question: str, path: str) -> str:
    """What a run would learn from a path now."""
    return _tracked(path) if question == TRACKED else fact_of(question, path)


def _tracked(path: str) -> str:
    from bringup_lint.discover.git_index import SIZE_LIMIT
    from bringup_lint.discover.git_index import UnknownFormat
    from bringup_lint.discover.git_index import content_of
    from bringup_lint.discover.git_index import tracked_paths
    from bringup_lint.discover.reading import Unreadable
    from bringup_lint.discover.reading import read_bytes

    try:
        data, status = read_bytes(path, SIZE_LIMIT)
        return text_fact(status, content_of(frozenset(tracked_paths(data))))
    except (Unreadable, UnknownFormat):
        return ""
