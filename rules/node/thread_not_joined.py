"""A node's thread is not ended at shutdown.

## What it finds
In C++ sources of nodes, a `std::thread` that is started, and that no source of its package joins, detaches or moves
elsewhere, or that only callbacks or transitions such as `on_cleanup()` join; also joins in transitions, and in
destructors of components, of a thread whose loop ends only with rclcpp. In Python, a thread of a node that is not a
daemon and whose `while True` nothing leaves, asks nobody whether it goes on, and calls nothing that raises after the
shutdown, such as `publish()`; one whose loop asks only between reads of a socket without a timeout; and one that spins
beside the window of a program which calls `rclpy.shutdown()` nowhere.

## Why it matters on a robot
The destructor of a thread that is still joinable calls `std::terminate`: each shutdown ends with SIGABRT and a core
dump, also after the thread's function has returned. What the node does after the thread in its destructor, such as
switching the motors off, does not run. systemd counts a failure, and restarts the node with `Restart=on-failure`.

Python waits for such a thread after `main()` has returned: Ctrl-C and `systemctl stop` seem to do nothing, until
SIGKILL comes.

## Bad
```cpp
Gripper() : Node("gripper") { reader_ = std::thread([this] { read_loop(); }); }
```

## Good
```cpp
~Gripper() override {
  running_ = false;
  if (reader_.joinable()) reader_.join();
}
```

## When to ignore it
When the object that holds the thread is never destroyed.

## References
- C++ standard, [thread.thread.destr]
- https://docs.python.org/3/library/threading.html (`daemon`)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["terminate called without an active exception"])
def thread_not_joined(robot: Robot) -> Iterator[Finding]:
    yield from _in_cpp(robot)
    for found in nodes.endless_threads(robot.nodes):
        message = (
            f"The thread of {found.function}() never ends: after SIGINT or SIGTERM the process hangs until SIGKILL"
        )
        advice, looks = "let its loop ask rclpy.ok()", "this loop has no end"
        if found.waits is not None:
            message = (
                f"The thread of {found.function}() waits in {found.waits.what} without a timeout: after SIGINT or "
                f"SIGTERM the process hangs {found.waits.how_long}"
            )
            advice, looks = "set a timeout for the socket", "asked only after something has arrived"
        yield finding(
            found.file.span_of(found.started),
            message,
            advice=f"make it a daemon (daemon=True), or {advice}",
            related=[note(found.file.span_of(found.loop.test), looks)],
            severity=robot.nodes.lowered(found.file.source, "warning"),
        )
    for each in nodes.window_spins(robot.nodes):
        yield finding(
            each.file.span_of(each.started),
            "This thread spins on when the window is closed: the process never ends",
            advice="call rclpy.shutdown() after the window, and join the thread",
            related=[note(each.file.span_of(each.window), "returns when the window is closed")],
            severity=robot.nodes.lowered(each.file.source, "warning"),
        )


def _in_cpp(robot: Robot) -> Iterator[Finding]:
    for source in robot.nodes.cpp:
        vendored = robot.launch.workspace.is_vendored(source.source)
        severity = "info" if vendored else robot.nodes.lowered(source.source, "warning")
        for thread in source.threads:
            late = nodes.late_join(robot.nodes, source, str(thread))
            if late is None and nodes.ends_thread(robot.nodes, source.source, str(thread)):
                continue
            by, when = "Nothing", "when it is destroyed, at each shutdown"
            if late is not None:
                by, when = f"Only {late.callback}", "at shutdown, once it was started"
            yield finding(
                thread,
                f"{by} joins the thread '{thread}': the program aborts {when}",
                advice=f"end its loop and call {thread}.join() in the destructor",
                related=[note(late.joins[0], "does not run at the shutdown")] if late is not None else [],
                severity=severity,
                confidence="medium",
            )
        for stuck in source.stuck_joins:
            yield finding(
                stuck.place,
                f"{stuck.function}() never returns: only the end of rclcpp ends the thread '{stuck.thread}'",
                advice="let the loop also ask a flag, and set it before join()",
                related=[note(stuck.loop, "nothing else ends this loop")],
                severity=severity,
            )
