"""A C++ node waits for the answer of a server without a timeout, and never looks whether there is one.

## What it finds
`get()` or `wait()` of what `async_send_request` or `async_send_goal` returns, in a function that bounds the wait in no
other way, in a source that makes the client and asks nowhere whether its server is there: neither `wait_for_service()`
nor `service_is_ready()`. Once a source, with the other places.

## Why it matters on a robot
A request that is sent while no server is there is lost, and its future never gets a value. The function waits from
then on, also when the server comes later: the callback that asked to disarm, to stop or to change the mode never
answers, and the thread is gone until somebody restarts the node.

## Bad
```cpp
auto answer = arming_client_->async_send_request(request);
answer.wait();
```

## Good
```cpp
if (!arming_client_->wait_for_service(1s)) { return false; }
auto answer = arming_client_->async_send_request(request);
if (answer.wait_for(2s) != std::future_status::ready) { return false; }
```

## When to ignore it
When something outside the source starts it only once the server is there, and again whenever that ends.

## References
- rclcpp, client.hpp: `async_send_request` returns a future without a timeout
- https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

_SERVICES = "async_send_request"


@rule("warning", silent="the thread waits for a condition variable, and rclcpp logs nothing", tags=["CWE-833"])
def answer_awaited_forever(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.endless_answers(robot.nodes):
        looks = "wait_for_service" if first.call == _SERVICES else "wait_for_action_server"
        yield finding(
            first.waiting,
            f"While the server of {first.client} is not running, the request is lost and this waits forever",
            advice=f"call {looks}() with a timeout before, and wait_for() with one instead",
            related=[note(first.asked, "asked here"), *(note(each.waiting, "the same here") for each in others)],
            severity=robot.nodes.lowered_if_vendored(first.waiting.source, "warning"),
        )
