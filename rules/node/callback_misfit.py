"""A callback does not fit its caller.

## What it finds
In Python nodes:

- `create_timer(0.5, self.blink())`: the method is called at once, and rclpy gets None in its place
- methods that take another number of arguments than their caller hands over: a subscription one, the message (or two,
  with its MessageInfo), a service two
- callbacks of services that return nothing, and callbacks of `add_on_set_parameters_callback` that return nothing
- actions whose execution ends the goal neither with `succeed()` nor with `abort()` or `canceled()`, or only with the
  last one, in branches that leave the function

It is an info in packages that others wrote and the tree only carries.

## Why it matters on a robot
Python looks at all this when the callback runs: with the first message, the first call, the first `ros2 param set`. The
exception leaves `spin()` and the node ends. From Iron on, rclpy compares the callback of a subscription with a message
when it is created, and the node does not start. The client of a service waits forever for a response. A callback for
parameters that returns nothing makes rclpy refuse every change; until the releases of spring 2025 it raised
AttributeError. A goal that nobody ends counts as aborted, although the arm has reached it, and what waits for it starts
its recovery.

## Bad
```python
self.create_service(Trigger, "home", self.on_home)

def on_home(self, request, response):
    response.success = self.home()
```

## Good
```python
self.create_service(Trigger, "home", self.on_home)

def on_home(self, request, response):
    response.success = self.home()
    return response
```

## When to ignore it
When something replaces the method at run time.

## References
- rclpy, service.py (`send_response`), subscription.py (`callback`), node.py (`_set_parameters_atomically`) and
  action/server.py (`_execute_goal`)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "Goal state not set, assuming aborted",
        "TypeError: '*' takes * positional arguments but * were given",
        "AttributeError: 'NoneType' object has no attribute 'successful'",
        "callback should be either be callable with one argument",
        "Callback returned an invalid type",
    ],
)
def callback_misfit(robot: Robot) -> Iterator[Finding]:
    for unfit in nodes.unfit_callbacks(robot.nodes):
        severity = "warning" if unfit.what in ("goal", "reached") else "error"
        yield finding(
            unfit.place,
            _message(unfit, _end(robot, unfit)),
            advice=_advice(unfit),
            related=[] if unfit.place == unfit.callback.span else [note(unfit.callback.span, "it is handed over here")],
            severity=robot.nodes.lowered_if_vendored(unfit.file.source, severity),
        )


def _end(robot: Robot, unfit: nodes.UnfitCallback) -> str:
    """What ends, in words; empty where several threads run callbacks."""
    if robot.nodes.threads(unfit.node) == "several":
        return ""
    return ", and " + nodes.end_of_callbacks(robot.nodes.syntax(unfit.file))


def _message(unfit: nodes.UnfitCallback, exits: str) -> str:
    match unfit.what:
        case "called":
            return f"{unfit.name}() runs here once and gives None: {_of_none(unfit.callback.role)}"
        case "arguments" if unfit.callback.role == "timer":
            return f"TypeError when the timer fires: {unfit.name}() needs an argument, and gets none{exits}"
        case "arguments" if unfit.callback.role == "subscription":
            return f"{unfit.name}() does not take {unfit.detail} of the subscription: rclpy raises an exception{exits}"
        case "arguments":
            return f"{unfit.name}() does not take {unfit.detail} of the {unfit.callback.role}: TypeError{exits}"
        case "answer" if unfit.callback.role == "parameters":
            return f"{unfit.name}() returns nothing: no parameter can be set, and with an older rclpy the node exits"
        case "answer":
            return f"{unfit.name}() does not return {unfit.detail}: TypeError, the client gets no answer{exits}"
        case "reached":
            return f"{unfit.name}() ends only goals that are canceled: those that it reaches count as aborted"
    return f"{unfit.name}() ends no goal: each one counts as aborted, also those that were reached"


def _of_none(role: str) -> str:
    if role == "timer":
        return "TypeError when the timer fires, and the node exits"
    return "the node exits" if role == "subscription" else "TypeError with the first request"


def _advice(unfit: nodes.UnfitCallback) -> str:
    match unfit.what:
        case "called":
            return f"hand over self.{unfit.name}, without parentheses"
        case "arguments":
            return "change its parameters" if unfit.callback.role != "timer" else "take no argument but self"
        case "answer":
            return f"return {unfit.detail}"
    return "call succeed() of the goal handle before the result is returned"
