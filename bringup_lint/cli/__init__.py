"""The command line: ``bringup-lint [OPTIONS] [PATH]...`` checks; a first word that names a command runs that
command."""

from __future__ import annotations

import importlib
import os
import sys

COMMANDS = {
    "check": "Check files and folders (the default).",
    "explain": "Print a rule's documentation, or find the rules behind a log line.",
    "rules": "List the rules.",
    "graph": "Draw what starts what, in which order and with what.",
    "live": "Compare the running ROS graph with the files.",
    "init": "Write a configuration file to start from.",
    "new-rule": "Write the files of a new rule, in a checkout.",
}


def dispatch(arguments: list[str], prog: str = "bringup-lint") -> None:
    """Run the command that the arguments name; exits with the command's code."""
    name = "check"
    if arguments and arguments[0] in COMMANDS:
        name, *arguments = arguments
        if name != "check":
            prog = f"{prog} {name}"
    elif arguments and not arguments[0].startswith("-") and not os.path.lexists(arguments[0]):
        _hint(arguments[0])
    module = importlib.import_module(f"bringup_lint.cli.{name.replace('-', '_')}")
    module.command.main(arguments, prog_name=prog)


def _hint(word: str) -> None:
    """A word that is neither a command nor a path may be a misspelt command."""
    from bringup_lint.spelling import meant

    if command := meant(word, COMMANDS):
        print(f"bringup-lint: there is no '{word}' here; did you mean the command '{command}'?", file=sys.stderr)
