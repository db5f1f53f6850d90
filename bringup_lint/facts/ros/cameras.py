"""Words of programs that read a camera by OpenCV."""

from __future__ import annotations

from bringup_lint.pattern import regex

VIDEO_FILE = regex(r"(?i)\.(?:mp4|avi|mov|mkv|webm|mpe?g|bag)\b|video_?(?:file|path)|file_?(?:name|path)")
"""What is opened is a file, not a camera."""
LOOKED_AFTER = regex(
    r"(?i)last_?(?:frame|image|img|capture)|watch_?dog|stale|re_?(?:connect|open|init)|fail\w{0,10}_?count|diagnostic"
)
"""Names of what may notice that no picture comes any more."""
