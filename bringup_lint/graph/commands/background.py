"""The jobs that a command line leaves in the background, and whether its shell stays with them."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_PASSING = ("echo", "printf", "true", "logger", "exit", ":", "disown")
_BUILTINS = ("trap", "set", "export", "cd", "kill")
"""What takes no time after a job; ``kill`` is of a trap."""
SHORT = frozenset(("sleep", "stty", "echo", "modprobe", "amixer", "aplay", "logger", "systemd-notify"))
"""Programs that end by themselves."""
_FILES = ("touch", "mkdir", "chmod", "chown", "rm", "cp", "mv", "ln", "date", "sync", "source", ".")
_LONGEST = regex(r"\d{1,3}(?:\.\d{1,9})?s?")
"""What sleep takes where a script does not wait forever."""
_INTERPRETERS = regex(r"roslaunch|rosrun|roscore|python[\d.]*|node|nodejs|npm|(?:ba|da|z)?sh")
_SERVERS = regex(
    r"ros(?:launch|run|core)|gst-launch-1\.0|MicroXRCEAgent|micro_ros_agent|mjpg_streamer|zenohd|zenoh-bridge-\w+"
    r"|mavlink-routerd|mavproxy\.py|iox-roudi|fast-discovery-server"
)
"""Programs that run until they are stopped, wherever they are started."""


class Job(NamedTuple):
    step: Step
    ends: bool
    """Nothing keeps the shell running after it."""


def background_jobs(line: CommandLine) -> Iterator[Job]:
    """The programs of a robot in the background; nothing for a shell that waits for the first one to end, and nothing
    for the only program of a shell that waits for it."""
    if any(step.command.name == "wait" and "-n" in step.command.words for step in line.steps):
        return
    jobs = [at for at, step in enumerate(line.steps) if step.command.background and _lasts(line, step)]
    if len(jobs) == 1 and _only_waits(line.steps[jobs[0] + 1 :]):
        return
    for at in jobs:
        step = line.steps[at]
        ends = not any(_keeps_running(later) for later in line.steps[at + 1 :])
        yield Job(step, ends and not step.command.depth)


def ends_after(line: CommandLine, step: Step) -> bool:
    """Whether nothing keeps a shell running after one of its commands, but what ends by itself."""
    at = next(at for at, each in enumerate(line.steps) if each is step)
    after = line.steps[at + 1 :]
    return not any(_keeps_running(later) and not _is_short(later) for later in after)


def _only_waits(after: Sequence[Step]) -> bool:
    """Whether the shell ends when its job does: it waits for it, and does nothing else that takes its time."""
    names = [step.command.name for step in after if _keeps_running(step) and step.command.name not in _BUILTINS]
    return bool(names) and set(names) == {"wait"}


def _lasts(line: CommandLine, step: Step) -> bool:
    """Whether a job is a program of the robot: of ROS, a server, or an interpreter that the line itself starts."""
    if any(other is step and found.kind != "cli" for other, found in line.ros):
        return True
    words = unwrapped(step.command.words)
    name = program_name(words[0]) if words else ""
    return bool(_SERVERS.fullmatch(name)) or (step.script is None and bool(_INTERPRETERS.fullmatch(name)))


def _keeps_running(step: Step) -> bool:
    """Whether a later command may take its time: wait, a foreground program, a loop."""
    command = step.command
    return bool(command.words) and not command.background and command.name not in _PASSING


def _is_short(step: Step) -> bool:
    """Whether a command ends by itself; in a loop it may be repeated forever."""
    command = step.command
    if command.depth or (command.name == "sleep" and not all(map(_LONGEST.fullmatch, command.words[1:]))):
        return False
    return command.name in SHORT or command.name in _BUILTINS or command.name in _FILES
