"""A node is spun only after a server that runs until the program ends.

## What it finds
In Python: `rclpy.spin()` in the statements after `app.run()` of Flask, `uvicorn.run()`, `serve_forever()` of the
standard library's servers, or `mainloop()` of tkinter, in a program that starts no thread.

## Why it matters on a robot
The server returns when it is stopped. Until then nothing spins the node: no subscription, timer or service of it runs.
The page or window comes up and shows its first values for good, and buttons publish, so that the program looks alive.

## Bad
```python
app.run(host='0.0.0.0')
rclpy.spin(node)
```

## Good
```python
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
app.run(host='0.0.0.0')
```

## When to ignore it
When the server is one of your own that returns at once.

## References
- https://flask.palletsprojects.com/en/stable/api/, `Flask.run`
- rclpy, `spin`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="callbacks that never run give no message")
def spin_unreached(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.judged:
        for each in nodes.late_spins(robot.nodes.syntax(file)):
            yield finding(
                file.span_of(each.spin),
                "This spin starts when the server above it ends: until then no callback of the node runs",
                advice="spin in a thread that is started before",
                related=[note(file.span_of(each.server), "runs until it is stopped")],
                severity=robot.nodes.lowered(file.source, "error"),
            )
