"""The command line: ``bringup-lint [OPTIONS] [PATH]...`` checks; a first word that names a command runs that
command."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Callable
from collections.abc import Iterator

TYPE_CHECKING = False  # an answer is given before typing is loaded
if TYPE_CHECKING:
    from bringup_lint.cache.answers import Question

TRACEBACK = "BRINGUP_LINT_TRACEBACK"
"""The variable that asks for the traceback of what failed inside."""
COMMANDS = {
    "check": "Check files and folders (the default).",
    "explain": "Print a rule's documentation, or find the rules behind a log line.",
    "rules": "List the rules.",
    "graph": "Draw what starts what, in which order and with what.",
    "live": "Compare the running ROS graph with the files.",
    "fleet": "Judge many robots together.",
    "server": "Speak the language server protocol with an editor.",
    "init": "Write the configuration that the current folder needs.",
    "completion": "Print a completion script for a shell.",
    "new-rule": "Write the files of a new rule, in a checkout.",
}
COLOURS = {"always": ("--colour",), "never": ("--no-colour",), "auto": ()}
"""What other programs call the flags of colour: a word after ``--color``, or after ``--color=``."""
PLAIN = {"check": "checking", "rules": "listing", "explain": "explaining"}
"""The commands that need no click where no option is given, with their modules."""


def dispatch(arguments: list[str], prog: str = "bringup-lint", question: Question | None = None) -> None:
    """Run the command that the arguments name; exits with the command's code. The answer to the question may be
    kept."""
    arguments = _with_flags(arguments)
    name = "check"
    at = _first_word(arguments)
    if at is not None and arguments[at] in COMMANDS:
        name = arguments[at]
        arguments = arguments[:at] + arguments[at + 1 :]
        if name != "check":
            prog = f"{prog} {name}"
    elif at == 0 and not os.path.lexists(arguments[0]):
        _hint(arguments[0])
    if name in PLAIN and (arguments or name != "explain") and not any(word.startswith("-") for word in arguments):
        plain = importlib.import_module(f"bringup_lint.cli.{PLAIN[name]}").plain
        sys.exit(_code(lambda: plain(tuple(arguments), question)))
    module = importlib.import_module(f"bringup_lint.cli.commands.{name.replace('-', '_')}")
    sys.exit(_code(lambda: module.command.main(arguments, prog_name=prog, standalone_mode=False, obj=question)))


def _code(command: Callable[[], object]) -> int:
    """The exit code of a command; what escapes from it is one line on standard error."""
    from bringup_lint.cli.streams import complain
    from bringup_lint.cli.streams import is_of_stream
    from bringup_lint.cli.streams import lost
    from bringup_lint.cli.streams import prepare

    try:
        prepare()
        os.getcwd()
        done = command()
    except KeyboardInterrupt:
        return 130
    except FileNotFoundError as error:
        if error.filename is None:
            complain("the working folder does not exist")
            return 2
        return _bug(error)
    except OSError as error:
        return lost(error) if is_of_stream(error) else _bug(error)
    except Exception as error:
        return _of_usage(error) or (_of_click(error) if "click" in sys.modules else _bug(error))
    return done if isinstance(done, int) else 0


def _of_usage(error: Exception) -> int:
    """2 for what could not be written and for a rule of the user's that cannot be loaded, which a line says; 0 for any
    other error."""
    from bringup_lint.cli.streams import complain
    from bringup_lint.writing import NotWritten

    registry = sys.modules.get("bringup_lint.registry")
    if not isinstance(error, (NotWritten, *([registry.RuleError] if registry else []))):
        return 0
    complain(error)
    return 2


def _of_click(error: Exception) -> int:
    """The exit code for what click raises, which says what is wrong with the command line."""
    import click

    from bringup_lint.cli.streams import say

    if isinstance(error, click.Abort):
        return 130
    if not isinstance(error, click.ClickException):
        return _bug(error)
    usage = error.ctx.get_usage() + "\n\n" if isinstance(error, click.UsageError) and error.ctx else ""
    message = error.format_message().replace("\n\t", "\n  ")
    say(f"{usage}Error: {message}")
    return error.exit_code


def _bug(error: Exception) -> int:
    """What nothing isolates: one line, or the traceback when that is asked for."""
    from bringup_lint.cli.streams import complain

    if os.environ.get(TRACEBACK):
        raise error
    complain(f"internal error: {type(error).__name__}; {TRACEBACK}=1 shows where, please report it")
    return 3


def _with_flags(arguments: list[str]) -> list[str]:
    """The arguments, with a flag in place of ``--color never`` and ``--color=never``."""
    words: list[str] = []
    for at, word in enumerate(arguments):
        if word == "--":
            return words + arguments[at:]
        if word in COLOURS and words and words[-1] in ("--color", "--colour"):
            words[-1:] = COLOURS[word]
            continue
        option, _, value = word.partition("=")
        if option in ("--color", "--colour") and value in COLOURS:
            words += COLOURS[value]
        else:
            words.append(word)
    return words


def _first_word(arguments: list[str]) -> int | None:
    """Where the first argument is that is neither an option nor the value of one."""
    if not arguments or not arguments[0].startswith("-"):
        return 0 if arguments else None
    valued = {name for command in ("check", *filter(COMMANDS.__contains__, arguments)) for name in _valued(command)}
    is_value = False
    for at, word in enumerate(arguments):
        if word == "--":
            return None
        if not is_value and (not word.startswith("-") or word == "-"):
            return at
        is_value = not is_value and word in valued
    return None


def _valued(command: str) -> Iterator[str]:
    """The options of a command that take a value."""
    module = importlib.import_module(f"bringup_lint.cli.commands.{command.replace('-', '_')}")
    for param in module.command.params:
        if not getattr(param, "is_flag", True):
            yield from param.opts


def _hint(word: str) -> None:
    """A word that is neither a command nor a path may be a misspelt command."""
    from bringup_lint.spelling import meant

    if command := meant(word, COMMANDS):
        from bringup_lint.cli.streams import complain

        complain(f"there is no '{word}' here; did you mean the command '{command}'?")
