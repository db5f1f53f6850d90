"""The launch context: configurations, environment, namespace and what is set for all following nodes."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

CHANGES = 100
"""Changes of one variable that are kept."""


class Binding(NamedTuple):
    """A launch configuration: its value with all defaults, and the same in terms of what the user may pass."""

    value: Value
    symbol: Value
    origin: Span
    declared: bool
    """Bound by a declaration's default, and so open to ``name:=value`` on the command line."""


class EnvChange(NamedTuple):
    """One change of an environment variable, by an action or for one process."""

    value: Value | None
    """None when the variable is unset."""
    origin: str
    """The action or keyword: ``SetEnvironmentVariable``, ``additional_env``, ..."""
    span: Span
    mode: str = "set"
    """``set``, ``append`` or ``prepend``."""
    separator: Value | None = None
    certain: bool = True
    """Whether it happens for sure before the process starts."""

    @property
    def is_plain(self) -> bool:
        """Whether what was before does not matter any more."""
        return self.certain and self.mode == "set"


EnvChanges = tuple[EnvChange, ...]


@dataclass(slots=True)
class Scope:
    arguments: dict[str, Binding] = field(default_factory=dict)
    env: dict[str, EnvChanges] = field(default_factory=dict)
    """Name -> the changes since launch began, in order."""
    namespaces: tuple[Value, ...] = ()
    """Pushed, outermost first."""
    remaps: tuple[tuple[Value, Value], ...] = ()
    parameters: tuple[Value, ...] = ()
    """Set for all following nodes, in order."""

    def copy(self) -> Scope:
        return replace(self, arguments=dict(self.arguments), env=dict(self.env))

    def change(self, name: str, change: EnvChange) -> None:
        """Change the environment for what follows."""
        self.env[name] = (*self.env.get(name, ())[-CHANGES:], change)

    def cleared(self) -> Scope:
        """What a group sees that does not forward."""
        return Scope()


def perhaps(before: dict[str, EnvChanges], after: dict[str, EnvChanges]) -> dict[str, EnvChanges]:
    """The environment after changes that may or may not have happened."""
    result = {}
    for name in before | after:
        ours, theirs = before.get(name, ()), after.get(name, ())
        doubtful = tuple(change._replace(certain=False) for change in theirs if change not in ours)
        lost = tuple(change._replace(certain=False) for change in ours[-1:] if not theirs)
        result[name] = theirs if ours is theirs else (*ours, *doubtful, *lost)
    return result


def later(
    env: dict[str, EnvChanges], before: dict[str, EnvChanges], now: dict[str, EnvChanges], unsure: set[str]
) -> dict[str, EnvChanges]:
    """The environment of a process that a timer or handler starts. The environment belongs to the whole launch process:
    what was not changed in the timer itself is as it is when everything else has been visited."""
    result = {}
    for name in env | now:
        ours = env.get(name, ())
        if ours is before.get(name, ()):
            ours = now.get(name, ())
            if name in unsure:
                ours = tuple(change._replace(certain=False) for change in (*ours, *env.get(name, ())))
        if ours:
            result[name] = ours
    return result
