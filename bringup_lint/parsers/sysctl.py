"""sysctl.d(5): lines ``name = value``; a leading ``-`` only forgives failures, ``/`` in names counts like
``.``."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source


class KernelParameter(NamedTuple):
    name: str
    """With dots, as ``net.core.rmem_max``."""
    key: Located
    value: Located


def parse(source: Source) -> list[KernelParameter]:
    """The settings of one file, in order; lines that sysctl could not read either are passed over."""
    return list(_settings(source))


def _settings(source: Source) -> Iterator[KernelParameter]:
    for number, start in enumerate(source.line_starts, 1):
        line = source.located(start, start + len(source.line_text(number)))
        if line.lstrip()[:1] in ("#", ";", "") or "=" not in line:
            continue
        at = line.index("=")
        key = line.part(0, at).strip_located()
        name = key.removeprefix("-").strip()
        first = next((mark for mark in name if mark in "./"), ".")
        if first == "/":
            name = name.replace("/", ".")
        yield KernelParameter(name, key, line.part(at + 1, len(line)).strip_located())
