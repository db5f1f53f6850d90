"""Topics that a launch file records, and that differ from published ones only in how their words are put together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.apart import End
from bringup_lint.graph.topics.questions.apart import ends_of
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.source import Located

_RECORD = ("ros2", "bag", "record")


class Recorded(NamedTuple):
    topic: Located
    """As the command asks for it."""
    publisher: End


def misspelt_records(topics: Topics) -> Iterator[Recorded]:
    """Topics in ``ros2 bag record`` that nobody publishes or takes, each with the one publisher of its letters."""
    asked = {word.span: word for word in _asked(topics)}
    if not asked:
        return
    ends = list(ends_of(topics, everything=True))
    used = {each.topic for each in ends}
    published: dict[str, dict[str, End]] = {}
    for each in ends:
        if each.role == "publisher":
            published.setdefault(_letters(each.topic), {}).setdefault(each.topic, each)
    for word in asked.values():
        meant = published.get(_letters(word), {})
        if word not in used and len(meant) == 1:
            yield Recorded(word, next(iter(meant.values())))


def _asked(topics: Topics) -> Iterator[Located]:
    for started in topics.launch.nodes:
        words = [literal_text(each) for each in started.arguments]
        if tuple(words[:3]) == _RECORD and started.file.source.judged:
            yield from (word for word in words[3:] if word is not None and word.startswith("/"))


def _letters(topic: str) -> str:
    return topic.replace("/", "").replace("_", "").lower()
