"""Settings of systemd's daemons: the service manager, journald and logind."""

from __future__ import annotations

import re
from collections.abc import Callable

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name

_FOLDER = regex(r"/systemd/(?:system|journald|logind)\.conf(?:\.d/[^/]+)?$")
_MAIN = regex(r"/(?P<daemon>system|journald|logind)\.conf$")
_DROPIN = regex(r"/(?P<daemon>system|journald|logind)\.conf\.d/(?P<name>[^/]+)$")
_SECTION = {"system": "Manager", "journald": "Journal", "logind": "Login"}
_LINE = regex(r"^[ \t]*(?:#[ \t]*)?[A-Z]\w+[ \t]*=", re.M)


def _claims(daemon: str) -> Callable[[str, Head], bool]:
    def claims(path: str, head: Head) -> bool:
        path = final_name(f"/{path}")
        found = _DROPIN.search(path) or _MAIN.search(path)
        if found is None or found["daemon"] != daemon or not path.endswith(".conf"):
            return False
        return bool(_FOLDER.search(path)) or f"[{_SECTION[daemon]}]" in head()

    return claims


def _is_misnamed(path: str, head: Head) -> bool:
    """A file in a drop-in folder that only its name keeps from being read."""
    found = _DROPIN.search(final_name(f"/{path}"))
    if found is None or found["name"].endswith(".conf") or found["name"].startswith((".", "README")):
        return False
    return f"[{_SECTION[found['daemon']]}]" in head() and bool(_LINE.search(head()))


KINDS = (
    *(Kind(f"{daemon}-conf", _claims(daemon), f"{daemon}.conf") for daemon in _SECTION),
    Kind("daemon-misnamed", _is_misnamed, ".conf.d/"),
)
