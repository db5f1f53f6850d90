"""Launch files: actions, values, and what a launch file starts."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.facts.ros.launch_api import module_of
    from bringup_lint.facts.ros.launch_arguments import OF_LAUNCH
    from bringup_lint.facts.ros.launch_calls import parameters_of
    from bringup_lint.facts.ros.public_programs import package_meant
    from bringup_lint.facts.ros.public_programs import public_package
    from bringup_lint.finding import Finding
    from bringup_lint.graph.dependencies.needs import Need
    from bringup_lint.graph.dependencies.undeclared import AT_RUN_TIME
    from bringup_lint.graph.dependencies.undeclared import Lack
    from bringup_lint.graph.dependencies.undeclared import Undeclared
    from bringup_lint.graph.dependencies.undeclared import undeclared
    from bringup_lint.graph.launch.expansion import Declared
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.expansion import Failed
    from bringup_lint.graph.launch.expansion import Used
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.lifecycle import Managed
    from bringup_lint.graph.launch.lifecycle import Manager
    from bringup_lint.graph.launch.lifecycle import full_name
    from bringup_lint.graph.launch.lifecycle import managers
    from bringup_lint.graph.launch.lifecycle import outside
    from bringup_lint.graph.launch.lifecycle import setting
    from bringup_lint.graph.launch.lifecycle import transitions_elsewhere
    from bringup_lint.graph.launch.lifecycle_names import as_lifecycle_node
    from bringup_lint.graph.launch.lifecycle_names import is_plain
    from bringup_lint.graph.launch.lifecycle_names import managed_names
    from bringup_lint.graph.launch.lifecycle_names import switched_by_program
    from bringup_lint.graph.launch.packages import is_known_package
    from bringup_lint.graph.launch.packages import package_like
    from bringup_lint.graph.launch.packages import path_of
    from bringup_lint.graph.launch.packages import yaml_names
    from bringup_lint.graph.launch.python_api import distribution_of
    from bringup_lint.graph.launch.python_api import looks_at_distribution
    from bringup_lint.graph.launch.python_api import names_of
    from bringup_lint.graph.launch.python_api import refused_calls
    from bringup_lint.graph.launch.python_api import removed_keywords
    from bringup_lint.graph.launch.questions.allowed_words import allowed_words
    from bringup_lint.graph.launch.questions.controllers import MANAGER
    from bringup_lint.graph.launch.questions.controllers import SPAWNER
    from bringup_lint.graph.launch.questions.controllers import has_controllers_apart
    from bringup_lint.graph.launch.questions.controllers import is_manager
    from bringup_lint.graph.launch.questions.controllers import starts_controllers
    from bringup_lint.graph.launch.questions.copied_packages import copied_packages
    from bringup_lint.graph.launch.questions.delays import delayed
    from bringup_lint.graph.launch.questions.delays import undelayed
    from bringup_lint.graph.launch.questions.delays import waiting_comment
    from bringup_lint.graph.launch.questions.entry_points import MissingEntry
    from bringup_lint.graph.launch.questions.entry_points import missing_entries
    from bringup_lint.graph.launch.questions.gone_arguments import GoneArgument
    from bringup_lint.graph.launch.questions.gone_arguments import gone_arguments
    from bringup_lint.graph.launch.questions.gone_packages import gone_packages
    from bringup_lint.graph.launch.questions.joined_commands import joined_commands
    from bringup_lint.graph.launch.questions.public_includes import Unpassed
    from bringup_lint.graph.launch.questions.public_includes import unpassed
    from bringup_lint.graph.launch.questions.public_includes import untaken
    from bringup_lint.graph.launch.questions.refused_words import in_degrees
    from bringup_lint.graph.launch.questions.refused_words import options_with_next
    from bringup_lint.graph.launch.questions.refused_words import refused_transforms
    from bringup_lint.graph.launch.questions.refused_words import turned
    from bringup_lint.graph.launch.questions.refused_words import unbridged
    from bringup_lint.graph.launch.questions.refused_words import unknown_flags
    from bringup_lint.graph.launch.questions.refused_words import unsplit_commands
    from bringup_lint.graph.launch.questions.refused_words import unsplit_ros_arguments
    from bringup_lint.graph.launch.questions.relative_paths import relative_paths
    from bringup_lint.graph.launch.questions.shared_devices import shared_devices
    from bringup_lint.graph.launch.questions.shutdowns import shut_down_by_helpers
    from bringup_lint.graph.launch.questions.unread_arguments import is_used
    from bringup_lint.graph.launch.questions.unread_arguments import unread_arguments
    from bringup_lint.graph.launch.reads import dead_reads
    from bringup_lint.graph.launch.reads import read_elsewhere
    from bringup_lint.graph.launch.reads import read_in
    from bringup_lint.graph.launch.reads import reads_unseen
    from bringup_lint.graph.launch.references import Reference
    from bringup_lint.graph.launch.resolve import text_of
    from bringup_lint.graph.launch.resolve import truth
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.launch.started import exclusive
    from bringup_lint.graph.launch.started import literal_text
    from bringup_lint.graph.launch.without_effect import happens_anyway
    from bringup_lint.graph.launch.without_effect import is_real_clock
    from bringup_lint.graph.launch.without_effect import passed_without_effect
    from bringup_lint.graph.params.questions.simulated_literally import Literally
    from bringup_lint.graph.params.questions.simulated_literally import simulated_literally
    from bringup_lint.graph.params.questions.simulated_literally import simulates_nothing
    from bringup_lint.graph.params.questions.simulated_public import simulated_by_public
    from bringup_lint.graph.params.questions.simulation_arguments import simulated_by_default
    from bringup_lint.graph.plugins.controllers import UntypedController
    from bringup_lint.graph.runners.launching import Launching
    from bringup_lint.graph.runners.questions.refused_choices import choices_of
    from bringup_lint.graph.runners.questions.refused_choices import refused_choices
    from bringup_lint.graph.runners.questions.required_arguments import not_passed
    from bringup_lint.graph.supervision.launched_processes import check_of
    from bringup_lint.graph.supervision.launched_processes import respawns
    from bringup_lint.graph.supervision.launched_processes import watched
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch import ComposableNode
    from bringup_lint.model.launch import DeclareArgument
    from bringup_lint.model.launch import Emit
    from bringup_lint.model.launch import EventHandler
    from bringup_lint.model.launch import Group
    from bringup_lint.model.launch import Include
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.model.launch import LoadComponents
    from bringup_lint.model.launch import Log
    from bringup_lint.model.launch import Node
    from bringup_lint.model.launch import ObjectAsValue
    from bringup_lint.model.launch import OldKeyword
    from bringup_lint.model.launch import Opaque
    from bringup_lint.model.launch import Other
    from bringup_lint.model.launch import Process
    from bringup_lint.model.launch import RefusedCall
    from bringup_lint.model.launch import SetEnv
    from bringup_lint.model.launch import SetParameter
    from bringup_lint.model.launch import Timer
    from bringup_lint.model.launch import UnplacedAction
    from bringup_lint.model.launch import Wait
    from bringup_lint.model.launch import walk_actions
    from bringup_lint.model.launch_values import Argument
    from bringup_lint.model.launch_values import Choice
    from bringup_lint.model.launch_values import Command
    from bringup_lint.model.launch_values import Concat
    from bringup_lint.model.launch_values import Condition
    from bringup_lint.model.launch_values import DerivedFile
    from bringup_lint.model.launch_values import DictValue
    from bringup_lint.model.launch_values import Env
    from bringup_lint.model.launch_values import FileDir
    from bringup_lint.model.launch_values import ListValue
    from bringup_lint.model.launch_values import Literal
    from bringup_lint.model.launch_values import Operation
    from bringup_lint.model.launch_values import PackageShare
    from bringup_lint.model.launch_values import ParameterFile
    from bringup_lint.model.launch_values import PathJoin
    from bringup_lint.model.launch_values import TypedValue
    from bringup_lint.model.launch_values import Unknown
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.launch_values import literal
    from bringup_lint.model.launch_values import same
    from bringup_lint.model.launch_values import understood
    from bringup_lint.model.launch_values import walk
    from bringup_lint.parsers.names_beside import names_beside
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "AT_RUN_TIME",
    "MANAGER",
    "OF_LAUNCH",
    "SPAWNER",
    "Action",
    "Argument",
    "Choice",
    "Command",
    "ComposableNode",
    "Concat",
    "Condition",
    "DeclareArgument",
    "Declared",
    "DerivedFile",
    "DictValue",
    "Emit",
    "Env",
    "EventHandler",
    "Expansion",
    "Failed",
    "FileDir",
    "GoneArgument",
    "Group",
    "Include",
    "Lack",
    "LaunchFile",
    "Launching",
    "ListValue",
    "Literal",
    "Literally",
    "LoadComponents",
    "Log",
    "Managed",
    "Manager",
    "MissingEntry",
    "Need",
    "Node",
    "ObjectAsValue",
    "OldKeyword",
    "Opaque",
    "Operation",
    "Other",
    "Package",
    "PackageShare",
    "ParameterFile",
    "PathJoin",
    "Process",
    "Reference",
    "RefusedCall",
    "SetEnv",
    "SetParameter",
    "Started",
    "Timer",
    "TypedValue",
    "Undeclared",
    "Unknown",
    "Unpassed",
    "UnplacedAction",
    "UntypedController",
    "Used",
    "Value",
    "Wait",
    "allowed_words",
    "as_lifecycle_node",
    "check_of",
    "choices_of",
    "copied_packages",
    "dead_reads",
    "delayed",
    "distribution_of",
    "exclusive",
    "full_name",
    "gone_arguments",
    "gone_packages",
    "happens_anyway",
    "has_controllers_apart",
    "in_degrees",
    "is_known_package",
    "is_manager",
    "is_plain",
    "is_real_clock",
    "is_used",
    "joined_commands",
    "literal",
    "literal_text",
    "looks_at_distribution",
    "managed_names",
    "managers",
    "missing_entries",
    "module_of",
    "names_beside",
    "names_of",
    "not_passed",
    "options_with_next",
    "outside",
    "package_like",
    "package_meant",
    "parameters_of",
    "passed_without_effect",
    "path_of",
    "public_package",
    "read_elsewhere",
    "read_in",
    "reads_unseen",
    "refused",
    "refused_calls",
    "refused_choices",
    "refused_transforms",
    "relative_paths",
    "removed_keywords",
    "respawns",
    "same",
    "setting",
    "shared_devices",
    "shut_down_by_helpers",
    "simulated_by_default",
    "simulated_by_public",
    "simulated_literally",
    "simulates_nothing",
    "starts_controllers",
    "switched_by_program",
    "text_of",
    "transitions_elsewhere",
    "truth",
    "turned",
    "unbridged",
    "undeclared",
    "undelayed",
    "understood",
    "unknown_flags",
    "unpassed",
    "unread_arguments",
    "unsplit_commands",
    "unsplit_ros_arguments",
    "untaken",
    "waiting_comment",
    "walk",
    "walk_actions",
    "watched",
    "yaml_names",
]


def refused(launch: Launch, code: str, otherwise: str) -> Iterator[Finding]:
    """What launch refuses for one of the codes of its grammar; ``otherwise`` advises where no known name is near."""
    from bringup_lint.parsers.names_beside import is_free
    from bringup_lint.parsers.names_beside import names_beside

    for file in launch.judged:
        for each in launch.refusals(file):
            if each.code == code:
                near = each.near[0] if len(each.near) == 1 else ""
                is_clear = near and each.is_spelling and is_free(near, each.word, names_beside(each.word))
                yield finding(
                    each.where,
                    each.effect,
                    advice=f"write {near}" if near else otherwise,
                    confidence="medium" if each.extension else None,
                    fix=fix(f"write {near}", (each.where, near), safe=False) if is_clear else None,
                )
