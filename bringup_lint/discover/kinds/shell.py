"""Shell scripts."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"\.(?:sh|bash)$")
_FOLDER = regex(r"(?:^|/)(?:s?bin|scripts?|libexec|cron\.(?:hourly|daily|weekly|monthly))/[^/.]+$")
_SHEBANG = regex(r"#!\s*(?:/usr)?(?:/bin/env\s+)?(?:\S*/)?(?:ba|da|k|z)?sh\b")


def _is_shell(path: str, head: Head) -> bool:
    if _NAME.search(path):
        return True
    return bool(_FOLDER.search(path)) and bool(_SHEBANG.match(head()))


KINDS = (Kind("shell-script", _is_shell),)
