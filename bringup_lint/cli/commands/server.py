"""``bringup-lint server``: speak the language server protocol with an editor."""

from __future__ import annotations

import sys
import threading
from typing import TYPE_CHECKING

import click

from bringup_lint.cli.reporting import known_to
from bringup_lint.cli.streams import complain
from bringup_lint.extras import installed_by

if TYPE_CHECKING:
    from bringup_lint.server.worker import Worker


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--stdio", is_flag=True, help="Talk over standard input and output (always so).")
def command(stdio: bool) -> int:
    """Speak the language server protocol with an editor, over standard input and output.

    Needs pygls, which the extra lsp brings.
    """
    try:
        import pygls  # noqa: F401
    except ImportError:
        complain(f"the language server needs pygls: {installed_by('lsp')}")
        return 2
    if sys.stdin is None:
        complain("the language server talks over standard input, which is closed")
        return 2
    from bringup_lint.server.worker import Worker

    worker = Worker()
    threading.Thread(target=_talk, args=(worker,), daemon=True).start()
    worker.run()
    return 0


def _talk(worker: Worker) -> None:
    from bringup_lint.registry import Registry
    from bringup_lint.server.connection import serve
    from bringup_lint.server.connection import standard_streams

    try:
        serve(worker, Registry.of(), known_to, *standard_streams())
    finally:
        worker.stop()
