"""logrotate's configuration, read as logrotate's own state machine reads it (config.c, 3.21).

What it does with an error is part of the meaning: inside a stanza most errors leave out the stanza up to the next
``}`` that is at the start of a line, outside they end the reading of the file.
"""

from __future__ import annotations

import re
from functools import cache

from bringup_lint.dataclass import replace
from bringup_lint.model.logrotate import Directive
from bringup_lint.model.logrotate import LogrotateFile
from bringup_lint.model.logrotate import Script
from bringup_lint.model.logrotate import Stanza
from bringup_lint.model.schema import Item
from bringup_lint.parsers.logrotate_values import SPACE
from bringup_lint.parsers.logrotate_values import check_value
from bringup_lint.parsers.logrotate_values import owners
from bringup_lint.parsers.logrotate_values import split_words
from bringup_lint.pattern import regex
from bringup_lint.schema.table import load
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

HARMLESS = frozenset({"unknown-directive", "text-after-brace", "unclosed"})
"""Problems that cost at most their own line."""
_WORD = regex(r"[ \t]*([A-Za-z]*)")
_SCRIPTS = frozenset({"prerotate", "postrotate", "firstaction", "lastaction", "preremove"})
_COMMENT_LINE = regex(r"^[ \t]*#[^\n]*", re.M)


@cache
def directives() -> dict[str, Item]:
    """The directives that logrotate knows."""
    return load("host/logrotate_directives").top.children


def parse(source: Source) -> LogrotateFile:
    """Read a logrotate file. Never raises; the codes of its problems are those of ``_Reader``."""
    reader = _Reader(source)
    reader.run()
    return reader.file


class _Reader:
    """The machine: ``at`` is the character that the state looks at; each step ends one further."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.text = source.text
        self.at = 0
        self.state = self.default
        self.file = LogrotateFile(source)
        self.stanza: Stanza | None = None
        self.script: tuple[Located, int] | None = None
        self.stopped = False
        self.known: dict[str, Located] = {}

    def run(self) -> None:
        while self.at < len(self.text) and not self.stopped:
            self.state()
            self.at += 1
        if self.script and not self.stopped:
            self.problem("missing-endscript", self.script[0])
            self.stop()
        elif self.stanza and not self.stopped and not self.stanza.skipped:
            self.problem("unclosed", self.source.located(self.stanza.header.start, self.stanza.header.end))

    @property
    def char(self) -> str:
        return self.text[self.at : self.at + 1]

    def problem(self, code: str, where: Located, detail: str = "") -> None:
        self.file.problems.append(Problem(code, where, detail))

    def stop(self) -> None:
        """logrotate gives the file up here."""
        self.stopped = True
        self.file.unread_from = self.at
        if self.stanza:
            self.stanza.skipped = True

    def fail(self) -> None:
        """Leave out the stanza; without one, give up."""
        if self.stanza is None:
            self.stop()
            return
        self.stanza.skipped = True
        self.state = self.failed

    # States

    def default(self) -> None:
        char = self.char
        if char in " \t\n":
            return
        if char == "#":
            self.skip_line()
        elif char.isascii() and char.isalpha():
            self.directive()
        elif char in "/\"'~":
            self.paths()
        elif char == "}":
            self.close()
        else:
            self.problem("bad-line-start", self.rest_of_line(self.at))
            self.fail()

    def failed(self) -> None:
        self.state = self.skipping

    def skipping(self) -> None:
        """In a stanza that is left out: only a ``}`` at the start of a line ends it."""
        if self.char == "}":
            self.stanza = None
            self.state = self.default
            return
        word = self.word()
        if word in _SCRIPTS:
            self.state = self.skipped_script
        elif self.char != "\n":
            self.skip_line()

    def skipped_script(self) -> None:
        if self.word() == "endscript":
            self.state = self.skipping
        elif self.char != "\n":
            self.skip_line()

    def in_script(self) -> None:
        word = self.word()
        if word != "endscript":
            if self.char != "\n":
                self.skip_line()
            return
        name, start = self.script or (word, self.at)
        body_end = max(self.text.rfind("\n", 0, self.at) + 1, start)
        script = Script(name, self.source.located(start, body_end), self.source.span(name.span.start, self.at))
        if self.stanza:
            self.stanza.scripts.append(script)
        self.script = None
        self.state = self.default

    def closed(self) -> None:
        if self.char in " \t":
            return
        self.state = self.default
        if self.char != "\n":
            self.problem("text-after-brace", self.rest_of_line(self.at))
            self.skip_line()

    # What the states read

    def word(self) -> Located:
        found = _WORD.match(self.text, self.at)
        assert found is not None
        self.at = found.end()
        return self.source.located(*found.span(1))

    def skip_line(self) -> None:
        """Stand on the line end, so that the next step begins the next line."""
        end = self.text.find("\n", self.at)
        self.at = len(self.text) if end == -1 else end

    def rest_of_line(self, start: int) -> Located:
        end = self.text.find("\n", start)
        end = len(self.text) if end == -1 else end
        return self.source.located(start, start + len(self.text[start:end].rstrip(SPACE)))

    def line_value(self) -> Located:
        """What is left of the line; the cursor goes to its last character."""
        value = self.rest_of_line(self.at).strip_located(SPACE)
        end = self.text.find("\n", self.at)
        self.at = (len(self.text) if end == -1 else end) - 1
        return value

    def argument(self, name: Located) -> Located | None:
        """The value behind blanks and perhaps ``=``; None, and a problem, when there is none."""
        at = self.skip_blanks(self.at)
        if self.text[at : at + 1] == "=":
            at = self.skip_blanks(at + 1)
        if self.text[at : at + 1] == "\n":
            self.problem("argument-expected", name)
            return None
        self.at = at
        return self.line_value()

    def skip_blanks(self, at: int) -> int:
        while self.text[at : at + 1] in (" ", "\t"):
            at += 1
        return at

    def directive(self) -> None:
        name = self.word()
        if self.char not in SPACE + "=" or not self.char:
            self.problem("not-separated", name, self.char)
            self.fail()
            return
        known = directives().get(name)
        kind = known.type if known else None
        if kind is None:
            self.problem("unknown-directive", name)
            if self.char != "\n":
                self.skip_line()
        elif kind == "script":
            self.script = (name, self.at)
            self.state = self.in_script
        elif kind == "flag":
            self.add(name, self.source.located(self.at, self.at))
        elif kind in ("weekday", "owner", "su", "options"):
            self.judge(name, kind, self.line_value())
        elif kind == "global" and self.stanza is not None:
            self.problem("global-only", name)
            self.fail()
        else:
            value = self.argument(name)
            if value is not None:
                self.judge(name, kind, value)
            elif kind not in ("format", "size", "global"):
                self.fail()

    def judge(self, name: Located, kind: str, value: Located) -> None:
        self.add(name, value)
        found = check_value(kind, value) if value or kind == "options" else None
        if kind in ("owner", "su"):
            found = self.judge_owner(name, kind, value)
        if found is not None:
            self.file.problems.append(replace(found, detail=str(name)))
            self.stop() if found.code == "bad-weekday" else self.fail()

    def judge_owner(self, name: Located, kind: str, value: Located) -> Problem | None:
        user, group, more = owners(kind, value)
        if more:
            return Problem("extra-arguments", value)
        if kind == "su" and not self.inherited("su"):
            if user is None or group is None:
                return Problem("su-incomplete", value if value else name)
        return None

    def inherited(self, name: str) -> bool:
        return self.stanza is not None and any(each.name == name for each in self.stanza.defaults)

    def add(self, name: Located, value: Located) -> None:
        end = value.span.end if value else name.span.end
        found = Directive(name, value, self.source.span(name.span.start, end))
        (self.stanza.directives if self.stanza else self.file.directives).append(found)

    def paths(self) -> None:
        """The paths of a stanza, up to its ``{``."""
        start = self.at
        if self.stanza is not None:
            self.problem("unexpected-path", self.rest_of_line(start))
            self.fail()
            return
        end = self.brace()
        blanked = _COMMENT_LINE.sub(lambda found: " " * len(found[0]), self.text[start:end])
        text = Located(blanked, self.source.span(start, end))
        header = self.source.span(start, start + len(self.text[start:end].rstrip(SPACE)))
        self.stanza = Stanza([], tuple(self.file.directives), header)
        if self.text[end : end + 1] != "{":
            self.problem("missing-open-brace", self.rest_of_line(start))
            self.stop()
            return
        words = split_words(text)
        self.at = end
        if not words:
            self.problem("bad-quotes", self.source.located(start, header.end))
            self.stop()
            return
        self.stanza.paths = words
        self.file.stanzas.append(self.stanza)
        self.find_duplicates()

    def brace(self) -> int:
        """Offset of the first brace outside comment lines, or the end of the text."""
        at, line_start = self.at, False
        while at < len(self.text) and self.text[at] not in "{}":
            if line_start and self.text[at] == "#":
                end = self.text.find("\n", at)
                at = len(self.text) if end == -1 else end
            line_start = self.text[at : at + 1] == "\n" or (line_start and self.text[at : at + 1] in SPACE)
            at += 1
        return at

    def find_duplicates(self) -> None:
        """Compare with the stanzas above; those that are skipped, or have ignoreduplicates, do not count."""
        above = self.file.stanzas[-2] if len(self.file.stanzas) > 1 else None
        if above is not None and not above.skipped and not above.get("ignoreduplicates"):
            self.known.update({str(path): path for path in above.paths})
        assert self.stanza is not None
        own: dict[str, Located] = {}
        for path in self.stanza.paths:
            if path in self.known or path in own:
                self.problem("duplicate-path", path)
            own[path] = path

    def close(self) -> None:
        if self.stanza is None:
            self.problem("unexpected-brace", self.source.located(self.at, self.at + 1))
            self.stop()
            return
        self.stanza.closed = True
        self.stanza = None
        self.state = self.closed
