"""A node imports a module of its package, or a name of a module, that does not exist.

## What it finds
`from .x import y` and `from package.x import y` in the source of a node, where the package of the node has neither
`x.py` nor a folder `x`. Only in packages with a setup.py that builds no modules. Imports in a `try` block or under a
condition are left out, as are modules that git ignores and those that tools write. It is an info in a `main()` that
nothing starts.
In nodes, and in the Python programs and modules beside them, also `from x import y` where `x` can only be one file of
the tree, and nothing in that file binds `y`. Files that make names in other ways (`import *`, `globals()`,
`__getattr__`) are left out.

## Why it matters on a robot
The import fails with ModuleNotFoundError or ImportError, and the node ends: at its start, or when the function that
imports is called. It goes unseen where the renamed module is still in the install folder of the developer.

## Bad
```python
from .thrust_view import ThrustView   # the file is called sam_thrust_view.py
```

## Good
```python
from .sam_thrust_view import ThrustView
```

## When to ignore it
When the module is copied into the package before it is built.

## References
- https://docs.python.org/3/reference/import.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["from .* import *", "ImportError: cannot import name '*' from '*'"])
def module_missing(robot: Robot) -> Iterator[Finding]:
    yield from _modules(robot)
    yield from _names(robot)


def _modules(robot: Robot) -> Iterator[Finding]:
    for found in nodes.missing_modules(robot.nodes):
        when = f"when {found.function}() is called" if found.function else "when the file is loaded"
        is_run = found.function != "main" or robot.nodes.runs_main(found.file.source)
        yield finding(
            found.file.span_of(found.statement),
            f"ModuleNotFoundError {when}: the package has no {found.path}",
            advice=f"add the module, or correct the name in 'from {found.module} import'",
            severity=robot.nodes.lowered(found.file.source, "error") if is_run else "info",
        )


def _names(robot: Robot) -> Iterator[Finding]:
    for found in nodes.missing_names(robot.nodes):
        when = f"when {found.function}() is called" if found.function else "when the file is loaded"
        is_run = found.function != "main" or robot.nodes.runs_main(found.file.source)
        name, module = found.alias.name, found.defined.source.basename
        yield finding(
            found.file.span_of(found.alias),
            f"ImportError {when}: {module} has no '{name}'",
            advice=f"import {found.like}" if found.like else f"define {name} in {module}, or import what it defines",
            related=[note(found.defined.source.whole, f"nothing here is called {name}")],
            severity=robot.nodes.lowered_if_vendored(found.file.source, "error") if is_run else "info",
        )
