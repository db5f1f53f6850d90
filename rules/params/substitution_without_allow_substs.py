"""launch loads a parameter file without resolving its substitutions.

## What it finds
`$(env X)`, `$(var x)`, `$(find-pkg-share p)` and similar substitutions in the values of a file that launch files of
this tree load, when none of them sets `allow_substs`.

## Why it matters on a robot
Nothing replaces the substitution. The node gets the text '$(find-pkg-share my_robot)/map.yaml' and finds no such
file.

## Bad
```python
Node(package='demo', executable='map', name='map', parameters=['config/map.yaml'])
```

## Good
```python
Node(package='demo', executable='map', name='map', parameters=[ParameterFile('config/map.yaml', allow_substs=True)])
```

## When to ignore it
When the node itself resolves the substitution, or a build step resolves it before the file is installed.

## References
- https://github.com/ros2/launch_ros/issues/96
- https://github.com/ros2/rcl/issues/527
- https://github.com/ros-navigation/navigation2/issues/3706
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

_SUBSTITUTION = regex(
    r"\$\((?:env|optenv|var|find-pkg-share|find-pkg-prefix|find-exec|exec-in-pkg|exec-in-package|dirname|filename|eval|command|anon"
    r"|not|and|or|equals|not-equals|if|log_dir)\b[^)]*\)"
)


@rule("error", fix="unsafe", symptoms=["No such file or directory: '$(find-pkg-share"])
def substitution_without_allow_substs(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.parameters:
        if "$(" not in parameter.text or any(load.substitutes is not False for load in robot.params.loads(file)):
            continue
        loads = robot.params.effective(file, parameter)
        if not loads:
            continue
        for item in robot.params.items(parameter):
            found = _SUBSTITUTION.search(item.text)
            if found:
                yield finding(
                    item.span,
                    f"The node gets the literal text '{found[0]}' for '{parameter.name}': launch does not resolve it",
                    advice='load the file with ParameterFile(path, allow_substs=True), in XML with allow_substs="true"',
                    chain=robot.provenance.chain_to_load(loads[0], note(item.span, f"{found[0]} is not resolved")),
                    related=[note(loads[0].where, "loaded here, without substitutions")],
                    fix=_allowed(loads[0].where),
                )


def _allowed(where: Span) -> Fix | None:
    """Only for a Python launch file that imports the class already."""
    text = where.source.text
    if (
        where.source.kind != "launch-python"
        or not re.search(r"import .*\bParameterFile\b", text)
        or not where.text.strip()
    ):
        return None
    if where.text.startswith("ParameterFile("):
        return None
    return fix("load it with allow_substs", (where, f"ParameterFile({where.text}, allow_substs=True)"), safe=False)
