"""A log call whose arguments rclpy does not take.

## What it finds
Calls of a logger of rclpy with further arguments, as the loggers of Python's own `logging` take them, with an option
that rclpy does not know, such as `exc_info`, and with a message that is no text: the exception of a handler, a number,
a list.

## Why it matters on a robot
The logger of rclpy takes one text and its own options. For anything else it raises TypeError in place of writing the
line. Most such calls stand where something has gone wrong, so that nobody tries them: the first fault of a sensor ends
the node that was to report it.

## Bad
```python
except serial.SerialException as error:
    self.get_logger().error(error)
self.get_logger().info("%d points", count)
```

## Good
```python
except serial.SerialException as error:
    self.get_logger().error(str(error))
self.get_logger().info(f"{count} points")
```

## When to ignore it
When the logger is one of the project's own that takes more.

## References
- rclpy.impl.rcutils_logger.RcutilsLogger.log (tried with rclpy 7.1: TypeError)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

UNTRIED = ("lyrical", "rolling")
"""Distributions whose rclpy may take more than that of Kilted."""
WHAT = {
    "arguments": "the logger takes one text, and formats nothing",
    "message": "the message is no text",
    "option": "the logger does not know this option",
}
ADVICE = {
    "arguments": 'format the text before: f"{value} V"',
    "message": "write str() around it, or an f-string",
    "option": "leave the option out; traceback.format_exc() gives the traceback as a text",
}


@rule(
    "error",
    fix="safe",
    symptoms=[
        "rclpy_logging_rcutils_log(): incompatible function arguments",
        "TypeError: RcutilsLogger.info() takes 2 positional arguments but 3 were given",
        "is not one of the recognized logging options",
    ],
)
def log_refused(robot: Robot) -> Iterator[Finding]:
    if robot.target.ros in UNTRIED:
        return
    for file in robot.nodes.robot_sources:
        groups: dict[str, list[nodes.RefusedLog]] = {}
        for each in nodes.refused_logs(robot.nodes.syntax(file)):
            groups.setdefault(each.kind, []).append(each)
        for kind, (first, *others) in groups.items():
            yield finding(
                file.span_of(first.what),
                f"TypeError in place of a log line: {WHAT[kind]}; {first.end}",
                advice=ADVICE[kind],
                related=[note(file.span_of(each.what), "likewise here") for each in others],
                fix=_written_well(file, [first, *others]),
                severity=robot.nodes.lowered(file.source, "error" if first.ends_node else "warning"),
            )


def _written_well(file: nodes.NodeSource, found: list[nodes.RefusedLog]) -> Fix | None:
    """The messages as texts, where it is plain how."""
    edits = []
    for each in found:
        first, *others = [file.span_of(argument) for argument in each.call.args]
        if each.kind == "message":
            edits.append((first, f"str({first.text})"))
        elif each.kind == "arguments" and each.formats:
            place = file.source.span(first.end, others[-1].end)
            if place.text.count("(") == place.text.count(")"):
                values = ", ".join(other.text for other in others)
                edits.append((place, f" % ({values})" if len(others) > 1 else f" % ({values},)"))
    return fix("give the logger one text", *edits) if edits else None
