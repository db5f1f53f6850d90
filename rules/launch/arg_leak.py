"""An argument of one include leaks into the next.

## What it finds
Two includes in the same scope whose files declare the same argument with different defaults. The second include
does not pass a value. Not reported: `use_sim_time` that is false for both in this way.

## Why it matters on a robot
launch has one scope for all included files. The default of the first file stays bound, and the second file never
uses its own: it silently loads the wrong parameters.

## Bad
```xml
<include file="$(dirname)/lidar.launch.xml"/>    <!-- declares params, default lidar.yaml -->
<include file="$(dirname)/camera.launch.xml"/>   <!-- declares params, default camera.yaml -->
```

## Good
```xml
<group><include file="$(dirname)/lidar.launch.xml"/></group>
<group><include file="$(dirname)/camera.launch.xml"/></group>
```

## When to ignore it
When the second file is meant to inherit the value of the first. Passing the argument explicitly says so and also
removes the finding.

## References
- launch, `GroupAction(scoped=True)`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import Import
from bringup_lint.api.python import in_call


@rule("warning", fix="unsafe", silent="launch passes the value on without a message")
def arg_leak(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        for declared in expansion.declared:
            before = declared.before
            if before is None or not before.declared or len(declared.chain) != 1 or declared.conditions:
                continue
            other = before.origin.source
            if other in (declared.file.source, expansion.entry.source) or declared.action.default is None:
                continue
            own = robot.launch.text(declared.action.default, declared.file)
            leaked = launch.text_of(before.value)
            if own is None or leaked is None or own.lower() == leaked.lower():
                continue
            if launch.is_real_clock(declared.name, leaked):
                continue  # one clock is for all nodes, and this one is that of the robot
            leaking = _include_of(expansion, declared.name, other)
            title = f"put the include of {other.basename} into a scoped group"
            scoped = in_call(leaking, Import("launch.actions", "GroupAction")) if leaking is not None else None
            yield finding(
                declared.chain[0],
                f"'{declared.name}' of {other.basename} leaks into this include: it gets '{leaked}', never its "
                f"default '{own}'",
                advice="pass the argument, or put each include into a scoped group",
                related=[
                    note(before.origin, "bound here first"),
                    note(declared.action.span, "this default is never used"),
                ],
                fix=fix(title, codemod=scoped, safe=False) if scoped else None,
            )


def _include_of(expansion: launch.Expansion, name: str, source: Source) -> Span | None:
    """The include of the entry that binds an argument in an included file first."""
    found = (each for each in expansion.declared if each.name == name and each.file.source is source)
    return next((each.chain[0] for each in found if len(each.chain) == 1), None)
