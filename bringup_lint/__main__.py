"""The entry point: answers ``--version`` at once, and loads the command line for everything else."""

from __future__ import annotations

import sys


def main() -> None:
    if sys.argv[1:] == ["--version"]:
        from bringup_lint import __version__

        print(f"bringup-lint {__version__}")
        return
    from bringup_lint.cli import dispatch

    dispatch(sys.argv[1:])


if __name__ == "__main__":
    main()
