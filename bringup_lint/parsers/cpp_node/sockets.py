"""Sockets of a C++ file that wait for a packet when they are read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.parsers.cpp_node.syntax import Call
    from bringup_lint.parsers.cpp_node.syntax import Code

OPENS = regex(
    r"\b(?P<kept>[A-Za-z]\w{0,80})\s{0,4}=\s{0,4}(?P<call>(?:::)?socket\s{0,4}\(\s{0,4}(?:PF|AF)_)", hints="socket"
)
WAITS_NOT = regex(
    r"O_NONBLOCK|SOCK_NONBLOCK|SO_RCVTIMEO|MSG_DONTWAIT|FIONBIO|FIONREAD|O_NDELAY|\b[ep]?poll\s{0,2}\((?!\s{0,4}\))|\be?p?select\s{0,2}\("
    r"|epoll_wait|std::j?thread|boost::thread|pthread_create|\basync\b|\btimeval\b"
)
KNOWN_CALLS = frozenset(
    (
        *("socket", "bind", "connect", "listen", "setsockopt", "ioctl", "close", "shutdown", "if", "while", "return"),
        *("read", "recv", "recvfrom", "recvmsg", "write", "send", "sendto", "sendmsg"),
    )
)
"""What may be called with a socket that keeps waiting for packets all the same."""
UNTIL_PACKET = "until a packet arrives"
_RECEIVES = {"read": 0, "recv": 4, "recvfrom": 4, "recvmsg": 3}
"""Function -> which of its arguments has flags; 0 without any."""


def waiting_sockets(code: Code) -> frozenset[str]:
    """The variables of sockets that the file opens, and that nothing lets return without a packet."""
    text = code.source.text
    opened = frozenset(found["kept"] for found in OPENS.finditer(text))
    if not opened or WAITS_NOT.search(text):
        return frozenset()
    handed = {code.text(each) for call in code.calls if call.name not in KNOWN_CALLS for each in call.arguments}
    return opened - handed


def receives(code: Code, call: Call, sockets: frozenset[str]) -> bool:
    flags = _RECEIVES.get(call.qualified.removeprefix("::"))
    if flags is None or not call.arguments or code.text(call.arguments[0]) not in sockets:
        return False
    return flags == 0 or [code.text(each) for each in call.arguments[flags - 1 : flags]] == ["0"]
