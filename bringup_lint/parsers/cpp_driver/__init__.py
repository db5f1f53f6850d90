"""C++ sources of nodes and of the drivers beside them, read from the syntax tree of tree-sitter."""

from __future__ import annotations

from bringup_lint.model.cpp_driver import CppDriver
from bringup_lint.parsers.cpp_driver.blind_waits import WAITS
from bringup_lint.parsers.cpp_driver.blind_waits import blind_waits
from bringup_lint.parsers.cpp_driver.cut_answers import TAKES_APART
from bringup_lint.parsers.cpp_driver.cut_answers import cut_answers
from bringup_lint.parsers.cpp_driver.endless_walks import WALKS
from bringup_lint.parsers.cpp_driver.endless_walks import endless_walks
from bringup_lint.parsers.cpp_driver.handlers import HANDLES
from bringup_lint.parsers.cpp_driver.handlers import waiting_handlers
from bringup_lint.parsers.cpp_driver.idle_reads import SERIAL
from bringup_lint.parsers.cpp_driver.idle_reads import idle_reads
from bringup_lint.parsers.cpp_driver.left_locked import BY_HAND
from bringup_lint.parsers.cpp_driver.left_locked import left_locked
from bringup_lint.parsers.cpp_driver.relocks import LOCKS
from bringup_lint.parsers.cpp_driver.relocks import relocks
from bringup_lint.parsers.cpp_driver.taken_targets import RECEIVES
from bringup_lint.parsers.cpp_driver.taken_targets import taken_targets
from bringup_lint.parsers.cpp_driver.thrown import THROWS
from bringup_lint.parsers.cpp_driver.thrown import thrown
from bringup_lint.parsers.cpp_driver.unchecked_devices import OPENS
from bringup_lint.parsers.cpp_driver.unchecked_devices import unchecked_devices
from bringup_lint.parsers.cpp_driver.unchecked_indexes import ASKS
from bringup_lint.parsers.cpp_driver.unchecked_indexes import unchecked_indexes
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.text_limits import too_much
from bringup_lint.source import Source


def parse(source: Source) -> CppDriver:
    """What a file does with devices, locks and signals, and what it throws. Never raises; ``problems``: ``too-large``,
    ``too-deep``."""
    driver = CppDriver(source)
    asks = ASKS in source.text
    is_serial, locks, by_hand, walks, receives, opens, throws, handles, waits, cuts = (
        each.search(source.text) is not None
        for each in (SERIAL, LOCKS, BY_HAND, WALKS, RECEIVES, OPENS, THROWS, HANDLES, WAITS, TAKES_APART)
    )
    if not (asks or is_serial or locks or by_hand or walks or receives or opens or throws or handles or waits or cuts):
        return driver
    problem = too_much(source)
    if problem is not None:
        driver.problems.append(problem)
        return driver
    code = Code(source)
    driver.unchecked_indexes = list(unchecked_indexes(code)) if asks else []
    driver.idle_reads = list(idle_reads(code)) if is_serial else []
    driver.relocks = list(relocks(code)) if locks else []
    driver.left_locked = list(left_locked(code)) if by_hand else []
    driver.endless_walks = list(endless_walks(code)) if walks else []
    driver.taken_targets = list(taken_targets(code)) if receives else []
    driver.unchecked_devices = list(unchecked_devices(code)) if opens else []
    driver.waiting_handlers = list(waiting_handlers(code)) if handles else []
    driver.blind_waits = list(blind_waits(code)) if waits else []
    driver.thrown = list(thrown(code)) if throws else []
    driver.cut_answers = list(cut_answers(code)) if cuts else []
    return driver
