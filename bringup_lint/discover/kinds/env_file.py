"""Environment files that set variables of ROS 2, whoever reads them."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_NAME = re.compile(
    r"/[^/]*\.env(?:\.[\w-]+)?$|/env(?:ironment)?$|/etc/(?:default|robot|ros\d?)/[^/]+$|/environment\.d/[^/]+\.conf$"
)
_VARIABLE = re.compile(r"^\s*(?:export\s+)?(?:ROS_|RMW_|CYCLONEDDS_|FASTRTPS_|FASTDDS_|RCUTILS_|ZENOH_)\w*=", re.M)


def _is_env_file(path: str, head: Head) -> bool:
    return bool(_NAME.search(f"/{path}")) and not path.endswith((".py", ".sh")) and bool(_VARIABLE.search(head()))


KINDS = (Kind("env-file", _is_env_file),)
