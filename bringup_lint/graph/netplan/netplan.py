"""Netplan's merge: which files it reads together, in which order, and what they make of each interface."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.netplan.checks import check_definitions
from bringup_lint.graph.netplan.checks import check_plan
from bringup_lint.model.netplan import Definition
from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import Netplan
from bringup_lint.model.netplan import NetplanFile
from bringup_lint.model.netplan import Plan
from bringup_lint.model.netplan import PlanCode
from bringup_lint.parsers.netplan import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

FOLDERS = ("run", "etc", "lib", "usr/lib")
"""Where netplan looks, the folder that wins first."""
PLACE = regex(r"(?P<root>(?:.*/)?)(?P<folder>etc|run|usr/lib|lib)/netplan/(?P<file>[^/]+)\Z")


def load_netplan(files: Files) -> Netplan:
    """All plans of a tree: one for each set of netplan folders, one for every file elsewhere."""
    return assemble(files.parsed(parse, files.of_kind("netplan", "cloud-init-network")))


def assemble(files: Iterable[NetplanFile]) -> Netplan:
    netplan = Netplan()
    folders: dict[str, dict[str, list[tuple[int, NetplanFile]]]] = {}
    for file in files:
        place = PLACE.match(f"/{file.source.name}") or PLACE.match(file.source.robot_path or "")
        if place is None or file.embedded:
            netplan.plans.append(merge([file]))
            continue
        rank = FOLDERS.index(place["folder"])
        folders.setdefault(place["root"], {}).setdefault(place["file"], []).append((rank, file))
    for named in folders.values():
        ordered = []
        for name in sorted(named):
            first, *hidden = sorted(named[name], key=lambda pair: pair[0])
            netplan.shadowed.extend((file, first[1]) for _, file in hidden)
            if name.endswith(".yaml"):
                ordered.append(first[1])
            else:
                netplan.unread.append(first[1].source)
        if ordered:
            netplan.plans.append(merge(ordered, whole=True))
    return netplan


def merge(files: list[NetplanFile], *, whole: bool = False) -> Plan:
    """Read the files one after the other, as netplan does; a file sees what it and those before it define."""
    plan = Plan(files, whole=whole)
    known: dict[str, Located] = {}
    for file in files:
        plan.renderer = file.renderer or plan.renderer
        for definition in file.definitions:
            known.setdefault(str(definition.name), definition.name)
            _add(plan, definition)
        known.update((str(port), port) for port in file.ports)
        plan.problems.extend(_undefined(plan, file, known, files))
        check_definitions(plan, file)
    for interface in plan.interfaces.values():
        interface.renderer = _renderer(interface) or plan.renderer
    check_plan(plan)
    unread = [file for file in files if file.source.template or not file.yaml.complete]
    if unread:
        plan.problems[:] = _certain(plan, unread)
    return plan


def _certain(plan: Plan, unread: list[NetplanFile]) -> list[Problem]:
    """The problems that files which could not be read cannot solve: they do not even name the interface."""
    texts = [file.source.text for file in unread]
    own = {
        interface.key("set-name"): name
        for name, interface in plan.interfaces.items()
        if interface.set_name is not None and not any(name in text for text in texts)
    }
    sources = {file.source for file in unread}
    return [
        problem
        for problem in plan.problems
        if problem.code == PlanCode.SET_NAME and problem.where in own and problem.where.span.source not in sources
    ]


def _add(plan: Plan, definition: Definition) -> None:
    interface = plan.interfaces.get(str(definition.name))
    if interface is None:
        plan.interfaces[str(definition.name)] = Interface(definition.kind, [definition])
    elif interface.kind != definition.kind:
        plan.problems.append(Problem(PlanCode.TYPE_CHANGED, definition.name, interface.kind))
    else:
        interface.definitions.append(definition)


def _renderer(interface: Interface) -> Located | None:
    own = interface.value("renderer")
    if own == "sriov":
        own = None
    return own or interface.definitions[0].renderer


def references(interface: Interface) -> Iterator[tuple[str, Located]]:
    """Every name of another interface, with the key that names it."""
    for key in ("link", "peer"):
        if (name := interface.value(key)) is not None:
            yield key, name
    if (primary := interface.value("parameters", "primary")) is not None:
        yield "primary", primary
    yield from (("interfaces", member) for member in interface.members)
    for key in ("path-cost", "port-priority"):
        for _, ports in interface.entries("parameters", key):
            yield from ((key, port.value) for port, _ in getattr(ports, "entries", ()))


def _undefined(plan: Plan, file: NetplanFile, known: dict[str, Located], files: list[NetplanFile]) -> Iterator[Problem]:
    """Names that neither this file nor one before it defines; the detail is a later file that does."""
    later = {
        str(definition.name): other.source.name
        for other in files[files.index(file) + 1 :]
        for definition in other.definitions
    }
    for name in dict.fromkeys(str(definition.name) for definition in file.definitions):
        interface = plan.interfaces[name]
        for key, reference in references(interface):
            if reference not in known and reference.span.source is file.source:
                vlan = interface.kind == "vlans" and key == "link"
                if key in ("link", "peer") and (_renderer(interface) or plan.renderer) == "NetworkManager":
                    continue
                yield Problem(
                    PlanCode.VLAN_LINK if vlan else PlanCode.UNDEFINED, reference, later.get(str(reference), "")
                )
