"""The file systems that the boot mounts: fstab(5)."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

BLOCK_DEVICE = regex(r"/dev/|(?:UUID|LABEL|PARTUUID|PARTLABEL|ID)=")
VIRTUAL = frozenset(("tmpfs", "ramfs", "proc", "sysfs", "devpts", "overlay", "none", "debugfs", "tracefs", "cgroup2"))


@dataclass(frozen=True, eq=False, slots=True)
class Mount:
    """One line: device, mount point, type, options, dump, pass; fields that are missing are None."""

    fields: tuple[Located, ...]
    device: Located
    target: Located | None = None
    """The mount point, with its escapes undone."""
    type: Located | None = None
    options: tuple[Located, ...] = ()
    passno: Located | None = None

    def has(self, *names: str) -> bool:
        """Whether one of these options is set, whatever its value."""
        return any(option.partition("=")[0] in names for option in self.options)

    def option(self, name: str) -> Located | None:
        """The value of the last ``name=value``."""
        found = [option for option in self.options if option.partition("=")[0] == name]
        return found[-1].part(len(name) + 1, len(found[-1])) if found else None

    @property
    def place(self) -> Located:
        """The mount point, where the line has one, else the device."""
        return self.target or self.device

    @property
    def is_block(self) -> bool:
        return bool(BLOCK_DEVICE.match(self.device)) and self.type not in VIRTUAL and not self.has("bind", "rbind")

    @property
    def is_tmpfs(self) -> bool:
        return self.type == "tmpfs"

    @property
    def is_read_only(self) -> bool:
        """The last of ``ro`` and ``rw`` counts."""
        found = [option for option in self.options if option in ("ro", "rw")]
        return bool(found) and found[-1] == "ro"

    @property
    def end_of_options(self) -> Span | None:
        """Where another option is written."""
        if len(self.fields) < 4:
            return None
        span = self.fields[3].span
        return Span(span.source, span.end, span.end)


@dataclass(eq=False, slots=True)
class Fstab:
    source: Source
    mounts: list[Mount] = field(default_factory=list)

    def mount_of(self, path: str) -> Mount | None:
        """The mount that holds a path: the one with the longest mount point."""
        targets = [(mount.target.rstrip("/"), mount) for mount in self.mounts if mount.target is not None]
        holding = [(len(target), mount) for target, mount in targets if f"{path}/".startswith(f"{target}/")]
        return max(holding, key=lambda each: each[0])[1] if holding else None
