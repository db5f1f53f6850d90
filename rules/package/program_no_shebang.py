"""A package installs a script as a program that does not say which interpreter it is for.

## What it finds
Python and shell scripts that CMakeLists.txt installs into `lib/<package>` with `install(PROGRAMS)`, whose first line
does not begin with `#!`: those that a launch file starts, and, as a warning, those that only an argument enables, and
Python scripts with `if __name__ == "__main__"`.

## Why it matters on a robot
The kernel executes a text file only by its first line. `ros2 run` and launch find the program and end with "Exec format
error". `python3 script.py` by hand works, which hides it.

## Bad
```python
import rclpy
```

## Good
```python
#!/usr/bin/env python3
import rclpy
```

## When to ignore it
When the file is only imported, or started as an argument of python3.

## References
- execve(2), ENOEXEC
- https://docs.ros.org/en/jazzy/How-To-Guides/Ament-CMake-Python-Documentation.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["[Errno 8] Exec format error"])
def program_no_shebang(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        started = robot.dependencies.started_programs(package)
        for each in robot.dependencies.plain_programs(package):
            name = each.renamed or each.source.rpartition("/")[2]
            where = started.get(name)
            file = robot.tree.beside(each.where.source, each.source)
            begin = [note(file.span(0, len(file.line_text(1))), "it begins here")] if file else []
            is_started = where is not None and robot.dependencies.starts_by_default(package, name)
            yield finding(
                each.where,
                f"{each.source} does not begin with #!: {'launch' if where else 'ros2 run'} cannot execute it",
                advice=f"begin it with #!/usr/bin/env {'python3' if each.source.endswith('.py') else 'bash'}",
                related=[*begin, *([note(where, "it is started here")] if where else [])],
                severity=None if is_started else "warning",
            )
