"""Serial lines that the kernel has its console on and that something of the robot opens as a device."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.kernel_command_line import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.host.device_uses import DeviceUse
    from bringup_lint.graph.host.devices import Devices

_OF_KERNEL = {"serial0": "ttyS0"}
"""A name that the firmware replaces -> the line that it is on most boards."""
_NO_LINE = regex(r"tty\d*$|hvc\d|null$")
"""Consoles that are no serial lines: screens, and those of virtual machines."""
_TAKEN_AWAY = regex(r"\bdo_serial|\bserial-getty@|\bconsole=", hints="do_serial serial-getty@ console=")
"""What scripts say that take a console away."""


class TakenConsole(NamedTuple):
    line: Located
    """The line that ``console=`` names."""
    uses: list[DeviceUse]
    certain: bool
    """Both name the same line, and the device is not only a default."""


def taken_consoles(files: Files, devices: Devices) -> Iterator[TakenConsole]:
    """The consoles on the lines of devices; nothing where the tree may change the command line."""
    if any(source.says(_TAKEN_AWAY) for source in files.of_kind("shell-script", "ansible", "cloud-init")):
        return
    for source in files.of_kind("kernel-command-line"):
        for words in files.parsed(parse, [source]):
            for word in words:
                if word.name == "console":
                    yield from _taken(word.value, files, devices)


def _taken(value: Located, files: Files, devices: Devices) -> Iterator[TakenConsole]:
    line = value.part(0, len(value.partition(",")[0]))
    if _NO_LINE.match(line):
        return
    names = [line, _OF_KERNEL.get(line, line)]
    uses = [use for use in devices.uses if use.path.removeprefix("/dev/") in names and files.same_robot(use.path, line)]
    if uses:
        same = [use for use in uses if use.path == f"/dev/{line}" and use.certainty not in ("default", "argument")]
        yield TakenConsole(line, same or uses, bool(same))
