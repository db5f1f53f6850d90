"""The entry point: answers ``--version`` at once, and what the cache knows; loads the command line for everything
else."""

from __future__ import annotations

import gc
import sys

_HOME = __file__.rpartition("/bringup_lint/")[0]
YOUNG_OBJECTS = 200_000
"""How many objects more than before start the search for garbage."""


def main() -> None:
    if sys.argv[1:] == ["--version"]:
        from bringup_lint import __version__

        print(f"bringup-lint {__version__}")
        return
    from bringup_lint.cli.answering import asked
    from bringup_lint.cli.answering import replayed

    question = asked(sys.argv[1:])
    answer = question and question.answer()
    if answer:
        sys.exit(replayed(answer))
    from bringup_lint.cli import dispatch

    _collect_seldom()
    dispatch(sys.argv[1:], question=question)


def _collect_seldom() -> None:
    """Nearly all objects of a run live until its end, so that the search for garbage, which Python starts every 700
    objects, finds none and takes a fifth of the time in a big repository."""
    gc.freeze()
    gc.set_threshold(YOUNG_OBJECTS, 20, 100)


if __name__ == "__main__":
    if not (sys.flags.isolated or getattr(sys.flags, "safe_path", False)) and sys.path[0] != _HOME:
        del sys.path[0]  # the folder that python -m puts there: a json.py of the tree would be imported
    main()
