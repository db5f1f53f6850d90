"""Cyclone DDS tracing that was left on.

## What it finds
`Verbosity` `fine`, `finer` or `finest`, or trace categories such as `data` and `traffic`, in a file
that is not named after debugging. In a whole root file system, an `OutputFile` in a folder that is not
there is an error.

## Why it matters on a robot
At `finest` every packet of every node is written down: the processor is busy with it, and the disk
fills. A trace file that cannot be opened is fatal: no node starts.

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

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
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
        if level in ("fine", "finer", "finest") and "debug" not in configuration.source.name.lower():
            yield finding(
                verbosity.value,
                f"Tracing at '{level}' slows every node and fills the disk",
                advice="write warning",
                fix=fix("write warning", (verbosity.value, "warning"), safe=False),
            )
        file = domain.get("Tracing/OutputFile")
        folder = (file.effective or "").rpartition("/")[0] if file else ""
        if traced and folder.startswith("/") and robot.tree.has(folder) is False:
            yield finding(
                file.value,
                f"{folder} does not exist: the trace file cannot be opened for writing, no node starts",
                advice="create the folder, or trace to stderr",
                severity="error",
            )
