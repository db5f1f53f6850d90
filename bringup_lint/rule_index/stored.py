"""The index of the built-in rules: one file with what all of them say of themselves and need.

A wheel carries it. In a checkout it lies in ``__pycache__``, is as trusted as the byte code there, and is made again
for the files whose size or time has changed. Where it can be neither read nor written, rules are read as they come.
"""

from __future__ import annotations

import marshal
import os
import sys
from collections.abc import Iterator
from contextlib import suppress
from importlib.util import cache_from_source

from bringup_lint import __version__
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.rule_index.described import Described
from bringup_lint.type_names import Any

FILE = "index.marshal"
FAMILY = "family.toml"
_FORMAT = 2
"""Of marshal; every Python reads it."""

Stamp = tuple[int, int]
"""The time of a file's last change in nanoseconds, and its size."""


class Entry(NamedTuple):
    """What is known of one rule."""

    described: Described
    needs: Any
    """``needs.Needs`` as tuples."""


class Index(NamedTuple):
    """What is known of all rules of a folder."""

    families: dict[str, dict[str, Any]]
    """Folder -> what its ``family.toml`` says."""
    rules: dict[str, bytes | None]
    """``systemd/kill_mode.py`` -> an ``Entry``, which is read when it is asked for, as most runs ask for a part of the
    rules; None for a file of an unusual form."""

    def entry(self, name: str) -> Entry | None:
        found = self.rules.get(name)
        if found is None:
            return None
        described, needs = marshal.loads(found)
        return Entry(Described(*described), needs)


def index_of(folder: str) -> Index | None:
    """The index of a folder of rules; None where there is none, and none can be written."""
    carried = _read(os.path.join(folder, FILE))
    if carried is not None and carried.get("version") == __version__:
        return Index(carried["families"], carried["rules"])
    place = cache_from_source(os.path.join(folder, "index.py")).removesuffix("pyc") + "marshal"
    stamps = _stamps(folder)
    known = _read(place) or {}
    if known.get("stamps") == stamps:
        return Index(known["families"], known["rules"])
    if sys.dont_write_bytecode or not _is_writable(place):
        return None
    made = _made(folder, stamps, known)
    _write(place, made)
    return Index(made["families"], made["rules"])


def made_for_wheel(folder: str) -> bytes:
    """The index that a wheel carries."""
    made = _made(folder, _stamps(folder), {})
    return marshal.dumps({**made, "stamps": {}, "version": __version__}, _FORMAT)


def _read(place: str) -> dict[str, Any] | None:
    try:
        with open(place, "rb") as file:
            data = marshal.loads(file.read())
    except (OSError, ValueError, EOFError, TypeError):
        return None
    return data if isinstance(data, dict) else None


def _stamps(folder: str) -> dict[str, Stamp]:
    """The files that the index is made from: the rules, and the modules that read them."""
    stamps: dict[str, Stamp] = {}
    places = [(os.path.join(folder, family), f"{family}/") for family in sorted(_folders(folder))]
    for place, prefix in [*places, (os.path.dirname(__file__), "")]:
        with os.scandir(place) as entries:
            for entry in entries:
                name = entry.name
                if name == FAMILY or (name.endswith(".py") and (not prefix or name[0] != "_")):
                    status = entry.stat()
                    stamps[prefix + name] = status.st_mtime_ns, status.st_size
    return stamps


def _folders(folder: str) -> Iterator[str]:
    with os.scandir(folder) as entries:
        yield from (entry.name for entry in entries if entry.is_dir() and not entry.name.startswith((".", "_")))


def _made(folder: str, stamps: dict[str, Stamp], known: dict[str, Any]) -> dict[str, Any]:
    """The index, with what is known of files that have not changed."""
    before = known.get("stamps", {})
    makers = [name for name in stamps if "/" not in name]
    if any(before.get(name) != stamps[name] for name in makers):
        before = {}
    families, rules = {}, {}
    for name, stamp in stamps.items():
        if "/" not in name:
            continue
        same = before.get(name) == stamp
        if name.endswith(FAMILY):
            families[name.partition("/")[0]] = _family(_text(folder, name))
        else:
            rules[name] = known["rules"][name] if same else _entry(_text(folder, name))
    return {"stamps": stamps, "families": families, "rules": dict(sorted(rules.items()))}


def _text(folder: str, name: str) -> str:
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return file.read()


def _family(text: str) -> dict[str, Any]:
    from bringup_lint.toml import read_toml

    return read_toml(text)


def _entry(text: str) -> bytes | None:
    from bringup_lint.rule_index.body import needs_of
    from bringup_lint.rule_index.described import described

    needs = tuple(sorted((tuple(sorted(alternative, key=repr)) for alternative in needs_of(text)), key=repr))
    try:
        return marshal.dumps((tuple(described(text)), needs), _FORMAT)
    except ValueError:
        return None


def _is_writable(place: str) -> bool:
    folder = os.path.dirname(place)
    return os.access(folder if os.path.isdir(folder) else os.path.dirname(folder), os.W_OK)


def _write(place: str, data: dict[str, Any]) -> None:
    """Whole or not at all, as two processes may write at once."""
    temporary = f"{place}.{os.getpid()}"
    try:
        os.makedirs(os.path.dirname(place), exist_ok=True)
        with open(temporary, "wb") as file:
            file.write(marshal.dumps(data, _FORMAT))
        os.replace(temporary, place)
    except OSError:
        with suppress(OSError):
            os.unlink(temporary)
