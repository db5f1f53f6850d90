"""A condition in brackets does not ask what it seems to ask.

## What it finds
In `[ ... ]`, `test` and, where it means the same, `[[ ... ]]`:

- a missing blank: `["$MODE" = sim ]`, `[ -z $MODE]`, `[ "$MODE"="sim" ]`;
- a word instead of a variable: `[ -n MODE ]`, `[ false ]`;
- `-n` with a variable without quotes;
- `<` or `>`, which redirect, and in `[[ ]]` compare a number as text;
- `-eq` and the like with a word in the place of a number;
- `=!`, `=<`, `=>` and `===`;
- `-o` with a word that is no option of the shell.

`while [ 1 ]`, `while [ 0 ]`, `[ true ]` and `[ : ]` are taken as meant. Silent for `test` where the script has
a function of this name.

## Why it matters on a robot
A condition that is always true deletes, overwrites or starts what it should only in one case. One that ends with an
error counts as false: the setting that it guards never has an effect. The script itself goes on.

## Bad
```sh
if [ -n $CAN_DEVICE ]; then ip link set "$CAN_DEVICE" up; fi
if ["$MODE" = sim ]; then exit 0; fi
```

## Good
```sh
if [ -n "$CAN_DEVICE" ]; then ip link set "$CAN_DEVICE" up; fi
if [ "$MODE" = sim ]; then exit 0; fi
```

## When to ignore it
Never.

## References
- POSIX, test(1)
- bash(1), "CONDITIONAL EXPRESSIONS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import every_command

GLUED = regex(r"\[{1,2}(?:[\"']?\$|!|-[a-zA-Z]\Z)[^\n]*")
VARIABLE = regex(r"\$(?:\w+|\{\w+(?:\[[^\]@*]{0,40}\])?\}|\([^\"]+\))")
COMPARED = regex(r"(?:\$\w+|\$\{\w+\}|[\w.-]+)(?:={1,2}|!=)(?:\$\w+|\$\{\w+\}|[\w.-]*)")
EXPANDS = regex(r"[$`*?{@%]")
NUMBER = regex(r"[-+]?\d+")
FROM_TWO = regex(r"(?!(?:19|20)\d{6,8}\Z)(?:[2-9]|[1-9]\d{1,9})")
"""Numbers before which, as text, others come that are more. Days, such as 20260131, have the same number of digits."""
DATE = regex(r"\$\(date\b|`date\b")
OWN_TEST = regex(r"(?m)^[ \t]*(?:function[ \t]+)?test[ \t]*\([ \t]*\)")
CONTAINERS = ("compose", "dockerfile")
"""Where `test` may be an argument of the entrypoint."""
OF_ZSH = regex(r"#![^\n]*\bzsh\b")
NUMERIC = ("-eq", "-ne", "-lt", "-gt", "-le", "-ge")
NO_OPERATORS = {"=!": "!=", "=<": "-le", "=>": "-ge", "===": "="}
MEANT = ("1", "true", ":")
SET_OPTIONS = frozenset(
    "allexport braceexpand debug emacs errexit errtrace functrace hashall histexpand history ignoreeof "
    "interactive-comments keyword monitor noclobber noexec noglob nolog notify nounset onecmd physical pipefail posix "
    "privileged stdin trackall verbose vi xtrace".split()
)
"""Names that `set -o` of bash, dash and ksh knows."""


@rule("warning", symptoms=["[: missing `]'", "integer expression expected", "[: unary operator expected"])
def condition_misread(robot: Robot) -> Iterator[Finding]:
    for command in every_command(robot.runners):
        if command.words and command.words[0].startswith(("[", "test")):
            found = _glued(command) or next(_of_brackets(command), None)
            if found is not None and "{{" not in command.words[0].span.source.line_text(command.words[0].line):
                where, message, advice = found
                yield finding(where, message, advice=advice)


def _glued(command: Command) -> tuple[Located, str, str] | None:
    """A missing blank after or before a bracket."""
    first, last = command.words[0], command.words[-1]
    raw = first.span.text
    if raw != "[[" and GLUED.fullmatch(raw) and len(command.words) > 1 and last.endswith("]"):
        return first, f"There is no command '{first}': this is never true", f"write a blank behind {raw[:1]}"
    if first == "[" and len(last) > 1 and last.span.text.endswith("]") and "]" not in command.words:
        is_pattern = last.count("[") >= last.count("]")
        return None if is_pattern else (last, "[ finds no ']' and ends with an error", "write a blank before ]")
    return None


def _of_brackets(command: Command) -> Iterator[tuple[Located, str, str]]:
    name = command.words[0]
    words = command.words[1:]
    if name != "test":
        if name not in ("[", "[[") or not words or words[-1] != "]" * len(name):
            return
        words = words[:-1]
    elif name.span.source.matches(OWN_TEST) or (len(words) == 1 and name.span.source.kind in CONTAINERS):
        return
    is_posix = name != "[["
    for redirect in command.redirects:
        target = redirect.target
        if redirect.operator in ("<", ">") and not redirect.descriptor and target is not None and words:
            if is_posix and len(words) == 1:
                message = f"'{redirect.operator}' opens a file called '{target}': nothing is compared"
                yield target, message, "write -lt or -gt"
            elif not is_posix and FROM_TWO.fullmatch(target) and not any(map(DATE.search, words)):
                yield (
                    target,
                    f"'{redirect.operator}' compares text here, in which 10 is less than 9",
                    "write -lt or -gt",
                )
    if words == ("0",) and name.span.source.line_before(name.span.start).endswith("while "):
        return
    for each in _primaries(words) if is_posix else (words,):
        found = _of_primary([word for word in each if word not in ("(", ")", "!")], is_posix)
        if found is not None:
            yield found


def _primaries(words: tuple[Located, ...]) -> Iterator[list[Located]]:
    """The single questions that `-a` and `-o` join."""
    found: list[Located] = []
    for word in words:
        if word in ("-a", "-o") and found and found[-1] not in ("!", "(", "=", "==", "!="):
            yield found
            found = []
        else:
            found.append(word)
    yield found


def _of_primary(words: list[Located], is_posix: bool) -> tuple[Located, str, str] | None:
    if len(words) == 1:
        return _of_word(words[0])
    if len(words) == 2:
        return _of_unary(words[0], words[1], is_posix)
    if len(words) == 3 and is_posix:
        return _of_binary(*words)
    return None


def _of_word(word: Located) -> tuple[Located, str, str] | None:
    if COMPARED.fullmatch(word):
        return word, f"'{word}' is one word, and no comparison: this is always true", "write blanks around the operator"
    if word and word not in MEANT and not EXPANDS.search(word):
        message = f"'{word}' is a word, and no variable or command: the answer is always the same"
        return word, message, "write what is to be asked"
    return None


def _of_unary(operator: Located, word: Located, is_posix: bool) -> tuple[Located, str, str] | None:
    raw = word.span.text
    is_plain = bool(word) and not EXPANDS.search(word)
    if operator in ("-n", "-z") and is_plain:
        answer = "true" if operator == "-n" else "false"
        return word, f"'{word}' is a word, and no variable: this is always {answer}", f'write "${word}"'
    if operator == "-n" and is_posix and VARIABLE.fullmatch(raw) and not raw.startswith(("$#", "$?", "$$")):
        return word, f"This is also true where {raw} is empty: then it is [ -n ]", f'write "{raw}"'
    if operator == "-o" and is_plain and word not in SET_OPTIONS and not OF_ZSH.match(word.span.source.text):
        return word, f"-o asks for an option of the shell, and none is called '{word}': never true", "write -n or ="
    return None


def _of_binary(first: Located, operator: Located, last: Located) -> tuple[Located, str, str] | None:
    if operator in NO_OPERATORS:
        return operator, f"There is no operator {operator}: this is never true", f"write {NO_OPERATORS[operator]}"
    if operator in NUMERIC:
        for word in (first, last):
            if word and not EXPANDS.search(word) and not NUMBER.fullmatch(word):
                return word, f"{operator} compares numbers, and '{word}' is none: this is never true", "write = or !="
    return None
