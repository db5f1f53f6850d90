"""Profiles of NetworkManager in the graph: the interfaces that they configure, and what these are built on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.model.networkmanager import Profile
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.networkmanager.profiles import NetworkManager

KIND = "networkmanager-profile"


def profile_edges(manager: NetworkManager) -> Iterator[Edge]:
    """``configured-by`` to profiles, and ``built-on`` from bridges, bonds and VLANs to their parts."""
    for folder in manager.folders:
        by_name = {name: profile for profile in folder for name in _names(profile)}
        for profile in folder:
            name = profile.interface
            if not profile.source.judged or name is None or not is_plain(name):
                continue
            here = profile_interface(manager, profile, str(name))
            yield Edge("configured-by", here, file_node(KIND, profile.source), name.span, f"[{profile.type}]")
            parent = profile.get("vlan", "parent") if profile.type == "vlan" else None
            if parent is not None:
                yield Edge("built-on", here, _named(manager, by_name, profile, parent), parent.span, "parent=")
            controller = profile.get("connection", "controller") or profile.get("connection", "master")
            if controller is not None:
                upper = _named(manager, by_name, profile, controller)
                yield Edge("built-on", upper, here, controller.span, "controller=")


def profile_places(manager: NetworkManager) -> Iterator[tuple[Node, Span]]:
    for profile in manager.judged:
        yield file_node(KIND, profile.source), file_place(profile.source)


def profile_interface(manager: NetworkManager, profile: Profile, name: str) -> Node:
    """An interface of the robot that a profile is for."""
    folder = profile.source.name.rpartition("/")[0]
    return Node("interface", name, "" if len(manager.folders) == 1 else folder)


def _named(manager: NetworkManager, by_name: dict[str, Profile], profile: Profile, word: Located) -> Node:
    """The interface that a profile names by its own name, or by the UUID or the id of the profile for it."""
    other = by_name.get(str(word))
    name = other.interface if other is not None else None
    return profile_interface(manager, profile, str(name or word))


def _names(profile: Profile) -> Iterator[str]:
    for key in ("uuid", "id"):
        text = profile.get("connection", key)
        if text is not None:
            yield str(text)
