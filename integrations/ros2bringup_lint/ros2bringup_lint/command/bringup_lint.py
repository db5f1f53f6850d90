"""`ros2 bringup-lint`."""

from __future__ import annotations

import argparse
import subprocess
import sys

from ros2cli.command import CommandExtension

BRINGUP_LINT = (
    sys.executable,
    "-c",
    "import sys; sys.path = [path for path in sys.path if path]; from bringup_lint.__main__ import main; main()",
)
"""The command; ``python -m`` would look for modules in the folder that is checked."""


class BringupLintCommand(CommandExtension):
    """Check how the robot comes up, with bringup-lint."""

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        """Leave all that follows the name to bringup-lint, --help too: no argument begins with an option's sign."""
        parser.prefix_chars = "\0"
        parser.add_argument("arguments", nargs=argparse.REMAINDER, help="arguments of bringup-lint")

    def main(self, *, parser: argparse.ArgumentParser, args: argparse.Namespace) -> int:
        return subprocess.run([*BRINGUP_LINT, *args.arguments], check=False).returncode
