"""The summaries of a fleet in a temporary database, so that memory does not grow with the robots.

SQLite keeps it in memory while it is small, then in a file without a name, which ends with the process. Texts are kept
as bytes, because names of files need not be UTF-8.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from collections.abc import Iterator
from contextlib import closing
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Mark
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from sqlite3 import Connection

_CACHE = 8 * 1024
"""KiB of the database that stay in memory."""
_BITS = 20
"""Of the number of a row, those that count within a robot; the others are the number of the robot."""
_TABLES = """
CREATE TABLE robots (id INTEGER PRIMARY KEY, path, files, own, silenced, failures);
CREATE TABLE facts (id INTEGER PRIMARY KEY, subject, key, value, path, line);
CREATE TABLE marks (id INTEGER PRIMARY KEY, kind, name, digest, path, line);
"""
_INDEXES = "CREATE INDEX subjects ON facts (subject); CREATE INDEX digests ON marks (kind, digest);"
_FACTS = "SELECT id, subject, key, value, path, line FROM facts WHERE subject = ?"
_SHARED = """
SELECT id, kind, name, digest, path, line
FROM marks JOIN (
    SELECT kind, digest, min(id) AS first FROM marks WHERE kind = ?
    GROUP BY kind, digest HAVING min(id) >> {bits} <> max(id) >> {bits}
) USING (kind, digest)
ORDER BY first, id
"""


class By(NamedTuple):
    """By what facts of one subject belong together."""

    order: str
    """In the database."""
    of: Callable[[Fact], object]


BY_KEY = By("key", lambda fact: fact.key)
BY_NAME = By("CASE key WHEN x'' THEN value ELSE key END", lambda fact: fact.key or fact.value)
"""What a fact is about, or what it says where it is about nothing."""
BY_VALUE = By("value", lambda fact: fact.value)
BY_BOTH = By("key, value", lambda fact: (fact.key, fact.value))


class StoreError(Exception):
    """The database cannot grow."""


@dataclass(frozen=True, eq=False, slots=True)
class FleetRobot:
    """A robot, as the rules of the fleet ask it. What it says of itself is read from the store each time."""

    number: int
    """In the order of the names."""
    name: str
    role: str
    """Robots of one role should be alike; ``robot`` when nothing says it."""
    site: str
    """Robots of one site reach each other over the network; all are of one site when nothing says it."""
    domain: int | None
    """The DDS domain that the inventory expects."""
    talks: str
    """How the site wants its domains: ``shared``, ``separate``, or empty when nothing says it."""
    store: Store

    @property
    def path(self) -> str:
        """What was read, as the user knows it."""
        return self.store.path_of(self.number)

    def of(self, subject: str) -> Iterator[Fact]:
        return self.store.facts_of(self.number, subject)

    def one(self, subject: str) -> Fact | None:
        """The only fact of a subject; None when the files disagree or say nothing."""
        found = list(self.of(subject))
        return found[0] if len({fact.value for fact in found}) == 1 else None


@dataclass(frozen=True, eq=False)
class Store:
    """The database: summaries go in robot by robot, and the fleet asks for facts of all."""

    database: Connection
    robots: list[FleetRobot] = field(default_factory=list)
    """In the order of their names."""

    def add(self, number: int, summary: Summary) -> None:
        """Raises StoreError."""
        first = number << _BITS
        said = map(json.dumps, (summary.own, summary.silenced, summary.failures))
        row = (number, _packed(summary.path), summary.files, *said)

        def insert() -> None:
            self.database.execute("INSERT INTO robots VALUES (?, ?, ?, ?, ?, ?)", row)
            for table, said in (("facts", summary.facts), ("marks", summary.marks)):
                rows = ((at, *map(_packed, each[:4]), each[4]) for at, each in enumerate(said, first))
                self.database.executemany(f"INSERT INTO {table} VALUES (?, ?, ?, ?, ?, ?)", rows)

        _tried(insert)

    def index(self) -> None:
        """After the last robot. Raises StoreError."""
        _tried(lambda: self.database.executescript(_INDEXES))

    def __len__(self) -> int:
        return len(self.robots)

    def __iter__(self) -> Iterator[Summary]:
        """The robots with what was found on each by itself, and without what they say of themselves."""
        for number, path, files, own, silenced, failures in self._rows("SELECT * FROM robots ORDER BY id"):
            known = self.robots[number]
            yield Summary(
                known.name,
                known.role,
                known.site,
                known.domain,
                known.talks,
                _unpacked(path),
                files,
                own=tuple(Own(*each) for each in json.loads(own)),
                silenced=tuple((what, count) for what, count in json.loads(silenced)),
                failures=tuple(json.loads(failures)),
            )

    def path_of(self, number: int) -> str:
        return next((_unpacked(path) for (path,) in self._rows("SELECT path FROM robots WHERE id = ?", number)), "")

    def facts(self, subject: str, by: By | None = None) -> Iterator[tuple[int, Fact]]:
        """What all robots say of a subject, with the numbers of the robots: robot after robot, or what belongs
        together."""
        order = f"{by.order}, id" if by else "id"
        return map(_fact, self._rows(f"{_FACTS} ORDER BY {order}", subject.encode()))

    def facts_of(self, number: int, subject: str) -> Iterator[Fact]:
        """What one robot says of a subject."""
        query = f"{_FACTS} AND id >= ? AND id < ? ORDER BY id"
        rows = self._rows(query, subject.encode(), number << _BITS, (number + 1) << _BITS)
        return (_fact(row)[1] for row in rows)

    def shared(self, *kinds: str) -> Iterator[tuple[int, Mark]]:
        """The marks of these kinds that several robots have, the same ones together."""
        for kind in kinds:
            for row in self._rows(_SHARED.format(bits=_BITS), kind.encode()):
                yield row[0] >> _BITS, Mark._make(_unpacked_all(row))

    def says_anything(self) -> bool:
        """Whether a file of any robot says something."""
        counted = ("facts", "marks", "robots WHERE files > 0 OR failures <> '[]'")
        return any(any(self._rows(f"SELECT 1 FROM {table} LIMIT 1")) for table in counted)

    def _rows(self, query: str, *values: bytes | int) -> Iterator[tuple[Any, ...]]:
        with closing(self.database.cursor()) as cursor:
            yield from cursor.execute(query, values)


def opened() -> Store:
    """An empty store."""
    import sqlite3

    database = sqlite3.connect("", isolation_level=None)
    database.execute(f"PRAGMA cache_size = -{_CACHE}")
    database.execute("PRAGMA journal_mode = OFF")
    database.execute("PRAGMA synchronous = OFF")
    database.executescript(_TABLES)
    return Store(database)


def _tried(action: Callable[[], object]) -> None:
    import sqlite3

    try:
        action()
    except sqlite3.Error as error:
        raise StoreError(f"the summaries do not fit into the folder for temporary files: {error}") from error


def _fact(row: tuple[Any, ...]) -> tuple[int, Fact]:
    return row[0] >> _BITS, Fact._make(_unpacked_all(row))


def _unpacked_all(row: tuple[Any, ...]) -> list[Any]:
    """All of a row but its number; the last one is the line."""
    return [*map(_unpacked, row[1:-1]), row[-1]]


def _packed(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def _unpacked(data: bytes) -> str:
    return data.decode("utf-8", "surrogatepass")
