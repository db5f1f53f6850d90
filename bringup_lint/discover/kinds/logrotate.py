"""logrotate's configuration."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name

_FOLDER = regex(r"/logrotate\.d/(?P<name>[^/]+)$")
_NAME = regex(r"/logrotate\.conf$|\.logrotate$|/logrotate$")
_TABOO = regex(
    r"(?:,v|\.(?:bak|cfsaved|disabled|dpkg-(?:bak|del|dist|new|old|tmp)|rhn-cfg-tmp-.*|rpm(?:new|orig|save)|swp"
    r"|ucf-(?:dist|new|old))|~)$"
)
"""The endings that logrotate passes over in included folders (tabooext in logrotate(8))."""
_STANZA = regex(r"^[ \t]*[\"'/~][^\n{]*(?:\n\s*)?\{", re.M)


def _is_logrotate(path: str, head: Head) -> bool:
    path = final_name(f"/{path}")
    found = _FOLDER.search(path)
    if found is not None:
        return not _passed_over(found["name"])
    return bool(_NAME.search(path)) and bool(_STANZA.search(head()))


def _is_misnamed(path: str, head: Head) -> bool:
    """A stanza in the folder that only the name of its file keeps from being read."""
    found = _FOLDER.search(f"/{path}")
    return found is not None and bool(_TABOO.search(found["name"])) and bool(_STANZA.search(head()))


def _passed_over(name: str) -> bool:
    return bool(_TABOO.search(name)) or name.startswith((".", "README")) or name.endswith((".md", ".rst"))


KINDS = (
    Kind("logrotate", _is_logrotate, "logrotate"),
    Kind("logrotate-misnamed", _is_misnamed, "logrotate"),
)
