"""DDS files as nodes: who selects them, and the interfaces that they bind."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dds import network
from bringup_lint.graph.dds.cyclonedds_discovery import is_loopback_interface
from bringup_lint.graph.edges.netplan import interface_node
from bringup_lint.graph.edges.networkmanager import profile_interface
from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.fastdds import Profiles
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.dds.dds import Dds
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.places import Places
    from bringup_lint.model.netplan import Netplan
    from bringup_lint.model.netplan import Plan

URI = "CYCLONEDDS_URI"
PROFILES = ("FASTDDS_DEFAULT_PROFILES_FILE", "FASTRTPS_DEFAULT_PROFILES_FILE")
_INSIDE_CONTAINERS = ("compose", "dockerfile")


def dds_places(files: Files) -> Iterator[tuple[Node, Span]]:
    for source in files.of_kind("cyclonedds", "fastdds"):
        yield file_node("dds-file", source), file_place(source)


def selection_edges(tree: Tree, dds: Dds, ros: RosEnvironment, places: Places) -> Iterator[Edge]:
    """``selects``, from whatever holds the line that sets the variable."""
    for selection in dds.selections:
        for source in selection.files:
            yield from _selects(places, selection.uri, file_node("dds-file", source), URI)
    for profiles in dds.profile_files:
        for _, value in dds.profile_readers(profiles):
            if value.span.source.kind in _INSIDE_CONTAINERS:
                yield from _selects(places, value, file_node("dds-file", profiles.source), "profiles file")
    for setting in ros.of(URI, *PROFILES):
        if setting.value.span.source.kind not in _INSIDE_CONTAINERS:
            for path in _paths(setting.name, setting.value):
                found = tree.find(path)
                target = file_node("dds-file", found) if found else Node("dds-file", path)
                yield from _selects(places, setting.value, target, setting.name)


def _paths(name: str, value: Located) -> Iterator[str]:
    texts = [part.text for part in split_uri(value) if not part.inline] if name == URI else [value]
    yield from (str(text) for text in texts if text.startswith("/") and is_plain(text))


def _selects(places: Places, value: Located, target: Node, why: str) -> Iterator[Edge]:
    for holder in places.of(value.span):
        yield Edge("selects", holder, target, value.span, why)


def binding_edges(
    dds: Dds, netplan: Callable[[], Netplan], networkmanager: Callable[[], NetworkManager], places: Places
) -> Iterator[Edge]:
    """``binds``, from a DDS configuration to the interfaces that it names."""

    def interface(file: Configuration | Profiles, name: str) -> Node:
        plan = dds.plan_of(file)
        if plan is not None:
            return _of_plan(plan, netplan(), name)
        own = _of_profiles(networkmanager(), file, name) if dds.in_use(file) else None
        return own or Node("interface", name, file.source.name)

    for configuration, domain in dds.domains:
        for setting in network.named_interfaces(domain):
            target = interface(configuration, str(setting.effective))
            for holder in _holders(places, configuration.source, setting.value.span):
                yield Edge("binds", holder, target, setting.value.span, str(setting.name))
    for profiles in dds.profile_files:
        for element in profiles.document.elements:
            if element.parent is not None and element.parent.name == "interfaceWhiteList" and _is_shown(element.text):
                target = interface(profiles, str(element.text))
                where = element.text.span
                yield Edge("binds", file_node("dds-file", profiles.source), target, where, "interfaceWhiteList")


def _is_shown(name: str) -> bool:
    return bool(name.strip()) and not is_loopback_interface(name)


def _holders(places: Places, source: Source, where: Span) -> list[Node]:
    return [file_node("dds-file", source)] if source.kind == "cyclonedds" else places.of(where)


def _of_plan(plan: Plan, netplan: Netplan, name: str) -> Node:
    """The interface of a netplan by its name or static address; else the bare name."""
    interface = plan.by_name_or_address.get(name)
    return Node("interface", name) if interface is None else interface_node(interface, plan, netplan)


def _of_profiles(manager: NetworkManager, file: Configuration | Profiles, name: str) -> Node | None:
    """The interface of the only folder of profiles, below the same root, by its name or static address."""
    from bringup_lint.model.netplan import root_of

    if file.source.robot_path is None or len(manager.folders) != 1:
        return None
    for profile in manager.folders[0]:
        addresses = [str(each.ip.ip) for each in profile.addresses]
        if profile.interface is None or root_of(profile.source) != root_of(file.source):
            continue
        if name == profile.interface or name in addresses:
            return profile_interface(manager, profile, str(profile.interface))
    return None
