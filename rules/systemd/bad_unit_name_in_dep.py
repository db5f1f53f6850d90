"""A word in a list of units is not a unit name: systemd ignores the dependency.

## What it finds
In After=, Wants=, Requires= and other lists of units: names that end in a comma or semicolon, names without a
type suffix, and misspelled suffixes. Names with specifiers whose value is unknown are not checked.

## Why it matters on a robot
systemd drops the word. The unit then starts before its drivers, or a Requires= that should stop it together
with them has no effect.

## Bad
```ini
[Unit]
After=robot-drivers.service, network-online.target
```

## Good
```ini
[Unit]
After=robot-drivers.service network-online.target
```

## When to ignore it
Never: systemd drops the word, and the dependency does not exist.

## References
- systemd.unit(5): lists of units are separated by blanks
- journal: "Failed to add dependency on robot-drivers.service,, ignoring: Invalid argument"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest
from bringup_lint.api.systemd import Line
from bringup_lint.api.systemd import ValueProblem


@rule("error", fix="unsafe", symptoms=["Failed to add dependency on"])
def bad_unit_name_in_dep(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        if line.directive.type not in ("units", "socket-units"):
            continue
        for problem in line.problems:
            if problem.code == "bad-unit-name":
                yield _finding(robot, line, problem)


def _finding(robot: Robot, line: Line, problem: ValueProblem) -> Finding:
    name = problem.where
    message = f"'{name}' in {line.key}= is not a unit name: systemd ignores it"
    if problem.suggestion:
        change = fix(f"write {problem.suggestion}", (name, problem.suggestion), safe=problem.safe)
        return finding(name, message, advice=f"write {problem.suggestion}: only blanks separate names", fix=change)
    found = _completed(robot, name)
    if found:
        change = fix(f"write {found}", (name, found), safe=False)
        return finding(name, message, advice=f"write {found}", fix=change)
    return finding(name, message, advice="write the whole name with its suffix, such as .service or .target")


def _completed(robot: Robot, name: Located) -> str | None:
    """The one unit of the tree that was meant: the same stem, or a near miss."""
    known = {unit.name for unit in robot.units.all}
    same = [unit for unit in known if unit.rpartition(".")[0] == name]
    meant = same if "." not in name else nearest(name, sorted(known))
    return meant[0] if len(meant) == 1 else None
