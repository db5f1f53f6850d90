"""Dockerfiles: stages, and what runs in them."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import CommandLine
    from bringup_lint.graph.containers.base_images import ended_release
    from bringup_lint.graph.containers.base_images import has_dash
    from bringup_lint.graph.containers.base_images import may_set
    from bringup_lint.graph.containers.base_images import oldest_codename
    from bringup_lint.graph.containers.base_images import ros_distro
    from bringup_lint.graph.containers.base_images import runs_as_root
    from bringup_lint.graph.containers.base_images import ubuntu_codename
    from bringup_lint.graph.containers.images import can_be_pulled
    from bringup_lint.graph.containers.questions.build_context import lacking_sources
    from bringup_lint.graph.containers.questions.devcontainers import Broken
    from bringup_lint.graph.containers.questions.devcontainers import broken_references
    from bringup_lint.graph.containers.questions.folder_owners import builds_of_others
    from bringup_lint.graph.containers.questions.git_history import without_history
    from bringup_lint.graph.containers.questions.image_use import is_deployed
    from bringup_lint.graph.containers.questions.image_use import is_entered_by_hand
    from bringup_lint.graph.containers.questions.image_use import is_used
    from bringup_lint.graph.containers.questions.mounted_files import services_with
    from bringup_lint.graph.containers.questions.shell_texts import Reads
    from bringup_lint.graph.containers.questions.shell_texts import checks_of
    from bringup_lint.graph.containers.questions.shell_texts import shell_texts
    from bringup_lint.graph.containers.questions.unknown_images import UnknownImage
    from bringup_lint.graph.containers.questions.unknown_images import unknown_images
    from bringup_lint.graph.containers.ros_in_image import distro_of
    from bringup_lint.graph.containers.ros_in_image import holds_ros
    from bringup_lint.graph.host.container_folders import CONTAINER_KINDS
    from bringup_lint.graph.host.container_folders import container_folders
    from bringup_lint.graph.host.container_folders import deploying
    from bringup_lint.graph.host.container_folders import is_deployed_to
    from bringup_lint.graph.host.container_folders import is_in_container
    from bringup_lint.graph.installed.package_lists import first_unlisted
    from bringup_lint.graph.runners.containers import image_user
    from bringup_lint.graph.runners.containers import user_name
    from bringup_lint.graph.runners.questions.image_distros import OtherDistro
    from bringup_lint.graph.runners.questions.image_distros import foreign_workspaces
    from bringup_lint.graph.runners.questions.image_distros import other_distros
    from bringup_lint.graph.runners.questions.misplaced_mounts import misplaced_mounts
    from bringup_lint.graph.runners.questions.missing_programs import MissingProgram
    from bringup_lint.graph.runners.questions.missing_programs import missing_programs
    from bringup_lint.graph.runners.questions.missing_settings import missing_settings
    from bringup_lint.graph.runners.questions.missing_users import missing_users
    from bringup_lint.graph.runners.questions.processors import foreign_programs
    from bringup_lint.graph.runners.questions.recordings import recordings
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Instruction
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.dockerfile import stays_in_shell
    from bringup_lint.model.dockerfile import substituted
    from bringup_lint.model.image_build import image_name
    from bringup_lint.parsers.dockerfile import INSTRUCTIONS
    from bringup_lint.parsers.dockerfile import assignments
    from bringup_lint.parsers.dockerfile import blocks_of_run
    from bringup_lint.parsers.dockerfile import commands_of
    from bringup_lint.parsers.dockerfile import commands_of_run
    from bringup_lint.parsers.dockerfile import environment_of
    from bringup_lint.parsers.dockerfile_variables import expanded
    from bringup_lint.parsers.dockerfile_variables import last_user
    from bringup_lint.robot import Robot
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "CONTAINER_KINDS",
    "INSTRUCTIONS",
    "Broken",
    "CommandLine",
    "Dockerfile",
    "Instruction",
    "MissingProgram",
    "OtherDistro",
    "Reads",
    "Runner",
    "Stage",
    "UnknownImage",
    "assignments",
    "blocks_of_run",
    "broken_references",
    "builds_of_others",
    "can_be_pulled",
    "checks_of",
    "commands_of",
    "commands_of_run",
    "container_folders",
    "deploying",
    "distro_of",
    "ended_release",
    "environment_of",
    "expanded",
    "first_unlisted",
    "foreign_programs",
    "foreign_workspaces",
    "has_dash",
    "holds_ros",
    "image_name",
    "image_user",
    "is_deployed",
    "is_deployed_to",
    "is_entered_by_hand",
    "is_in_container",
    "is_used",
    "lacking_sources",
    "last_user",
    "may_set",
    "misplaced_mounts",
    "missing_programs",
    "missing_settings",
    "missing_users",
    "oldest_codename",
    "other_distros",
    "own_homes",
    "recordings",
    "ros_distro",
    "runs_as_root",
    "services_with",
    "shell_texts",
    "stays_in_shell",
    "substituted",
    "ubuntu_codename",
    "unknown_images",
    "user_name",
    "without_history",
]


def own_homes(robot: Robot) -> frozenset[str]:
    """The folders of homes that the robot has because its tree says so."""
    from bringup_lint.graph.host.robot_homes import own_folders

    units = robot.units.judged if robot.of_kind("systemd-unit") else []
    users = [
        user for unit in units if (user := unit.get("User")) and user.span.source.name.endswith((".service", ".conf"))
    ]
    return own_folders(robot.files, users, robot.launch.workspace)
