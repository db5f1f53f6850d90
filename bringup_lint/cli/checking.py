"""What ``bringup-lint [PATH]...`` does with its paths and options."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.cli.answering import keep
from bringup_lint.cli.configuring import configuration
from bringup_lint.cli.reading import read_robot
from bringup_lint.cli.reading import standard_input
from bringup_lint.cli.reports import Output
from bringup_lint.cli.reports import write
from bringup_lint.cli.run_options import RunOptions
from bringup_lint.cli.streams import complain
from bringup_lint.cli.usage import OF_A_PART
from bringup_lint.cli.usage import baseline_usage
from bringup_lint.cli.usage import refuse_ineffective
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.discover.disk import recorded
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from bringup_lint.cache.answers import Question
    from bringup_lint.discover.held import Held
    from bringup_lint.engine import Outcome
    from bringup_lint.report import Report
    from bringup_lint.robot import Robot


def check(
    paths: tuple[str, ...], options: RunOptions, outputs: list[Output], given: set[str], question: Question | None
) -> int:
    """Check files and folders; returns the exit code. The answer to the question may be kept, which depends on the
    options that are given. Raises UsageError for options that would have no effect."""
    from bringup_lint.registry import RuleError

    refuse_ineffective(paths, options)
    if options.stdin_filename:
        paths = (options.stdin_filename,)
    changed_files = None
    if options.changed:
        changed_files, paths = paths, (".",)
    try:
        with recorded() if question else contextlib.nullcontext() as record:
            code = _check(outputs, paths or ("/" if options.root else ".",), options, changed_files)
        if question and record:
            keep(question, given, outputs, record, code)
    except (ConfigError, RuleError) as error:
        complain(error)
        return 2
    return code


def plain(paths: tuple[str, ...], question: Question | None) -> int:
    """Check files and folders without options."""
    return check(paths, RunOptions(), [Output("text", None)], {"paths"} if paths else set(), question)


def _check(
    outputs: list[Output], paths: tuple[str, ...], options: RunOptions, changed_files: tuple[str, ...] | None
) -> int:
    from bringup_lint.cli.changes import changes_limit
    from bringup_lint.cli.progress import progress
    from bringup_lint.engine import run
    from bringup_lint.registry import Registry

    started = time.time()
    config, rule_folders = configuration(paths, options)
    baseline_usage(config, options)
    registry = Registry.of(rule_folders)
    if options.stdin_filename:
        options.stdin_data = standard_input()
    limit = changes_limit(options.since, changed_files)

    if asked := [name for name in ("show_settings", "show_files") if getattr(options, name)]:
        from bringup_lint.cli.showing import show

        return _shown(show(asked, read_robot(paths, config, options), config, options))

    held = _held_between_rounds(options)

    def checked() -> tuple[Robot, Outcome]:
        with progress(wanted=not options.quiet) as state:
            robot = read_robot(paths, config, options, held)
            ignores = not options.no_ignores
            return robot, limit(run(robot, registry, config, ignores=ignores, between=state.rule))

    robot, outcome = checked()
    unsafe = options.unsafe_fixes
    if options.diff:
        from bringup_lint.cli.fixing import show_diff

        code = show_diff(robot, outcome, checked, unsafe=unsafe)
        return 0 if options.exit_zero and code == 1 else code
    if options.add_ignores:
        from bringup_lint.cli.ignoring import add_ignores

        return add_ignores(robot, outcome, checked, config, options.add_ignores.strip())
    if options.fix and options.stdin_filename:
        from bringup_lint.cli.fixing import print_fixed

        return print_fixed(robot, outcome, checked, options, unsafe=unsafe)
    unwritten: list[str] = []
    if options.fix:
        from bringup_lint.cli.fixing import fix_files

        robot, outcome, unwritten = fix_files(robot, outcome, checked, unsafe=unsafe)
    return deliver(outcome, robot, config, started, outputs, options, unwritten)


def deliver(
    outcome: Outcome,
    robot: Robot,
    config: Config,
    started: float,
    outputs: list[Output],
    options: RunOptions,
    unwritten: Iterable[str] = (),
) -> int:
    """Write the reports, and the baseline when one is asked for; returns the exit code. What cannot be written is said,
    and what was not written before (``unwritten``); the rest is."""
    from bringup_lint.cli.reporting import report_of
    from bringup_lint.cli.terminal import wants_colour
    from bringup_lint.finish import rendered
    from bringup_lint.report import DRAWN
    from bringup_lint.report import FINDINGS_ALONE
    from bringup_lint.report import Part

    drawn = any(output.format in DRAWN for output in outputs)
    part = Part.STATISTICS if options.statistics else Part.FINDINGS if options.quiet else Part.WHOLE
    people = {"html"} if part is Part.STATISTICS else {"html", "text"}
    told = any(output.format in people for output in outputs)
    report = replace(report_of(outcome, robot, config, started, drawn=drawn, told=told), part=part)
    if options.exit_zero and report.exit_code == 1:
        report = replace(report, exit_code=0)
    for said in report.notifications:
        if said.level == "note" and not options.quiet:
            complain(said.message)
    if not options.quiet and all(output.format in FINDINGS_ALONE for output in outputs):
        for words in report.by_configuration:
            complain(f"{words}: --no-ignores" if "suppressed" in words else words)
    report, kept = _with_baseline(report, config, options)
    failures, code = [*unwritten, *kept], report.exit_code
    for output in outputs:
        colour = output.file is None and wants_colour(options.colour)
        text, rendered_code = rendered(output.format, replace(report, colour=colour))
        failures += _failed(write, text, output.file)
        code = max(code, rendered_code)
    for failure in failures:
        complain(f"not written: {failure}")
    if failures:
        return max(code, 2)
    return code


def _shown(text: str) -> int:
    """Print what was asked for in place of a report; the exit code."""
    if failures := _failed(write, text, None):
        complain(f"not written: {failures[0]}")
    return 2 if failures else 0


def _with_baseline(report: Report, config: Config, options: RunOptions) -> tuple[Report, list[str]]:
    """The report after its baseline was written or pruned, and why that could not be done."""
    from bringup_lint.cli.reporting import prune_baseline
    from bringup_lint.cli.reporting import save_baseline
    from bringup_lint.writing import NotWritten

    if any(getattr(options, name) for name in OF_A_PART):
        report = replace(report, stale=())
    try:
        if options.write_baseline:
            return save_baseline(report, options.write_baseline), []
        if options.prune_baseline:
            return prune_baseline(report, config), []
    except NotWritten as error:
        return report, [str(error)]
    return report, []


def _failed(write: Callable[..., None], *arguments: Any) -> list[str]:
    from bringup_lint.writing import NotWritten

    try:
        write(*arguments)
    except NotWritten as error:
        return [str(error)]
    return []


def _held_between_rounds(options: RunOptions) -> Held | None:
    """What keeps the models of files that no fix changes from one round to the next."""
    from bringup_lint.discover.held import Held

    return Held() if options.fix or options.diff else None
