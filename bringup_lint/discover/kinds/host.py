"""Files of the host that no other family reads: fstab, crontabs, audit rules, apt, fail2ban, limits, boot loaders."""

from __future__ import annotations

import re
from collections.abc import Callable

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_FSTAB = regex(r"(?:^|/)fstab(?:\.(?!d/)[\w-]+)?$|\.fstab$")
_CODE = regex(r"fstab\.(?:py|pyc|sh|bash|c|h|cpp|hpp|cc|rs|go|js|ts|rb|pl|lua|json|ya?ml|toml|xml|html|txt|rst)$")
_BACKUP = regex(r"(?:~|\.(?:bak|orig|old|rej|swp|save|md|dpkg-\w+|rpm\w+|ucf-\w+))$")
_CRON = regex(r"(?:^|/)(?:cron\.d/[^/]+|etc/crontab)$")
_USER_CRON = regex(r"(?:^|/)(?:[\w-]+[._-])?crontab(?:\.txt|\.conf)?$|\.cron(?:tab)?$")
_JOB = regex(r"^[ \t]*(?:@(?:reboot|hourly|daily|weekly|monthly)|[\d*/,-]+(?:[ \t]+[\w*/,-]+){4})[ \t]+\S", re.M)
_AUDIT = regex(r"(?:^|/)audit/(?:rules\.d/[^/]+\.rules|audit\.rules)$")
_APT = regex(r"(?:^|/)apt(?:\.conf\.d/[^/]+|/apt\.conf)$")
_FAIL2BAN = regex(r"(?:^|/)fail2ban/(?:jail\.(?:conf|local)|jail\.d/[^/]+\.(?:conf|local))$")
_LIMITS = regex(r"(?:^|/)(?:security/)?limits(?:\.conf|(?:\.d)?/[^/]+\.conf)$")
_LIMIT_LINE = regex(r"^[^\S\n]*[@*%\w][\w@:.*%-]*\s+(?:soft|hard|-)\s+\w+\s+\S+", re.M)
_TMPFILES = regex(r"(?:^|/)(?:user-)?tmpfiles\.d/[^/]+\.conf$|(?:^|[/._-])tmpfiles(?:\.conf)?$")
_WATCHDOG = regex(r"(?:^|/)watchdog\.conf$(?<!\.conf\.d/watchdog\.conf)")
_OVERLAYROOT = regex(r"(?:^|/)overlayroot(?:\.local)?\.conf$")
_BOOT = regex(r"(?:^|/)(?:cmdline\.txt|extlinux\.conf|default/grub(?:\.d/[^/]+\.cfg)?)$")


def _named(pattern: re.Pattern[str]) -> Callable[[str, Head], bool]:
    return lambda path, head: bool(pattern.search(path)) and not _BACKUP.search(path)


def _is_fstab(path: str, head: Head) -> bool:
    """A table, or one of several (``fstab.jetson``), not a program or a page about it."""
    return bool(_FSTAB.search(path)) and not _BACKUP.search(path) and not _CODE.search(path)


def _is_cron(path: str, head: Head) -> bool:
    name = path.rpartition("/")[2]
    return bool(_CRON.search(path)) and not _BACKUP.search(path) and not name.startswith((".", "README"))


def _is_user_cron(path: str, head: Head) -> bool:
    """The crontab of a user, which `crontab FILE` installs: without a field for the user."""
    return bool(_USER_CRON.search(path)) and not _CRON.search(path) and bool(_JOB.search(head()))


def _is_limits(path: str, head: Head) -> bool:
    return bool(_LIMITS.search(path)) and ("/security/" in f"/{path}" or bool(_LIMIT_LINE.search(head())))


def _is_os_release(path: str, head: Head) -> bool:
    return f"/{path}".endswith(("/etc/os-release", "/usr/lib/os-release"))


KINDS = (
    Kind("fstab", _is_fstab, "fstab"),
    Kind("cron", _is_cron, "cron"),
    Kind("user-crontab", _is_user_cron, "cron"),
    Kind("audit-rules", _named(_AUDIT), "audit"),
    Kind("apt-conf", _named(_APT), "apt"),
    Kind("fail2ban-jail", _named(_FAIL2BAN), "fail2ban"),
    Kind("limits-conf", _is_limits, "limits"),
    Kind("overlayroot", _named(_OVERLAYROOT), "overlayroot"),
    Kind("tmpfiles", _named(_TMPFILES), "tmpfiles"),
    Kind("kernel-command-line", _named(_BOOT)),
    Kind("watchdog-conf", _named(_WATCHDOG), "watchdog"),
    Kind("os-release", _is_os_release, "os-release"),
)
