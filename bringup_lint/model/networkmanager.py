"""A connection profile of NetworkManager, as its keyfile says it."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.addresses import parse_interface
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.addresses import Interface

ALIASES = {"802-3-ethernet": "ethernet", "802-11-wireless": "wifi", "802-11-wireless-security": "wifi-security"}
"""Names of nm-settings(5) to those of keyfiles."""
TRUE = ("true", "1")
FALSE = ("false", "0")
"""The booleans of GLib's key files: yes, no, on and off are none."""
_ADDRESS_KEY = regex(r"address(?:es)?\d*")
SECRETS = regex(r"psk|password|passwd|pin|private-key|wep-key\d|preshared-key|.*-password")
METRICS = {"ethernet": 100, "wifi": 600, "gsm": 700, "bridge": 425, "vlan": 400}
"""NetworkManager's own metrics of default routes, by the type of the connection."""


class Setting(NamedTuple):
    section: str
    """The name of keyfiles, also where the file writes that of nm-settings(5)."""
    key: Located
    value: Located


class Address(NamedTuple):
    text: Located
    ip: Interface
    gateway: bool
    """Whether the same line names a gateway."""


@dataclass(eq=False, slots=True)
class Profile:
    """One keyfile: its settings in the order of the text, and what is wrong with them."""

    source: Source
    settings: list[Setting] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    """``syntax``, which makes NetworkManager ignore the file, and what the table says of names and values."""

    def get(self, section: str, key: str) -> Located | None:
        """The value that counts: the last one."""
        found = [each.value for each in self.settings if each.section == section and each.key == key]
        return found[-1] if found else None

    def flag(self, section: str, key: str, default: bool) -> bool:
        """A boolean; what is not one counts as not written."""
        text = self.get(section, key)
        return default if text is None or text not in TRUE + FALSE else text in TRUE

    @property
    def name(self) -> str:
        return str(self.get("connection", "id") or self.source.basename)

    @property
    def type(self) -> str:
        text = str(self.get("connection", "type") or "")
        return ALIASES.get(text, text)

    @property
    def interface(self) -> Located | None:
        return self.get("connection", "interface-name")

    @property
    def comes_up(self) -> bool:
        """NetworkManager activates it by itself."""
        return self.flag("connection", "autoconnect", True) and not any(each.code == "syntax" for each in self.problems)

    @property
    def addresses(self) -> Iterator[Address]:
        """The static addresses, each where it is written."""
        for section in ("ipv4", "ipv6"):
            for each in self.settings:
                if each.section == section and _ADDRESS_KEY.fullmatch(each.key):
                    text, _, gateway = each.value.partition(",")
                    ip = parse_interface(text.strip())
                    if ip is not None:
                        yield Address(each.value.part(0, len(text)), ip, bool(gateway.strip()))

    @property
    def default_gateway(self) -> Located | None:
        """Where a static IPv4 profile that may be the default route names its gateway."""
        if self.get("ipv4", "method") != "manual" or self.flag("ipv4", "never-default", False):
            return None
        written = [address.text for address in self.addresses if address.gateway and address.ip.version == 4]
        return self.get("ipv4", "gateway") or (written[0] if written else None)

    @property
    def metric(self) -> int | None:
        """The metric of its IPv4 default route; None when it is not known."""
        text = self.get("ipv4", "route-metric")
        if text is None or text == "-1":
            return METRICS.get(self.type)
        return int(text) if text.isascii() and text.isdecimal() else None

    @property
    def secrets(self) -> Iterator[Located]:
        """Passphrases, passwords and private keys."""
        return (each.value for each in self.settings if each.value and SECRETS.fullmatch(each.key))
