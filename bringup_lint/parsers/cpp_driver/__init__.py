"""C++ sources that open a CAN bus or a serial port, read from the syntax tree of tree-sitter."""

from __future__ import annotations

from bringup_lint.model.cpp_driver import CppDriver
from bringup_lint.parsers.cpp_driver.idle_reads import SERIAL
from bringup_lint.parsers.cpp_driver.idle_reads import idle_reads
from bringup_lint.parsers.cpp_driver.unchecked_indexes import ASKS
from bringup_lint.parsers.cpp_driver.unchecked_indexes import unchecked_indexes
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.text_limits import too_much
from bringup_lint.source import Source


def parse(source: Source) -> CppDriver:
    """What a file does with the answers of devices. Never raises; ``problems``: ``too-large``, ``too-deep``."""
    driver = CppDriver(source)
    asks, is_serial = ASKS in source.text, SERIAL.search(source.text)
    problem = too_much(source) if asks or is_serial else None
    if problem is not None:
        driver.problems.append(problem)
    elif asks or is_serial:
        code = Code(source)
        driver.unchecked_indexes = list(unchecked_indexes(code)) if asks else []
        driver.idle_reads = list(idle_reads(code)) if is_serial else []
    return driver
