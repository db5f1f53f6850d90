"""The environment of a process: every variable with its value, where it comes from, and whether all sources are known.

It knows nothing of who runs the process: units, compose services, images, launch files and shells fill the same class.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.shell import Command
from bringup_lint.model.shell import Word
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

SETUP_FILE = regex(r"(?:^|/)(?:local_)?setup\.(?:bash|sh|zsh)$")
"""What sets up ROS: setup files of a distribution or a workspace."""
_ASSIGNMENT = regex(r"[A-Za-z_][A-Za-z0-9_]*\+?=")
_EXPANSION = regex(
    r"\\?\$(?:(?P<name>[A-Za-z_]\w*)|\{(?P<braced>[A-Za-z_]\w*)(?P<default>:?-[^{}]*)?\}|[({@*#?$!0-9])|`"
)
_BY_SHELL = regex(r"^~|[:=]~|\{[^{}$]*,|^\(")
"""What the shell replaces by something else where it is not quoted: homes, alternatives, arrays."""
_QUOTED = regex(r"[`'\"\\(]")
_TESTS = frozenset(
    ("[", "[[", "((", "!", "test", "false", "grep", "egrep", "pgrep", "command", "which", "type", "hash")
)
"""Programs whose status is asked for, so that what comes after ``&&`` is meant to run sometimes."""


class Variable(NamedTuple):
    """One setting of a variable."""

    name: str
    value: Located
    """As written, quotes removed."""
    text: str | None
    """What the process sees; None when that depends on something unknown."""
    origin: str
    """Who sets it: ``Environment=``, ``EnvironmentFile=``, ``export``, ``shell``, ``PassEnvironment=``,
    ``environment:``, ..."""


@dataclass(eq=False)
class Environment:
    """The variables of a process and their history."""

    chains: dict[str, list[Variable]] = field(default_factory=dict)
    """Name -> every setting in the order in which they apply; the last one wins. Empty list: unset on
    purpose."""
    complete: bool = True
    """Whether every source was found and read, so that a variable that is not here is not set."""

    def copy(self) -> Environment:
        return Environment({name: list(chain) for name, chain in self.chains.items()}, self.complete)

    def set(self, variable: Variable) -> None:
        self.chains.setdefault(variable.name, []).append(variable)

    def unset(self, name: str) -> None:
        if name in self.chains:
            self.chains[name] = []

    def get(self, name: str) -> Variable | None:
        """The setting that wins."""
        chain = self.chains.get(name)
        return chain[-1] if chain else None

    def text(self, name: str) -> str | None:
        """The value that the process sees; None when it is unset or unknown."""
        variable = self.get(name)
        return variable.text if variable else None

    def chain(self, name: str) -> list[Variable]:
        return self.chains.get(name, [])

    def defines(self, name: str) -> bool | None:
        """Whether the variable is set; None when a source that was not found may set it."""
        return True if self.get(name) else None if not self.complete else False

    def __contains__(self, name: str) -> bool:
        return bool(self.chains.get(name))

    def __iter__(self) -> Iterator[Variable]:
        """The settings that win."""
        return (chain[-1] for chain in self.chains.values() if chain)

    def expand(self, word: str) -> str | None:
        """A shell word with ``$NAME``, ``${NAME}`` and ``${NAME:-default}`` put in, but not where it is quoted; None
        when that is not known."""
        stretches = word.stretches() if isinstance(word, Word) else ((word, ""),)
        try:
            return "".join(part if quote == "'" else self._put_in(part, quote) for part, quote in stretches)
        except LookupError:
            return None

    def _put_in(self, text: str, quote: str) -> str:
        if not quote and _BY_SHELL.search(text):
            raise LookupError(text)
        return _EXPANSION.sub(self._value, text)

    def _value(self, match: re.Match[str]) -> str:
        name = match["name"] or match["braced"]
        if name is None or match[0].startswith("\\"):
            raise LookupError(match[0])
        found = self.get(name)
        default = match["default"]
        if found is not None:
            if found.text is None:
                raise LookupError(name)
            if found.text or not (default or "").startswith(":"):
                return found.text
        if default and not _QUOTED.search(default) and (found is not None or self.complete):
            return _EXPANSION.sub(self._value, default.lstrip(":")[1:])
        raise LookupError(name)


def stays_local(environment: Environment) -> bool:
    """Whether ROS 2 is told to talk to this machine only."""
    wide = environment.text("ROS_AUTOMATIC_DISCOVERY_RANGE")
    return environment.text("ROS_LOCALHOST_ONLY") == "1" or wide in ("LOCALHOST", "OFF")


def assign_before(environment: Environment, command: Command) -> None:
    """Add what is before a program on its own command line: ``NAME=value program``, ``env NAME=value program``."""
    for word in (*command.assignments, *command.words):
        if not _ASSIGNMENT.match(word) and word not in ("env", "exec"):
            break
        if "=" in word:
            _assign(environment, word, "shell", False)


def after_commands(environment: Environment, commands: Iterable[Command], known: Callable[[str], bool]) -> Environment:
    """The environment after shell commands (``model.shell.Command``): assignments, ``export``, ``unset``.

    What is inside ``if`` and the like, or after a test, may or may not run: that makes a value unknown. What is in a
    pipeline or in the background runs in a shell of its own. ``known`` tells which sourced files hide nothing.
    """
    now = environment.copy()
    before = ""
    perhaps = False
    for command in commands:
        perhaps = (perhaps and before in ("&&", "||")) or before == "||"
        if "|" not in (before, command.ends) and not command.background:
            _run(now, command, bool(command.depth or perhaps), known)
        perhaps = perhaps or command.name in _TESTS
        before = command.ends
    return now


def _run(environment: Environment, command: Command, perhaps: bool, known: Callable[[str], bool]) -> None:
    words = command.words
    if not words:
        for word in command.assignments:
            _assign(environment, word, "shell", perhaps)
    elif command.name in ("export", "declare", "typeset", "readonly", "local"):
        before = environment.copy() if len(words) > 2 else environment
        for word in words[1:]:
            if _ASSIGNMENT.match(word):
                _assign(environment, word, command.name, perhaps or "-i" in words, before)
            elif word.startswith("$"):
                environment.complete = False
    elif command.name == "unset" and "-f" not in words:
        for word in words[1:]:
            if perhaps:
                environment.set(Variable(str(word), word, None, "unset"))
            else:
                environment.unset(word)
    elif command.name in ("source", ".") and len(words) > 1 and not known(words[1]):
        environment.complete = False
    elif command.name in ("eval", "read", "printf", "let", "mapfile", "readarray", "getopts"):
        environment.complete &= command.name == "printf" and "-v" not in words


def _assign(
    environment: Environment, word: Located, origin: str, perhaps: bool, before: Environment | None = None
) -> None:
    """Set a variable; a command's words are expanded ``before`` it sets any."""
    equals = word.find("=")
    name, value = word[:equals], word.part(equals + 1, len(word))
    append = name.endswith("+")
    text = None if perhaps or append else (before or environment).expand(value)
    environment.set(Variable(name.rstrip("+"), value, text, origin))


UNKNOWN = Environment(complete=False)
"""The environment of somebody's shell."""
