"""Times as reports write them."""

from __future__ import annotations

import os
from datetime import datetime
from datetime import timezone


def utc(seconds: float) -> str:
    """The time, or the one that reproducible builds ask for."""
    fixed = os.environ.get("SOURCE_DATE_EPOCH", "")
    try:
        when = datetime.fromtimestamp(int(fixed[:20]) if fixed.isdecimal() else seconds, timezone.utc)
    except (OverflowError, OSError, ValueError):
        when = datetime.fromtimestamp(seconds, timezone.utc)
    return when.isoformat(timespec="milliseconds").replace("+00:00", "Z")
