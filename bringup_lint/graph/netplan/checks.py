"""What netplan refuses although every key and value is well formed."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import NetplanFile
from bringup_lint.model.netplan import Plan
from bringup_lint.model.netplan import PlanCode
from bringup_lint.model.netplan import Route
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.netplan_values import is_ip4
from bringup_lint.parsers.netplan_values import unsigned
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem

WIREGUARD_KEY = regex(r"[A-Za-z0-9+/]{42}[A-Za-z0-9+/]=\Z")
HEX_KEY = regex(r"[0-9a-fA-F]{64}\Z")
BROADCAST = ("broadcast", "multicast", "anycast")
IP6_TUNNELS = frozenset(("ipip6", "ip6ip6", "ip6gre", "ip6gretap", "vti6"))
KEYED_TUNNELS = frozenset(("gre", "ip6gre", "gretap", "ip6gretap", "vti", "vti6", "wireguard"))
OVERRIDES = (
    "use-dns",
    "use-domains",
    "use-ntp",
    "send-hostname",
    "use-hostname",
    "use-mtu",
    "hostname",
    "route-metric",
    "use-routes",
)


def check_definitions(plan: Plan, file: NetplanFile) -> None:
    """Check what a file defines against all that was read so far; only what is certain by itself when a name is still
    missing."""
    stopped = any(problem.code in (PlanCode.UNDEFINED, PlanCode.VLAN_LINK) for problem in plan.problems)
    for name in dict.fromkeys(str(definition.name) for definition in file.definitions):
        interface = plan.interfaces[name]
        for check in (*COMMON, *BY_KIND.get(interface.kind, ())):
            if not stopped or check in (_set_name, _vlan):
                plan.problems.extend(check(interface))


def check_plan(plan: Plan) -> None:
    """Check what only shows when all files are read: memberships and what the renderers can do."""
    plan.problems.extend(_memberships(plan))
    for interface in plan.interfaces.values():
        plan.problems.extend(BACKENDS.get(interface.backend, lambda _: ())(interface))


def _set_name(interface: Interface) -> Iterator[Problem]:
    if interface.set_name is not None and interface.match is None:
        yield Problem(PlanCode.SET_NAME, interface.key("set-name") or interface.set_name)


def _routes(interface: Interface) -> Iterator[Problem]:
    for route in interface.routes:
        if _mixes_families(route):
            where = route.value("via") or route.where
            yield Problem(PlanCode.ROUTE_FAMILIES, where, "the route mixes IPv4 and IPv6")
        elif reason := _missing_of(route):
            yield Problem(PlanCode.ROUTE, route.where, reason)
    for policy in interface.items("routing-policy"):
        if isinstance(policy, Mapping) and policy.get("from") is None and policy.get("to") is None:
            yield Problem(PlanCode.ROUTE, policy.span, "a routing policy needs from or to")


def _missing_of(route: Route) -> str:
    """What a route lacks, by its type and scope."""
    to, via = route.value("to"), route.value("via")
    if to is None:
        return "the route has no destination (to)"
    if to == "default" and route.family is None:
        return "a default route needs a gateway (via), or from, to distinguish IPv4 from IPv6"
    if route.type == "unicast" and _scope(route) == "global" and via is None:
        return "a global unicast route needs a gateway (via)"
    return ""


def _mixes_families(route: Route) -> bool:
    return len(set(route.families)) > 1


def _scope(route: Route) -> str:
    """The scope, which netplan derives from the type where it is not written."""
    written = str(route.value("scope") or "").lower()
    if written:
        return written
    if route.type in ("local", "nat"):
        return "host"
    linked = (route.type == "unicast" and route.value("via") is None) or route.type in BROADCAST
    return "link" if linked else "global"


def _duplicate_ssids(interface: Interface) -> Iterator[Problem]:
    for definition in interface.definitions:
        for key, value in definition.body.entries:
            if key.value == "access-points" and isinstance(value, Mapping):
                yield from (Problem(PlanCode.DUPLICATE_SSID, again.value) for _, again in value.duplicates)


def _wifi(interface: Interface) -> Iterator[Problem]:
    if not interface.access_points:
        yield Problem(PlanCode.NO_ACCESS_POINT, interface.definitions[-1].name)


def _vlan(interface: Interface) -> Iterator[Problem]:
    number = interface.value("id")
    if interface.link is None:
        yield Problem(PlanCode.INCOMPLETE, interface.name, "a VLAN needs link")
    if number is None:
        yield Problem(PlanCode.VLAN_NO_ID, interface.name)
    elif number.isdecimal() and int(number) > 4094:
        yield Problem(PlanCode.VLAN_ID, number)


def _vrf(interface: Interface) -> Iterator[Problem]:
    if interface.value("table") is None:
        yield Problem(PlanCode.INCOMPLETE, interface.name, "a VRF needs table")


def _tokens(interface: Interface) -> Iterator[Problem]:
    token = interface.value("ipv6-address-token")
    if token is not None and interface.value("ipv6-address-generation") is not None:
        yield Problem(
            PlanCode.INCOMPLETE, token, "ipv6-address-token and ipv6-address-generation are mutually exclusive"
        )


def _passthrough(interface: Interface) -> Iterator[Problem]:
    if interface.value("networkmanager", "passthrough", "connection.type") is None:
        yield Problem(
            PlanCode.INCOMPLETE, interface.name, "a NetworkManager device needs connection.type in its passthrough"
        )


def _tunnel(interface: Interface) -> Iterator[Problem]:
    mode = str(interface.value("mode") or "")
    if not mode:
        yield Problem(PlanCode.INCOMPLETE, interface.name, "a tunnel needs mode")
    elif mode == "wireguard":
        yield from _wireguard(interface)
    elif mode == "vxlan":
        if not 1 <= (interface.number("id") or 0) <= 16777215:
            yield Problem(
                PlanCode.INCOMPLETE, interface.value("id") or interface.name, "a VXLAN needs an id in 1..16777215"
            )
    else:
        yield from _tunnel_numbers(interface)
        remote = interface.value("remote")
        if remote is None:
            yield Problem(PlanCode.INCOMPLETE, interface.name, "a tunnel needs remote")
        for end in filter(None, (interface.value("local"), remote)):
            if (":" in end) != (mode in IP6_TUNNELS):
                family = "IPv6" if mode in IP6_TUNNELS else "IPv4"
                yield Problem(PlanCode.INCOMPLETE, end, f"a tunnel of mode {mode} needs {family} ends")


def _tunnel_numbers(interface: Interface) -> Iterator[Problem]:
    """The keys of a tunnel are numbers or dotted quads."""
    for path in (("key",), ("keys",), ("keys", "input"), ("keys", "output")):
        key = interface.value(*path)
        if key is not None and unsigned(key) is None and not is_ip4(key):
            yield Problem(PlanCode.INCOMPLETE, key, "the key of a tunnel is a number or a dotted quad")


def _wireguard(interface: Interface) -> Iterator[Problem]:
    for key in ("key", "keys"):
        private = interface.value(key) or interface.value(key, "private")
        if private is not None and not private.startswith("/") and not WIREGUARD_KEY.match(private):
            yield Problem(PlanCode.SECRET, private)
    for peer in interface.items("peers"):
        if not isinstance(peer, Mapping):
            continue
        keys = peer.mapping("keys")
        public = keys.scalar("public") if keys else None
        if public is None:
            yield Problem(PlanCode.INCOMPLETE, peer.span, "a WireGuard peer needs a public key")
        elif not WIREGUARD_KEY.match(public.value):
            yield Problem(PlanCode.INCOMPLETE, public.value, "this is not a WireGuard public key")
        shared = keys.scalar("shared") if keys else None
        if shared is not None and not shared.value.startswith("/") and not WIREGUARD_KEY.match(shared.value):
            yield Problem(PlanCode.SECRET, shared.value)


def _memberships(plan: Plan) -> Iterator[Problem]:
    """A port belongs to one bridge or bond, and to one VRF."""
    owners: dict[tuple[str, bool], Interface] = {}
    for interface in plan.interfaces.values():
        for member in interface.members:
            owner = owners.setdefault((str(member), interface.kind == "vrfs"), interface)
            if owner is not interface:
                yield Problem(PlanCode.TWO_MASTERS, member, str(owner.name))


def _networkd(interface: Interface) -> Iterator[Problem]:
    if interface.kind == "modems":
        yield Problem(PlanCode.NETWORKD_LACKS, interface.name, "networkd does not support modems")
    if interface.is_wifi:
        match = interface.key("match")
        if match is not None:
            yield Problem(PlanCode.NETWORKD_LACKS, match, "networkd matches Wi-Fi by interface name only")
        for point in interface.access_points:
            if point.mode == "ap":
                yield Problem(PlanCode.NETWORKD_LACKS, point.mode, "networkd cannot create an access point")
            yield from _passphrase(point.password, point.key_management, point.auth)
    yield from _tunnel_keys(interface, KEYED_TUNNELS)
    mode = interface.value("mode")
    if mode is not None and mode == "isatap" and interface.kind == "tunnels":
        yield Problem(PlanCode.NETWORKD_LACKS, mode, "networkd does not support ISATAP tunnels")
    if interface.dhcp4 and interface.dhcp6:
        for key in OVERRIDES:
            one, other = interface.value("dhcp4-overrides", key), interface.value("dhcp6-overrides", key)
            where = one or other
            if where is not None and _setting(one, key) != _setting(other, key):
                yield Problem(
                    PlanCode.DIFFERENT_OVERRIDES, where, f"networkd needs the same {key} for DHCPv4 and DHCPv6"
                )


def _tunnel_keys(interface: Interface, keyed: frozenset[str]) -> Iterator[Problem]:
    mode = str(interface.value("mode") or "")
    if interface.kind != "tunnels" or not mode or mode in keyed:
        return
    for key in ("key", "keys"):
        where = interface.key(key)
        paths = ((key,), (key, "input"), (key, "output"))
        if where is not None and any(interface.value(*path) is not None for path in paths):
            networkd = interface.backend == "networkd"
            code = PlanCode.NETWORKD_LACKS if networkd else PlanCode.NETWORK_MANAGER_LACKS
            yield Problem(code, where, f"{interface.backend} does not accept a key for a tunnel of mode {mode}")


def _setting(text: Located | None, key: str) -> object:
    """An override as netplan compares it: booleans default to true, words and numbers to nothing."""
    if key in ("hostname", "use-domains", "route-metric"):
        return None if text is None else str(text)
    return text is None or text.lower() in ("true", "on", "yes", "y")


def _passphrase(password: Scalar | None, management: Located | None, auth: Mapping | None) -> Iterator[Problem]:
    """The length of a WPA passphrase, which netplan checks when networkd starts wpa_supplicant."""
    if auth is not None:
        inner = auth.scalar("password")
        if inner is not None and str(management) == "psk":
            password = inner
        elif management is not None:
            return
    if password is None:
        return
    length = len(password.value.encode())
    if length == 64 and not HEX_KEY.match(password.value):
        yield Problem(PlanCode.PASSPHRASE, password.value, "64 characters that are not hexadecimal digits")
    elif length != 64 and not 8 <= length <= 63:
        yield Problem(PlanCode.PASSPHRASE, password.value, f"{length} characters")


def _network_manager(interface: Interface) -> Iterator[Problem]:
    driver = interface.key("match", "driver")
    if driver is not None and interface.set_name is None:
        yield Problem(PlanCode.NETWORK_MANAGER_LACKS, driver, "NetworkManager cannot match by driver")
    yield from _tunnel_keys(interface, KEYED_TUNNELS - {"vti", "vti6"})
    off = interface.value("activation-mode")
    if off is not None and off != "manual":
        yield Problem(PlanCode.NETWORK_MANAGER_LACKS, off, f"NetworkManager does not support activation-mode {off}")
    if (mtu := interface.key("ipv6-mtu")) is not None:
        yield Problem(PlanCode.NETWORK_MANAGER_LACKS, mtu, "NetworkManager does not support ipv6-mtu")
    for item in interface.items("addresses"):
        if isinstance(item, Mapping):
            yield Problem(
                PlanCode.NETWORK_MANAGER_LACKS, item.span, "NetworkManager does not support options for addresses"
            )
    for route in interface.routes:
        kind = route.value("type")
        if kind is not None and kind.lower() != "unicast":
            yield Problem(PlanCode.NETWORK_MANAGER_LACKS, kind, "NetworkManager supports unicast routes only")


Check = Callable[[Interface], Iterator[Problem]]
COMMON: tuple[Check, ...] = (_set_name, _routes, _tokens)
BY_KIND: dict[str, tuple[Check, ...]] = {
    "wifis": (_duplicate_ssids, _wifi),
    "vlans": (_vlan,),
    "vrfs": (_vrf,),
    "tunnels": (_tunnel,),
    "nm-devices": (_passthrough,),
}
BACKENDS: dict[str, Check] = {"networkd": _networkd, "NetworkManager": _network_manager}
