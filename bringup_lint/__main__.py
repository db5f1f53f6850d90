"""The entry point: answers ``--version`` at once, and what the cache knows; loads the command line for everything
else."""

from __future__ import annotations

import atexit
import gc
import os
import sys

_HOME = __file__.rpartition("/bringup_lint/")[0]


def program() -> None:
    """``main`` in a process of its own, which ends without taking apart the objects of the run one by one: that would
    take a tenth of the time."""
    code: str | int | None = 0
    gc.disable()  # until the modules are there, of which nothing is garbage
    try:
        main()
    except SystemExit as ended:
        code = ended.code or 0
    except KeyboardInterrupt:
        code = 130
    if isinstance(code, int) and _is_done():
        os._exit(code)
    sys.exit(code)


def main() -> None:
    if sys.argv[1:] == ["--version"]:
        from bringup_lint import __version__

        try:
            print(f"bringup-lint {__version__}", flush=True)
        except OSError as error:
            from bringup_lint.cli.streams import lost

            sys.exit(lost(error))
        return
    from bringup_lint.cli.answering import asked
    from bringup_lint.cli.answering import replayed

    question = asked(sys.argv[1:])
    answer = question and question.answer()
    if answer:
        sys.exit(replayed(answer))
    from bringup_lint.importing import import_directly

    import_directly()
    from bringup_lint.cli import dispatch

    _settle()
    dispatch(sys.argv[1:], question=question)


def _is_done() -> bool:
    """Whether nothing is left to do: all is written, no thread runs, and no library wants to say goodbye."""
    threading = sys.modules.get("threading")
    callbacks = getattr(atexit, "_ncallbacks", None)
    if callbacks is None or callbacks() or (threading and threading.active_count() > 1):
        return False
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, ValueError, AttributeError):
        return False
    return True


def _settle() -> None:
    """What is loaded by now stays until the end."""
    from bringup_lint.garbage import collect_seldom

    gc.freeze()
    collect_seldom()
    gc.enable()


if __name__ == "__main__":
    if not (sys.flags.isolated or getattr(sys.flags, "safe_path", False)) and sys.path[0] != _HOME:
        del sys.path[0]  # the folder that python -m puts there: a json.py of the tree would be imported
    program()
