"""The words that start a container are split wrongly.

## What it finds
In the list form of ENTRYPOINT, CMD, `entrypoint:` and `command:`: a whole command line as one word, a shell that is
given a command line without `-c`, a shell with `-c` whose command is only the first of several words, and a word in
single quotes of its own where no shell or script reads them. What an entrypoint in shell form drops is left to
`docker/command-ignored`.

## Why it matters on a robot
Docker starts the first word as a program, and looks for one with blanks in its name. A shell without `-c` takes its
first word for the name of a script. With `-c`, the second word is the command line, and those after it are `$0`, `$1`
and so on: `bash -c ros2 launch rover rover.launch.py` runs `ros2` without arguments. Quotes in a word
reach the program.

## Bad
```dockerfile
CMD ["ros2 launch rover_bringup rover.launch.py"]
ENTRYPOINT ["bash", "source /opt/ros/jazzy/setup.bash && ros2 run rover base"]
```

## Good
```dockerfile
CMD ["ros2", "launch", "rover_bringup", "rover.launch.py"]
ENTRYPOINT ["bash", "-c", "source /opt/ros/jazzy/setup.bash && ros2 run rover base"]
```

## When to ignore it
When an entrypoint that is not in the tree gives its words to a shell.

## References
- https://docs.docker.com/reference/dockerfile/#exec-form
- bash(1), "OPTIONS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SHELLS
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

OPTION = regex(r"-[a-zA-Z]*c")
LINE = regex(r"(?:ros2|source|\.|cd|exec|python3?|bash|sh|\S*/[\w.-]+)[ \t]+\S")
"""The beginning of a command line with arguments."""
QUOTED = regex(r"'[^']+'")
READERS = frozenset(("ros2", "su", "ssh", "xargs", "watch", "screen", "tmux", "eval"))
"""Programs that read quotes in their words themselves, or hand them to a shell."""
TAKES = regex(r"\$[@*0-9{]")


class Wrong(NamedTuple):
    word: Located
    message: str
    advice: str


@rule("error", symptoms=['exec: "ros2 launch *": executable file not found in $PATH'])
def start_not_run(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for runner in robot.runners.in_containers:
        for line in runner.main:
            wrong = _wrong(unwrapped(line.argv))
            if wrong is None and not any(step.script is not None for step in line.steps):
                wrong = _quoted(unwrapped(line.argv))
            if wrong is None or wrong.word.span in seen:
                continue
            seen.add(wrong.word.span)
            yield finding(
                wrong.word,
                wrong.message,
                advice=wrong.advice,
                related=[note(runner.where, f"starts {runner.name}")],
            )


def _wrong(words: tuple[Located, ...]) -> Wrong | None:
    if not words:
        return None
    first, *rest = words
    if LINE.match(first):
        return Wrong(
            first,
            f"This is one word: there is no program called '{first}', and the container does not start",
            "write each word by itself",
        )
    if program_name(first) not in SHELLS or not rest or first.span == rest[0].span:
        return None  # the last is true of a shell that Docker puts before an entrypoint in shell form
    if LINE.match(rest[0]):
        return Wrong(
            rest[0],
            f"{program_name(first)} takes this for the name of a script, and the container ends at once",
            "write -c before it",
        )
    return _of_command(program_name(first), rest)


def _quoted(words: tuple[Located, ...]) -> Wrong | None:
    """A word with quotes that nobody takes away."""
    if not words or program_name(words[0]) in READERS or program_name(words[0]) in SHELLS:
        return None
    for word in words[1:]:
        if QUOTED.fullmatch(word):
            message = f"No shell reads this list: {program_name(words[0])} gets the quotes as part of its argument"
            return Wrong(word, message, f"write {word[1:-1]} without the single quotes")
    return None


def _of_command(shell: str, words: list[Located]) -> Wrong | None:
    """A shell whose command line is only the first of the words that were meant."""
    if not OPTION.fullmatch(words[0]) or len(words) < 3:
        return None
    text, following = words[1], words[2]
    if " " in text.strip() or TAKES.search(text) or following in ("--", "_"):
        return None
    return Wrong(
        following,
        f"{shell} -c runs only '{text}': this word and those after it are not arguments of it",
        "put the whole command line into one word",
    )
