"""Units: settings, processes, sandboxes and the edits of unit files."""

from __future__ import annotations

from bringup_lint.facts.systemd import directives
from bringup_lint.facts.systemd.directives import Legacy
from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.systemd.capabilities import file_capabilities
from bringup_lint.graph.systemd.cycles import Cycle
from bringup_lint.graph.systemd.filesystem import forgotten
from bringup_lint.graph.systemd.filesystem import is_made
from bringup_lint.graph.systemd.filesystem import is_there
from bringup_lint.graph.systemd.limits import granted_limits
from bringup_lint.graph.systemd.memory import memory
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.sandbox import LogDirectory
from bringup_lint.graph.systemd.sandbox import Sandbox
from bringup_lint.graph.systemd.sandbox import View
from bringup_lint.graph.systemd.sandbox import paths
from bringup_lint.graph.systemd.sandbox import sandbox
from bringup_lint.graph.systemd.settings import duration
from bringup_lint.graph.systemd.settings import flag
from bringup_lint.graph.systemd.supervision import Supervision
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.unit_edits import delete_lines
from bringup_lint.graph.systemd.unit_edits import lift_comment
from bringup_lint.graph.systemd.unit_edits import move_lines
from bringup_lint.graph.systemd.unit_lines import Line
from bringup_lint.graph.systemd.units import Units
from bringup_lint.model.unit import Assignment
from bringup_lint.parsers.systemd_values.commands import Command
from bringup_lint.parsers.systemd_values.problems import ValueProblem

__all__ = [
    "Assignment",
    "Command",
    "Cycle",
    "Environment",
    "Legacy",
    "Line",
    "LogDirectory",
    "Process",
    "RestartPolicy",
    "Ros",
    "Sandbox",
    "Step",
    "Supervision",
    "Unit",
    "Units",
    "ValueProblem",
    "Variable",
    "View",
    "delete_lines",
    "directives",
    "duration",
    "file_capabilities",
    "flag",
    "forgotten",
    "granted_limits",
    "is_made",
    "is_there",
    "lift_comment",
    "memory",
    "move_lines",
    "paths",
    "sandbox",
]
