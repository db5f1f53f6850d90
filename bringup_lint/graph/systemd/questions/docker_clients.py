"""The Docker commands of services: what a unit asks the daemon for, and whether the client stays."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.docker_options import run_options
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.systemd.process import Process
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

_CLIENTS = frozenset({"docker", "nvidia-docker"})
_COMPOSE = frozenset({"docker-compose"})
_STARTING = frozenset({"run", "start", "up"})
_STOPPING = frozenset({"down", "stop", "kill", "rm"})
_ASKS_HOW = "SERVICE_RESULT"
"""What tells a command of ExecStop= how the service ended. Source: systemd.exec(5)."""
_IGNORES = "--ignore-pull-failures"
_OWN_REGISTRIES = ("localhost", "127.0.0.1", "$", "{")
_DAEMON_OPTIONS = frozenset({"-H", "--host", "-c", "--context", "--config", "-l", "--log-level"})
_COMPOSE_OPTIONS = frozenset({"-f", "--file", "-p", "--project-name", "--env-file", "--profile", "--project-directory"})


class DockerCommand(NamedTuple):
    """A command about containers or images."""

    process: Process
    step: Step
    verb: Located
    """``run``, ``up``, ``stop``, ``pull`` and the like."""
    compose: bool
    options: tuple[Located, ...]
    """The words after the verb."""

    @property
    def detached(self) -> bool:
        """Whether the client ends as soon as the containers run."""
        if self.verb == "start":
            return not any(word in ("-a", "-ai", "-ia", "-i", "--attach", "--interactive") for word in self.options)
        return any(word == "--detach" or _has_letter(word, "d") for word in self.options)

    @property
    def containers(self) -> tuple[str, ...]:
        """The names of the containers, where the command gives them."""
        if self.verb == "run":
            return tuple(str(each.value) for each in run_options(self.options) if each.name == "--name")
        return tuple(str(word) for word in self.options if not word.startswith("-"))

    @property
    def restarted_by_docker(self) -> bool:
        """Whether a restart policy that the command gives keeps the container running."""
        return any(word.startswith("--restart") and word != "--restart=no" for word in self.options)


def docker_starts(process: Process) -> Iterator[DockerCommand]:
    """The commands of a process by which the Docker daemon of this machine starts containers."""
    return _commands(process, _STARTING)


def docker_stop(start: DockerCommand, process: Process) -> Located | None:
    """The word by which a process always takes down what a command has started."""
    if _ASKS_HOW in process.line:
        return None
    return next((each.verb for each in _commands(process, _STOPPING) if _takes_down(each, start)), None)


def _takes_down(stop: DockerCommand, start: DockerCommand) -> bool:
    named = {str(word) for word in stop.options if not word.startswith("-")}
    if start.compose or stop.compose:
        return start.compose and stop.compose and not named
    return not named.isdisjoint(start.containers)


def docker_pulls(process: Process) -> Iterator[Located]:
    """The words by which a process asks a registry for images whenever it runs, and fails without an answer."""
    for pull in _commands(process, frozenset({"pull"})):
        images = [word for word in pull.options if not word.startswith("-")]
        if _IGNORES not in pull.options and not any(word.startswith(_OWN_REGISTRIES) for word in images):
            yield pull.verb
    for start in docker_starts(process):
        pairs = zip(start.options, (*start.options[1:], ""))
        yield from (
            word for word, value in pairs if word == "--pull=always" or (word == "--pull" and value == "always")
        )


def _commands(process: Process, verbs: frozenset[str]) -> Iterator[DockerCommand]:
    for step in process.steps:
        words = unwrapped(step.command.words)
        name = program_name(words[0]) if words else ""
        if name not in _CLIENTS | _COMPOSE:
            continue
        compose = name in _COMPOSE
        rest = _after_options(words[1:], _COMPOSE_OPTIONS if compose else _DAEMON_OPTIONS)
        if rest and rest[0] == "compose":
            compose, rest = True, _after_options(rest[1:], _COMPOSE_OPTIONS)
        if rest and rest[0] in ("container", "image", "stack"):
            rest = rest[1:]
        if rest and rest[0] in verbs and not _is_remote(words):
            yield DockerCommand(process, step, rest[0], compose, _own_options(rest[0], rest[1:], compose))


def _after_options(words: tuple[Located, ...], valued: frozenset[str]) -> tuple[Located, ...]:
    at = 0
    while at < len(words) and words[at].startswith("-"):
        at += 2 if words[at] in valued else 1
    return words[at:]


def _own_options(verb: Located, words: tuple[Located, ...], compose: bool) -> tuple[Located, ...]:
    """The options of the command itself, without those of the program in the container."""
    if compose or verb != "run":
        return words
    return tuple(word for option in run_options(words) for word in option.words)


def _is_remote(words: tuple[Located, ...]) -> bool:
    return any(word in ("-H", "--host", "--context") or word.startswith(("--host=", "--context=")) for word in words)


def _has_letter(word: str, letter: str) -> bool:
    """Whether a word is a group of single-letter switches with this one, such as ``-itd``."""
    return word.startswith("-") and not word.startswith("--") and word[1:].isalpha() and letter in word[1:5]
