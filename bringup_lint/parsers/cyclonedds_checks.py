"""What Cyclone DDS refuses although every single value is fine: settings that contradict each other.

``ddsi_config_init`` (interfaces, transport), ``rtps_config_prep`` (ports, watermarks) and the thread start
of the library.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.addresses import HIGHEST_PORT
from bringup_lint.addresses import parse_address
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Element
from bringup_lint.parsers.cyclonedds_values import size

INTERFACE = "General/Interfaces/NetworkInterface"


def check(domain: Domain, version: str) -> Iterator[Remark]:
    """The contradictions of one Domain block. Values that depend on the environment are left alone."""
    if version not in ("0.7", "0.8"):
        yield from _interfaces(domain)
        yield from _mixed_interfaces(domain)
    yield from _watermarks(domain)
    yield from _transport(domain)
    yield from _ports(domain)
    yield from _priorities(domain)
    yield from _multicast_addresses(domain)


def _interfaces(domain: Domain) -> Iterator[Remark]:
    for element in domain.found(INTERFACE):
        name = domain.of(element, "name")
        address = domain.of(element, "address")
        automatic = domain.of(element, "autodetermine")
        held = [each for each in (name, address) if each is not None and each.effective != ""]
        if automatic is not None and automatic.effective is None:
            continue
        if _word(automatic, "false") == "true":
            for each in held[:1]:
                if each.effective is not None:
                    yield Remark(Code.AUTODETERMINED, each.value, each.effective, item=each.item)
        elif not held:
            yield Remark(Code.ANONYMOUS, element.name)


def interfaces_twice(domains: list[Domain]) -> None:
    """Name the same interface twice, also in several blocks that count for every domain."""
    seen: set[str] = set()
    for domain in domains:
        names = seen if domain.applies_to_any else set()
        for setting in domain.all(f"{INTERFACE}@name"):
            if setting.effective and setting.effective in names:
                domain.remarks.append(Remark(Code.INTERFACE_TWICE, setting.value, setting.effective, item=setting.item))
            names.add(setting.effective or "")


def _mixed_interfaces(domain: Domain) -> Iterator[Remark]:
    old = [
        each
        for path, idle in (
            ("General/NetworkInterfaceAddress", "auto"),
            ("General/PreferMulticast", "false"),
            ("Internal/AssumeMulticastCapable", ""),
        )
        for each in domain.all(path)
        if each.effective is not None and each.effective.lower() != idle
    ]
    interfaces = domain.found(INTERFACE)
    for each in old:
        if interfaces:
            yield Remark(Code.MIXED_INTERFACES, each.name, interfaces[0].name, item=each.item)
        elif each.item.name == "AssumeMulticastCapable" and not _is_pattern(each.effective or ""):
            yield Remark(Code.MIXED_INTERFACES, each.name, "", item=each.item)


def _is_pattern(text: str) -> bool:
    return text != "*" and ("*" in text or "?" in text)


def _watermarks(domain: Domain) -> Iterator[Remark]:
    low = _size(domain, "WhcLow", 1 << 10)
    high = _size(domain, "WhcHigh", 500 << 10)
    initial = _size(domain, "WhcHighInit", 30 << 10)
    if low is None or high is None or initial is None or (high >= low and low <= initial <= high):
        return
    written = [each for each in domain.settings if "/Watermarks/Whc" in each.path and each.item.type == "memsize"]
    detail = f"WhcLow {low} B, WhcHighInit {initial} B, WhcHigh {high} B"
    yield Remark(Code.WATERMARKS, written[-1].value, detail, item=written[-1].item)


def _size(domain: Domain, name: str, default: int) -> int | None:
    setting = domain.get(f"Internal/Watermarks/{name}")
    if setting is None:
        return default
    if setting.effective is not None and setting.effective.lower() == "default":
        low = domain.get("Internal/Watermarks/WhcLow")
        return 1 << 10 if low is None else size(low.effective or "")
    return None if setting.effective is None else size(setting.effective)


def _transport(domain: Domain) -> Iterator[Remark]:
    chosen = domain.get("General/Transport")
    transport = _word(chosen, "default")
    tcp = _word(domain.get("TCP/Enable"), "default")
    ipv6 = _word(domain.get("General/UseIPv6"), "default")
    wanted = {
        "tcp": ("true", "false"),
        "tcp6": ("true", "true"),
        "udp": ("false", "false"),
        "udp6": ("false", "true"),
    }
    expected = wanted.get(transport, ("false", "false"))
    if transport in ("default", "") or chosen is None:
        return
    if any(value in ("true", "false") and value != want for value, want in zip((tcp, ipv6), expected, strict=True)):
        if transport in ("raweth", "none") and "true" not in (tcp, ipv6):
            return
        yield Remark(Code.TRANSPORT, chosen.value, f"TCP/Enable {tcp}, UseIPv6 {ipv6}", item=chosen.item)


def _word(setting: Setting | None, default: str) -> str:
    """The value in lower case; empty when it depends on the environment."""
    if setting is None:
        return default
    return "" if setting.effective is None else setting.effective.lower()


PORT_DEFAULTS = {
    "Base": 7400,
    "DomainGain": 250,
    "ParticipantGain": 2,
    "MulticastMetaOffset": 0,
    "UnicastMetaOffset": 10,
    "MulticastDataOffset": 1,
    "UnicastDataOffset": 11,
}


def port_numbers(domain: Domain) -> dict[str, int] | None:
    """The parameters of the port formula; None when one depends on the environment or is not a number."""
    numbers = dict(PORT_DEFAULTS)
    for name in numbers:
        setting = domain.get(f"Discovery/Ports/{name}")
        if setting is not None:
            if setting.effective is None or not re.fullmatch(r"\+?[0-9]{1,10}", setting.effective):
                return None
            numbers[name] = int(setting.effective)
    return numbers


def _ports(domain: Domain) -> Iterator[Remark]:
    """The ports of domain 0, or of the domain that the block or ExternalDomainId names."""
    numbers = port_numbers(domain)
    external = domain.get("Discovery/ExternalDomainId")
    text = external.effective if external else str(domain.id or "any")
    if numbers is None or text is None:
        return
    stated = text.strip(" \t\r\n")
    number = int(stated) & 0xFFFFFFFF if re.fullmatch(r"[+-]?[0-9]{1,10}", stated) else 0
    base = numbers["Base"] + numbers["DomainGain"] * number
    ports = [base + numbers["MulticastMetaOffset"], base + numbers["MulticastDataOffset"]]
    index = domain.get("Discovery/ParticipantIndex")
    if index is not None and re.fullmatch(r"[0-9]{1,9}", index.effective or ""):
        unicast = base + numbers["ParticipantGain"] * int(index.effective or "")
        ports += [unicast + numbers["UnicastMetaOffset"], unicast + numbers["UnicastDataOffset"]]
    written = [each for each in domain.settings if "/Discovery/Ports/" in each.path]
    where = external or (written[-1] if written else index)
    if where is not None and (max(ports) > HIGHEST_PORT or min(ports) < 1):
        detail = f"domain {number} would use the ports {min(ports)} to {max(ports)}"
        yield Remark(Code.PORTS, where.value, detail, item=where.item)


def _priorities(domain: Domain) -> Iterator[Remark]:
    """A priority without a scheduling class makes the thread start abort the process."""
    for thread in domain.found("Threads/Thread"):
        inside = [each for each in domain.settings if _below(each, thread)]
        priority = next((each for each in inside if each.item.name == "Priority"), None)
        kind = next((each for each in inside if each.item.name == "Class"), None)
        if (
            priority is None
            or _word(priority, "default") in ("default", "0", "")
            or _word(kind, "default") != "default"
        ):
            continue
        number = priority.effective or ""
        if re.fullmatch(r"[+-]?[0-9]{1,18}", number) and int(number) & 0xFFFFFFFF:
            yield Remark(Code.PRIORITY, priority.value, priority.effective or "", item=priority.item)


def _below(setting: Setting, ancestor: object) -> bool:
    element: Element | None = setting.owner
    while element is not None and element is not ancestor:
        element = element.parent
    return element is ancestor


def _multicast_addresses(domain: Domain) -> Iterator[Remark]:
    for path in ("Discovery/SPDPMulticastAddress", "Discovery/DefaultMulticastAddress"):
        for setting in domain.all(path):
            address = parse_address(setting.effective or "auto")
            if address is None or address.version != 4:
                continue
            if not address.is_multicast and not address.is_unspecified:
                yield Remark(Code.ADDRESS, setting.value, str(address), item=setting.item)
