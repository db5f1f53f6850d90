"""Shell syntax in an Exec line that no shell interprets.

## What it finds
Unquoted words such as &&, ||, |, >, 2>&1, < or &, and command substitution with $(...) or backquotes, in a
command line whose program is not a shell with -c. Programs that pass their arguments to a shell, such as ssh
and watch, are exempt. `rm -f x || true` is an info, as is docker's: it ignores the names that are not there.

A `~/` at the beginning of an argument is found where the program certainly takes it as the name of a file: the script
of `bash`, `sh` or `python3`, and what `mkdir`, `cp`, `cat` and others of coreutils get.

## Why it matters on a robot
systemd passes these words to the program as arguments. The second command never runs, the log file is never
written, and systemd-analyze verify does not report it.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers > /var/log/robot.log 2>&1
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
StandardOutput=append:/var/log/robot.log
```

## When to ignore it
When the program interprets the word itself, for example a wrapper of yours that passes its arguments to a
shell.

## References
- systemd.service(5), "Command lines": redirection, pipes and background jobs are not supported
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Command

_OPERATOR = regex(r"&&|\|\|?|&|[0-9]?>{1,2}(?:&[0-9]|[\w./-]+)?|&>{1,2}[\w./-]*|<<?[\w./-]*")
_SUBSTITUTION = regex(r"\$\([^)]|`")
_SHELLS = ("sh", "bash", "dash", "zsh", "ksh")
_INTERPRETER = regex(r"(?:ba|da|z|k)?sh|python[0-9.]*|perl|node")
_OF_FILES = ("mkdir", "cp", "mv", "rm", "chmod", "chown", "touch", "cat", "ln", "install")
_HANDS_ON = (
    "ssh",
    "autossh",
    "sshpass",
    "watch",
    "parallel",
    "tmux",
    "screen",
    "expr",
    "test",
    "[",
    "awk",
    "jq",
    "xterm",
)


@rule("error", fix="unsafe", symptoms=["unrecognized arguments: &&", "unrecognized arguments: |"])
def exec_shell_syntax(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        for command in line.commands:
            names = [word.rpartition("/")[2] for word in command.argv]
            if names[0] in _HANDS_ON or _has_shell(names):
                continue
            yield from _tilde(line.key, names[0], command)
            for word in command.arguments:
                plain = word.span.text == word
                if (plain and _OPERATOR.fullmatch(word)) or _SUBSTITUTION.search(word):
                    yield finding(
                        word,
                        f"No shell interprets {line.key}=: {names[0]} gets '{_shortened(word)}' as an argument",
                        advice="wrap the command in /bin/bash -c '...', or use StandardOutput= and more Exec lines",
                        fix=_wrapped(command),
                        severity="info" if _is_harmless(command) else None,
                    )
                    break


def _tilde(key: str, program: str, command: Command) -> Iterator[Finding]:
    """The first name of a file with a tilde that nothing expands."""
    words = [word for word in command.arguments if not word.startswith("-")]
    files = words[:1] if _INTERPRETER.fullmatch(program) else words if program in _OF_FILES else []
    word = next((each for each in files if each.startswith("~/")), None)
    if word is not None:
        yield finding(
            word,
            f"No shell expands the tilde in {key}=: {program} looks for a folder that is called '~'",
            advice="write the home in full",
        )


def _has_shell(names: list[str]) -> bool:
    """Whether a shell reads one of the arguments, as in ``env bash -c ...`` or ``sudo -u robot sh -c ...``."""
    shells = [at for at, name in enumerate(names) if name in _SHELLS]
    return any(name.startswith("-") and "c" in name for at in shells[:1] for name in names[at + 1 :])


def _is_harmless(command: Command) -> bool:
    """Whether the words only name more files or containers, which ``rm -f`` does not miss."""
    words = [word.rpartition("/")[2] for word in command.argv]
    return words[-2:] == ["||", "true"] and "-f" in words and "rm" in words[:2]


def _shortened(word: Located) -> str:
    return word if len(word) <= 30 else f"{word[:27]}..."


def _wrapped(command: Command) -> Fix | None:
    text = command.where.span.text
    if command.prefixes or {"'", "\\", "\n"} & set(text):
        return None
    return fix("run it in a shell", (command.where, f"/bin/bash -c '{text}'"), safe=False)
