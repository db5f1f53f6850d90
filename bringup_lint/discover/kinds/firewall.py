"""Saved iptables rules and nftables files; firewall scripts are shell scripts."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_SAVED_NAME = regex(r"(?:^|/)(?:rules\.v[46]|iptables\.(?:rules|conf)|ip6?tables\.up\.rules)$")
_SAVED = regex(r"^\*filter\b", re.M)
_NFT_NAME = regex(r"(?:^|/)nftables(?:\.d/[^/]+)?\.conf$|\.nft$")
_NFT = regex(r"^[^\S\n]*table\s+(?:inet|ip6?|bridge|netdev)\s+\w+", re.M)


KINDS = (
    Kind("iptables-rules", lambda path, head: bool(_SAVED_NAME.search(path)) and bool(_SAVED.search(head()))),
    Kind("nftables", lambda path, head: bool(_NFT_NAME.search(path)) and bool(_NFT.search(head())), "nft"),
)
