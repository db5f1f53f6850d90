"""Who may run what as another user: sudoers(5)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"/sudoers\.d/[^/.~]+$|/[\w-]*sudo[\w-]*$|/[\w-]+\.sudoers$")
_RULE = regex(r"^[ \t]*[^#\s][^\n]*?=[ \t]*(?:\(|NOPASSWD|ALL)", re.M)


def _is_sudoers(path: str, head: Head) -> bool:
    return bool(_NAME.search(f"/{path}")) and bool(_RULE.search(head()))


KINDS = (Kind("sudoers", _is_sudoers),)
