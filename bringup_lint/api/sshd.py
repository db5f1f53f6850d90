"""The effective configuration of sshd."""

from __future__ import annotations

from bringup_lint.graph.host.sshd import Sshd
from bringup_lint.model.sshd import Option

__all__ = [
    "Option",
    "Sshd",
]
