"""What a run keeps so that the next one goes on where it stopped: summaries by what they were made from.

The folder holds the key of the keyed hashes too, so only its owner may read it; without it the summaries say nothing
about key material. Remove the folder to begin anew.
"""

from __future__ import annotations

import hashlib
import json
import os
import secrets
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from pathlib import Path

from bringup_lint.cache.program import program
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import read_bytes
from bringup_lint.discover.walk import walk
from bringup_lint.fleet.check import Job
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.summary import VERSION
from bringup_lint.fleet.summary import Summary
from bringup_lint.fleet.summary import from_data
from bringup_lint.fleet.summary import to_data

_KEY = "key"
_CHUNK = 1024 * 1024


class State:
    """A folder of summaries. Raises ConfigError when it cannot be used."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.trouble = ""
        """Why something could not be kept; empty while all is."""
        self._checked_by = ""
        try:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            status = folder.stat()
            if status.st_mode & 0o077:
                raise ConfigError(f"{folder}: others may read it; use a folder of mode 0700")
            self.key = self._key()
        except OSError as error:
            raise ConfigError(f"{folder}: {error.strerror}") from error

    def _key(self) -> bytes:
        path = self.folder / _KEY
        if not path.exists():
            _write(path, secrets.token_bytes(32))
        key = path.read_bytes()
        if len(key) != 32:
            raise ConfigError(f"{path}: not a key of a fleet; remove the folder")
        return key

    def resumed(
        self,
        members: Iterable[Member],
        job: Job,
        make: Callable[[Iterable[Member | Summary]], Iterator[Summary]],
    ) -> Iterator[Summary]:
        """The summaries that are kept, and those that ``make`` makes, which are kept from now on."""
        names: dict[str, str] = {}

        def known() -> Iterator[Member | Summary]:
            for member in members:
                name = self.name(member, job)
                kept = self.load(name)
                if kept is None:
                    names[member.name] = name
                yield kept or member

        for summary in make(known()):
            name = names.pop(summary.name, "")
            if name:
                self.save(name, summary)
            yield summary

    def name(self, member: Member, job: Job) -> str:
        """The name of a summary: a hash of all that it is made from. What cannot be read is found out when it is
        checked."""
        digest = hashlib.sha256()
        context = (VERSION, member, replace(job, key=b""), sorted(job.config.severity.items()), self._program(job))
        digest.update(repr(context).encode("utf-8", "surrogateescape"))
        for layer in (*member.layers, *(path for _, path in member.delivered)):
            try:
                for part in _content(layer):
                    digest.update(hashlib.sha256(part).digest())
            except OSError as error:
                digest.update(str(error).encode("utf-8", "surrogateescape"))
        return digest.hexdigest()

    def _program(self, job: Job) -> str:
        """What checks the robots: the same version with other rules finds something else."""
        if not self._checked_by:
            digest = hashlib.sha256(program(by_content=True).encode())
            for folder in job.rule_folders:
                for part in _content(folder):
                    digest.update(hashlib.sha256(part).digest())
            self._checked_by = digest.hexdigest()
        return self._checked_by

    def load(self, name: str) -> Summary | None:
        try:
            return from_data(json.loads((self.folder / f"{name}.json").read_text("utf-8")))
        except (OSError, ValueError):
            return None

    def save(self, name: str, summary: Summary) -> None:
        """Nothing of a robot on which something failed is kept."""
        if summary.failures or self.trouble:
            return
        try:
            _write(self.folder / f"{name}.json", json.dumps(to_data(summary)).encode())
        except OSError as error:
            self.trouble = f"{self.folder}: nothing more is kept for another run: {error.strerror}"


def _write(path: Path, data: bytes) -> None:
    """Whole or not at all, and for the owner only."""
    new = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as file:
            file.write(data)
        new.replace(path)
    except OSError:
        new.unlink(missing_ok=True)
        raise


def _content(layer: str) -> Iterator[bytes]:
    """The files of a folder with their names and modes, or an archive piece by piece."""
    if not os.path.isdir(layer):
        with open(layer, "rb") as file:
            while chunk := file.read(_CHUNK):
                yield chunk
        return
    for path in walk(os.path.abspath(layer)):
        status = os.lstat(path)
        yield f"{path}\0{status.st_mode}\0{status.st_uid}\0{status.st_gid}".encode("utf-8", "surrogateescape")
        if os.path.islink(path):
            yield os.fsencode(os.readlink(path))
            continue
        try:
            yield read_bytes(path)[0]
        except Unreadable as error:
            yield str(error).encode()
