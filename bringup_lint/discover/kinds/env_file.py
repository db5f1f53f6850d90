"""Environment files: by their names, or, where the name alone tells little, because they set variables of ROS 2."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"/[^/]*\.env(?:\.[\w-]+)?$|/etc/environment$")
_MAYBE = regex(r"/env(?:ironment)?$|/etc/(?:default|robot|ros\d?)/[^/]+$|/environment\.d/[^/]+\.conf$")
_ENTRY = regex(r"^[ \t]*(?:export[ \t]+)?[A-Za-z_]\w*[ \t]*=", re.M)
_VARIABLE = regex(r"^[^\S\n]*(?:export\s+)?(?:ROS_|RMW_|CYCLONEDDS_|FASTRTPS_|FASTDDS_|RCUTILS_|ZENOH_)\w*=", re.M)


def _is_env_file(path: str, head: Head) -> bool:
    path = f"/{path}"
    if path.endswith((".py", ".sh")):
        return False
    if _NAME.search(path):
        return bool(_ENTRY.search(head()))
    return bool(_MAYBE.search(path) and _VARIABLE.search(head()))


KINDS = (Kind("env-file", _is_env_file),)
