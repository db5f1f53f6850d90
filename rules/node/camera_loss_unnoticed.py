"""A node goes on without pictures when its camera is unplugged, and never opens it again.

## What it finds
In the callback of a timer or in a `while` loop of a Python node, a `read()` of `cv2.VideoCapture` after whose failure
the code only returns, continues, waits or logs, where nothing opens the camera again: it is opened in the constructor
or before the loop alone. In C++ the same of `read(frame)` and `camera >> frame` of `cv::VideoCapture`, in files where
only the start throws or ends the process. Video files are left out.

## Why it matters on a robot
When the USB camera is unplugged, or resets for a moment, `read()` returns False at once, each time. OpenCV does not
open the device again. No picture comes until somebody restarts the node, which stays alive: launch and systemd see
nothing to restart, and what follows the camera goes on without it.

## Bad
```python
def on_timer(self):
    ok, frame = self.camera.read()
    if not ok:
        return
```

## Good
```python
def on_timer(self):
    ok, frame = self.camera.read()
    if not ok:
        raise RuntimeError('the camera is gone')  # launch starts the node again: respawn=True
```

## When to ignore it
When another node notices that no picture comes, and restarts this one.

## References
- https://docs.opencv.org/4.x/d8/dfe/classcv_1_1VideoCapture.html, `read`: "If no frames has been grabbed (camera has
  been disconnected, or there are no more frames in video file), the method returns false"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

ADVICE = "open the camera again, or end the node and let launch or systemd restart it"


@rule("warning", silent="OpenCV says nothing of a device that is gone", tags=["CWE-391"])
def camera_loss_unnoticed(robot: Robot) -> Iterator[Finding]:
    for found in nodes.lost_cameras(robot.nodes):
        only = "only logs it" if found.is_logged else "says nothing"
        yield finding(
            found.file.span_of(found.call),
            f"When the camera is unplugged, this fails at once each time, and {found.function}() {only}: "
            "no picture comes until somebody restarts the node",
            advice=ADVICE,
            related=[
                note(found.file.span_of(found.choice.test), "goes on without a picture"),
                note(found.file.span_of(found.opened), "is the only time that it is opened"),
            ],
            severity=robot.nodes.lowered_if_vendored(found.file.source, "warning"),
        )
    for driver in robot.nodes.drivers:
        for lost in driver.lost_cameras:
            only = "only logs it" if lost.is_logged else "says nothing"
            yield finding(
                lost.test,
                f"When the camera is unplugged, this goes on without a picture each time, and {only}: no picture comes "
                "until somebody restarts the node",
                advice=ADVICE,
                related=[
                    note(lost.read, "fails at once"),
                    note(lost.opened, "is the only time that it is opened"),
                ],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
