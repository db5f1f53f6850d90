"""rcl rejects the name of a topic or service.

## What it finds
The literal name of a publisher, subscription, service or client in a Python or C++ node that is not a valid topic
name:

- a character other than letters, digits, `_` and `/`
- a part that begins with a digit, a `/` at the end, or `//`
- a `~` that is not at the beginning
- a substitution other than `{node}`, `{ns}` and `{namespace}`
- more than 247 characters after expansion

The default of a parameter that gives the name counts only where no parameter or launch file sets that parameter.
Parameters that set the name of a topic are checked too, and so are the remappings of launch files, which may
contain neither `__` nor a substitution. A name into which the default of a launch argument brings the sign is a warning
where no command of the tree launches the file: whoever does may pass another value.

## Why it matters on a robot
The call raises an exception, usually in the constructor: the node never starts.

## Bad
```python
self.create_publisher(Image, "camera-1/image", 10)
```

## Good
```python
self.create_publisher(Image, "camera_1/image", 10)
```

## When to ignore it
Never: rcl rejects such a name in every distribution.

## References
- `rcl_validate_topic_name`, `rmw_validate_full_topic_name` (tried with rclpy of Jazzy)
- https://design.ros2.org/articles/topic_and_service_names.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api import topics
from bringup_lint.api.nodes import Endpoint

TESTED = regex(r"\.empty\(\)|[=!]=\s*(?:\"\"|'')|\bif not \w+:")
"""Code that asks whether a text is empty."""
WRONG = regex(r"[^A-Za-z0-9_/~{}]")
ROLES = {"publisher": "topic", "subscription": "topic", "service": "service", "client": "service"}


@rule(
    "error",
    fix="unsafe",
    symptoms=["Invalid topic name: topic name", "InvalidTopicNameException", "InvalidServiceNameException"],
)
def topic_name_invalid(robot: Robot) -> Iterator[Finding]:
    for endpoint in robot.topics.endpoints:
        if endpoint.role not in ROLES or endpoint.name is None:
            continue
        if endpoint.parameter is not None and (is_guarded(endpoint) or robot.topics.is_given(str(endpoint.parameter))):
            continue
        reason = topics.refusal(endpoint.name)
        if reason is not None:
            better = re.sub(r"/+", "/", re.sub(r"[^A-Za-z0-9_/~{}]", "_", endpoint.name)).rstrip("/")
            good = better and topics.refusal(better) is None
            yield finding(
                endpoint.name,
                f"'{endpoint.name}' is not a valid {ROLES[endpoint.role]} name, because {reason}: "
                f"the node exits when it creates the {endpoint.role}",
                advice=f"write '{better}'"
                if good
                else "use letters, digits, '_' and '/' only, and no part that begins with a digit",
                related=topics.used_at(endpoint.name, endpoint.span),
                fix=fix(f"rename it to '{better}'", (endpoint.name, better), safe=False)
                if good and endpoint.name.span.text == endpoint.name
                else None,
            )
    for (node, where, name, when), others in refused(robot):
        given = list(defaults(robot, node, name))
        unless = f" unless '{given[0].name}' is passed" if given else ""
        yield finding(
            where,
            f"'{name}' is not a valid topic name: {ends(node, when)}{unless}",
            advice="use letters, digits, '_' and '/' only, no '__', and no part that begins with a digit",
            related=[note(node.started.span, f"{node.label()} is started here")]
            + [note(default.text, "this default is a part of it") for default in given]
            + [note(each.where, f"'{each.name}' is not valid either") for each in others],
            severity="warning" if given and not robot.runners.launching(node.started.file) else None,
        )


def is_guarded(endpoint: Endpoint) -> bool:
    """Whether the code looks at the value of the parameter first, so that the default may mean that there is no
    topic."""
    return endpoint.conditional or (endpoint.name == "" and bool(TESTED.search(endpoint.span.source.text)))


def ends(node: topics.LaunchedNode, when: str) -> str:
    """A component takes nothing down with it: its container answers that it was not loaded."""
    if isinstance(node.started.action, launch.ComposableNode):
        return f"the container does not load {node.label()}"
    return f"{node.label()} exits {when}"


class Default(NamedTuple):
    name: str
    """Of the argument."""
    text: Located


def defaults(robot: Robot, node: topics.LaunchedNode, name: str) -> Iterator[Default]:
    """The defaults of arguments that bring a sign into a name that no name may have."""
    for declared in robot.launch.expansion(node.started.file).declared:
        text = launch.literal_text(declared.action.default)
        if text is not None and text in name and WRONG.search(text) is not None:
            yield Default(declared.name, text)


class Refused(NamedTuple):
    node: topics.LaunchedNode
    where: Span
    name: str
    when: str


def refused(robot: Robot) -> Iterator[tuple[Refused, list[Refused]]]:
    """The refused names of each node by their first part: one value is often the namespace of several names."""
    found: dict[tuple[Span, str], list[Refused]] = {}
    for each in map(Refused._make, robot.topics.refused):
        found.setdefault((each.node.started.span, each.name.strip("/").partition("/")[0]), []).append(each)
    for first, *others in found.values():
        yield first, others
