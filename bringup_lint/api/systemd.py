"""Units: settings and their spelling, directives, who a service runs as and what it sees, edits of unit files."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.facts.systemd import directives
    from bringup_lint.facts.systemd.directives import Legacy
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.commands.environment import Environment
    from bringup_lint.graph.commands.environment import Variable
    from bringup_lint.graph.commands.open_access import Offer
    from bringup_lint.graph.commands.open_access import open_access
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.installed.named_instances import named_instances
    from bringup_lint.graph.runners.questions.refused_writes import RefusedWrite
    from bringup_lint.graph.runners.questions.refused_writes import refused_writes
    from bringup_lint.graph.systemd.cycles import Cycle
    from bringup_lint.graph.systemd.directories import line_to_create
    from bringup_lint.graph.systemd.directories import paths
    from bringup_lint.graph.systemd.identity import HomeOrigin
    from bringup_lint.graph.systemd.identity import Identity
    from bringup_lint.graph.systemd.network_online import ONLINE
    from bringup_lint.graph.systemd.network_online import TooEarly
    from bringup_lint.graph.systemd.network_online import edits_to_wait
    from bringup_lint.graph.systemd.network_online import too_early
    from bringup_lint.graph.systemd.network_online import waits_itself
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.graph.systemd.questions.capabilities import file_capabilities
    from bringup_lint.graph.systemd.questions.docker_clients import DockerCommand
    from bringup_lint.graph.systemd.questions.docker_clients import docker_pulls
    from bringup_lint.graph.systemd.questions.docker_clients import docker_starts
    from bringup_lint.graph.systemd.questions.docker_clients import docker_stop
    from bringup_lint.graph.systemd.questions.ending import set_up
    from bringup_lint.graph.systemd.questions.hidden_home import HiddenHome
    from bringup_lint.graph.systemd.questions.hidden_home import hidden_home
    from bringup_lint.graph.systemd.questions.kept_off import kept_off
    from bringup_lint.graph.systemd.questions.left_out import left_out_units
    from bringup_lint.graph.systemd.questions.limits import limit_line
    from bringup_lint.graph.systemd.questions.limits import missing_limits
    from bringup_lint.graph.systemd.questions.limits import sets_priority
    from bringup_lint.graph.systemd.questions.log_directory import LogAccess
    from bringup_lint.graph.systemd.questions.log_directory import LogDirectory
    from bringup_lint.graph.systemd.questions.log_directory import Obstacle
    from bringup_lint.graph.systemd.questions.log_directory import Unwritable
    from bringup_lint.graph.systemd.questions.log_directory import log_directory
    from bringup_lint.graph.systemd.questions.memory import memory
    from bringup_lint.graph.systemd.questions.needless_root import NeedlessRoot
    from bringup_lint.graph.systemd.questions.needless_root import Work
    from bringup_lint.graph.systemd.questions.needless_root import changes_user
    from bringup_lint.graph.systemd.questions.needless_root import needless_root
    from bringup_lint.graph.systemd.questions.needless_root import reads_display_of_root
    from bringup_lint.graph.systemd.questions.never_enabled import installed_at
    from bringup_lint.graph.systemd.questions.never_enabled import never_enabled_units
    from bringup_lint.graph.systemd.questions.restart_loop import CrashLoop
    from bringup_lint.graph.systemd.questions.restart_loop import Outcome
    from bringup_lint.graph.systemd.questions.restart_loop import crash_loops
    from bringup_lint.graph.systemd.questions.restart_loop import only_connects
    from bringup_lint.graph.systemd.questions.restart_loop import sufficient_limit
    from bringup_lint.graph.systemd.questions.timers import Misspelt
    from bringup_lint.graph.systemd.questions.timers import has_trigger
    from bringup_lint.graph.systemd.questions.timers import misspelt_trigger
    from bringup_lint.graph.systemd.questions.unsourced import NotSourced
    from bringup_lint.graph.systemd.questions.unsourced import SourcedBefore
    from bringup_lint.graph.systemd.questions.unsourced import unsourced
    from bringup_lint.graph.systemd.questions.unstartable import Defect
    from bringup_lint.graph.systemd.questions.unstartable import is_own_program
    from bringup_lint.graph.systemd.questions.unstartable import unstartable
    from bringup_lint.graph.systemd.restart import RestartPolicy
    from bringup_lint.graph.systemd.sandbox import Sandbox
    from bringup_lint.graph.systemd.sandbox import View
    from bringup_lint.graph.systemd.settings import duration
    from bringup_lint.graph.systemd.supervision import Supervision
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.unit_edits import delete_lines
    from bringup_lint.graph.systemd.unit_edits import lift_comment
    from bringup_lint.graph.systemd.unit_edits import move_lines
    from bringup_lint.graph.systemd.unit_lines import Line
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.unit import Assignment
    from bringup_lint.model.unit import UnitFile
    from bringup_lint.parsers.systemd_values import is_unit_name
    from bringup_lint.parsers.systemd_values.commands import Command
    from bringup_lint.parsers.systemd_values.problems import ValueProblem
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "ONLINE",
    "Assignment",
    "Command",
    "CrashLoop",
    "Cycle",
    "Defect",
    "DockerCommand",
    "Environment",
    "HiddenHome",
    "HomeOrigin",
    "Identity",
    "Legacy",
    "Line",
    "LogAccess",
    "LogDirectory",
    "Misspelt",
    "NeedlessRoot",
    "NotSourced",
    "Obstacle",
    "Offer",
    "Outcome",
    "Process",
    "RefusedWrite",
    "RestartPolicy",
    "Ros",
    "Sandbox",
    "SourcedBefore",
    "Step",
    "Supervision",
    "TooEarly",
    "Unit",
    "UnitFile",
    "Units",
    "Unwritable",
    "ValueProblem",
    "Variable",
    "View",
    "Work",
    "changes_user",
    "crash_loops",
    "delete_lines",
    "directives",
    "docker_pulls",
    "docker_starts",
    "docker_stop",
    "duration",
    "edits_to_wait",
    "file_capabilities",
    "has_trigger",
    "hidden_home",
    "installed_at",
    "is_own_program",
    "is_unit_name",
    "kept_off",
    "left_out_units",
    "lift_comment",
    "limit_line",
    "line_to_create",
    "log_directory",
    "memory",
    "missing_limits",
    "misspelt_trigger",
    "move_lines",
    "named_instances",
    "needless_root",
    "never_enabled_units",
    "only_connects",
    "open_access",
    "paths",
    "reads_display_of_root",
    "refused_writes",
    "set_up",
    "sets_priority",
    "sufficient_limit",
    "too_early",
    "unsourced",
    "unstartable",
    "waits_itself",
]
