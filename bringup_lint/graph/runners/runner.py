"""Runner: whatever starts processes on the robot, in one shape.

A unit, a compose service, an image that is run alone, a script that people run, an ``@reboot`` line, a program of
supervisord: a rule about environments, devices, users, signals or secrets asks the runner and holds for all of them.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from enum import Enum
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.commands.environment import SETUP_FILE
from bringup_lint.graph.commands.environment import UNKNOWN
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import after_commands
from bringup_lint.graph.commands.environment import assign_before
from bringup_lint.graph.commands.typed import typed
from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import CommandLine
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.shell import Command
    from bringup_lint.source import Located
    from bringup_lint.source import Source
    from bringup_lint.source import Span

SUPERVISING = ("systemd-unit", "systemd-dropin", "compose", "dockerfile", "supervisord", "cron")
"""Kinds of files that start processes without a person."""


class RunnerKind(Enum):
    UNIT = "systemd unit"
    SERVICE = "compose service"
    IMAGE = "image"
    SCRIPT = "script"
    CRON = "cron job"
    PROGRAM = "supervised program"


class Start(NamedTuple):
    """One command that starts something of ROS, and the environment in which it runs."""

    ros: Ros
    environment: Environment
    line: CommandLine
    step: Step

    @property
    def arguments(self) -> list[tuple[Located, Located]]:
        """The names and values of ``name:=value`` words."""
        found = ((word, word.find(":=")) for word in self.ros.arguments)
        return [(word.part(0, at), word.part(at + 2, len(word))) for word, at in found if at > 0]


class Stop(NamedTuple):
    """How a runner is stopped. None: it is not known."""

    signal: str | None = "SIGTERM"
    seconds: float | None = None
    """Between the signal and the kill."""
    where: Located | None = None
    """What sets the signal."""


DEFAULT_STOP = Stop()
MOST_ENVIRONMENTS = 200
"""Programs of one command line of which each has an environment of its own; nothing is known of that of the others."""


@dataclass(eq=False)
class Runner:
    """One runner. ``environment`` is what its processes get before their own shells say more."""

    kind: RunnerKind
    name: str
    """How a message calls it: ``robot.service``, ``service 'driver'``."""
    where: Span
    environment: Environment
    lines: list[CommandLine] = field(default_factory=list)
    """Its command lines with what they run, those before and after the start included."""
    main: list[CommandLine] = field(default_factory=list)
    """Those that start what it is for."""
    runs_ros: bool = False
    """It takes part in the communication of ROS 2: it starts something of it, or its environment configures it."""
    system: str = ""
    """Runners with the same one run together: a boot, a compose file, a configuration of supervisord."""
    user: str | None = None
    """The user, ``root`` included; None when it is not known."""
    stop: Stop = DEFAULT_STOP
    restarts: bool | None = None
    """Whether it is started again after its end; None when it is not known."""
    asks_status: bool = False
    """Only an end that is a failure has it started again, or something else run."""
    purpose: Purpose = Purpose.ROBOT
    extent: Span | None = None
    """All that the file says of it, where a file holds several."""
    environment_files: tuple[tuple[Located, Source], ...] = ()
    """The environment files of the tree that it reads, each with the word that names it."""
    unit: Unit | None = None
    service: Service | None = None
    stage: Stage | None = None
    """The stage of a Dockerfile that becomes its image."""
    reads: Callable[[str], Source | None] = lambda path: None
    """The file of the tree at an absolute path, as its processes see it."""
    certain: bool = True
    """Whether it surely runs what the tree holds: an image from elsewhere may hold another version."""

    @property
    def source(self) -> Source:
        return self.where.source

    @property
    def in_container(self) -> bool:
        return self.service is not None or self.stage is not None

    @cached_property
    def starts(self) -> list[Start]:
        """The ROS programs on its main command lines."""
        return [start for line in self.main for start in self.starts_of(line)]

    @cached_property
    def launches(self) -> list[Start]:
        """Every ``ros2 launch`` on its command lines that names a launch file."""
        return [start for line in self.lines for start in self.starts_of(line) if is_launch(start)]

    @property
    def typed(self) -> list[Start]:
        """What its commands start in terminals, or give a short name."""
        return [
            Start(ros, UNKNOWN, line, step) for line in self.lines for step in line.steps for ros in typed(step.command)
        ]

    def starts_of(self, line: CommandLine) -> list[Start]:
        """The ROS programs that a command line starts."""
        return [
            Start(ros, self.environment_at(line, step) if number < MOST_ENVIRONMENTS else UNKNOWN, line, step)
            for number, (step, ros) in enumerate(line.ros)
        ]

    def environment_at(self, line: CommandLine, until: Step | None = None) -> Environment:
        """The environment at a step of a command line, or after all of them."""
        steps = line.steps[: line.steps.index(until)] if until is not None else line.steps
        found = after_commands(self.environment, [step.command for step in steps], self._hides_nothing)
        if until is not None:
            assign_before(found, until.command)
        if self.unit is not None:
            found.complete &= not line.opaque
        return found

    def _hides_nothing(self, path: str) -> bool:
        """Whether what a sourced file sets is known: it is one of ROS, or its commands are among the steps."""
        return bool(SETUP_FILE.search(path)) or (self.unit is not None and self.reads(path) is not None)

    @property
    def commands(self) -> Iterable[Command]:
        """The commands on its command lines and in the scripts that they run."""
        return (step.command for line in self.lines for step in line.steps)


def is_launch(start: Start) -> bool:
    return start.ros.kind == "launch" and start.ros.target is not None
