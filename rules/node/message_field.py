"""A message has no such field, or the field does not take the value.

## What it finds
Python nodes that read or set a field which the message does not have, and values of another type than the field:
`twist.linear.x = 1` (the field is a `float64`), `header.stamp = self.get_clock().now()`, a number for a time, a text
for a number, the value of a parameter that is declared with another type. Also constants that a message does not have,
and those of a request that are taken from the service; what the callback for the feedback of an action gets, which
holds the feedback itself in its field `feedback`; the `request` of the goal that a server executes; and a `publish()`
that gets a number, a text or a message of another type, as `publish(True)`, which rospy allowed. Also
fields that a message gets without their names, `Point(0.0, 0.0, 0.0)`, as in ROS 1; and a message that is used as if
it were the list in one of its fields: `path[0]`, `len(scan)`, `for each in array`. The fields are those of the
`.msg`, `.srv` and `.action` files of the tree, and of the common interface packages. It is an info in packages that
others wrote and the tree only carries.

## Why it matters on a robot
Python looks at fields and values when the line runs, often only in the branch for an emergency. A field that is
missing raises AttributeError; as an argument of the message it raises AssertionError in Humble, and newer releases
ignore it. A value of the wrong type raises AssertionError in Humble. Newer releases do not look at it any more: an
integer in a float field arrives as 5e-324, so that the robot does not move, or aborts the node; an integer in a bool
arrives as False; other wrong types make `publish()` raise.

## Bad
```python
twist = Twist()
twist.linear.x = 1
```

## Good
```python
twist = Twist()
twist.linear.x = 1.0
```

## When to ignore it
When the message comes from another version of its package, in which the field exists.

## References
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html
- rosidl_python, `_msg.py.em` and `_msg_support.c.em`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "AttributeError: '*' object has no attribute '*'",
        "must be of type 'float'",
        "AttributeError: 'Twist' object has no attribute",
        "AttributeError: 'TwistStamped' object has no attribute",
        "AttributeError: 'Pose' object has no attribute",
        "AttributeError: 'PoseStamped' object has no attribute",
        "AttributeError: 'Odometry' object has no attribute",
        "AttributeError: 'Imu' object has no attribute",
        "TypeError: '*' object is not subscriptable",
        "TypeError: '*' object is not iterable",
        "TypeError: object of type '*' has no len()",
        "TypeError: Expected <class '*'>, got <class '*'>",
        "TypeError: *.__init__() takes 1 positional argument but * were given",
    ],
)
def message_field(robot: Robot) -> Iterator[Finding]:
    for types in robot.nodes.message_types:
        severity = robot.nodes.lowered_if_vendored(types.file.source, "error")
        usual = "error" if nodes.is_checked(robot.target.ros) else "warning"
        of_values = robot.nodes.lowered_if_vendored(types.file.source, usual)
        for uses in nodes.missing_fields(types):
            lacking, *rest = sorted(uses, key=lambda use: not robot.leads_to(types.file.span_of(use.place)))
            yield finding(
                types.file.span_of(lacking.place),
                f"{lacking.type} has no {lacking.kind} '{lacking.name}': {_consequence(lacking, robot.target.ros)}",
                advice=f"its {lacking.kind}s are {', '.join(lacking.others)}"
                if lacking.others
                else f"it has no {lacking.kind}s",
                related=[
                    note(
                        types.file.span_of(each.place),
                        "the same" if each.name == lacking.name else f"nor '{each.name}'",
                    )
                    for each in rest
                ],
                severity=of_values if lacking.given else severity,
            )
        for constant in nodes.misplaced_constants(types):
            owner = types.file.span_of(constant.place.value)
            name = f"{owner.text}.{constant.part}.{constant.place.attr}"
            yield finding(
                types.file.span_of(constant.place),
                f"{owner.text} has no constant '{constant.place.attr}', its {constant.part} has it: AttributeError, "
                f"and {constant.end}",
                advice=f"write {name}",
                severity=severity,
            )
        for first, *others in nodes.wrong_fields(types, robot.target.ros):
            spans = [types.file.span_of(each.value) for each in (first, *others)]
            better = nodes.converted(first, spans[0].text)
            edits = [(each, nodes.converted(first, each.text) or each.text) for each in spans]
            yield finding(
                spans[0],
                f"'{first.name}' is {first.kind}, and {spans[0].text} is {first.got}: "
                f"{nodes.consequence(first, robot.target.ros)}",
                advice=f"write {better}" if better else f"give it {first.kind}",
                related=[note(each, "the same") for each in spans[1:]],
                fix=fix(f"write {better}", *edits, safe=False) if better else None,
                severity=of_values,
            )
        for given in nodes.given_in_order(types):
            places = [types.file.span_of(call.args[0]) for call in given.calls]
            places.sort(key=lambda place: not robot.leads_to(place))
            yield finding(
                places[0],
                f"{given.type} takes its fields by their names only: TypeError, and {given.end}",
                advice="write NAME=VALUE for each field",
                related=[note(each, "here too") for each in places[1:]],
                severity="info" if given.function and robot.nodes.is_idle(types.file, given.function) else severity,
            )
        for wrong in nodes.wrong_publishes(types):
            yield finding(
                types.file.span_of(wrong.value),
                f"This publisher takes a {wrong.wanted}, and gets {wrong.got}: TypeError, and {wrong.end}",
                advice=f"make a {wrong.wanted.rpartition('/')[2]} of it, and publish that",
                related=[note(types.file.span_of(wrong.made), "the publisher is made with this type")],
                severity=severity,
            )
        for used in nodes.used_as_lists(types):
            name = used.type.rpartition("/")[2]
            yield finding(
                types.file.span_of(used.value),
                f"TypeError: a {name} has no {used.needed.removeprefix('a ')}, and {used.end}",
                advice=f"take its field {' or '.join(used.lists)}" if used.lists else "take one of its fields",
                severity="info" if used.idle else severity,
            )


def _consequence(lacking: nodes.NoField, distribution: str | None) -> str:
    """What happens where a field that does not exist is used, in words."""
    if not lacking.given:
        return f"AttributeError, and {lacking.end}"
    if distribution is None:
        return "AssertionError in Humble, ignored by newer releases"
    return f"AssertionError, and {lacking.end}" if nodes.is_checked(distribution) else "the argument is ignored"
