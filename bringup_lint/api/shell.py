"""Shell scripts and their commands, and the tasks of Ansible."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.background import SHORT
    from bringup_lint.graph.commands.background import Job
    from bringup_lint.graph.commands.background import background_jobs
    from bringup_lint.graph.commands.background import ends_after
    from bringup_lint.graph.commands.docker_options import Option
    from bringup_lint.graph.commands.docker_options import run_options
    from bringup_lint.graph.commands.expected_failure import is_forgiven
    from bringup_lint.graph.commands.expected_failure import may_fail
    from bringup_lint.graph.commands.shells import SH_IS_BASH
    from bringup_lint.graph.commands.shells import SHELLS
    from bringup_lint.graph.commands.shells import STRICT
    from bringup_lint.graph.commands.shells import shell_input
    from bringup_lint.graph.commands.wrappers import program_name
    from bringup_lint.graph.commands.wrappers import unwrapped
    from bringup_lint.graph.image_builds import has_busybox
    from bringup_lint.graph.image_builds import runs_in_image
    from bringup_lint.graph.installed.ansible.modes import FileMode
    from bringup_lint.graph.installed.ansible.modes import file_modes
    from bringup_lint.graph.installed.ansible.names import missing_names
    from bringup_lint.graph.installed.ansible.roles import roles_of
    from bringup_lint.graph.installed.ansible.shells import sh_commands
    from bringup_lint.graph.installed.masked import masked_units
    from bringup_lint.graph.installed.misnamed_files import Misnamed
    from bringup_lint.graph.installed.misnamed_files import misnamed_files
    from bringup_lint.graph.installed.paths import in_tree
    from bringup_lint.graph.installed.plain_modes import plain_modes
    from bringup_lint.graph.installed.script import Run
    from bringup_lint.graph.installed.script import Written
    from bringup_lint.graph.installed.script_arguments import short_calls
    from bringup_lint.graph.installed.script_files import missing_files
    from bringup_lint.graph.installed.script_files import read_words
    from bringup_lint.graph.installed.script_functions import functions
    from bringup_lint.graph.installed.without_sudo import without_sudo
    from bringup_lint.graph.runners.questions.edits_without_effect import lost_edits
    from bringup_lint.graph.runners.questions.errexit import Statement
    from bringup_lint.graph.runners.questions.errexit import ended_by_failure
    from bringup_lint.graph.runners.questions.errexit import is_inverted
    from bringup_lint.graph.runners.questions.every_command import every_command
    from bringup_lint.graph.runners.questions.every_command import with_inner
    from bringup_lint.model.shell import Block
    from bringup_lint.model.shell import Command
    from bringup_lint.model.shell import Redirect
    from bringup_lint.model.shell import Word
    from bringup_lint.parsers.ansible_tasks import Module
    from bringup_lint.parsers.ansible_tasks import Task
    from bringup_lint.parsers.ansible_tasks import plays
    from bringup_lint.parsers.ansible_tasks import tasks
    from bringup_lint.parsers.shell import commands
    from bringup_lint.parsers.shell import shell_blocks
    from bringup_lint.parsers.shell import shell_commands
    from bringup_lint.parsers.shell_syntax import Mistake
    from bringup_lint.parsers.shell_syntax import syntax_mistake
    from bringup_lint.parsers.shell_tokens import substitutions
    from bringup_lint.parsers.shell_tokens import tokens
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "SHELLS",
    "SHORT",
    "SH_IS_BASH",
    "STRICT",
    "Block",
    "Command",
    "FileMode",
    "Job",
    "Misnamed",
    "Mistake",
    "Module",
    "Option",
    "Redirect",
    "Run",
    "Statement",
    "Task",
    "Word",
    "Written",
    "background_jobs",
    "commands",
    "ended_by_failure",
    "ends_after",
    "every_command",
    "file_modes",
    "functions",
    "has_busybox",
    "in_tree",
    "is_forgiven",
    "is_inverted",
    "lost_edits",
    "masked_units",
    "may_fail",
    "misnamed_files",
    "missing_files",
    "missing_names",
    "plain_modes",
    "plays",
    "program_name",
    "read_words",
    "roles_of",
    "run_options",
    "runs_in_image",
    "sh_commands",
    "shell_blocks",
    "shell_commands",
    "shell_input",
    "short_calls",
    "substitutions",
    "syntax_mistake",
    "tasks",
    "tokens",
    "unwrapped",
    "with_inner",
    "without_sudo",
]
