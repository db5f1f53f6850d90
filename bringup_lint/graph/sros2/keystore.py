"""Keystores as sros2 lays them out: ``public``, ``private``, and one folder an enclave below ``enclaves``."""

from __future__ import annotations

import os
from dataclasses import dataclass
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import display_name
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

REQUIRED = (
    "identity_ca.cert",
    "cert",
    "key",
    "permissions_ca.cert",
    "governance",
    "permissions",
)
"""What the RMW opens in an enclave; as ``.pem`` and ``.p7s``, or as ``.p11`` since Iron."""
_OF_ENCLAVE = {
    "cert.pem",
    "key.pem",
    "identity_ca.cert.pem",
    "permissions_ca.cert.pem",
    "permissions.xml",
    "permissions.p7s",
}
_INDEX_VERSIONS = (2, 3)


@dataclass(eq=False)
class Enclave:
    path: str
    """As ``--enclave`` names it."""
    folder: str
    files: set[str] = field(default_factory=set)

    def missing(self) -> list[str]:
        """The required files that are not there."""
        found = []
        for stem in REQUIRED:
            name = f"{stem}.{'p7s' if stem in ('governance', 'permissions') else 'pem'}"
            if name not in self.files and f"{stem}.p11" not in self.files:
                found.append(name)
        return found

    def dangling(self) -> list[str]:
        """The links that lead nowhere."""
        paths = (os.path.join(self.folder, name) for name in sorted(self.files))
        return [
            path
            for path in paths
            if os.path.islink(path) and not os.path.isabs(os.readlink(path)) and not os.path.exists(path)
        ]


@dataclass(eq=False)
class Keystore:
    folder: str
    enclaves: dict[str, Enclave] = field(default_factory=dict)

    @property
    def name(self) -> str:
        return display_name(self.folder)


def load_keystores(robot: Robot) -> list[Keystore]:
    """The keystores of the tree: a folder ``enclaves`` with at least two files of an enclave somewhere below."""
    found: dict[str, Keystore] = {}
    for path in robot.tree.paths:
        folder, name = os.path.split(path)
        if name not in _OF_ENCLAVE and not name.startswith("governance."):
            continue
        parts = folder.split("/")
        if "enclaves" not in parts:
            continue
        at = len(parts) - 1 - parts[::-1].index("enclaves")
        top, inner = "/".join(parts[:at]), "/".join(parts[at + 1 :])
        keystore = found.setdefault(top, Keystore(top))
        enclave = keystore.enclaves.setdefault(f"/{inner}", Enclave(f"/{inner}", folder))
        enclave.files.add(name)
    for keystore in found.values():
        for path, enclave in list(keystore.enclaves.items()):
            if not enclave.files & _OF_ENCLAVE:
                del keystore.enclaves[path]
    return [keystore for keystore in found.values() if any(len(each.files) > 1 for each in keystore.enclaves.values())]


def anchor(robot: Robot, folder: str) -> Source:
    """A file of the enclave to point at: its own permissions, or whatever the tree has read there."""
    name = display_name(folder)
    inside = [source for source in robot.sources if source.name.rpartition("/")[0] == name]
    inside.sort(key=lambda source: ("permissions" not in source.kind, source.name))
    return inside[0] if inside else Source(name)


def ships(robot: Robot, source: Source) -> bool:
    """Whether a file goes with the repository: git knows it, or there is no git to ask."""
    if robot.tree.root is not None:
        return False
    path = Path(source.name).absolute()
    for folder in path.parents:
        index = _index(folder)
        if index is None:
            continue
        try:
            data = index.read_bytes()
        except OSError:
            return False
        if int.from_bytes(data[4:8], "big") not in _INDEX_VERSIONS:
            return False
        return b"%s\0" % os.fsencode(path.relative_to(folder)) in data
    return True


def _index(folder: Path) -> Path | None:
    """The index of the repository whose top this folder is."""
    git = folder / ".git"
    if git.is_dir():
        return git / "index"
    if not git.is_file():
        return None
    line = git.read_text("utf-8", "replace").strip()
    return folder / line.removeprefix("gitdir:").strip() / "index" if line.startswith("gitdir:") else None
