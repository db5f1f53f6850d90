"""The firewalls of a tree: rule files, and the scripts that call a firewall tool."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.model.firewall import Firewall
from bringup_lint.parsers.firewall import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_TOOLS = regex(r"\b(?:ufw|ip6?tables)\b", hints="ufw iptables ip6tables")


def load_firewalls(files: Files) -> list[Firewall]:
    """The judged rule files, and the scripts that call a firewall tool."""
    scripts = [source for source in files.of_kind("shell-script") if source.matches(_TOOLS)]
    return files.parsed(parse, [*files.of_kind("iptables-rules", "nftables"), *scripts])
