"""Lines of setup.cfg that setuptools refuses, or that it does not read as they are meant."""

from __future__ import annotations

import os
from collections.abc import Container
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.setup_options import SECTIONS
from bringup_lint.facts.ros.setup_options import setup_options
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.setup_cfg import settings
from bringup_lint.pattern import regex
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.model.package import Manifest
    from bringup_lint.source import Located
    from bringup_lint.source import Source

_FOLDERS = (("install", "install_scripts"), ("develop", "script_dir"))
"""The options that say where programs are installed."""
_PYTHON = regex(r"(?:pypy|python)(?:\d(?:\.\d+)?)?\Z")


class UnreadSetting(NamedTuple):
    """``kind``: an unknown ``section``, an ``option`` that its command refuses, a ``folder`` that is not that of the
    package, or an ``interpreter`` that does not exist."""

    kind: str
    where: Located
    section: str
    package: str
    meant: str
    """Empty when it is not known."""


def unread_settings(
    manifests: Iterable[Manifest], sources: Iterable[Source], names: Container[str]
) -> Iterator[UnreadSetting]:
    """Those of packages of the type ``ament_python``."""
    files = {os.path.dirname(source.absolute): source for source in sources if source.judged}
    for manifest in manifests:
        source = files.get(os.path.dirname(manifest.source.absolute))
        if source is not None and manifest.build_type == "ament_python" and manifest.name:
            yield from _of_package(source, str(manifest.name), names)


def _of_package(source: Source, package: str, names: Container[str]) -> Iterator[UnreadSetting]:
    commands = setup_options()
    known = (*commands, *SECTIONS, "sdist", "bdist", "bdist_wheel", "wheel", "global", "aliases")
    for section, option, value in settings(source):
        name = str(section)
        if option is None:
            near = nearest(name, known) if name not in known else []
            if len(near) == 1:
                yield UnreadSetting("section", section, name, package, near[0])
            continue
        key = option.lower().replace("-", "_")
        if name in commands and key not in commands[name]:
            near = nearest(key, sorted(commands[name]))
            yield UnreadSetting("option", option, name, package, near[0] if len(near) == 1 else "")
        elif value is not None and (name, key) in _FOLDERS and _is_other(value, package, names):
            yield UnreadSetting("folder", value, name, package, f"$base/lib/{package}")
        elif value is not None and (name, key) == ("build_scripts", "executable"):
            program = value.rpartition("/")[2].rpartition(" ")[2]
            near = nearest(program, ["python3", "python"]) if not _PYTHON.match(program) else []
            if near:
                yield UnreadSetting("interpreter", value, name, package, near[0])


def _is_other(value: str, package: str, names: Container[str]) -> bool:
    """Whether programs go to the folder of another package, or to one whose name is nearly right."""
    right = f"$base/lib/{package}"
    written = value.rstrip("/")
    return written != right and (written.removeprefix("$base/lib/") in names or bool(nearest(written, [right])))
