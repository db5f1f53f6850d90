"""A callback spins the node that an executor spins already.

## What it finds
In C++, `rclcpp::spin`, `spin_some`, `spin_all` and `spin_until_future_complete` of the node itself
(`shared_from_this()`, `get_node_base_interface()`) in a callback, or a method that it calls. In Python,
`rclpy.spin_once(self)` and `rclpy.spin_until_future_complete(self, ...)` there, when the programs that make the node
add it to an executor of their own (`MultiThreadedExecutor`).

## Why it matters on a robot
A callback only runs while an executor has the node. rclcpp refuses to add it to a second one: `std::runtime_error`
leaves the callback, and the process aborts. rclpy moves the node to the global executor and takes it out of that at the
end: the program goes on without an error, and no timer, subscription or service of the node is ever served again.

## Bad
```cpp
void on_request(const Request::SharedPtr, Response::SharedPtr)
{
  auto future = client_->async_send_request(request);
  rclcpp::spin_until_future_complete(shared_from_this(), future);
}
```

## Good
```cpp
client_->async_send_request(request, [this](Client::SharedFuture answer) { finish(answer.get()); });
```

## When to ignore it
When only a thread of its own runs the function.

## References
- rclcpp, executor_entities_collector.cpp, add_node: "has already been added to an executor"
- rclpy, node.py, the setter of `executor`; tried with rclpy of Jazzy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", symptoms=["Node '*' has already been added to an executor."])
def spin_in_callback(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        for spin in node.nested_spins:
            end = "what follows in its try block never runs" if spin.is_caught else "the process aborts"
            yield finding(
                spin.span,
                f"{spin.call}() in {spin.callback} throws, as the executor that runs it has the node: {end}",
                advice="give the client a callback for its answer, and let the executor that runs do its work",
                severity=robot.nodes.lowered(node.source, "error"),
            )
    for taken in nodes.nested_spins(robot.nodes):
        yield finding(
            taken.file.span_of(taken.call),
            f"{taken.name}(self) in {taken.callback} takes the node from its executor: no callback of it runs any more",
            advice="use call_async() with add_done_callback(), or await the future",
            severity=robot.nodes.lowered(taken.file.source, "error"),
        )
