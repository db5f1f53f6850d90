"""A script copies, sources or runs a file that is not there.

## What it finds
A file of the script's own folders that `cp`, `install`, `ln`, `source`, `bash`, `python3`, `pip install -r`,
`docker ... -f` or its path names and that does not exist: below a variable that holds the folder of the script or one
near it (`$(cd "$(dirname "$0")/.." && pwd)`), where another file exists that the script names so, and for relative
paths, below the one folder in which another file exists that the script names (two for names without a folder).
A pattern such as `udev/*.rules` that matches no file is reported in the same way. A file anywhere that the tree has in
another spelling only (`Ros.sh` for `ros.sh`, `map_server.yaml` for `map-server.yaml`, `.yml` for `.yaml`) is reported
also where the failure is hidden.

Not reported: files that the script names a second time (it may make or test them), files of builds, ignored files and
those of submodules, and commands whose failure is expected (`||`, `2>/dev/null`).

## Why it matters on a robot
With `set -e` the installation stops in the middle: the first files are copied, and no service is enabled. Without it
the error scrolls past, and the robot boots without what the file was for.

## Bad
```sh
cp rover.service /etc/systemd/system/
cp rover.rules /etc/udev/rules.d/        # the file is called 99-rover.rules
```

## Good
```sh
cp rover.service /etc/systemd/system/
cp 99-rover.rules /etc/udev/rules.d/
```

## When to ignore it
When people put the file there before they run the script.

## References
- cp(1), bash(1)
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import Misnamed
from bringup_lint.api.shell import misnamed_files
from bringup_lint.api.shell import missing_files


@rule(
    "warning",
    symptoms=[
        "cannot stat",
        "line *: *: No such file or directory",
        "cp: cannot stat '*': No such file or directory",
    ],
)
def file_missing(robot: Robot) -> Iterator[Finding]:
    sources = [
        source
        for source in robot.of_kind("shell-script")
        if source.judged and not source.template and source.origin is None
    ]
    misnamed: dict[Source, list[Misnamed]] = {}
    for each in misnamed_files(robot.scripts, sources):
        misnamed.setdefault(each.word.span.source, []).append(each)
    for source in sources:
        yield from _misnamed(robot, misnamed.get(source, []))
        spelt = {each.word.span for each in misnamed.get(source, [])}
        missing = [each for each in missing_files(robot.scripts, source) if each.word.span not in spelt]
        if missing:
            first, *others = missing
            yield finding(
                first.word,
                f"There is no {first.path}: this command fails",
                advice="correct the name, or add the file",
                related=[note(other.word, f"nor {other.path}") for other in others],
            )


def _misnamed(robot: Robot, found: list[Misnamed]) -> Iterator[Finding]:
    """One finding for each name in a script."""
    by_name: dict[str, list[Misnamed]] = {}
    for each in found:
        by_name.setdefault(each.name, []).append(each)
    for name, (first, *others) in by_name.items():
        meant = posixpath.basename(first.there)
        file = robot.tree.at(first.there)
        yield finding(
            first.word,
            f"There is no {name}: the file is called {meant}, and this command fails",
            advice=f"write {meant}",
            related=[
                *([note(file.whole, "this file")] if file is not None else []),
                *(note(other.word, "here too") for other in others),
            ],
        )
