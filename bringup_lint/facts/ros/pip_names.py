"""Projects of PyPI that requirements name by mistake (table ``ros/pip_names``)."""

from __future__ import annotations

from functools import lru_cache


@lru_cache
def pip_names() -> dict[str, tuple[str, str]]:
    """The normalized name of each: what is wrong with it, and what to write instead."""
    from bringup_lint.facts import rows

    return {name: (what, instead) for name, what, instead in rows("ros/pip_names")[1]}
