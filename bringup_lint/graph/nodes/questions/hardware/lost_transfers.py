"""Transfers on an I2C bus that a node makes outside every ``try``, so that one that fails ends it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import OF_SYSTEM
from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import is_restarted
from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import threads
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.drivers import driver_of
from bringup_lint.graph.nodes.sources.drivers import first_uncaught
from bringup_lint.graph.nodes.sources.drivers import made_of
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_IMPORTED = regex(r"^[ \t]*(?:import|from)[ \t]+(?:smbus2?|busio|board|mpu6050|ina219|adafruit_\w+)\b", re.M)
_BUSES = ("busio.I2C", "board.I2C", "board.STEMMA_I2C", "smbus.SMBus", "smbus2.SMBus")
_TRANSFERS = frozenset(
    "read_byte_data read_word_data read_block_data read_i2c_block_data write_byte_data write_word_data write_quick "
    "write_block_data write_i2c_block_data i2c_rdwr writeto readfrom_into writeto_then_readfrom".split()
)
"""Methods of smbus and busio that no other library has."""
_CHIPS = {
    "mpu6050.mpu6050": frozenset({"get_accel_data", "get_gyro_data", "get_all_data", "get_temp"}),
    "ina219.INA219": frozenset({"voltage", "current", "power", "shunt_voltage", "supply_voltage"}),
}
"""Classes of chips, and their methods that read them."""
_READINGS = frozenset(
    "acceleration gyro magnetic temperature euler quaternion linear_acceleration gravity voltage value bus_voltage "
    "shunt_voltage current power pressure humidity relative_humidity altitude distance range lux proximity".split()
)
"""Properties of the drivers of CircuitPython that read their chip each time."""
_DEPTH = 3


class Lost(NamedTuple):
    file: NodeSource
    node: ast.expr
    """What raises, or the call that leads to it."""
    name: str
    """The callback."""
    where: Span | None
    """The transfer, where it is in another file or class."""
    is_thread: bool


_Transfer = tuple[ast.expr, "Span | None"]


def lost_transfers(nodes: Nodes) -> Iterator[Lost]:
    """For each node the first transfer in a callback or thread where nothing takes its exception."""
    for file, cls in nodes.node_classes:
        if not file.source.matches(_IMPORTED):
            continue
        syntax = nodes.syntax(file)
        bodies = [(*code_of(nodes.ending(file), cls, each), False) for each in cls.callbacks]
        bodies += [(name, body_of(cls.methods[name].node), True) for name in threads(syntax, cls)]
        look = Uncaught(syntax, cls, OF_SYSTEM, partial(_transfer, nodes, file, cls))
        found = (
            Lost(file, node, name, where, is_thread)
            for name, body, is_thread in bodies
            for node, where in look.of(body)
        )
        first = next(found, None)
        if first is not None and (first.is_thread or not is_restarted(nodes, file)):
            yield first


def _transfer(nodes: Nodes, file: NodeSource, cls: NodeClass, node: ast.AST) -> _Transfer | None:
    syntax = nodes.syntax(file)
    if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load) and node.attr in _READINGS:
        chip = node.value.value if isinstance(node.value, ast.Subscript) else node.value
        return (node, None) if _is_chip(syntax, cls, chip, _DEPTH) else None
    function = node.func if isinstance(node, ast.Call) else None
    if not isinstance(node, ast.Call) or not isinstance(function, ast.Attribute):
        return None
    if function.attr in _TRANSFERS:
        return node, None
    made = made_of(syntax, cls, function.value)
    if made is None:
        return None
    if function.attr in _CHIPS.get(str(syntax.qualified(made)), ()):
        return node, None
    where = _in_driver(nodes, file, made, function.attr)
    return (node, where) if where is not None else None


def _is_chip(syntax: Syntax, cls: NodeClass, value: ast.expr, depth: int) -> bool:
    """Whether a value is a driver of CircuitPython that is made with an I2C bus, or with such a driver."""
    made = made_of(syntax, cls, value) if depth else None
    if made is None or not (syntax.qualified(made) or "").startswith("adafruit_"):
        return False
    given = (*made.args, *(each.value for each in made.keywords))
    return any(_is_bus(syntax, cls, each) or _is_chip(syntax, cls, each, depth - 1) for each in given)


def _is_bus(syntax: Syntax, cls: NodeClass, value: ast.expr) -> bool:
    made = value if isinstance(value, ast.Call) else made_of(syntax, cls, value) or _local(syntax, value)
    return made is not None and syntax.qualified(made) in _BUSES


def _local(syntax: Syntax, value: ast.expr) -> ast.Call | None:
    """The call that a function gives to the variable that it hands over."""
    made = (each for each in own(body_of(syntax.function(value))) if isinstance(each, ast.Assign))
    target = written(value)
    found = next((each.value for each in made if target in map(written, each.targets)), None)
    return found if isinstance(found, ast.Call) else None


def _in_driver(nodes: Nodes, file: NodeSource, made: ast.Call, method: str) -> Span | None:
    """The first transfer that a method of a class of the workspace makes, itself or through others of the class."""
    driver = driver_of(nodes, file, made)
    first = first_uncaught(nodes, driver, method, OF_SYSTEM, _is_transfer) if driver is not None else None
    return driver.file.span_of(first) if driver is not None and first is not None else None


def _is_transfer(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr in _TRANSFERS
