"""Whether a path will be there on the running robot, by everything that makes files and directories."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from itertools import islice
from itertools import takewhile

from bringup_lint.dataclass import dataclass
from bringup_lint.facts import table
from bringup_lint.folders import above
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.directories import directories
from bringup_lint.graph.systemd.provision import makes
from bringup_lint.graph.systemd.provision import makes_at
from bringup_lint.graph.systemd.provision import may_make
from bringup_lint.graph.systemd.provision import mentions
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.model.fstab import Fstab
from bringup_lint.pattern import regex

_MAKERS = ("mkdir", "install")
_MADE_BY_TMPFILES = frozenset("fFwdDvqQpLcbC")
_STATE = ("/var/log/", "/var/lib/", "/var/cache/", "/var/spool/", "/run/", "/var/run/", "/tmp/", "/var/tmp/")
"""Where nothing is unless somebody makes it."""
_SURE_TAIL = 2
"""So many names at the end of a path say which file of the tree it is: its own and that of its folder."""
_OF_ONE_ROBOT = regex(
    r"(?i)(?:^|[-_.])(?:calib\w*|cred\w*|custom|host\w*|id|instance|keys?|local|machine|maps?|override\w*|pass\w*|private"
    r"|robot_?(?:id|name)|secrets?|serial|site|tokens?|user|wifi|wlan)(?=[-_.]|$)"
)
"""Words in the names of files that are made for each robot, and lie in no repository."""
_PATTERN = regex(r"(?i)[-_.](?:example|sample|templ(?:ate)?|tmpl|dist|in|j2|orig|bak)(?=[-_.]|$)")
"""Names of files from which somebody makes another one."""
_COMPARED = 200
"""Files of one folder that a missing one is compared with."""
_SURE_STEM = 4
"""So many characters that two names begin with say that one may be meant by the other."""
_OF_PACKAGES = frozenset(
    "apache2 apt bluetooth chrony clickhouse containerd docker dpkg gpsd grafana influxdb jenkins lxd mongodb "
    "mosquitto mysql netplan NetworkManager nginx nvidia postgresql prometheus redis samba snapd systemd tailscale "
    "telegraf tftpboot udisks2 www zerotier-one journal user".split()
)
"""Folders below /var/lib and the like that packages of the distribution and of vendors bring."""
_OF_SYSTEM = regex(r"/(?:usr|opt|etc|srv|var/lib)/")
_COMMON = regex(
    r"(?i)(?:app|bringup|conf(?:ig)?|configuration|daemon|default|entrypoint|env|init|install|launch|log(?:ging)?|main|node"
    r"|params?|parameters|robot|run(?:_?me)?|server|service|settings|setup|start(?:_?up)?|stop|test|update)s?\.\w+"
)
"""Names that files of several programs have: one in a folder of another program is another file."""
_SHARED = frozenset(
    "/ /etc /opt /srv /usr /usr/lib /usr/local /usr/local/etc /usr/local/lib /usr/share /var/lib".split()
)
_VOLATILE = ("/run/", "/var/run/", "/tmp/", "/dev/", "/proc/", "/sys/")


@dataclass(eq=False)
class Filesystem:
    """Asked as ``robot.filesystem``: whether anything of the tree makes a path, also before a unit starts."""

    files: Files
    units: Units
    fstabs: Callable[[], list[Fstab]]

    def is_created(self, path: str, unit: Unit) -> bool | None:
        """Whether something makes the path before the unit starts. False: nothing of the tree; None: unknown."""
        if any(made == path or made.startswith(f"{path}/") for made in self._presumed(unit)):
            return True
        return self.is_made(path)

    def is_made(self, path: str) -> bool | None:
        """The same, whatever the unit itself may presume."""
        path = path.replace("/var/run/", "/run/", 1) if path.startswith("/var/run/") else path
        if path in self._created:
            return True
        if self._is_below_mount(path):
            return None
        tree = self.files.tree
        if tree.complete and tree.root is not None and not path.startswith(_VOLATILE):
            there = self.exists(path)
            if there is not None:
                return there
        if path in self._shipped or mentions(tree, path):
            return True
        if not path.startswith(_STATE) or _of_package(path) or may_make(tree, path):
            return None
        return False

    def exists(self, path: str) -> bool | None:
        """What a root file system says of a path; None when it is not whole there, or the path lies on another
        mount."""
        tree = self.files.tree
        if tree.root is None or self._is_below_mount(path):
            return None
        if tree.inside(path) is not None:
            return True
        parts = path.split("/")
        top = "/".join(parts[:3]) if parts[1] == "home" else "/".join(parts[:2])
        return False if path != top and tree.inside(top) is not None else None

    def shipped_sibling(self, path: str) -> str | None:
        """A file of one's own that the repository has for the same folder of the robot, when it ships and makes
        nothing at ``path``. Names that share their first word or a longer beginning, and scripts, are one's own;
        the rest may come from elsewhere. A file of the same name that it puts into another folder goes before."""
        elsewhere = self.installed_elsewhere(path)
        if elsewhere is not None:
            return elsewhere
        tree = self.files.tree
        if tree.root is not None or tree.find(path) is not None or path.startswith(_VOLATILE):
            return None
        folder, _, name = path.rpartition("/")
        if _OF_ONE_ROBOT.search(name):
            return None
        there = chain(self._shipped_in.get(folder, []), self._checked_out_in(folder))
        related = [found for found in islice(there, _COMPARED) if _related(name, _basename(found))]
        sibling = next(iter(related), None)
        if any(_PATTERN.search(_basename(found)) for found in related):
            return None
        if sibling is None or any(True for _ in tree.named(name)) or makes(tree, name) or mentions(tree, path):
            return None
        return sibling

    def installed_elsewhere(self, path: str) -> str | None:
        """Where the scripts of the repository put the file of this name, when it is one folder of the system, and
        nothing puts it at ``path``, which is another."""
        tree = self.files.tree
        if not _OF_SYSTEM.match(path) or tree.root is not None:
            return None
        folder, _, name = path.rpartition("/")
        places = {each for each in self.files.installed if _basename(each) == name}
        if len(places) != 1 or path in places or not all(map(_OF_SYSTEM.match, places)):
            return None
        if _COMMON.fullmatch(name) and any(os.path.commonpath((path, each)) in _SHARED for each in places):
            return None
        file = tree.find(path)
        if file is not None and file.robot_path not in (None, *places):
            return None
        if file is not None and _basename(os.path.dirname(file.name)) == _basename(folder):
            return None
        if makes_at(tree, folder, name) or mentions(tree, path) or may_make(tree, path):
            return None
        return next(iter(places))

    @cached_property
    def _shipped_in(self) -> dict[str, list[str]]:
        """The paths on the robot of the files that the tree has or that its scripts install, by folder."""
        found: dict[str, list[str]] = {}
        overlaid = filter(None, map(self.files.tree.robot_path, self.files.tree.paths))
        for shipped in chain(overlaid, sorted(self.files.installed)):
            found.setdefault(shipped.rpartition("/")[0], []).append(shipped)
        return found

    def _checked_out_in(self, folder: str) -> Iterator[str]:
        """The paths on the robot of the files in a folder of the checkout that units start programs from."""
        for robot_top, top in sorted(self._checkouts):
            if not f"{folder}/".startswith(f"{robot_top}/"):
                continue
            inside = self.files.tree.walked_in(top + folder[len(robot_top) :])
            yield from (f"{folder}/{_basename(path)}" for path in inside)

    @cached_property
    def _checkouts(self) -> frozenset[tuple[str, str]]:
        """The folders on the robot that the repository is checked out in, each with its folder in the tree: where a
        unit starts a file that the tree has in a folder of the same name."""
        tree = self.files.tree
        found = set()
        for unit in self.units.services:
            for process in self.units.processes(unit):
                source = tree.find(process.program) if process.program.startswith("/") else None
                if source is None or source.robot_path is not None:
                    continue
                robot_parts, parts = process.program.split("/"), source.absolute.split("/")
                same = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(robot_parts[::-1], parts[::-1])))
                if same >= _SURE_TAIL:
                    found.add(("/".join(robot_parts[:-same]), "/".join(parts[:-same])))
        return frozenset(found)

    @cached_property
    def _shipped(self) -> frozenset[str]:
        """The folders on the robot that hold files of the tree."""
        return frozenset(folder for source in self.files.sources for folder in above(source.robot_path or ""))

    @cached_property
    def _created(self) -> frozenset[str]:
        """What is made whatever unit asks, with the folders above it."""
        made = list(self._made())
        return frozenset([*made, *(folder for path in made for folder in above(path))])

    def _made(self) -> Iterator[str]:
        yield from (row["path"] for row in table("host/base_directories"))
        for unit in self.units.all:
            yield from directories(unit)
            where = unit.get("Where") if unit.type == "mount" else None
            if where:
                yield str(where)
        for source in self.files.of_kind("tmpfiles"):
            for line in source.text.splitlines():
                words = line.split()
                if len(words) > 1 and words[0][:1] in _MADE_BY_TMPFILES:
                    yield words[1].strip("\"'").rstrip("/")
        yield from self._mounts

    @cached_property
    def _mounts(self) -> frozenset[str]:
        """The mount points of fstab, without the root."""
        targets = (mount.target for fstab in self.fstabs() for mount in fstab.mounts if mount.target)
        return frozenset(target.rstrip("/") for target in targets if target.startswith("/") and target != "/")

    def _is_below_mount(self, path: str) -> bool:
        return any(folder in self._mounts for folder in above(path))

    def _presumed(self, unit: Unit) -> Iterator[str]:
        """What must be there for the unit to start at all."""
        folder = unit.get("WorkingDirectory")
        if folder and folder.startswith("/"):
            yield folder.rstrip("/")
        for process in self.units.processes(unit):
            yield from (str(word) for word in process.argv if word.startswith("/"))
            for step in process.steps:
                name, *words = unwrapped(step.command.words) or [""]
                if program_name(name) in _MAKERS:
                    yield from (str(word) for word in words if word.startswith("/"))


def _of_package(path: str) -> bool:
    return not _OF_PACKAGES.isdisjoint(path.split("/")[2:4])


def _basename(path: str) -> str:
    return path.rpartition("/")[2]


def _related(name: str, other: str) -> bool:
    words = re.split(r"[-_.]", name)
    if name.endswith((".sh", ".bash")) or (len(words) > 1 and words[0] == re.split(r"[-_.]", other)[0]):
        return True
    (stem, extension), (its_stem, its_extension) = os.path.splitext(name), os.path.splitext(other)
    return extension == its_extension != "" and (
        min(len(stem), len(its_stem)) >= _SURE_STEM and (stem.startswith(its_stem) or its_stem.startswith(stem))
    )
