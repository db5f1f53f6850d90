"""Text of a message becomes part of a shell command or of a program.

## What it finds
`os.system`, `os.popen` and `subprocess` with `shell=True`, and `exec` and `eval` of Python, that run text of a
subscription's message, of a service request or of the goal of an action: `std_msgs/String`, and types of the tree with
fields of type `string`. Functions and methods of the file are followed, and what a callback keeps for them in
attributes and queues. Not reported: text that is quoted with `shlex.quote`, converted to a number, looked up in a table
or compared with what is allowed. In C++ the same for `system()` and `popen()` in the function that gets the request,
the `std_msgs/String` or the goal, where nothing before looks into the text.

## Why it matters on a robot
Without SROS2, everybody in the same ROS domain may publish and call services. A name such as `x; reboot` runs with the
rights of the node.

## Bad
```python
def on_play(self, request, response):
    os.system(f'aplay {request.file}')
```

## Good
```python
def on_play(self, request, response):
    subprocess.run(['aplay', '--', request.file], check=True)
```

## When to ignore it
When SROS2 is enforced and only trusted nodes may publish the topic or call the service.

## References
- https://docs.python.org/3/library/subprocess.html#security-considerations
- CWE-78
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

PROGRAM = "Python runs text of {} here: whoever sends it runs any program on the robot"
COMMAND = "The shell command holds text of {}: whoever sends it runs commands on the robot"
ADVICE = "pass a list of arguments without shell=True, or accept only known values"


@rule("warning", silent="the shell runs what it is given", tags=["CWE-78"])
def shell_from_message(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for file, node in robot.nodes.node_classes:
        for found in nodes.shell_commands(robot.nodes, robot.nodes.syntax(file), node):
            if found.call in seen:
                continue
            seen.add(found.call)
            yield finding(
                file.span_of(found.call),
                PROGRAM.format(found.what) if found.is_program else COMMAND.format(found.what),
                advice="call what known names mean" if found.is_program else ADVICE,
                related=[note(found.callback.span, f"the callback of a {found.callback.role}")],
                severity=robot.nodes.lowered(file.source, "warning"),
            )
    for driver in robot.nodes.drivers:
        for text in driver.shell_texts:
            yield finding(
                text.call,
                COMMAND.format(text.read.text),
                advice="use posix_spawn(), which takes a list of arguments, or accept only known values",
                related=[note(text.read, "taken as it comes")],
                severity=robot.nodes.lowered(driver.source, "warning"),
            )
