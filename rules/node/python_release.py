"""A node needs another release of Python than its distribution has.

## What it finds
Imports and uses of modules and names that came later, or that were removed, and syntax and annotations that came later.
Foxy and Galactic run on Python 3.8, Humble and Iron on 3.10, Jazzy and Kilted on 3.12. On Jazzy and Kilted also names
that NumPy and Pillow of Ubuntu 24.04 do not have any more: `np.float`, `Image.ANTIALIAS`. What is in `try` and below a
test is left out, and trees whose distribution is not known. It is a warning where the tree describes an environment
with a Python of its own, for Nix or pixi, and for a name that a function uses.

## Why it matters on a robot
It works on the developer's computer. On the robot the node ends with an ImportError or a SyntaxError before its first
line of code runs, or with an AttributeError where it uses the name.

## Bad
```python
from typing import Self     # Python 3.11; Humble has 3.10
```

## Good
```python
from typing_extensions import Self
```

## When to ignore it
When the nodes of the robot run in an environment with a Python of its own, as with conda, pixi or Nix.

## References
- REP 2000: the Ubuntu release of each distribution
- https://docs.python.org/3/whatsnew/
- https://numpy.org/doc/stable/release/1.24.0-notes.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.nodes import NodeSource
from bringup_lint.api.nodes import NotThere

BRINGING_PYTHON = ("flake.nix", "shell.nix", "pixi.toml")
"""Files of environments with a Python of their own, in which the node may run."""


@rule("error", confidence="medium", symptoms=["ImportError: cannot import name 'deprecated' from 'warnings'"])
def python_release(robot: Robot) -> Iterator[Finding]:
    distribution = robot.target.ros
    python = nodes.python_of(distribution)
    if distribution is None or python is None:
        return
    brought = next((name for name in BRINGING_PYTHON if next(robot.tree.named(name), None) is not None), None)
    where = f"outside of the environment of {brought} " if brought is not None else ""
    for file in robot.nodes.with_modules:
        found = sorted(nodes.not_there(robot.nodes.syntax(file), python), key=lambda each: each.node.lineno)
        if not found:
            continue
        first, *others = found
        yield finding(
            file.span_of(first.node),
            f"{first.what}, and {distribution.capitalize()} {first.present}: {where}{_ends(robot, file, first)}",
            advice="use what both releases have, or a backport such as typing_extensions",
            related=[note(file.span_of(each.node), each.what) for each in others[:5]],
            severity=robot.nodes.lowered(file.source, "warning" if brought is not None or first.late else "error"),
        )


def _ends(robot: Robot, file: NodeSource, found: NotThere) -> str:
    if found.late:
        return f"this raises {found.raises}, and {nodes.end_of(robot.nodes.syntax(file), found.node)}"
    return f"the node ends with {found.raises}"
