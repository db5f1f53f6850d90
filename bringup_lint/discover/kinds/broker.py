"""Configuration of message brokers: mosquitto.conf(5)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"(?:^|/)mosquitto[^/]*\.conf(?:\.default)?$|(?:^|/)mosquitto/(?:conf\.d|config)/[^/]+\.conf$")
_KEY = regex(r"^(?:listener|port|allow_anonymous|password_file|persistence|include_dir)\b", re.M)


def _is_mosquitto(path: str, head: Head) -> bool:
    return bool(_NAME.search(path)) and bool(_KEY.search(head()))


KINDS = (Kind("mosquitto", _is_mosquitto, "mosquitto"),)
