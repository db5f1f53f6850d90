"""C++ sources of nodes and of the drivers beside them, read from the syntax tree of tree-sitter."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.model.cpp_driver import CppDriver
from bringup_lint.parsers.cpp_driver.blind_waits import WAITS
from bringup_lint.parsers.cpp_driver.blind_waits import blind_waits
from bringup_lint.parsers.cpp_driver.blind_writes import ANSWERED
from bringup_lint.parsers.cpp_driver.blind_writes import WRITES
from bringup_lint.parsers.cpp_driver.blind_writes import blind_writes
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
from bringup_lint.parsers.cpp_driver.lost_cameras import CAMERA
from bringup_lint.parsers.cpp_driver.lost_cameras import lost_cameras
from bringup_lint.parsers.cpp_driver.lost_transforms import LOOKS_UP
from bringup_lint.parsers.cpp_driver.lost_transforms import TAKES
from bringup_lint.parsers.cpp_driver.lost_transforms import lost_transforms
from bringup_lint.parsers.cpp_driver.relocks import LOCKS
from bringup_lint.parsers.cpp_driver.relocks import relocks
from bringup_lint.parsers.cpp_driver.shell_texts import BRINGS
from bringup_lint.parsers.cpp_driver.shell_texts import RUNS
from bringup_lint.parsers.cpp_driver.shell_texts import shell_texts
from bringup_lint.parsers.cpp_driver.short_answers import TAKES_PARTS
from bringup_lint.parsers.cpp_driver.short_answers import short_answers
from bringup_lint.parsers.cpp_driver.shut_contexts import SHUTS
from bringup_lint.parsers.cpp_driver.shut_contexts import shut_contexts
from bringup_lint.parsers.cpp_driver.shut_ports import OPENS_PORT
from bringup_lint.parsers.cpp_driver.shut_ports import SERIAL_PORT
from bringup_lint.parsers.cpp_driver.shut_ports import shut_ports
from bringup_lint.parsers.cpp_driver.taken_targets import RECEIVES
from bringup_lint.parsers.cpp_driver.taken_targets import taken_targets
from bringup_lint.parsers.cpp_driver.thread_throws import ENDS
from bringup_lint.parsers.cpp_driver.thread_throws import STARTS
from bringup_lint.parsers.cpp_driver.thread_throws import thread_throws
from bringup_lint.parsers.cpp_driver.thrown import THROWS
from bringup_lint.parsers.cpp_driver.thrown import thrown
from bringup_lint.parsers.cpp_driver.unchecked_devices import OPENS
from bringup_lint.parsers.cpp_driver.unchecked_devices import unchecked_devices
from bringup_lint.parsers.cpp_driver.unchecked_indexes import ASKS
from bringup_lint.parsers.cpp_driver.unchecked_indexes import unchecked_indexes
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.text_limits import too_much
from bringup_lint.source import Source

_QUESTIONS: tuple[tuple[str, tuple[re.Pattern[str], ...], Callable[[Code], Iterable[object]]], ...] = (
    ("unchecked_indexes", (ASKS,), unchecked_indexes),
    ("idle_reads", (SERIAL,), idle_reads),
    ("relocks", (LOCKS,), relocks),
    ("left_locked", (BY_HAND,), left_locked),
    ("endless_walks", (WALKS,), endless_walks),
    ("taken_targets", (RECEIVES,), taken_targets),
    ("unchecked_devices", (OPENS,), unchecked_devices),
    ("waiting_handlers", (HANDLES,), waiting_handlers),
    ("blind_waits", (WAITS,), blind_waits),
    ("thrown", (THROWS,), thrown),
    ("cut_answers", (TAKES_APART,), cut_answers),
    ("lost_transforms", (LOOKS_UP, TAKES), lost_transforms),
    ("thread_throws", (STARTS, ENDS), thread_throws),
    ("shut_contexts", (SHUTS,), shut_contexts),
    ("blind_writes", (WRITES, ANSWERED), blind_writes),
    ("shut_ports", (OPENS_PORT, SERIAL_PORT), shut_ports),
    ("short_answers", (TAKES_PARTS,), short_answers),
    ("lost_cameras", (CAMERA,), lost_cameras),
    ("shell_texts", (RUNS, BRINGS), shell_texts),
)
"""What is asked of a file, with the words without all of which it has none."""


def parse(source: Source) -> CppDriver:
    """What a file does with devices, locks and signals, and what it throws. Never raises; ``problems``: ``too-large``,
    ``too-deep``."""
    driver = CppDriver(source)
    asked = [(name, look) for name, words, look in _QUESTIONS if all(each.search(source.text) for each in words)]
    if not asked:
        return driver
    problem = too_much(source)
    if problem is not None:
        driver.problems.append(problem)
        return driver
    code = Code(source)
    for name, look in asked:
        setattr(driver, name, list(look(code)))
    return driver
