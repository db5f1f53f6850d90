"""Definitions of interfaces against rosidl_adapter: it refuses what our reader does, values aside."""

from __future__ import annotations

import contextlib
import io
import random
from collections.abc import Iterator

import pytest

from bringup_lint.parsers import interface_grammar
from bringup_lint.source import Source

rosidl = pytest.importorskip("rosidl_adapter.parser")

LINES = """\
float64 force
float64[] forces  # all of them
float64[3] joints
string<=10[<=3] names
std_msgs/Header header
Paw[4] paws
string TEXT = "a=b"
uint8 LEFT=0
  # indented
bool on true
time stamp
wstring wide
Header header_
int32 Wide=1
std_msgs/msg/Header three
float64 fieldOfView
uint8[0] none
float64
unknown word
Paw CONSTANT=1
string<=0 short
float64 a__b
""".splitlines()
CASES = 3_000


def _texts() -> Iterator[str]:
    chance = random.Random(0)
    for _ in range(CASES):
        text = "\n".join(chance.choices(LINES[:12], k=3) + chance.choices(LINES, k=1)) + "\n"
        at = chance.randrange(len(text))
        yield chance.choice((text, text[:at] + text[at] + text[at:], text[:at] + text[at + 1 :]))


def _is_refused(text: str) -> bool:
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            rosidl.parse_message_string("otter_msgs", "Otter", text)
    except Exception:
        return True
    return False


def test_refused() -> None:
    texts = [*_texts()]
    ours = [text for text in texts if interface_grammar.parse(Source("msg/Otter.msg", text)).problems]
    assert [text for text in ours if not _is_refused(text)] == []
    assert CASES / 10 < len(ours) < CASES
    assert sum(map(_is_refused, texts)) * 0.8 < len(ours)
