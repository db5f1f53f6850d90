"""A message that is empty or malformed ends the node.

## What it finds
In callbacks of subscriptions and services of Python nodes, outside every `try` that takes the exception:
- `json.loads`, `ast.literal_eval`, `yaml.safe_load`, `float` and `int` of the text of a message,
- an entry of a dictionary that the file writes out, for the text of a message,
- both also after a branch that asks for the text, where the branch leaves nothing and the line after it runs all the
  same,
- the first or last element, `max()` or `min()` of an array that is empty in regular operation, and that the function
  asks nothing about before: `detections`, `markers`, the `poses` of a path, the `points` of a trajectory.

Also a `try` that takes another exception than the one which is raised: StopIteration of `next()` of a search that may
find nothing, SerialException of a port that is opened, ConnectionRefusedError of a socket, IndexError of the `axes` and
`buttons` of a joystick, which are lists. Texts that a node of the tree makes with `json.dumps` for the same topic are
left out.

## Why it matters on a robot
rclpy hands an exception of a callback on to `spin()`, which ends the node. Everybody can publish on a topic: one
message of a test with `ros2 topic pub`, or a camera that sees nothing, and the driver or the mission is gone.
In C++ nothing checks the index: the node crashes, or takes what lies behind the array for a button that is pressed. An
Xbox controller has 11 buttons, and `game_controller_node` sends 6 axes.

## Bad
```python
def on_plan(self, msg):
    plan = json.loads(msg.data)
```

## Good
```python
def on_plan(self, msg):
    try:
        plan = json.loads(msg.data)
    except ValueError as error:
        self.get_logger().error(f'not a plan: {error}')
        return
```

## When to ignore it
When only one program publishes on the topic, and never sends such a message, or the robot has one gamepad forever.

## References
- rclpy, executors.py: exceptions of a task are raised by `spin_once`
- https://docs.python.org/3/library/functions.html#next
- https://en.cppreference.com/w/cpp/container/vector/operator_at
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["json.decoder.JSONDecodeError: Expecting value", "IndexError: list index out of range"])
def message_unchecked(robot: Robot) -> Iterator[Finding]:
    yield from _in_callbacks(robot)
    yield from _in_handlers(robot)
    yield from _in_cpp(robot)


def _in_cpp(robot: Robot) -> Iterator[Finding]:
    for source, found in nodes.unchecked_elements(robot.nodes):
        first, *others = found.told
        yield finding(
            found.first,
            f"{first.place.text} is read without a look at how many {first.field} the message has: where it is "
            "missing, the node crashes, or goes on with what lies there in memory",
            advice="return when the array is too short",
            related=[
                *(note(each.place, "this one, too") for each in others),
                *([note(first.place, "the last of them")] if first.place != found.first else []),
            ],
            severity=robot.nodes.lowered_if_vendored(source.source, "warning"),
        )


def _in_callbacks(robot: Robot) -> Iterator[Finding]:
    alike: dict[tuple[nodes.NodeSource, str], list[nodes.Unchecked]] = {}
    for each in nodes.unchecked_messages(robot.nodes):
        alike.setdefault((each.file, each.fault.raises), []).append(each)
    for (file, _), found in alike.items():
        yield _finding(robot, file, *found)


def _in_handlers(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        syntax = robot.nodes.syntax(file)
        for node, raised, handler in nodes.mistaken_handlers(syntax):
            yield finding(
                file.span_of(node),
                f"{raised.what}, and this try does not take it: {nodes.end_of(syntax, node)}",
                advice=raised.advice,
                related=[note(file.span_of(handler), "takes another exception")],
                severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
            )


def _finding(robot: Robot, file: nodes.NodeSource, first: nodes.Unchecked, *others: nodes.Unchecked) -> Finding:
    """One for what a file does in the same way with several messages."""
    fault, topic = first.fault, f" on {first.endpoint.name}" if first.endpoint.name is not None else ""
    kind = "request" if first.endpoint.role == "service" else "message"
    return finding(
        file.span_of(fault.node),
        f"A {kind}{topic} {fault.when} raises {fault.raises}: {nodes.end_of(robot.nodes.syntax(file), fault.node)}",
        advice="catch it, log it and go without this message"
        if fault.is_text
        else "return when the array is too short",
        related=[
            note(first.endpoint.span, f"{first.name}() is the callback of this {first.endpoint.role}"),
            *(note(file.span_of(each), "raises too") for each in first.others),
            *(note(file.span_of(each.fault.node), f"the same in {each.name}()") for each in others),
        ],
        severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
    )
