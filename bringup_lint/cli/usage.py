"""Which options go together. click is only imported to say what is wrong."""

from __future__ import annotations

from bringup_lint.cli.run_options import RunOptions
from bringup_lint.config import Config

OF_A_PART = ("since", "changed", "tracked", "stdin_filename")
"""Options that leave out findings which are there."""


def refuse_ineffective(paths: tuple[str, ...], options: RunOptions) -> None:
    """Raises UsageError for options that would have no effect."""
    name = options.stdin_filename
    if "-" in paths and not name:
        raise _usage_error("standard input needs a name, which says what kind of file it is: --stdin-filename NAME")
    if name and (options.root or options.tracked or set(paths) - {"-"}):
        raise _usage_error("--stdin-filename checks standard input alone: leave out paths, --root and --tracked")
    if options.changed and (not paths or name or options.root):
        raise _usage_error("--changed takes the changed files of the working folder as PATHs, and no --root")
    if options.since and (name or options.root):
        raise _usage_error("--since compares a working tree with git's objects: leave out --root and --stdin-filename")
    if options.add_ignores is not None:
        _ignores_usage(options.add_ignores, options)
    if options.statistics and options.quiet:
        raise _usage_error("--statistics prints the table that --quiet leaves out")
    if options.unsafe_fixes and not (options.fix or options.diff):
        raise _usage_error("--unsafe-fixes needs --fix or --diff")


def _usage_error(message: str) -> Exception:
    import click

    return click.UsageError(message)


def _ignores_usage(reason: str, options: RunOptions) -> None:
    """Raises UsageError for a reason that no comment can hold, and what does not go together."""
    if not reason.strip() or "--" in reason or not reason.isprintable():
        raise _usage_error("--add-ignores needs a reason: one line without '--', which XML does not allow")
    for name in ("stdin_filename", "fix", "diff", "write_baseline", "prune_baseline", "no_ignores"):
        if getattr(options, name):
            raise _usage_error(f"--add-ignores writes suppressions alone: leave out --{name.replace('_', '-')}")


def baseline_usage(config: Config, options: RunOptions) -> None:
    """Raises UsageError for a baseline that cannot be pruned."""
    if not options.prune_baseline:
        return
    if not config.baseline:
        raise _usage_error("--prune-baseline needs --baseline, or a baseline in the configuration")
    if options.write_baseline:
        raise _usage_error("--write-baseline writes all findings: leave out --prune-baseline")
    if given := next((name for name in OF_A_PART if getattr(options, name)), None):
        raise _usage_error(f"--prune-baseline needs a run over all files: leave out --{given.replace('_', '-')}")
