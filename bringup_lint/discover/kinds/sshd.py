"""sshd's configuration."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name

_NAME = regex(r"/sshd_config(?:\.d/[^/]+\.conf)?$")
_LINE = regex(
    r"^[ \t]*(?:#[ \t]*)?(?:Port|PermitRootLogin|PasswordAuthentication|Subsystem|Match|Include|UsePAM"
    r"|X11Forwarding|AllowUsers|PubkeyAuthentication|AuthorizedKeysFile|\w*Authentication|\w*Forwarding|Ciphers|MACs|MaxAuthTries"
    r"|ClientAlive\w+)[ \t=]",
    re.M | re.I,
)


def _is_sshd(path: str, head: Head) -> bool:
    path = final_name(f"/{path}")
    return bool(_NAME.search(path)) and ("/ssh/sshd_config" in path or bool(_LINE.search(head())))


KINDS = (Kind("sshd-config", _is_sshd),)
