"""Shell scripts."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"\.(?:sh|bash)$")
_FOLDER = regex(
    r"(?:^|/)(?:s?bin|scripts?|libexec|usr/lib/[\w.-]+|cron\.(?:hourly|daily|weekly|monthly))/[^/.]+$"
    r"|(?:^|/)(?:rc\.local|[\w.-]*entrypoint|(?:[\w.-]*[.-])?(?:pre|post)(?:inst|rm))$"
)
"""Places and names of scripts that have no ending of their own."""
_SHEBANG = regex(r"#!\s*(?:/usr)?(?:/bin/env\s+)?(?:\S*/)?(?:ba|da|k|z)?sh\b")


def _is_shell(path: str, head: Head) -> bool:
    if _NAME.search(path):
        return True
    return bool(_FOLDER.search(path)) and bool(_SHEBANG.match(head()))


KINDS = (Kind("shell-script", _is_shell),)
