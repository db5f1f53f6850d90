"""A service callback in C++ answers `false`, which nobody reads.

## What it finds
`return false` in a callback of `create_service`, where neither the block of the `return` nor the function sets a field
of the response that could tell of the failure. It is an info where the callback sets nothing in the response at all.
Once a source, with the other callbacks.

## Why it matters on a robot
ROS 1 turned `false` into a failed call. rclcpp ignores what a callback returns: the client gets the response as it is
then, with zeros and empty texts, and takes it for the answer. A conversion that was not possible yet is the point
0, 0, and a plan that failed is an empty one.

## Bad
```cpp
bool convert(const std::shared_ptr<ToPoint::Request> request, std::shared_ptr<ToPoint::Response> response) {
  if (!is_ready_) { return false; }
```

## Good
```cpp
void convert(const std::shared_ptr<ToPoint::Request> request, std::shared_ptr<ToPoint::Response> response) {
  if (!is_ready_) { response->success = false; return; }
```

## When to ignore it
When an empty response says that it failed, and all clients know.

## References
- rclcpp, any_service_callback.hpp: the type of a callback gives nothing back
- https://wiki.ros.org/roscpp/Overview/Services: `false` means that the call has failed
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the client gets an empty answer as if all had gone well")
def service_answer_unread(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.unread_answers(robot.nodes):
        yield finding(
            first.place,
            f"rclcpp ignores what {first.callback}() returns: the client gets an empty response as the answer",
            advice="tell of the failure in a field of the response, such as success",
            related=[
                note(first.registered, "registered here"),
                *(note(each.place, f"{each.callback}() does the same") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning") if first.has_data else "info",
        )
