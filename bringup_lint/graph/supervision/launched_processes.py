"""Who notices when a process of a launch file ends."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import split
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.launch_values import Value

_CHECK_WORD = regex(
    r"(?:^|[/_.-])(?:check|checks|verify|validate|validation|preflight|pre_flight|self_?test|diagnose|wait_for)(?:$|[/_.-])"
)
_SHELL_TEST = regex(r"(?:^|[;&|(]\s*|\bif\s+|\s)(?:test\s+-|\[\s+-|\[\[\s)")
_SECONDS = regex(r"\d+(?:\.\d+)?")
_SHELLS = ("bash", "sh", "dash", "zsh")


def respawns(node: Started) -> bool | None:
    """Whether launch starts the process again; None when that is not known."""
    from bringup_lint.graph.launch.resolve import truth

    value = node.options.get("respawn")
    return False if value is None else truth(value)


def watched(node: Started, expansion: Expansion) -> bool:
    """Whether somebody reacts to the end of the process: an exit action or an event handler for it, or for any."""
    from bringup_lint.model.launch import Process

    action = node.action
    if isinstance(action, Process) and (action.on_exit or action.open):
        return True
    for handler, _ in expansion.handlers:
        if handler.event in ("OnProcessExit", "OnExecutionComplete", "", "EventHandler"):
            if handler.target is None or handler.target == action.key:
                return True
    return False


STEPS = ("sigterm_timeout", "sigkill_timeout")
"""After how many seconds launch goes on to the next signal, 5 each unless a process says otherwise."""


class StopTime(NamedTuple):
    """How long launch may need to stop all that it starts."""

    seconds: float
    given: list[Value]
    """The values that say so; none when they are launch's own."""


def stop_time(expansion: Expansion) -> StopTime | None:
    """None when it is not known."""
    from bringup_lint.graph.launch.resolve import text_of

    longest: StopTime | None = None
    for node in expansion.nodes:
        given = [node.options[name] for name in STEPS if name in node.options]
        texts = [text_of(value) for value in given]
        if any(text is None or not _SECONDS.fullmatch(text) for text in texts):
            return None
        seconds = sum(float(text) for text in texts if text) + 5.0 * (len(STEPS) - len(given))
        if longest is None or seconds > longest.seconds:
            longest = StopTime(seconds, given)
    return None if expansion.open else longest


def check_of(node: Started) -> str | None:
    """What a process checks, when it is a check: ``test -e /dev/x``, a script called check or verify."""
    from bringup_lint.graph.launch.resolve import text_of
    from bringup_lint.model.launch import Process

    if not isinstance(node.action, Process) or node.is_node:
        return None
    words = [text_of(word) or "" for word in node.arguments]
    if len(words) == 1:
        words = split(words[0])
    if not words:
        return None
    program = words[0].rpartition("/")[2]
    if program in ("test", "["):
        return " ".join(words)
    if program in _SHELLS and len(words) > 2 and words[1] in ("-c", "-ec", "-lc"):
        return words[2] if _SHELL_TEST.search(words[2]) and "||" not in words[2] else None
    script = words[1].rpartition("/")[2] if program in (*_SHELLS, "python3", "python") and len(words) > 1 else program
    return script if _CHECK_WORD.search(script) else None
