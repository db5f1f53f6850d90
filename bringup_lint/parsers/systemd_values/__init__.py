"""The values of systemd unit files: what systemd accepts, what it makes of them, what is wrong with them.

``check(type, value, version)`` judges a value of a type of ``facts/systemd/directives.tsv``; the other functions
read values for those who want to know what a unit does. All are pure, none raises on any text.
"""

from bringup_lint.parsers.systemd_values.commands import Command
from bringup_lint.parsers.systemd_values.commands import CommandLine
from bringup_lint.parsers.systemd_values.commands import split_command_line
from bringup_lint.parsers.systemd_values.environment import Variable
from bringup_lint.parsers.systemd_values.environment import is_variable_name
from bringup_lint.parsers.systemd_values.environment import split_environment
from bringup_lint.parsers.systemd_values.grammars import check
from bringup_lint.parsers.systemd_values.lists import parse_cpus
from bringup_lint.parsers.systemd_values.numbers import parse_bool
from bringup_lint.parsers.systemd_values.numbers import parse_integer
from bringup_lint.parsers.systemd_values.numbers import parse_mode
from bringup_lint.parsers.systemd_values.numbers import parse_share
from bringup_lint.parsers.systemd_values.numbers import parse_size
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import expand
from bringup_lint.parsers.systemd_values.specifiers import unit_specifiers
from bringup_lint.parsers.systemd_values.timespan import parse_timespan
from bringup_lint.parsers.systemd_values.unit_names import UnitName
from bringup_lint.parsers.systemd_values.unit_names import escape
from bringup_lint.parsers.systemd_values.unit_names import escape_path
from bringup_lint.parsers.systemd_values.unit_names import is_unit_name
from bringup_lint.parsers.systemd_values.unit_names import split_name
from bringup_lint.parsers.systemd_values.unit_names import unescape
from bringup_lint.parsers.systemd_values.unit_names import unescape_path
from bringup_lint.parsers.systemd_values.word_splitting import Words
from bringup_lint.parsers.systemd_values.word_splitting import nowhere
from bringup_lint.parsers.systemd_values.word_splitting import split_words

__all__ = [
    "Command",
    "CommandLine",
    "UnitName",
    "ValueProblem",
    "Variable",
    "Words",
    "check",
    "escape",
    "escape_path",
    "expand",
    "is_unit_name",
    "is_variable_name",
    "nowhere",
    "parse_bool",
    "parse_cpus",
    "parse_integer",
    "parse_mode",
    "parse_share",
    "parse_size",
    "parse_timespan",
    "split_command_line",
    "split_environment",
    "split_name",
    "split_words",
    "unescape",
    "unescape_path",
    "unit_specifiers",
]
