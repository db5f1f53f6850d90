"""Settings of the service manager itself."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_SYSTEM_CONF = re.compile(r"(?:^|/)systemd/system\.conf$|(?:^|/)systemd/system\.conf\.d/[^/]+\.conf$|(?:^|/)system\.conf\.d/[^/]+\.conf$")


def _is_system_conf(path: str, head: Head) -> bool:
    return bool(_SYSTEM_CONF.search(path)) and "[Manager]" in head()


KINDS = (Kind("system-conf", _is_system_conf),)
