"""A virtual camera gets another number than the one that is written to.

## What it finds
`modprobe v4l2loopback` without `video_nr=`, in a script or a unit, while a script or unit of the tree writes to a
device with a fixed number: `v4l2sink device=/dev/video6` of GStreamer, or `-f v4l2 /dev/video6` of ffmpeg. Silent if
anything of the tree gives `video_nr=` or makes the device with `v4l2loopback-ctl`.

## Why it matters on a robot
The module takes the first number that is free. With one camera more or less, or with a camera that is found later at
boot, that is another one: the pipeline ends, or writes to a camera that cannot be written to, and no image arrives.

## Bad
```sh
modprobe v4l2loopback
gst-launch-1.0 udpsrc port=5600 ! h264parse ! avdec_h264 ! v4l2sink device=/dev/video6
```

## Good
```sh
modprobe v4l2loopback video_nr=6 card_label=front
gst-launch-1.0 udpsrc port=5600 ! h264parse ! avdec_h264 ! v4l2sink device=/dev/video6
```

## When to ignore it
When a file in /etc/modprobe.d that is not in the tree gives the module its options.

## References
- https://github.com/v4l2loopback/v4l2loopback, "Options": video_nr
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

MODULE = regex(
    r"\bmodprobe[ \t]{1,8}(?:-[^-\s]\S{0,40}[ \t]{1,8}|--\S{1,40}[ \t]{1,8}){0,8}(?P<module>v4l2loopback)\b"
    r"(?![^\n;&|$`{]{0,400}[$`{])",
    hints="v4l2loopback",
)
"""Without a variable after it, which may give the number."""
REMOVES = regex(r"[ \t](?:-r|--remove)\b")
NUMBERED = regex(
    r"\bvideo_nr\b|\bv4l2loopback-ctl\b|\bv4l2loopback[ \t][^\n]{0,80}\bdevices=", hints="video_nr v4l2loopback"
)
SINK = regex(
    r"(?:\bv4l2sink\b[^!\n]{0,100}?\bdevice=|(?<=[ \t])-f[ \t]+v4l2[ \t](?:(?!-i[ \t])[^\n|;&]){0,100}?)"
    r"['\"]?(?P<device>/dev/video\d+)\b",
    hints="/dev/video",
)
"""What writes to a video device; ffmpeg reads from one that ``-i`` names."""
KINDS = ("shell-script", "systemd-unit", "systemd-dropin")


@rule("warning", symptoms=["is not a output device", "Cannot identify device '/dev/video"])
def virtual_camera_number(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(MODULE) or robot.mentions(NUMBERED):
        return
    sources = [source for source in robot.of_kind(*KINDS) if source.judged]
    devices = [device for source in sources for device in _sinks(source)]
    module = next((module for source in sources for module in _loaded(source)), None)
    if module is None or not devices:
        return
    device = next((each for each in devices if each.span.source is module.span.source), devices[0])
    yield finding(
        module,
        f"The virtual camera gets the first free number, which is {device} only by chance",
        advice=f"add video_nr={device.removeprefix('/dev/video')}",
        related=[note(device, "this device is written to")],
    )


def _loaded(source: Source) -> Iterator[Located]:
    for match in MODULE.finditer(source.said):
        if not REMOVES.search(match[0]) and not _is_comment(source, match.start()):
            yield source.located(*match.span("module"))


def _sinks(source: Source) -> Iterator[Located]:
    for match in SINK.finditer(source.said):
        if not _is_comment(source, match.start()):
            yield source.located(*match.span("device"))


def _is_comment(source: Source, offset: int) -> bool:
    return "#" in source.line_before(offset) or source.line_before(offset).lstrip().startswith("echo ")
