"""The command line as a question to the cache: what it is made of, and whether its answer may be kept.

Nothing heavy is imported here: an answer that is found is written before click or a rule is loaded.
"""

from __future__ import annotations

import os
import sys

from bringup_lint.cache.answers import Answer
from bringup_lint.cache.answers import Question
from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import put
from bringup_lint.cli.streams import repeat
from bringup_lint.cli.streams import said
from bringup_lint.cli.streams import written
from bringup_lint.cli.terminal import is_terminal
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.cli.terminal import wants_colour

TYPE_CHECKING = False  # an answer is given before typing is loaded
if TYPE_CHECKING:
    from bringup_lint.cli.reports import Output
    from bringup_lint.discover.record import Record

OFF = "BRINGUP_LINT_NO_CACHE"
"""The variable that switches the cache off, whatever it holds."""
VARIABLES = ("GIT_INDEX_FILE",)
"""The variables that decide over an answer, besides those of the terminal."""
_REPEATABLE = frozenset(
    "paths root output_format select ignore min_severity fail_on exit_zero target_ros target_systemd now no_ignores"
    " config_path isolated exclude tracked changed baseline colour cache_by quiet statistics".split()
)
"""The options whose answer is on standard output, and depends on nothing but files. Any other keeps an answer from
being kept: what changes files, reads standard input or git's objects, or runs the user's own rules."""
_TIMELESS = frozenset({"text", "concise", "json", "github", "gitlab", "markdown", "rdjson"})
"""The formats that say nothing of the time of the run."""


def asked(arguments: list[str]) -> Question | None:
    """The question that a command line asks; None where the cache is off, or nothing can be kept."""
    if "--no-cache" in arguments or os.environ.get(OFF) or sys.stdout is None:
        return None
    encoding = (sys.stdout.encoding or "").lower().replace("-", "")
    try:
        here = os.getcwd()
    except OSError:
        return None
    if encoding != "utf8" or not hasattr(os, "getgroups"):
        return None
    user = (os.getuid(), os.getgid(), sorted(os.getgroups()))
    shown = (terminal_width(), wants_colour(None), is_terminal())
    words = (here, repr(user), repr(shown), *(os.environ.get(name, "") for name in VARIABLES), "--", *arguments)
    return Question(words, by_content=_by_content(arguments))


def _by_content(arguments: list[str]) -> bool:
    words = " ".join(arguments).replace("=", " ")
    return "--cache-by content" in words


def replayed(answer: Answer) -> int:
    """Say again what an earlier run said; returns the exit code."""
    repeat(answer.said)
    try:
        put(answer.text)
    except Exception as error:
        complain(f"not written: {error}")
        return 2
    return answer.code


def keep(question: Question, given: set[str], outputs: list[Output], record: Record, code: int) -> None:
    """Keep what this run said, if the same question will have the same answer. ``given`` are the options of the
    command line."""
    if code in (0, 1) and given <= _REPEATABLE and _is_plain(outputs):
        question.keep(Answer("".join(written), "".join(said), code), record)


def _is_plain(outputs: list[Output]) -> bool:
    return len(outputs) == 1 and outputs[0].file is None and outputs[0].format in _TIMELESS
