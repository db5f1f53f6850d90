"""The values of ROS variables as rcl, rmw and rcutils read them (rcl ``domain_id.c``, ``localhost.c``,
``discovery_options.c``; rcutils ``logging.c``)."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

MAX_DOMAIN = 232
"""The last domain whose ports fit below 65536 (RTPS 9.6.2.3)."""
EPHEMERAL_DOMAINS = range(102, 215)
"""Domains whose ports lie in Linux's default ephemeral range, 32768 to 60999."""
DISCOVERY_RANGES = ("OFF", "LOCALHOST", "SUBNET", "SYSTEM_DEFAULT")
RMW_IMPLEMENTATIONS = (
    "rmw_fastrtps_cpp",
    "rmw_fastrtps_dynamic_cpp",
    "rmw_cyclonedds_cpp",
    "rmw_connextdds",
    "rmw_gurumdds_cpp",
    "rmw_zenoh_cpp",
)
LOGGING_SWITCHES = ("RCUTILS_LOGGING_USE_STDOUT", "RCUTILS_COLORIZED_OUTPUT", "RCUTILS_LOGGING_BUFFERED_STREAM")
FORMAT_TOKENS = (
    "severity",
    "name",
    "message",
    "time",
    "date_time_with_ms",
    "time_as_nanoseconds",
    "function_name",
    "file_name",
    "line_number",
    "short_file_name",
)
FORMAT_TOKENS_SINCE = {"short_file_name": "kilted"}
"""Tokens that older distributions print as they are (Jazzy does, with rcutils 6.7.4)."""

ULONG_MAX = 2**64 - 1
"""As a domain, it means the default."""

_STRTOUL = regex(
    r"[ \t\n\v\f\r]*(?P<sign>[+-]?)(?:0[xX](?P<hex>[0-9a-fA-F]+)|0(?P<octal>[0-7]*)|(?P<decimal>[1-9][0-9]*))"
)


class DomainId(NamedTuple):
    """What rcl makes of ``ROS_DOMAIN_ID``."""

    number: int | None
    """None: not an integral number, or beyond ``unsigned long``, so that every process exits."""
    plain: bool
    """Written as what it means: decimal digits without leading zero."""


def domain_id(text: str) -> DomainId:
    """rcl calls ``strtoul`` with base 0, and minds what is left over only when the number is 0."""
    if text == "":
        return DomainId(0, True)
    found = _STRTOUL.match(text)
    if found is None:
        return DomainId(None, False)
    number = int(found["hex"] or "0", 16) or int(found["octal"] or "0", 8) or int(found["decimal"] or "0")
    if number > ULONG_MAX or (number == 0 and found.end() < len(text)):
        return DomainId(None, False)
    if found["sign"] == "-" and number:
        number = ULONG_MAX + 1 - number
    number = 0 if number == ULONG_MAX else number
    return DomainId(number, text == str(number))


def highest_port(domain: int) -> int:
    """The unicast user port of the first participant of a domain, with the default port parameters."""
    return 7411 + 250 * domain
