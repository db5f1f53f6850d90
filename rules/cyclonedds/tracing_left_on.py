"""Cyclone DDS tracing is still switched on.

## What it finds
Tracing that is useful only for debugging:
- **warning**: `Verbosity` `fine`, `finer` or `finest`, in a file whose name does not contain `debug`.
- **error**: an `OutputFile` in a folder that does not exist, in a complete root file system.

## Why it matters on a robot
At `finest` every node writes down every packet: this uses much CPU time and fills the disk. A trace file that
cannot be opened is fatal: no node starts.

## Bad
```xml
<Tracing>
  <Verbosity>finest</Verbosity>
  <OutputFile>/var/log/dds.log</OutputFile>
</Tracing>
```

## Good
```xml
<Tracing>
  <Verbosity>warning</Verbosity>
</Tracing>
```

## When to ignore it
While you debug discovery on this robot. A missing folder is harmless only if something creates it before ROS
starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["cannot open for writing"])
def tracing_left_on(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        verbosity = domain.get("Tracing/Verbosity")
        category = domain.get("Tracing/Category")
        level = (verbosity.effective or "").lower() if verbosity else ""
        traced = level not in ("", "none") or bool(category and category.effective)
        meant = "debug" in configuration.source.name.lower()
        if verbosity is not None and level in ("fine", "finer", "finest") and not meant:
            yield finding(
                verbosity.value,
                f"Tracing at '{level}' slows every node and fills the disk",
                advice="write warning",
                fix=fix("write warning", (verbosity.value, "warning"), safe=False),
            )
        file = domain.get("Tracing/OutputFile")
        folder = (file.effective or "").rpartition("/")[0] if file else ""
        if file is not None and traced and folder.startswith("/") and robot.tree.has(folder) is False:
            yield finding(
                file.value,
                f"{folder} does not exist: the trace file cannot be opened for writing, no node starts",
                advice="create the folder, or trace to stderr",
                severity="error",
            )
