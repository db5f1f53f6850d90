"""What a firewall lets in, as far as scripts and rule files say it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span


@dataclass(frozen=True, eq=False, slots=True)
class Opening:
    """One rule that accepts incoming packets."""

    where: Located | Span
    protocol: str
    """``udp``, ``tcp``, or empty for every protocol."""
    first: int | None
    """The lowest port; None for all ports, or for one that cannot be told."""
    last: int | None
    certain: bool = True
    """False when a port holds a variable that nothing sets."""


class Ports(NamedTuple):
    """Ports that a rule opens, from the lowest to the highest."""

    where: Located | Span
    first: int
    last: int


@dataclass(eq=False, slots=True)
class Firewall:
    source: Source
    tools: dict[str, Located] = field(default_factory=dict)
    """The first use of ``ufw``, ``iptables``, ``ip6tables``, ``nft`` and the family ``inet`` of nftables."""
    openings: list[Opening] = field(default_factory=list)
    first_input: Located | Span | None = None
    """The first rule about incoming packets."""
    drops: bool = False
    """What no rule accepts is dropped."""
    opens_all: bool = False
    """A whole subnet or interface is let in, or everything."""

    def opens(self, port: int) -> bool:
        """Whether a rule lets in the port over TCP; one of an unknown port may."""
        tcp = [each for each in self.openings if each.protocol != "udp"]
        return any(each.first is None or each.last is None or each.first <= port <= each.last for each in tcp)

    @property
    def is_closed_ufw(self) -> bool:
        """Whether a script enables ufw, and all that it lets in is known: single ports."""
        unknown = any(each.first is None for each in self.openings)
        return "ufw" in self.tools and self.drops and not self.opens_all and not unknown

    @property
    def udp(self) -> list[Ports]:
        """The ports that are open to UDP, where they are known."""
        return [
            Ports(each.where, each.first, each.last)
            for each in self.openings
            if each.protocol in ("udp", "") and each.first is not None and each.last is not None
        ]
