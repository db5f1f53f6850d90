"""Whether code looks at how old something is."""

from __future__ import annotations

import re
from collections import Counter

from bringup_lint.model.cpp_text import COMMENT
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_QUANTITY = (
    r"(?:\w{1,20}_)?(?:rpms?|vel|velocity|velocities|speeds?|err|errors?|servos?|pos|positions?|angles?|yaw|theta"
    r"|encoders?|ticks?|throttle|steering|linear|angular|[xyz])(?:_[a-z]|_left|_right)?"
    r"|(?:cmd|command|twist)\w{0,10}\.(?:linear|angular|twist|drive|data)"
)
"""What a difference to the last one of is no age: a slope of a speed, an error of a controller."""
_TIMED = regex(
    r"(?=[twdsehflnamc-])(?:time_?out|watch_?dog|\bwdog|dead_?man|stale|expir|elapsed|heart_?beat|fail_?safe|deadline"
    r"|\blease|since_?last|last_?\w{0,20}(?:time|stamp|recv|received|call)|(?:time|stamp)\w{0,20}last|no_?(?:cmd|command)|\bstamp\b|\bage\b"
    r"|\bnow\s{0,3}-(?!>)|(?:now|time|monotonic|clock)\(\)[\w.()]{0,40}\s{0,3}-"
    rf"|-\s{{0,3}}(?:self\.|this->)?(?:last|prev)(?!(?:ious)?_?(?:{_QUANTITY})(?![a-z])))",
    re.I,
)
"""What code that ends a motion by time has in it somewhere. The look at the first character keeps the search from
trying each way at each place."""
COMMENTS = regex(rf"#[^\n]*|{COMMENT.pattern}")
"""Of Python and C++, and what the preprocessor reads."""
_OTHER_TIMEOUTS = regex(
    r"\b(?:read_|write_|write|socket_)?timeout(?:_sec)?\s*=\s*[^,)\n]+"
    r"|SerialTimeout\w*|serial::Timeout|setTimeout|settimeout|TimeoutE\w+"
    r"|\bstamp\s*=(?!=)[^;\n]*|[\"']stamp[\"']\s*:"
)
"""Time-outs of reading and writing and stamps that are written, which end no motion."""


_SET = regex(
    r"(?m)^[ \t]{0,60}(?:(?:self\.|this->)?(?P<set>[A-Za-z_]\w{0,60})[ \t]{0,4}[-+]?=[ \t]{0,4}"
    r"(?:None|0|0\.0|1|[\w.()>-]{0,60}\b(?:now|time|monotonic|perf_counter)\(\)[\w.()]{0,60})[ \t]{0,4};?[ \t]{0,4}$"
    r"|rclcpp::Time[ \t]{1,4}(?P<declared>\w{1,60})[ \t]{0,4};)"
)
"""A line that sets a name to a time or a number, or declares a time."""
_WORD = regex(r"[A-Za-z_]\w*")


def looks_at_time(source: Source) -> bool:
    """Whether a file compares times, or speaks of a time-out that is not one of reading or writing."""
    return source.once(looks_at_time, lambda: looks_at_age(source.text))


def looks_at_age(text: str) -> bool:
    """As ``looks_at_time``, for a text."""
    return bool(_TIMED.search(_OTHER_TIMEOUTS.sub("", _without_unread(COMMENTS.sub("", text)))))


def _without_unread(text: str) -> str:
    """A text without the lines that set a time which nothing reads: ``self.last_cmd_time = now``."""
    lines = Counter(name for match in _SET.finditer(text) if (name := _name(match)) and _TIMED.search(name))
    if not lines:
        return text
    words = Counter(match[0] for match in _WORD.finditer(text))
    unread = {name for name, number in lines.items() if words[name] == number}
    return _SET.sub(lambda match: "" if _name(match) in unread else match[0], text)


def _name(match: re.Match[str]) -> str:
    return match["set"] or match["declared"]
