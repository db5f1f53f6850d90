"""Parameter files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.qos_overrides import POLICIES as QOS_POLICIES
from bringup_lint.graph.params.questions.qos_overrides import WORDS as QOS_WORDS
from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.params.declared import Declared
    from bringup_lint.graph.params.declared_types import declared_type
    from bringup_lint.graph.params.declared_types import is_never_read
    from bringup_lint.graph.params.left_files import is_left
    from bringup_lint.graph.params.questions.camera_urls import RefusedUrl
    from bringup_lint.graph.params.questions.camera_urls import refused_urls
    from bringup_lint.graph.params.questions.covariances import Lopsided
    from bringup_lint.graph.params.questions.covariances import lopsided
    from bringup_lint.graph.params.questions.filter_chains import BrokenChain
    from bringup_lint.graph.params.questions.filter_chains import broken_chains
    from bringup_lint.graph.params.questions.fusion import SkippedSensor
    from bringup_lint.graph.params.questions.fusion import skipped_sensors
    from bringup_lint.graph.params.questions.navigation import NavigationProblem
    from bringup_lint.graph.params.questions.navigation import navigation_problems
    from bringup_lint.graph.params.questions.operator import OperatorProblem
    from bringup_lint.graph.params.questions.operator import operator_problems
    from bringup_lint.graph.params.questions.public import Unknown
    from bringup_lint.graph.params.questions.public import unknown_to_public
    from bringup_lint.graph.params.questions.qos_overrides import OverrideProblem
    from bringup_lint.graph.params.questions.qos_overrides import QosOverride
    from bringup_lint.graph.params.questions.qos_overrides import qos_overrides
    from bringup_lint.graph.params.questions.time import simulated
    from bringup_lint.graph.params.questions.time import waits_for_time
    from bringup_lint.graph.params.questions.unlisted import unlisted
    from bringup_lint.graph.params.questions.unmatched_rewrites import unmatched_rewrites
    from bringup_lint.graph.params.questions.unread import Unread
    from bringup_lint.graph.params.questions.unread import unread
    from bringup_lint.graph.params.questions.wrong_types import WrongType
    from bringup_lint.graph.params.questions.wrong_types import wrong_types
    from bringup_lint.graph.params.refused_files import severity_of_refusal
    from bringup_lint.graph.params.values import Item
    from bringup_lint.graph.params.values import holds_maps
    from bringup_lint.graph.params.values import indenting_tabs
    from bringup_lint.graph.params.values import is_flattened
    from bringup_lint.graph.params.values import tab_width
    from bringup_lint.graph.params.values import taken_back
    from bringup_lint.graph.plugins.hardware_parameters import HardwareParameter
    from bringup_lint.graph.plugins.incomplete import IncompleteController
    from bringup_lint.graph.plugins.joints import UnknownJoint
    from bringup_lint.graph.plugins.moveit import MoveItProblem
    from bringup_lint.graph.plugins.refused import Refused
    from bringup_lint.graph.plugins.unknown import UnknownPlugin
    from bringup_lint.graph.plugins.untyped import UntypedPlugin
    from bringup_lint.graph.plugins.xacro_refused import XacroRefused
    from bringup_lint.graph.topics.questions.foreign_files import foreign
    from bringup_lint.graph.topics.questions.frames import unknown_frames
    from bringup_lint.graph.topics.questions.gone_parameters import GoneParameters
    from bringup_lint.graph.topics.questions.gone_parameters import gone_parameters
    from bringup_lint.graph.topics.questions.parameter_blocks import unreached
    from bringup_lint.graph.topics.questions.parameter_blocks import unused
    from bringup_lint.graph.topics.questions.undeclared import Undeclared
    from bringup_lint.graph.topics.questions.undeclared import undeclared
    from bringup_lint.graph.topics.questions.unhanded_blocks import unhanded
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "QOS_POLICIES",
    "QOS_WORDS",
    "Block",
    "BrokenChain",
    "Declared",
    "GoneParameters",
    "HardwareParameter",
    "IncompleteController",
    "Item",
    "Lopsided",
    "MoveItProblem",
    "NavigationProblem",
    "OperatorProblem",
    "OverrideProblem",
    "Parameter",
    "ParameterFile",
    "QosOverride",
    "Refused",
    "RefusedUrl",
    "SkippedSensor",
    "Undeclared",
    "Unknown",
    "UnknownJoint",
    "UnknownPlugin",
    "Unread",
    "UntypedPlugin",
    "WrongType",
    "XacroRefused",
    "broken_chains",
    "declared_type",
    "foreign",
    "gone_parameters",
    "holds_maps",
    "indenting_tabs",
    "is_flattened",
    "is_left",
    "is_never_read",
    "lopsided",
    "navigation_problems",
    "operator_problems",
    "qos_overrides",
    "refused_urls",
    "severity_of_refusal",
    "simulated",
    "skipped_sensors",
    "tab_width",
    "taken_back",
    "undeclared",
    "unhanded",
    "unknown_frames",
    "unknown_to_public",
    "unlisted",
    "unmatched_rewrites",
    "unreached",
    "unread",
    "unused",
    "waits_for_time",
    "wrong_types",
]
