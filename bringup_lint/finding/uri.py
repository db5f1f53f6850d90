"""Source names as paths below the root folder, and as URIs."""

from __future__ import annotations

import posixpath
from functools import lru_cache


@lru_cache(10_000)
def below_root(name: str, root: str, cwd: str = "") -> str:
    """The path relative to ``root``, absolute when the file lies outside; relative names start at ``cwd``."""
    if not root:
        return posixpath.normpath(name)
    path = posixpath.normpath(posixpath.join(cwd or root, name))
    prefix = root.rstrip("/") + "/"
    return path.removeprefix(prefix)


def file_uri(path: str) -> str:
    return "file://" + quoted(path)


def quoted(path: str) -> str:
    """Percent-encoded, including the bytes of a name that is not text."""
    from urllib.parse import quote

    return quote(path.encode("utf-8", "surrogateescape"), safe="/-._~+@,=")
