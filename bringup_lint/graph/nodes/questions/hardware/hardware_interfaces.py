"""Sources of ros2_control hardware that jump at activation, or stop the loop of the controller manager."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros import simulation
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_text import end_of_block
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.sockets import KNOWN_CALLS
from bringup_lint.parsers.cpp_node.sockets import OPENS
from bringup_lint.parsers.cpp_node.sockets import WAITS_NOT
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_HARDWARE = regex(r"\b(?:System|Actuator)Interface\b")
_METHOD = regex(
    r"\b(?:\w{1,80}::)?(?P<name>on_(?:activate|deactivate|cleanup|shutdown)|export_command_interfaces|read|write)\s{0,4}\([^;{}()]{0,300}\)"
    r"(?:\s{0,4}(?:override|noexcept|const|final)){0,3}\s{0,40}\{(?P<body>)"
)
_ZERO = regex(r"0(?:\.0*)?f?\s*\Z")
_SUCCEEDS = regex(r"\breturn\b[^;]{0,80}\bOK\s{0,4};")
_POSITION = regex(r"(?:HW_IF_POSITION|\"position\")\s{0,4},\s{0,40}&\s{0,4}(?P<member>[A-Za-z_]\w{0,80})")
_SLOWED = regex(
    r"(?i)profile_?vel|max_?vel|vel(?:ocity)?_?limit|\bramp|interpolat|is_?first|first_|isnan|initial|homing|home"
    r"|set_?zero|calibrat|perform_command_mode_switch"
)
"""Words of what starts slowly, waits for the first command or for a controller, or makes 0 the place of the joints."""
LOG = regex(r"\bRCLCPP_\w{3,40}\s{0,4}\([^;]{0,600};")
SIMULATED = regex(rf"(?i){simulation.TOLD}|\bfake|\bmock")
_RECEIVES = regex(
    r"(?<![\w.>])(?:::)?(?P<name>read|recv|recvfrom|recvmsg)\s{0,4}\(\s{0,4}\w{0,40}(?:sock|fd|can|port|serial|bus)"
)


class ZeroedCommand(NamedTuple):
    source: Source
    place: Span
    """The assignment in ``on_activate``, or where the command is made."""
    member: str
    exported: Span
    """Where it is exported as a position command."""


class BlockingRead(NamedTuple):
    source: Source
    place: Span
    call: str
    opened: Span


def zeroed_commands(nodes: Nodes) -> Iterator[ZeroedCommand]:
    """Position commands that the activation sets to 0, or leaves there, wherever the joints are."""
    for source, plain, bodies in hardware(nodes):
        exported = bodies.get("export_command_interfaces")
        body = bodies.get("on_activate")
        found = _POSITION.search(plain, *exported) if exported is not None else None
        if found is None or body is None or _SLOWED.search(LOG.sub(" ", plain)) or SIMULATED.search(plain):
            continue
        place = _zeroed(plain, body, found["member"]) or _made_zero(plain, body, found["member"])
        if place is not None and _is_sent_as_it_is(plain, bodies, found["member"]):
            span = Span(source, found.start("member"), found.end("member"))
            yield ZeroedCommand(source, Span(source, *place), found["member"], span)


def _zeroed(plain: str, body: tuple[int, int], member: str) -> tuple[int, int] | None:
    """Where a body sets a member to 0, when it gives it no other value."""
    name = re.escape(member)
    zero = re.compile(
        rf"\b{name}\s{{0,4}}\[[^\]]{{1,40}}\]\s{{0,4}}=\s{{0,4}}0(?:\.0*)?f?\s{{0,4}};"
        rf"|\b{name}\s{{0,4}}\.\s{{0,4}}assign\s{{0,4}}\([^;]{{1,80}},\s{{0,4}}0(?:\.0*)?f?\s{{0,4}}\)"
        rf"|\bfill\s{{0,4}}\(\s{{0,4}}{name}\s{{0,4}}\.\s{{0,4}}begin[^;]{{1,80}},\s{{0,4}}0(?:\.0*)?f?\s{{0,4}}\)"
    )
    found = list(zero.finditer(plain, *body))
    named = len(re.compile(rf"\b{name}\b(?!\s{{0,4}}\.\s{{0,4}}(?:size|end)\b)").findall(plain, *body))
    return found[0].span() if len(found) == 1 and named == 1 else None


def _made_zero(plain: str, body: tuple[int, int], member: str) -> tuple[int, int] | None:
    """Where a member is made as 0, when ``on_activate`` does not name it, and nothing else in the source makes it."""
    name = re.escape(member)
    made = re.compile(
        rf"\b{name}\s{{0,4}}\.\s{{0,4}}(?:resize|assign)\s{{0,4}}\((?:[^;]{{1,80}},\s{{0,4}}(?P<value>[^;,]{{1,40}}))?\)"
    )
    found = list(made.finditer(plain))
    if len(found) != 1 or re.compile(rf"\b{name}\b").search(plain, *body) is not None:
        return None
    return found[0].span() if _ZERO.match(found[0]["value"] or "") else None


def _is_sent_as_it_is(plain: str, bodies: dict[str, tuple[int, int]], member: str) -> bool:
    """Whether ``write()`` sends a command whatever it is, and nothing else in the source gives it a value; not where
    ``read()`` makes the states of the commands, as simulations do."""
    if "write" not in bodies or "read" not in bodies:
        return False
    name = rf"\b{re.escape(member)}\b(?:\s{{0,4}}\[[^\]\n]{{1,40}}\])?"
    given = re.compile(rf"{name}\s{{0,4}}=(?!=)(?!\s{{0,4}}0(?:\.0*)?f?\s{{0,4}};|\s{{0,4}}[\w:<> ]{{0,60}}NaN)")
    filled = re.compile(rf"\b(?:copy|copy_n|transform|swap)\s{{0,4}}\([^;]{{0,200}}{name}")
    compared = re.compile(rf"{name}\s{{0,4}}[!=]=|[!=]=\s{{0,4}}{name}|\bf?abs\s{{0,4}}\([^;]{{0,120}}{name}")
    written = plain[slice(*bodies["write"])]
    return (
        not any(pattern.search(plain) for pattern in (given, filled))
        and re.search(name, written) is not None
        and not compared.search(written)
        and len(_SUCCEEDS.findall(written)) < 2
        and re.search(name, plain[slice(*bodies["read"])]) is None
    )


def blocking_reads(nodes: Nodes) -> Iterator[BlockingRead]:
    """Reads of a socket in ``read()`` that wait until a packet arrives, as nothing in the sources says otherwise."""
    for source, plain, bodies in hardware(nodes):
        body = bodies.get("read")
        found = _RECEIVES.search(plain, *body) if body is not None else None
        if found is None or WAITS_NOT.search(with_header(nodes, source)):
            continue
        opened = OPENS.search(plain)
        if opened is not None and not _is_handed_on(plain, opened["kept"]):
            place = Span(source, found.start("name"), found.end("name"))
            yield BlockingRead(source, place, found["name"], Span(source, *opened.span("call")))


def _is_handed_on(plain: str, kept: str) -> bool:
    """Whether a socket is given to a function of the project, which may set a time-out or wait with one."""
    call = re.compile(
        rf"\b(?P<name>\w{{1,80}})\s{{0,4}}\((?:[^;(){{}}]{{0,200}},)?\s{{0,40}}&?{re.escape(kept)}\s{{0,4}}[,)]"
    )
    return any(found["name"] not in KNOWN_CALLS for found in call.finditer(plain))


def hardware(nodes: Nodes) -> Iterator[tuple[Source, str, dict[str, tuple[int, int]]]]:
    """The sources that define hardware: their text without comments, and where the bodies of their methods are."""
    for each in nodes.cpp:
        text = each.source.text
        if "hardware_interface" in text and _HARDWARE.search(text):
            yield each.source, *_read(each.source)


def _read(source: Source) -> tuple[str, dict[str, tuple[int, int]]]:
    def read() -> tuple[str, dict[str, tuple[int, int]]]:
        plain = plain_of(source)
        return plain, _bodies(plain)

    return source.once(_read, read)


def _bodies(plain: str) -> dict[str, tuple[int, int]]:
    """Method -> where its body starts and ends; none of those that are defined several times."""
    found: dict[str, list[int]] = {}
    for match in _METHOD.finditer(plain):
        found.setdefault(match["name"], []).append(match.start("body"))
    return {name: (starts[0], end_of_block(plain, starts[0])) for name, starts in found.items() if len(starts) == 1}
