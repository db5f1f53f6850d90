"""A node uses an attribute that nothing sets, or sets one that rclpy keeps.

## What it finds
`self.x`, and `self.x += 1`, in a Python node when no code sets `x` and neither its base classes nor rclpy define it;
and assignments to `self.subscriptions`, `self.publishers`, `self.clients`, `self.services`, `self.timers` and the other
properties of `rclpy.node.Node` that cannot be set; and `get_parameter('x').double_value` or `.as_double()`, which are
those of ParameterValue and of C++, and `.value.bool_value` of a parameter that rclpy hands out; and attributes that
only a subscription sets and that a timer or another subscription uses without asking whether the message came; and
attributes whose every assignment comes behind a use of them; and those that a `try` of the constructor sets, whose
`except` goes on, and that the constructor or a callback uses afterwards; and what the module rclpy does not have, such
as `rclpy.Time` and the functions of rospy; and `Encoder.port`, where only the objects of the class Encoder have a port;
and members that an `Enum` of the tree does not have, where no `setattr` may give it more. The same holds for classes
beside the nodes, in Python modules of the tree too, that build on nothing and that the code makes; and for
`motor.brake()` and `self.motor.brake()` where the object is only ever of one such class, be it of another file of the
tree. Classes with bases that are not in the tree are left out. It is an info in a method that nothing calls, in
`__getitem__`, `__str__` and the like of a plain class, where no `len(x)`, `x[0]` and the like runs them, behind a
handler that shuts the context down, and after the `join()` of a thread, where the node has done its work. It is an info
in packages that others wrote and the tree only carries.

## Why it matters on a robot
Python looks an attribute up when the line runs: in the callback for a fault or an emergency stop, perhaps weeks later,
on the robot. AttributeError then leaves `spin()`, and the node ends. An assignment to a property of rclpy ends it at
its start.

## Bad
```python
def on_stop(self, msg):
    self.cmd_publisher.publish(Twist())  # it is called self.cmd_pub
```

## Good
```python
def on_stop(self, msg):
    self.cmd_pub.publish(Twist())
```

## When to ignore it
When the attribute is set from outside in a way that the linter does not see.

## References
- https://docs.python.org/3/reference/datamodel.html, "Custom classes"
- rclpy, node.py: the properties of Node
"""

import ast
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

BY_OPERATORS = frozenset("__getitem__ __iter__ __len__ __contains__ __str__ __repr__ __eq__ __lt__ __hash__".split())
"""Methods that no call names."""


@rule(
    "error",
    symptoms=[
        "AttributeError: '*' object has no attribute '*'",
        "AttributeError: can't set attribute '*'",
        "AttributeError: property '*' of '*' object has no setter",
        "AttributeError: module 'rclpy' has no attribute '*'",
        "AttributeError: type object '*' has no attribute '*'",
        "ImportError: cannot import name '*' from 'rclpy'",
    ],
)
def undefined_attribute(robot: Robot) -> Iterator[Finding]:
    yield from _missing(robot)
    yield from _of_plain_classes(robot)
    yield from _taken(robot)
    yield from _late(robot)
    yield from _early(robot)
    yield from _half_made(robot)
    yield from _untyped(robot)
    yield from _of_rclpy(robot)
    yield from _of_objects(robot)
    yield from _of_other_objects(robot)


def _missing(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.missing_attributes(robot.nodes):
        end = nodes.end_of(robot.nodes.syntax(first.file), first.place)
        lacking, advice = _described(robot, first.file, first.place, first.owner.name or "its class")
        yield finding(
            first.file.span_of(first.place),
            f"AttributeError when {first.function}() runs: {lacking}, and {end}",
            advice=f"write self.{first.like}" if first.like else advice,
            related=[note(each.file.span_of(each.place), f"nothing sets self.{each.place.attr}") for each in others],
            severity="info" if first.idle else robot.nodes.lowered_if_vendored(first.file.source, "error"),
        )


def _described(robot: Robot, file: nodes.NodeSource, place: ast.Attribute, owner: str) -> tuple[str, str]:
    """What a class lacks, and what to write: a method where it is called."""
    outer, _ = next(robot.nodes.syntax(file).above(place))
    if isinstance(outer, ast.Call) and outer.func is place:
        return f"nothing defines self.{place.attr}()", f"define {place.attr}() in {owner}, or call what it has"
    return f"nothing sets self.{place.attr}", f"set self.{place.attr} in __init__()"


def _of_plain_classes(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.plain_attributes(robot.nodes):
        end = nodes.end_of(robot.nodes.syntax(first.file), first.place, caught=first.caught)
        lacking, advice = _described(robot, first.file, first.place, first.owner)
        idle = first.idle and robot.nodes.is_idle(first.file, first.function)
        severity = "warning" if first.function.startswith("__") and first.function != "__init__" else "error"
        if first.function in BY_OPERATORS:
            idle = not nodes.is_operated(robot.nodes, first)
        yield finding(
            first.file.span_of(first.place),
            f"AttributeError when {first.function}() runs: {lacking} in {first.owner}, and {end}",
            advice=advice,
            related=[note(each.file.span_of(each.place), f"used in {each.function}() too") for each in others],
            severity="info" if idle else robot.nodes.lowered_if_vendored(first.file.source, severity),
        )


def _taken(robot: Robot) -> Iterator[Finding]:
    for taken in nodes.taken_attributes(robot.nodes):
        name, end = taken.place.attr, nodes.end_of(robot.nodes.syntax(taken.file), taken.place)
        yield finding(
            taken.file.span_of(taken.place),
            f"AttributeError: '{name}' is a property of rclpy's Node that cannot be set so, and {end}",
            advice=f"choose another name, such as self.own_{name}",
            severity=robot.nodes.lowered_if_vendored(taken.file.source, "error"),
        )


def _late(robot: Robot) -> Iterator[Finding]:
    for late, *more in nodes.late_attributes(robot.nodes):
        name, end = late.place.attr, nodes.end_of(robot.nodes.syntax(late.file), late.place)
        yield finding(
            late.file.span_of(late.place),
            f"AttributeError when {late.user.name}() runs before {late.setter.name}() sets self.{name}: {end}",
            advice=f"set self.{name} = None in __init__(), and return while it is None",
            related=[
                note(late.file.span_of(late.set_at), "only here is it set, when a message comes"),
                *(note(each.file.span_of(each.place), f"self.{each.place.attr} likewise") for each in more),
            ],
            severity=robot.nodes.lowered_if_vendored(late.file.source, "warning"),
        )


def _early(robot: Robot) -> Iterator[Finding]:
    for early, *more in nodes.early_reads(robot.nodes):
        name, end = early.place.attr, nodes.end_of(robot.nodes.syntax(early.file), early.place)
        yield finding(
            early.file.span_of(early.place),
            f"AttributeError when {early.method}() runs: self.{name} is set only after it was used, and {end}",
            advice=f"give self.{name} its first value in __init__()",
            related=[
                note(early.file.span_of(early.set_at), "set only behind a use of it"),
                *(note(each.file.span_of(each.place), f"self.{each.place.attr} likewise") for each in more),
            ],
            severity="info" if early.idle else robot.nodes.lowered_if_vendored(early.file.source, "error"),
        )


def _half_made(robot: Robot) -> Iterator[Finding]:
    for file, handler, place, set_at, function, ends in nodes.half_made(robot.nodes):
        end = nodes.end_of(robot.nodes.syntax(file), place)
        where = handler.type if handler.type is not None else set_at
        yield finding(
            file.span_of(where),
            f"AttributeError in {function}(): the constructor goes on without self.{place.attr}, and {end}",
            advice="raise the exception again, or set the attribute to None and look at it where it is used",
            related=[
                note(file.span_of(set_at), "not set when this fails"),
                note(file.span_of(place), "used all the same"),
            ],
            severity="info" if ends else robot.nodes.lowered_if_vendored(file.source, "warning"),
        )


def _untyped(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        reads = list(nodes.untyped_reads(robot.nodes.syntax(file)))
        for read in reads[:1]:
            end = nodes.end_of(robot.nodes.syntax(file), read)
            is_farther = isinstance(read.value, ast.Attribute)
            lacking = (
                f"the value of a Parameter is one of Python, which has no '{read.attr}'"
                if is_farther
                else f"get_parameter() returns a Parameter, which has no '{read.attr}'"
            )
            yield finding(
                file.span_of(read),
                f"AttributeError: {lacking}, and {end}",
                advice=f"leave out .{read.attr}" if is_farther else "write .value",
                related=[note(file.span_of(each), f"nor '{each.attr}'") for each in reads[1:]],
                severity=robot.nodes.lowered_if_vendored(file.source, "error"),
            )


def _of_rclpy(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for lacking in nodes.lacking_names(robot.nodes.syntax(file)):
            yield finding(
                file.span_of(lacking.place),
                f"{lacking.error}: the module rclpy has no '{lacking.name}', and {lacking.end}",
                advice=f"write {lacking.instead}",
                severity="info" if lacking.idle else robot.nodes.lowered_if_vendored(file.source, "error"),
            )


def _of_objects(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for found in nodes.class_attributes(robot.nodes.syntax(file)):
            name = found.place.attr
            yield finding(
                file.span_of(found.place),
                f"AttributeError: the class {found.owner} has no '{name}', only its objects do, and {found.end}",
                advice=f"take {name} from the object",
                related=[note(file.span_of(found.set_at), "set on an object")],
                severity=robot.nodes.lowered_if_vendored(file.source, "error"),
            )


def _of_other_objects(robot: Robot) -> Iterator[Finding]:
    for found in (*nodes.object_attributes(robot.nodes), *nodes.enum_members(robot.nodes)):
        name, owner = found.place.attr, found.defined.node.name
        when = f"when {found.function}() runs" if found.function is not None else "when the file is loaded"
        end = nodes.end_of(robot.nodes.syntax(found.file), found.place, caught=found.caught)
        idle = found.idle and robot.nodes.is_idle(found.file, found.function)
        yield finding(
            found.file.span_of(found.place),
            f"AttributeError {when}: {owner} has no '{name}', and {end}",
            advice=f"define {name} in {owner}, or take what it has",
            related=[note(found.defined.file.span_of(found.defined.node), f"nothing in {owner} is called {name}")],
            severity="info" if idle else robot.nodes.lowered_if_vendored(found.file.source, "error"),
        )
