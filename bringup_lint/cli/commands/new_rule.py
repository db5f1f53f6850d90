"""``bringup-lint new-rule FAMILY/NAME``: the files of a new rule in a checkout."""

from __future__ import annotations

from pathlib import Path

import click

from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import say
from bringup_lint.pattern import regex
from bringup_lint.registry import builtin_folder
from bringup_lint.writing import NotWritten
from bringup_lint.writing import create

_ID = regex(r"[a-z][a-z0-9-]*/[a-z][a-z0-9-]*")
RULE = '''\
"""What is wrong, as one sentence.

## What it finds
TODO: the defect, in the terms of the manual.

## Why it matters on a robot
TODO: what happens on the robot, with numbers.

## Bad
```text
TODO
```

## Good
```text
TODO
```

## When to ignore it
TODO: where the finding is right and yet does no harm.

## References
- TODO: the manual page or specification, with its section
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="TODO: why no program reports it; or symptoms=[...], the log lines of those that do")
def {function}(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind({kinds}):
        if "TODO" in source.text:
            yield finding(source, "What will happen on the robot", advice="what to write instead")
'''


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("rule_id", metavar="FAMILY/NAME")
@click.pass_context
def command(ctx: click.Context, rule_id: str) -> None:
    """Write the file of a new rule, and a bad and a good fixture, in a checkout of bringup-lint.

    The fixtures start as copies of a good one of the same family. Existing files are never overwritten.

    \b
    bringup-lint new-rule systemd/no-tabs
    """
    problem = _problem(rule_id)
    if problem:
        complain(problem)
        ctx.exit(2)
    try:
        written = write(rule_id, Path(builtin_folder()).parent)
    except NotWritten as error:
        complain(error)
        ctx.exit(2)
    for path in written:
        say(f"Wrote {path}.")
    name = rule_id.partition("/")[2].replace("-", "_")
    say(f"Next: fill in each TODO, then pytest tests/rules/test_fixtures.py -k {name} --update-expected")


def _problem(rule_id: str) -> str:
    """Why no rule of this id can be written; empty when it can."""
    rules = Path(builtin_folder())
    family, _, name = rule_id.replace("-", "_").partition("/")
    fixtures = rules.parent / "fixtures"
    if not fixtures.is_dir():
        return (
            "new-rule works in a checkout of bringup-lint that is installed with pip install -e '.[test]'; "
            "docs/own-rules.md describes rules that stay outside of it"
        )
    if not _ID.fullmatch(rule_id):
        return f"'{rule_id}' is not a rule id; write FAMILY/NAME in lower case with dashes, such as systemd/no-tabs"
    if not (rules / family).is_dir():
        known = ", ".join(sorted(path.parent.name.replace("_", "-") for path in rules.glob("*/family.toml")))
        return f"there is no family '{rule_id.partition('/')[0]}'; the families are {known}"
    for path in (rules / family / f"{name}.py", fixtures / family / name):
        if path.exists():
            return f"{path} exists already"
    return ""


def write(rule_id: str, project: Path) -> list[Path]:
    """Write the rule file and its fixtures; returns what was written. Raises NotWritten."""
    from bringup_lint.registry import families

    family, _, name = rule_id.replace("-", "_").partition("/")
    rule = project / "rules" / family / f"{name}.py"
    reads = next(each.reads for each in families([str(project / "rules")]) if Path(each.folder).name == family)
    kinds = ", ".join(f'"{kind}"' for kind in sorted(reads))
    create(rule, RULE.format(function=name, kinds=kinds).encode("utf-8"))
    fixtures = project / "fixtures" / family
    start = _smallest_good(fixtures)
    written = [rule]
    for case in ("bad", "good"):
        folder = fixtures / name / case
        folder.mkdir(parents=True)
        if start is not None:
            _copy(start, folder)
        written.append(folder)
    return written


def _copy(start: Path, folder: Path) -> None:
    """The files below a folder, in another one."""
    for path in sorted(start.rglob("*")):
        copy = folder / path.relative_to(start)
        if path.is_dir():
            copy.mkdir(parents=True, exist_ok=True)
        elif path.is_file():
            create(copy, path.read_bytes())


def _smallest_good(fixtures: Path) -> Path | None:
    """The good fixture of the family with the fewest bytes in its files."""
    sizes = []
    for folder in fixtures.glob("*/good"):
        files = [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]
        sizes.append((len(files), sum(path.stat().st_size for path in files), folder))
    return min(sizes)[2] if sizes else None
