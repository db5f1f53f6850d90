"""The kernel parameters that the boot sets: sysctl.d(5), the last value wins."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.variants import overlay_of
from bringup_lint.parsers.sysctl import KernelParameter
from bringup_lint.parsers.sysctl import parse
from bringup_lint.source import Source
from bringup_lint.spelling import nearest
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

FOLDERS = (
    "/etc/sysctl.d/",
    "/run/sysctl.d/",
    "/usr/local/lib/sysctl.d/",
    "/usr/lib/sysctl.d/",
    "/lib/sysctl.d/",
)
"""Where a file of the same name hides those further right."""


@dataclass(eq=False)
class Sysctl:
    settings: list[KernelParameter] = field(default_factory=list)
    """In the order in which they are applied."""
    certain: bool = True
    """False when files of several robots or overlays lie side by side."""

    def get(self, name: str) -> KernelParameter | None:
        """The setting that wins."""
        return next((each for each in reversed(self.settings) if each.name == name), None)

    def number(self, name: str) -> int | None:
        setting = self.get(name)
        return int(setting.value) if setting and setting.value.isdecimal() else None

    def mentions(self, name: str) -> bool:
        return any(each.name == name for each in self.settings)

    @property
    def unknown(self) -> Iterator[tuple[KernelParameter, str]]:
        """The settings of a name that no kernel has, each with the one that is meant: misspelt, without its end, or of
        another folder."""
        folders = _folders() if self.settings else {}
        for setting in self.settings:
            folder, _, name = setting.name.rpartition(".")
            known = folders.get(folder, frozenset((name,)))
            if name in known:
                continue
            longer = [f"{folder}.{each}" for each in known if each.startswith(f"{name}_")]
            elsewhere = [f"{other}.{name}" for other, names in folders.items() if name in names]
            misspelt = [f"{folder}.{each}" for each in nearest(name, sorted(known))]
            found = elsewhere or misspelt or longer
            if len(found) == 1:
                yield setting, found[0]


@lru_cache
def _folders() -> dict[str, frozenset[str]]:
    from bringup_lint.facts import table

    return {row["folder"]: frozenset(row["names"].split()) for row in table("host/sysctl")}


def load_sysctl(files: Files) -> Sysctl:
    """Merge the files by their names; Debian and Ubuntu link /etc/sysctl.conf as 99-sysctl.conf."""
    by_name: dict[str, tuple[int, Source]] = {}
    certain = True
    overlays: set[str | None] = set()
    for source in files.of_kind("sysctl"):
        place = source.robot_path or f"/{source.name}"
        rank = next((index for index, folder in enumerate(FOLDERS) if folder in place), 0)
        overlays.add(overlay_of(source))
        name = "99-sysctl.conf" if place.endswith("/etc/sysctl.conf") else source.basename
        known = by_name.get(name)
        if known is not None and known[0] == rank:
            certain = False
        if known is None or rank < known[0]:
            by_name[name] = (rank, source)
    sources = [by_name[name][1] for name in sorted(by_name)]
    settings = [setting for found in files.parsed(parse, sources) for setting in found]
    return Sysctl(settings, certain and len(overlays) < 2)
