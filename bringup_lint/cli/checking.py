"""What ``bringup-lint [PATH]...`` does with its paths and options. click is only imported to say what is wrong with
them."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.cli.answering import keep
from bringup_lint.cli.reports import Output
from bringup_lint.cli.reports import write
from bringup_lint.cli.streams import complain
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.config import find
from bringup_lint.config import read
from bringup_lint.dataclass import replace
from bringup_lint.discover import disk
from bringup_lint.discover.disk import recorded
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from bringup_lint.cache.answers import Question
    from bringup_lint.discover.held import Held
    from bringup_lint.engine import Outcome
    from bringup_lint.report import Report
    from bringup_lint.robot import Robot

DEFAULTS: dict[str, Any] = {
    **dict.fromkeys(("output_format", "output_file", "select", "ignore", "rule_folders", "exclude"), ()),
    **dict.fromkeys(("root", "min_severity", "fail_on", "target_ros", "target_systemd", "now", "config_path")),
    **dict.fromkeys(("stdin_filename", "since", "baseline", "write_baseline", "add_ignores", "colour")),
    **dict.fromkeys(("exit_zero", "no_ignores", "isolated", "tracked", "changed", "prune_baseline", "quiet"), False),
    **dict.fromkeys(("statistics", "show_files", "show_settings", "fix", "unsafe_fixes", "diff", "no_cache"), False),
    "cache_by": "times",
}
"""Option -> its value where it is not given."""
_OF_A_PART = ("since", "changed", "tracked", "stdin_filename")
"""Options that leave out findings which are there."""


def check(
    paths: tuple[str, ...], options: dict[str, Any], outputs: list[Output], given: set[str], question: Question | None
) -> int:
    """Check files and folders; returns the exit code. The answer to the question may be kept, which depends on the
    options that are given. Raises UsageError for options that would have no effect."""
    from bringup_lint.registry import RuleError

    _usage(paths, options)
    if options["stdin_filename"]:
        paths = (options["stdin_filename"],)
    if options["changed"]:
        options["changed_files"], paths = paths, (".",)
    try:
        with recorded() if question else contextlib.nullcontext() as record:
            code = _check(outputs, paths or ("/" if options["root"] else ".",), options)
        if question and record:
            keep(question, given, outputs, record, code)
    except (ConfigError, RuleError) as error:
        complain(error)
        return 2
    return code


def plain(paths: tuple[str, ...], question: Question | None) -> int:
    """Check files and folders without options."""
    return check(paths, dict(DEFAULTS), [Output("text", None)], {"paths"} if paths else set(), question)


def _check(outputs: list[Output], paths: tuple[str, ...], options: dict[str, Any]) -> int:
    from bringup_lint.cli.changes import changes_limit
    from bringup_lint.cli.progress import progress
    from bringup_lint.engine import run
    from bringup_lint.registry import Registry

    started = time.time()
    config, rule_folders = configuration(paths, options)
    baseline_usage(config, options)
    registry = Registry.of(rule_folders)
    if options["stdin_filename"]:
        options["stdin_data"] = _standard_input()

    limit = changes_limit(options)

    if asked := [name for name in ("show_settings", "show_files") if options[name]]:
        from bringup_lint.cli.showing import show

        return _shown(show(asked, read_robot(paths, config, options), config, options))

    held = _held_between_rounds(options)

    def checked() -> tuple[Robot, Outcome]:
        with progress(wanted=not options["quiet"]) as state:
            robot = read_robot(paths, config, options, held)
            ignores = not options["no_ignores"]
            return robot, limit(run(robot, registry, config, ignores=ignores, between=state.rule))

    robot, outcome = checked()
    unsafe = options["unsafe_fixes"]
    if options["diff"]:
        from bringup_lint.cli.fixing import show_diff

        code = show_diff(robot, outcome, checked, unsafe=unsafe)
        return 0 if options["exit_zero"] and code == 1 else code
    if options["add_ignores"]:
        from bringup_lint.cli.ignoring import add_ignores

        return add_ignores(robot, outcome, checked, config, options["add_ignores"].strip())
    if options["fix"] and options["stdin_filename"]:
        from bringup_lint.cli.fixing import print_fixed

        return print_fixed(robot, outcome, checked, options, unsafe=unsafe)
    unwritten: list[str] = []
    if options["fix"]:
        from bringup_lint.cli.fixing import fix_files

        robot, outcome, unwritten = fix_files(robot, outcome, checked, unsafe=unsafe)
    return deliver(outcome, robot, config, started, outputs, options, unwritten)


def deliver(
    outcome: Outcome,
    robot: Robot,
    config: Config,
    started: float,
    outputs: list[Output],
    options: dict[str, Any],
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
    part = Part.STATISTICS if options.get("statistics") else Part.FINDINGS if options.get("quiet") else Part.WHOLE
    people = {"html"} if part is Part.STATISTICS else {"html", "text"}
    told = any(output.format in people for output in outputs)
    report = replace(report_of(outcome, robot, config, started, drawn=drawn, told=told), part=part)
    if options["exit_zero"] and report.exit_code == 1:
        report = replace(report, exit_code=0)
    for said in report.notifications:
        if said.level == "note" and not options.get("quiet"):
            complain(said.message)
    if not options.get("quiet") and all(output.format in FINDINGS_ALONE for output in outputs):
        for words in report.by_configuration:
            complain(f"{words}: --no-ignores" if "suppressed" in words else words)
    report, kept = _with_baseline(report, config, options)
    failures, code = [*unwritten, *kept], report.exit_code
    for output in outputs:
        colour = output.file is None and wants_colour(options["colour"])
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


def _with_baseline(report: Report, config: Config, options: dict[str, Any]) -> tuple[Report, list[str]]:
    """The report after its baseline was written or pruned, and why that could not be done."""
    from bringup_lint.cli.reporting import prune_baseline
    from bringup_lint.cli.reporting import save_baseline
    from bringup_lint.writing import NotWritten

    if any(options.get(name) for name in _OF_A_PART):
        report = replace(report, stale=())
    try:
        if options["write_baseline"]:
            return save_baseline(report, options["write_baseline"]), []
        if options["prune_baseline"]:
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


def _standard_input() -> bytes:
    """Raises ConfigError when it is closed, or holds more than is read of any file."""
    from bringup_lint.discover.reading import SIZE_LIMIT

    disk.depends_on_more()
    try:
        data = sys.stdin.buffer.read(SIZE_LIMIT + 1)
    except (AttributeError, OSError, ValueError) as error:
        raise ConfigError("--stdin-filename: standard input is closed") from error
    if len(data) > SIZE_LIMIT:
        raise ConfigError(f"--stdin-filename: standard input is longer than {SIZE_LIMIT // 1024 // 1024} MiB")
    return data


def _untracked_too(excluded: Callable[[str], bool]) -> Callable[[str], bool]:
    """What is left out, and the files that git does not track. Raises ConfigError outside of a repository."""
    from bringup_lint.discover.git_index import UnknownFormat
    from bringup_lint.discover.git_index import tracked_only

    try:
        untracked = tracked_only(os.getcwd())
    except UnknownFormat as error:
        raise ConfigError(f"--tracked: {error}") from error
    return lambda path: excluded(path) or untracked(path)


def _usage(paths: tuple[str, ...], options: dict[str, Any]) -> None:
    """Raises UsageError for options that would have no effect."""
    name = options["stdin_filename"]
    if "-" in paths and not name:
        raise _usage_error("standard input needs a name, which says what kind of file it is: --stdin-filename NAME")
    if name and (options["root"] or options["tracked"] or set(paths) - {"-"}):
        raise _usage_error("--stdin-filename checks standard input alone: leave out paths, --root and --tracked")
    if options["changed"] and (not paths or name or options["root"]):
        raise _usage_error("--changed takes the changed files of the working folder as PATHs, and no --root")
    if options["since"] and (name or options["root"]):
        raise _usage_error("--since compares a working tree with git's objects: leave out --root and --stdin-filename")
    if options["add_ignores"] is not None:
        _ignores_usage(options)
    if options["statistics"] and options["quiet"]:
        raise _usage_error("--statistics prints the table that --quiet leaves out")
    if options["unsafe_fixes"] and not (options["fix"] or options["diff"]):
        raise _usage_error("--unsafe-fixes needs --fix or --diff")


def _usage_error(message: str) -> Exception:
    import click

    return click.UsageError(message)


def _ignores_usage(options: dict[str, Any]) -> None:
    """Raises UsageError for a reason that no comment can hold, and what does not go together."""
    reason = options["add_ignores"]
    if not reason.strip() or "--" in reason or not reason.isprintable():
        raise _usage_error("--add-ignores needs a reason: one line without '--', which XML does not allow")
    for name in ("stdin_filename", "fix", "diff", "write_baseline", "prune_baseline", "no_ignores"):
        if options[name]:
            raise _usage_error(f"--add-ignores writes suppressions alone: leave out --{name.replace('_', '-')}")


def baseline_usage(config: Config, options: dict[str, Any]) -> None:
    """Raises UsageError for a baseline that cannot be pruned."""
    if not options["prune_baseline"]:
        return
    if not config.baseline:
        raise _usage_error("--prune-baseline needs --baseline, or a baseline in the configuration")
    if options["write_baseline"]:
        raise _usage_error("--write-baseline writes all findings: leave out --prune-baseline")
    if given := next((name for name in _OF_A_PART if options.get(name)), None):
        raise _usage_error(f"--prune-baseline needs a run over all files: leave out --{given.replace('_', '-')}")


def configuration(paths: tuple[str, ...], options: dict[str, Any]) -> tuple[Config, list[str]]:
    """The settings from file and command line, and the folders of further rules. Raises ConfigError."""
    named = str(options["config_path"] or "")
    path = named or (None if options["isolated"] else find(_start(paths, options["root"])))
    try:
        config = read(path, named=bool(named)) if path else Config()
    except ConfigError as error:
        raise _with_unknown_names(error, map(str, options["rule_folders"])) from error
    found = config if path and not named else None
    rule_folders = [str(folder) for folder in options["rule_folders"]]
    if config.rules and named:
        rule_folders += map(config.beside, config.rules)
    elif config.rules:
        complain(f"{path}: 'rules' is only read from a file named by --config")
    given = {
        "select": options["select"],
        "ignore": (*config.ignore, *options["ignore"]),
        "exclude": (*config.exclude, *options["exclude"]),
        "min_severity": options["min_severity"],
        "fail_on": options["fail_on"],
        "target_ros": options["target_ros"],
        "target_systemd": options["target_systemd"],
        "baseline": options["baseline"] and str(options["baseline"].absolute()),
        "found": found,
    }
    return replace(config, **{key: value for key, value in given.items() if value}), rule_folders


def _with_unknown_names(error: ConfigError, rule_folders: Iterable[str]) -> ConfigError:
    """The mistakes of a configuration, and the names in it that mean no rule."""
    from bringup_lint.engine import Selection
    from bringup_lint.registry import Registry

    if error.config is None or error.config.rules:
        return error
    try:
        Selection(Registry.of(rule_folders), error.config)
    except ConfigError as unknown:
        return ConfigError(f"{error}\n{unknown}")
    return error


def _start(paths: tuple[str, ...], root: str | None) -> str:
    """Where the search for a configuration begins: at the first path, which lies in the root when there is one."""
    first = disk.absolute(os.path.join(root, paths[0].lstrip("/")) if root else paths[0])
    return first if disk.isdir(first) else os.path.dirname(first)


def _folders(paths: Iterable[str], root: str | None) -> list[str]:
    """The absolute folders among the paths of the command line, with a slash at the end."""
    from bringup_lint.discover.walk import inside

    places = [os.path.abspath(path) if root is None else inside(disk.absolute(root), path) for path in paths]
    return [f"{place.rstrip('/')}/" for place in places if disk.isdir(place)]


def _held_between_rounds(options: dict[str, Any]) -> Held | None:
    """What keeps the models of files that no fix changes from one round to the next."""
    from bringup_lint.discover.held import Held

    return Held() if options["fix"] or options["diff"] else None


def read_robot(paths: tuple[str, ...], config: Config, options: dict[str, Any], held: Held | None = None) -> Robot:
    """Read the paths, or standard input, into a robot."""
    from bringup_lint.discover.exclude import exclusion
    from bringup_lint.discover.exclude import noting
    from bringup_lint.discover.tree import display_name
    from bringup_lint.discover.walk import discover
    from bringup_lint.discover.walk import discover_text
    from bringup_lint.discover.walk import missing
    from bringup_lint.robot import Robot

    if options["stdin_filename"]:
        tree = discover_text(options["stdin_filename"], options["stdin_data"])
    else:
        if why := missing(paths, options["root"]):
            raise ConfigError(why)
        deploy = {config.beside(path): place for path, place in config.deploy.items()}
        excluded = exclusion(config.folder, config.exclude, _folders(paths, options["root"]))
        met: set[str] = set()
        if config.found and config.found.exclude:
            excluded = noting(excluded, met)
        if options.get("tracked"):
            excluded = _untracked_too(excluded)
        tree = discover(paths, root=options["root"], deploy=deploy, excluded=excluded, held=held)
        tree.excluded = met
    now = options.get("now")
    purposes = {display_name(config.beside(path)): name for path, name in config.purpose.items()}
    return Robot(tree, config.target_ros, config.target_systemd, now.date() if now else None, purposes)
