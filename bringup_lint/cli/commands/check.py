"""``bringup-lint [PATH]...``: check files and folders."""

from __future__ import annotations

import click
from click.core import ParameterSource

from bringup_lint import __version__
from bringup_lint.cli import COMMANDS
from bringup_lint.cli.checking import check
from bringup_lint.cli.options import baseline_options
from bringup_lint.cli.options import cache_options
from bringup_lint.cli.options import changes_options
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import configuration_options
from bringup_lint.cli.options import ignores_option
from bringup_lint.cli.options import names
from bringup_lint.cli.options import root_option
from bringup_lint.cli.options import shown_options
from bringup_lint.cli.options import target_options
from bringup_lint.cli.options import verdict_options
from bringup_lint.cli.outputs import PairedOptions
from bringup_lint.cli.outputs import file_option
from bringup_lint.cli.outputs import format_option
from bringup_lint.cli.run_options import RunOptions

SECTIONS = {
    "What is checked": ("root", "exclude", "tracked", "stdin_filename", "target_ros", "target_systemd", "now"),
    "What is found": ("select", "ignore", "rule_folders", "no_ignores", "config_path", "isolated"),
    "What is shown": (
        "output_format",
        "output_file",
        "min_severity",
        "quiet",
        "statistics",
        "show_files",
        "show_settings",
        "colour",
    ),
    "What fails": ("fail_on", "exit_zero"),
    "Trees that have findings already": (
        "since",
        "changed",
        "baseline",
        "write_baseline",
        "prune_baseline",
        "add_ignores",
    ),
    "Fixes": ("fix", "unsafe_fixes", "diff"),
}
"""The options by what they are for; all others come last."""
EPILOG = (
    "\b\nExit codes:\n  0  nothing at or above --fail-on\n  1  findings"
    "\n  2  wrong usage or configuration, or a file that cannot be written"
    "\n  3  a rule or parser failed inside; everything else is still reported"
)


class Sections(PairedOptions):
    """Has the commands, then the options in sections."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))
        options = (param for param in self.get_params(ctx) if isinstance(param, click.Option))
        records = {param.name: param.get_help_record(ctx) for param in options}
        for title, own in SECTIONS.items():
            shown = [records.pop(name) for name in own]
            with formatter.section(title):
                formatter.write_dl([record for record in shown if record])
        with formatter.section("Other options"):
            formatter.write_dl([record for record in records.values() if record])


@click.command(cls=Sections, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("paths", nargs=-1, type=click.Path(readable=False), metavar="[PATH]...")
@root_option
@format_option
@file_option
@click.option("--select", multiple=True, callback=names, help="Run only these rules or families.")
@verdict_options
@target_options
@ignores_option
@configuration_options
@click.option("--stdin-filename", help="Check standard input as the file of this name.")
@click.option("--tracked", is_flag=True, help="Leave out the files that git does not track.")
@changes_options
@baseline_options
@shown_options
@click.option("--fix", is_flag=True, help="Apply the safe fixes.")
@click.option("--unsafe-fixes", is_flag=True, help="With --fix or --diff: the unsafe fixes too.")
@click.option("--diff", is_flag=True, help="Show what --fix would change, and change nothing.")
@click.option("--add-ignores", metavar="REASON", help="Suppress all that is found by comments that give this reason.")
@cache_options
@colour_option
@click.version_option(__version__, prog_name="bringup-lint", message="%(prog)s %(version)s")
@click.pass_context
def command(ctx: click.Context, paths: tuple[str, ...], **options) -> None:
    """Check every file that decides how a ROS 2 robot comes up.

    PATH is a file or a folder, by default the current one. Give /etc on the robot, or --root with a mounted image.
    Write ./NAME for a path that is also the name of a command.
    """
    given = {name for name in ctx.params if ctx.get_parameter_source(name) is not ParameterSource.DEFAULT}
    ctx.exit(check(paths, RunOptions.of(options), ctx.meta["outputs"], given, ctx.obj))
