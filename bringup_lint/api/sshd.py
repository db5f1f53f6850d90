"""The effective configuration of sshd."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.host.sshd import Sshd
    from bringup_lint.model.sshd import Option
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Option",
    "Sshd",
]
