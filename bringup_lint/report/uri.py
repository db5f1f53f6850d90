"""Source names as paths below the root folder, and as URIs."""

from __future__ import annotations

import posixpath

from bringup_lint.report.model import Report


def below_root(name: str, root: str, cwd: str = "") -> str:
    """The path relative to ``root``, absolute when the file lies outside; relative names start at ``cwd``."""
    if not root:
        return posixpath.normpath(name)
    path = posixpath.normpath(posixpath.join(cwd or root, name))
    prefix = root.rstrip("/") + "/"
    return path.removeprefix(prefix)


def location(name: str, report: Report) -> dict[str, str]:
    """A SARIF ``artifactLocation``: relative to ``%SRCROOT%`` where that is possible."""
    path = below_root(name, report.root, report.cwd)
    if path.startswith("/"):
        return {"uri": file_uri(path)}
    return {"uri": _quoted(path), "uriBaseId": "%SRCROOT%"}


def file_uri(path: str) -> str:
    return "file://" + _quoted(path)


def _quoted(path: str) -> str:
    """Percent-encoded, including the bytes of a name that is not text."""
    from urllib.parse import quote

    return quote(path.encode("utf-8", "surrogateescape"), safe="/-._~+@,=")
