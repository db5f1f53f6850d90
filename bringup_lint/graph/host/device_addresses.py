"""Addresses of devices that drivers are given, compared with those that the robot gives itself."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.netplan.netplan import Netplan
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.params.params import Params

_OF_DEVICE = regex(r"(?:(?:sensor|lidar|laser|scanner|device|camera)_(?:ip|ip_addr(?:ess)?|host(?:name)?))\Z")
_OF_DRIVER = regex(r"urg_node2?|sick_\w+|pf_driver")
"""Nodes and packages whose ``ip_address`` is that of the sensor; those of others may be what they listen on."""
_ADDRESS = regex(r"(?:[0-9]{1,3}\.){3}[0-9]{1,3}\Z")


class OwnAddress(NamedTuple):
    given: Located
    """What the driver is told to connect to."""
    name: str
    own: Located
    """Where the robot gets the address."""


def own_addresses(
    params: Params, launch: Launch, netplan: Netplan, networkmanager: NetworkManager
) -> Iterator[OwnAddress]:
    """Devices at an address that the robot itself has."""
    own = {str(text).partition("/")[0]: text for text in _of_host(netplan, networkmanager)}
    if not own:
        return
    for name, value in chain(_of_files(params), _of_launch(launch)):
        if str(value) in own:
            yield OwnAddress(value, name, own[str(value)])


def _of_host(netplan: Netplan, networkmanager: NetworkManager) -> Iterator[Located]:
    for _, address in networkmanager.addresses:
        yield address.text
    plan = netplan.only_plan
    if plan is not None and not plan.has_templates:
        for interface in plan.interfaces.values():
            yield from (address.text for address in interface.addresses)


def _of_files(params: Params) -> Iterator[tuple[str, Located]]:
    for file, each in params.parameters:
        name, text = str(each.name).rpartition(".")[2], each.value.data
        node = str(each.block.key).rpartition("/")[2]
        if isinstance(text, str) and _is_of_device(name, node) and _ADDRESS.match(text) and params.is_used(file):
            yield name, Located(text, each.span)


def _is_of_device(parameter: str, driver: str) -> bool:
    if parameter == "ip_address":
        return _OF_DRIVER.fullmatch(driver) is not None
    return _OF_DEVICE.match(parameter) is not None


def _of_launch(launch: Launch) -> Iterator[tuple[str, Located]]:
    for node in launch.nodes:
        if not node.file.source.judged:
            continue
        for key, value in node.given:
            text = literal_text(value.value if isinstance(value, TypedValue) else value)
            name = text_of(key) or ""
            package = str(literal_text(node.package))
            if text is not None and _is_of_device(name, package) and _ADDRESS.match(text):
                yield name, text
