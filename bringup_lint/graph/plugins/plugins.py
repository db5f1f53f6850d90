"""What ros2_control and Navigation2 load, the joints that they are told to use, and the descriptions that have them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.plugins.claims import Claim
from bringup_lint.graph.plugins.claims import claims
from bringup_lint.graph.plugins.controllers import UntypedController
from bringup_lint.graph.plugins.controllers import unnamed_controllers
from bringup_lint.graph.plugins.controllers import untyped_controllers
from bringup_lint.graph.plugins.description_words import MisspeltWord
from bringup_lint.graph.plugins.description_words import misspelt_words
from bringup_lint.graph.plugins.drive_commands import Unstamped
from bringup_lint.graph.plugins.drive_commands import unstamped_commands
from bringup_lint.graph.plugins.gone_simulator_plugins import GonePlugin
from bringup_lint.graph.plugins.gone_simulator_plugins import gone_simulator_plugins
from bringup_lint.graph.plugins.hardware_parameters import HardwareParameter
from bringup_lint.graph.plugins.hardware_parameters import hardware_parameters
from bringup_lint.graph.plugins.incomplete import IncompleteController
from bringup_lint.graph.plugins.incomplete import incomplete_controllers
from bringup_lint.graph.plugins.joints import UnknownJoint
from bringup_lint.graph.plugins.joints import unknown_joints
from bringup_lint.graph.plugins.meshes import MissingMesh
from bringup_lint.graph.plugins.meshes import missing_meshes
from bringup_lint.graph.plugins.misspelt import Misspelt
from bringup_lint.graph.plugins.misspelt import misspelt_names
from bringup_lint.graph.plugins.moveit import MoveItProblem
from bringup_lint.graph.plugins.moveit import moveit_problems
from bringup_lint.graph.plugins.moveit_files import MissingMoveItFile
from bringup_lint.graph.plugins.moveit_files import missing_moveit_files
from bringup_lint.graph.plugins.moveit_namespaces import ControllersElsewhere
from bringup_lint.graph.plugins.moveit_namespaces import controllers_elsewhere
from bringup_lint.graph.plugins.refused import Refused
from bringup_lint.graph.plugins.refused import refused_descriptions
from bringup_lint.graph.plugins.renamed import RenamedControllers
from bringup_lint.graph.plugins.renamed import renamed_controllers
from bringup_lint.graph.plugins.simulator_hardware import OtherSimulator
from bringup_lint.graph.plugins.simulator_hardware import other_simulators
from bringup_lint.graph.plugins.srdf import UnknownName
from bringup_lint.graph.plugins.srdf import unknown_names
from bringup_lint.graph.plugins.unknown import Named
from bringup_lint.graph.plugins.unknown import UnknownPlugin
from bringup_lint.graph.plugins.unread_descriptions import Unread
from bringup_lint.graph.plugins.unread_descriptions import unread_descriptions
from bringup_lint.graph.plugins.untyped import UntypedPlugin
from bringup_lint.graph.plugins.untyped import untyped_plugins
from bringup_lint.graph.plugins.xacro_arguments import UnknownArgument
from bringup_lint.graph.plugins.xacro_arguments import unknown_arguments
from bringup_lint.graph.plugins.xacro_refused import XacroRefused
from bringup_lint.graph.plugins.xacro_refused import xacro_refused

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params
    from bringup_lint.source import Located


class Plugins:
    """Controllers, hardware and servers with what they load, and the robot descriptions that go with them."""

    def __init__(self, files: Files, launch: Launch, params: Callable[[], Params]) -> None:
        self._files = files
        self._launch = launch
        self._params = params

    @cached_property
    def unknown(self) -> list[UnknownPlugin]:
        """Plugins that robot descriptions and parameter files name, and that no package exports."""
        return self._named.unknown

    @cached_property
    def described(self) -> frozenset[str]:
        """The classes of hardware and of transmissions that the robot descriptions name."""
        return frozenset(str(name) for each in self._named.descriptions for name in each.plugins)

    @cached_property
    def _named(self) -> Named:
        return Named(self._files, self._launch.workspace, self._params)

    @cached_property
    def untyped(self) -> list[list[UntypedPlugin]]:
        """Plugins that parameter files tell a server of Navigation2 to load, without their class; those of one file
        together."""
        return list(untyped_plugins(self._params()))

    @cached_property
    def untyped_controllers(self) -> list[UntypedController]:
        """Controllers that launch files spawn, of types that their manager is not given."""
        return list(untyped_controllers(self._launch, self._params()))

    @cached_property
    def unnamed_controllers(self) -> list[tuple[Located, Started, Located]]:
        """Controllers that launch files spawn and that nothing else names, with the spawner and one that is named."""
        return list(unnamed_controllers(self._launch, self._files))

    @cached_property
    def renamed_controllers(self) -> list[RenamedControllers]:
        """Controllers that get the name of their manager, because a launch file names it."""
        return list(renamed_controllers(self._launch, self._params()))

    @cached_property
    def incomplete_controllers(self) -> list[list[IncompleteController]]:
        """The parameters that controllers of ros2_controllers lack and without which they are not configured, those of
        one controller together."""
        return list(incomplete_controllers(self._params(), self._launch, self._launch.workspace.packages))

    @cached_property
    def claims(self) -> list[Claim]:
        """Controllers that are activated together and claim the same interface of a joint."""
        return list(claims(self._files.tree, self._launch, self._params()))

    @cached_property
    def unknown_joints(self) -> list[UnknownJoint]:
        """Joints and interfaces that controllers are told to use, and that no description of the tree has."""
        return list(unknown_joints(self._files, self._params(), self._launch.workspace.packages))

    @cached_property
    def refused_descriptions(self) -> list[list[Refused]]:
        """What is wrong with robot descriptions, that of one file together."""
        return list(refused_descriptions(self._files, self._launch.workspace))

    @cached_property
    def unread_descriptions(self) -> list[Unread]:
        """Robot descriptions that are not well-formed XML."""
        return list(unread_descriptions(self._files))

    @cached_property
    def xacro_refused(self) -> list[XacroRefused]:
        """Names in descriptions that xacro does not know, each once in a file."""
        return list(xacro_refused(self._files, self._launch.workspace))

    @cached_property
    def misspelt_names(self) -> list[Misspelt]:
        """Names of frames, joints, interfaces and hardware parameters that only one place of the tree has, beside one
        that differs in a letter."""
        return list(misspelt_names(self._files, self._params(), self._launch.workspace))

    @cached_property
    def misspelt_words(self) -> list[MisspeltWord]:
        """Misspelt elements, attributes and types of descriptions."""
        return list(misspelt_words(self._files))

    @cached_property
    def missing_meshes(self) -> list[list[MissingMesh]]:
        """Meshes that descriptions name and that packages of the tree do not have, those of one file together."""
        return list(missing_meshes(self._files, self._launch.workspace))

    @cached_property
    def gone_simulator_plugins(self) -> list[list[GonePlugin]]:
        """Plugins of Gazebo Classic that descriptions name, and that only ROS 1 has: all of them together."""
        return list(filter(None, [list(gone_simulator_plugins(self._files, self._launch.workspace))]))

    @cached_property
    def other_simulators(self) -> list[OtherSimulator]:
        """Hardware in descriptions that is of another simulator than the one whose plugin is loaded."""
        return list(other_simulators(self._files, self._launch.workspace))

    @cached_property
    def unknown_arguments(self) -> list[UnknownArgument]:
        """Arguments that launch files give to xacro, and that the description does not declare."""
        return list(unknown_arguments(self._launch, self._files.tree))

    @cached_property
    def unstamped_commands(self) -> list[Unstamped]:
        """Commands without a time stamp for drive controllers that take only stamped ones."""
        return list(unstamped_commands(self._launch, self._params()))

    @cached_property
    def moveit_problems(self) -> list[MoveItProblem]:
        """Groups and controllers that MoveIt is configured for, and that the robot does not have."""
        return list(moveit_problems(self._files.tree, self._launch.workspace, self._params()))

    @cached_property
    def unknown_srdf_names(self) -> list[UnknownName]:
        """Links and joints of an SRDF that the description of its robot does not have, those of one file together."""
        return list(unknown_names(self._files.tree, self._launch.workspace.packages))

    @cached_property
    def missing_moveit_files(self) -> list[list[MissingMoveItFile]]:
        """Files that MoveItConfigsBuilder opens, and that its package does not have, those of one builder together."""
        return list(missing_moveit_files(self._launch, self._files.tree))

    @cached_property
    def controllers_elsewhere(self) -> list[ControllersElsewhere]:
        """Controllers to which MoveIt sends in a namespace where no controller manager runs."""
        return list(controllers_elsewhere(self._launch, self._files.tree))

    @cached_property
    def hardware_parameters(self) -> list[HardwareParameter]:
        """Parameters of hardware that its source needs and is not given, does not read, or takes for another value."""
        return list(hardware_parameters(self._files))
