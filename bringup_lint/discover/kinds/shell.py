"""Shell scripts."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name
from bringup_lint.templates import is_sample

_NAME = regex(r"\.(?:sh|bash)$")
_FOLDER = regex(
    r"(?:^|/)(?:s?bin|scripts?|libexec|usr/lib/[\w.-]+|cron\.(?:hourly|daily|weekly|monthly))/[^/.]+$"
    r"|(?:^|/)roles/[^/]+/(?:files|templates)/[^/.]+$"
    r"|(?:^|/)(?:rc\.local|[\w.-]*entrypoint|(?:[\w.-]*[.-])?(?:pre|post)(?:inst|rm))$"
)
"""Places and names of scripts that have no ending of their own."""
_BARE = regex(r"(?:^|/)[^/.]+$")
"""Names without an ending, which any program may have."""
_OF_BUILDS = regex(r"(?:^|/)(?:gradlew|mvnw|configure|\.git/[^\n]*|\.?(?:git)?hooks/[^/\n]*)$")
"""Scripts that tools write, and that no robot runs."""
_LOGIN = regex(r"(?:^|/)(?:[\w.-]*bashrc|\.?bash_(?:aliases|profile|login)|\.profile)$")
"""Files that a shell reads at the login of a user."""
_SHEBANG = regex(r"(?:#jinja2:[^\n]*\n)?#!\s*(?:/usr)?(?:/bin/env\s+)?(?:\S*/)?(?:ba|da|k|z)?sh\b")


def _is_shell(path: str, head: Head) -> bool:
    """A template is one by the name that it will have, or by its first line."""
    final = path if is_sample(path) else final_name(path)
    if _NAME.search(final) or _LOGIN.search(final):
        return True
    if final == path and not _FOLDER.search(path) and (not _BARE.search(path) or _OF_BUILDS.search(path)):
        return False
    return bool(_SHEBANG.match(head()))


KINDS = (Kind("shell-script", _is_shell),)
