"""What boot loaders hand to the kernel: cmdline.txt of the Raspberry Pi, extlinux.conf and /etc/default/grub
(kernel-parameters of the Linux documentation)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_PARAMETER = regex(r"(?<![^\s\"'])(?P<name>[A-Za-z][\w.-]*)=(?P<value>[^\s\"']+)")
_IN_LINES = regex(r"[ \t]*(?:APPEND[ \t]|GRUB_CMDLINE_LINUX\w*=)", re.I)


class KernelWord(NamedTuple):
    """A parameter with a value: ``console=ttyS0,115200``."""

    name: str
    value: Located


def parse(source: Source) -> list[KernelWord]:
    """The parameters of all entries, in their order. Never raises."""
    return [
        KernelWord(match["name"], source.located(start + match.start("value"), start + match.end("value")))
        for start, line in _lines(source)
        for match in _PARAMETER.finditer(line)
    ]


def _lines(source: Source) -> Iterator[tuple[int, str]]:
    """The lines that go to the kernel, each with its offset: of cmdline.txt the firmware reads the first alone."""
    start = 0
    for line in source.text.splitlines(keepends=True):
        if source.basename == "cmdline.txt":
            yield start, line
            return
        if _IN_LINES.match(line):
            yield start, line
        start += len(line)
