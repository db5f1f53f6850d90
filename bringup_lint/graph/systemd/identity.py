"""Who the processes of a unit run as: User=, Group=, SupplementaryGroups= and DynamicUser= of systemd.exec(5)."""

from __future__ import annotations

from enum import Enum

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.user_database import UserDatabase
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located

ROOT = ("root", "0")
_NO_HOME = ("", "/nonexistent")


class HomeOrigin(Enum):
    """Who says where the home of a user is."""

    DYNAMIC = "DynamicUser="
    ROOT = "root"
    PASSWD = "/etc/passwd"
    CONVENTION = "/home"


class Home(NamedTuple):
    path: str | None
    """None when there is none."""
    origin: HomeOrigin


@dataclass(frozen=True)
class Identity:
    """What the settings of one unit say, drop-ins included."""

    unit: str
    """The name of the unit."""
    manager: str
    """``system`` or ``user``; a user manager runs everything as its own user."""
    user: Located | None
    """User= as written."""
    dynamic: Setting[bool]
    """DynamicUser=."""
    group: Located | None
    supplementary: tuple[Located, ...]
    opaque: bool
    """User= holds a template's placeholder."""
    certain: bool
    """Nothing that the tree does not show can set the user: no other unit file, no branch of a template."""

    @property
    def name(self) -> str | None:
        """The name or number of the user, specifiers replaced: ``root`` where the system manager is told nothing.
        None for a user that systemd makes up, for the user of a user manager, and where it is not known."""
        if self.manager != "system":
            return None
        if self.user is None:
            return None if self.dynamic else "root"
        if self.opaque:
            return None
        known = {**unit_specifiers(self.unit), "u": "root", "U": "0"} if "%" in self.user else {}
        return expand(self.user, known) or None

    @property
    def is_root(self) -> bool | None:
        """Whether the processes run as root; None when that is not known. A unit of a user manager never does."""
        if self.manager != "system" or self.dynamic:
            return False
        name = self.name
        return name in ROOT if self.certain and name is not None and not self.dynamic.unknown else None

    @property
    def is_other(self) -> bool:
        """Whether User= names somebody else than root, for certain."""
        return self.user is not None and self.is_root is False

    @property
    def is_number(self) -> bool:
        """Whether the user is known by number alone."""
        return self.name is not None and self.name.isdecimal() and self.name not in ROOT

    def groups(self, database: UserDatabase) -> frozenset[str]:
        """The groups of the processes: those of the unit and those that /etc/group gives to the user."""
        own = {str(word) for word in (self.group, *self.supplementary) if word}
        return frozenset(own | database.groups_of(self.name)) if self.name is not None else frozenset(own)

    def home(self, database: UserDatabase) -> Home | None:
        """The home directory of the user; None when the user is not known."""
        if self.manager != "system":
            return None
        if self.dynamic:
            return Home(None, HomeOrigin.DYNAMIC)
        if self.name is None:
            return None
        if self.name in ROOT:
            return Home("/root", HomeOrigin.ROOT)
        account = database.account(self.name)
        if account is not None:
            return Home(None if account.home in _NO_HOME else account.home, HomeOrigin.PASSWD)
        return None if self.is_number else Home(f"/home/{self.name}", HomeOrigin.CONVENTION)
