"""The options of ``docker run`` and its likes, each with its value."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_SWITCHES = regex(
    r"-[dtiPq]+|--(?:detach|tty|interactive|privileged|init|publish-all|read-only|rm|replace|quiet|tls-verify)"
)
"""Options without a value. Source: docker-run(1), podman-run(1)."""


class Option(NamedTuple):
    name: str
    """Without its value: ``--name``, ``-itd``, ``-v``, or the variable that may hold an option."""
    words: tuple[Located, ...]
    value: Located | None


def run_options(words: Sequence[Located]) -> Iterator[Option]:
    """The options after the verb and before the image."""
    at = 0
    while at < len(words) and words[at].startswith(("-", "$")):
        word = words[at]
        name, equals, _ = word.partition("=")
        if equals:
            yield Option(name, (word,), word.part(len(name) + 1, len(word)))
        elif _SWITCHES.fullmatch(word) or word.startswith("$") or (not word.startswith("--") and len(word) > 2):
            yield Option(str(word), (word,), None)
        elif at + 1 < len(words):
            yield Option(name, (word, words[at + 1]), words[at + 1])
            at += 1
        at += 1
