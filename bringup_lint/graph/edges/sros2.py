"""Keystores and enclaves as nodes: who uses them, and the permissions and governance that they hold."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import display_name
from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.sros2.keystore import Keystore
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.places import Places
    from bringup_lint.graph.sros2.sros2 import Sros2

_DOCUMENTS = ("sros2-governance", "sros2-permissions")


def keystore_edges(files: Files, sros2: Sros2, ros: RosEnvironment, places: Places) -> Iterator[Edge]:
    """``selects`` keystores by variable, ``holds`` their enclaves, ``secures`` what selects one."""
    for keystore in sros2.keystores:
        for enclave in keystore.enclaves.values():
            where = next((source.whole for source in _inside(files, enclave.folder)), None)
            yield Edge("holds", _keystore_node(keystore), _enclave(sros2, enclave.path, keystore), where, "enclaves/")
    for setting in ros.of("ROS_SECURITY_KEYSTORE"):
        if setting.value.startswith("/") and setting.value.span.source.kind not in ("compose", "dockerfile"):
            target = _keystore_at(files, sros2, str(setting.value).rstrip("/"))
            for holder in places.of(setting.value.span):
                yield Edge("selects", holder, target, setting.value.span, setting.name)
    for name in sros2.selected:
        for holder in places.of(name.span):
            yield Edge("secures", holder, _enclave(sros2, str(name), _only(sros2)), name.span, "enclave")


def document_edges(sros2: Sros2) -> Iterator[Edge]:
    """``grants`` from enclaves to permissions, ``governed-by`` from keystores to their governance."""
    for permissions, grant in sros2.ros_grants:
        keystore = next((each for each in sros2.keystores if _lies_in(permissions.source, each)), None)
        if keystore is None and sros2.keystores:
            continue
        if grant.enclave is None:
            continue
        enclave = _enclave(sros2, str(grant.enclave), keystore)
        yield Edge("grants", enclave, file_node("permissions-file", permissions.source), grant.enclave.span, "grant")
    for governance in sros2.used_governances:
        for keystore in sros2.keystores:
            if _lies_in(governance.source, keystore):
                target = file_node("governance-file", governance.source)
                yield Edge("governed-by", _keystore_node(keystore), target, governance.source.whole, "governance")


def security_places(files: Files, sros2: Sros2) -> Iterator[tuple[Node, Span]]:
    for keystore in sros2.keystores:
        inside = [source for source in files.sources if source.judged and _lies_in(source, keystore)]
        inside.sort(key=lambda source: source.kind in _DOCUMENTS)
        for at, source in enumerate(inside):
            if source.kind not in _DOCUMENTS or at == 0:
                yield _keystore_node(keystore), source.whole if source.kind in _DOCUMENTS else file_place(source)
    for permissions in sros2.permissions:
        if sros2.is_used(permissions.source):
            yield file_node("permissions-file", permissions.source), file_place(permissions.source)
    for governance in sros2.used_governances:
        yield file_node("governance-file", governance.source), file_place(governance.source)


def _keystore_node(keystore: Keystore) -> Node:
    return Node("keystore", keystore.name)


def _keystore_at(files: Files, sros2: Sros2, path: str) -> Node:
    """The keystore of the tree at a path on the robot, else one by that path."""
    for keystore in sros2.keystores:
        if files.tree.robot_path(keystore.folder) == path:
            return _keystore_node(keystore)
    return Node("keystore", path)


def _only(sros2: Sros2) -> Keystore | None:
    keystores = sros2.keystores
    return keystores[0] if len(keystores) == 1 else None


def _enclave(sros2: Sros2, path: str, keystore: Keystore | None) -> Node:
    """An enclave; which of several keystores it lies in has to be known."""
    several = len(sros2.keystores) > 1
    return Node("enclave", path, keystore.name if several and keystore else "")


def _lies_in(source: Source, keystore: Keystore) -> bool:
    return source.name.startswith(f"{keystore.name}/")


def _inside(files: Files, folder: str) -> Iterator[Source]:
    name = display_name(folder)
    return (source for source in files.sources if source.name.rpartition("/")[0] == name)
