"""A command has quotes or a dash that are typographic characters.

## What it finds
In commands of scripts, images, units and compose files: a word that begins with a typographic quote (`“`, `”`, `„`,
`‘`, `’`), or has one after `=` or `+`, and an option whose dash is `–` or `—`. Not in what `echo`, `printf` and others
only say, nor within ASCII quotes. The same line in copies of a script for the
same purpose is one finding.

## Why it matters on a robot
Web pages and word processors put these characters in the place of those of the keyboard, and they are copied with the
command. For the shell they are letters: `“a b”` is two words with the quotes in them, and `–y` is the name of a
package. The value, the path or the option is another one than the line seems to say.

## Bad
```sh
export ROVER_NAME=“mole”
apt-get install –y can-utils
```

## Good
```sh
export ROVER_NAME="mole"
apt-get install -y can-utils
```

## When to ignore it
When the character belongs to the value.

## References
- bash(1), "QUOTING"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Purpose
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Word
from bringup_lint.api.shell import every_command

ANY = regex(r"[“”„‘’–—]")
QUOTE = regex(r"(?:^|(?<=[=+]))[“”„‘’]")
DASH = regex(r"[–—]{1,2}[A-Za-z][\w-]{0,40}(?:=.*)?")
SAYS = frozenset("echo printf log info warn error say notify-send whiptail dialog zenity espeak git read die".split())
MOST = 20
PLAIN = {"“": '"', "”": '"', "„": '"', "‘": "'", "’": "'"}


@rule("warning", silent="the character is a letter of the word")
def typographic_quote(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(ANY):
        return
    found: dict[Source, list[Located]] = {}
    for command in every_command(robot.runners):
        if command.name not in SAYS:
            for word in (*command.assignments, *command.words):
                found.setdefault(word.span.source, []).extend(_in(word))
    alike: dict[tuple[Purpose, bool, tuple[str, ...]], list[Located]] = {}
    for source, places in found.items():
        if places:
            lines = tuple(source.line_text(each.span.line).strip() for each in places)
            alike.setdefault((robot.purpose(source), robot.leads_to(source), lines), []).extend(places)
    for first, *others in alike.values():
        is_quote = first in PLAIN
        message = (
            f"{first} is no quote for the shell: it becomes part of the word"
            if is_quote
            else f"{first} is no option: its dash is not that of the keyboard"
        )
        yield finding(
            first,
            message,
            advice=f"write {PLAIN[first] if is_quote else '-'}",
            related=[note(each, "here too") for each in others[:MOST]],
        )


def _in(word: Located) -> Iterator[Located]:
    """The typographic quotes that begin a word or a value, and the options with such a dash."""
    if not ANY.search(word):
        return
    if DASH.fullmatch(word):
        yield word
    stretches = word.stretches() if isinstance(word, Word) else ()
    for stretch, quote in stretches:
        if not quote:
            yield from (stretch.part(*match.span()) for match in QUOTE.finditer(stretch))
