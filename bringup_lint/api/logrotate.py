"""logrotate files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.model.logrotate import LogrotateFile
    from bringup_lint.model.logrotate import Script
    from bringup_lint.model.logrotate import Stanza
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "LogrotateFile",
    "Script",
    "Stanza",
]
