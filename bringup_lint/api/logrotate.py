"""logrotate files."""

from __future__ import annotations

from bringup_lint.model.logrotate import LogrotateFile
from bringup_lint.model.logrotate import Script
from bringup_lint.model.logrotate import Stanza

__all__ = [
    "LogrotateFile",
    "Script",
    "Stanza",
]
