"""The command `ament_bringup_lint`: checks a package, prints what fails and writes it for `colcon test-result`."""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Iterator
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from typing import NamedTuple

from ament_bringup_lint.xunit import Case
from ament_bringup_lint.xunit import document
from ament_bringup_lint.xunit import suite_name

SEVERITIES = ("info", "warning", "error")
FOUND = 1
BRINGUP_LINT = (
    sys.executable,
    "-c",
    "import sys; sys.path = [path for path in sys.path if path]; from bringup_lint.__main__ import main; main()",
)
"""The command; ``python -m`` would look for modules in the folder that is checked."""
"""The exit code of bringup-lint for findings. Everything above means that it could not check the package."""


class Outcome(NamedTuple):
    """What a run of bringup-lint came to."""

    code: int
    summary: str
    failures: Sequence[Case]


def main(argv: Sequence[str] | None = None) -> int:
    """Check as the arguments say; 0 when nothing fails."""
    arguments = _parser().parse_args(argv)
    started = time.monotonic()
    outcome = check(arguments)
    elapsed = time.monotonic() - started
    for case in outcome.failures:
        print(case.text, file=sys.stderr)
    print(outcome.summary)
    if arguments.xunit_file:
        _write(arguments.xunit_file, outcome, elapsed)
    return outcome.code


def check(arguments: argparse.Namespace) -> Outcome:
    run = subprocess.run(_command(arguments), capture_output=True, text=True, encoding="utf-8", check=False)
    if run.returncode not in (0, FOUND):
        return Outcome(run.returncode, "bringup-lint could not check the package", [_broken(run.stderr or run.stdout)])
    report = json.loads(run.stdout)
    failures = [_case(finding) for finding in _failing(report, arguments.fail_on)] if run.returncode else []
    return Outcome(run.returncode, _summary(report, len(failures)), failures)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="ament_bringup_lint",
        description="Check the configuration that decides how a ROS 2 robot comes up, with bringup-lint.",
    )
    parser.add_argument("paths", nargs="*", default=["."], help="files and folders to check (default: this folder)")
    parser.add_argument("--config", metavar="FILE", help="configuration file (default: the one that is found)")
    parser.add_argument(
        "--exclude", nargs="*", default=[], metavar="PATTERN", help="skip what matches, as .gitignore has it"
    )
    parser.add_argument("--fail-on", choices=SEVERITIES, help="lowest severity that fails (default: warning)")
    parser.add_argument("--target-ros", metavar="DISTRO", help="the ROS distribution that the robot runs")
    parser.add_argument("--xunit-file", metavar="FILE", help="write the result as xunit")
    return parser


def _command(arguments: argparse.Namespace) -> list[str]:
    options = [("--config", arguments.config), ("--target-ros", arguments.target_ros), ("--fail-on", arguments.fail_on)]
    options += [("--exclude", pattern) for pattern in arguments.exclude]
    if arguments.fail_on == "info":
        options.append(("--min-severity", "info"))
    given = [word for option, value in options if value for word in (option, value)]
    return [*BRINGUP_LINT, "check", "--output-format", "json", *given, "--", *arguments.paths]


def _failing(report: dict[str, Any], fail_on: str | None) -> Iterator[dict[str, Any]]:
    least = SEVERITIES.index(fail_on or "warning")
    for finding in report["findings"]:
        if not finding["suppressed"] and SEVERITIES.index(finding["severity"]) >= least:
            yield finding


def _case(finding: dict[str, Any]) -> Case:
    where = _where(finding["location"])
    lines = [f"{where}: {finding['severity']}[{finding['rule']}] {finding['message']}"]
    lines += [f"    {_where(other['location'])}: {other['message']}" for other in finding["related"]]
    if finding["advice"]:
        lines.append(f"    help: {finding['advice']}")
    return Case(f"{finding['rule']} ({where})", finding["message"], "\n".join(lines))


def _where(location: dict[str, Any]) -> str:
    return f"{location['path']}:{location['start']['line']}:{location['start']['column']}"


def _broken(said: str) -> Case:
    last = said.strip().rpartition("\n")[2]
    return Case("bringup_lint", last or "bringup-lint ended without a message", said.strip())


def _summary(report: dict[str, Any], failures: int) -> str:
    checked = _count(report["summary"]["files"], "file")
    return f"{checked} checked: {_count(failures, 'problem') if failures else 'no problems'}"


def _count(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _write(name: str, outcome: Outcome, elapsed: float) -> None:
    file = Path(name)
    file.parent.mkdir(parents=True, exist_ok=True)
    kind = "failure" if outcome.code == FOUND else "error"
    file.write_text(document(suite_name(file), outcome.failures, kind, elapsed, outcome.summary), "utf-8")


if __name__ == "__main__":
    sys.exit(main())
