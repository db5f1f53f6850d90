"""Keystores as sros2 lays them out: ``public``, ``private``, and one folder an enclave below ``enclaves``."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover.tree import display_name
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

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

    def broken_links(self, tree: Tree) -> list[str]:
        """The names of the links that lead nowhere."""
        return [name for name in sorted(self.files) if tree.is_broken(os.path.join(self.folder, name))]


@dataclass(eq=False)
class Keystore:
    folder: str
    enclaves: dict[str, Enclave] = field(default_factory=dict)

    @property
    def name(self) -> str:
        return display_name(self.folder)


def load_keystores(tree: Tree) -> list[Keystore]:
    """The keystores of the tree: a folder ``enclaves`` with two files of an enclave below it, or with one of them
    in a folder that is called a keystore."""
    found: dict[str, Keystore] = {}
    for path in tree.paths:
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
    return [keystore for keystore in found.values() if _is_whole(keystore)]


def _is_whole(keystore: Keystore) -> bool:
    """Whether the folder surely is a keystore, and no template or lonely document."""
    named = "keystore" in os.path.basename(keystore.folder).lower()
    return any(len(each.files) > 1 or named for each in keystore.enclaves.values())


def anchor(tree: Tree, folder: str) -> Source:
    """A file of the enclave to point at: its own permissions, or whatever the tree has read there."""
    name = display_name(folder)
    inside = [source for source in tree.sources if source.name.rpartition("/")[0] == name]
    inside.sort(key=lambda source: ("permissions" not in source.kind, source.name))
    return inside[0] if inside else Source(name, judged=tree.judges(folder))


def ships(tree: Tree, source: Source) -> bool:
    """Whether a file goes with the repository: git knows it, or there is no git to ask."""
    return tree.root is None and tree.tracked(source.name) is not False
