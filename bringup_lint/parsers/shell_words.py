"""The words, quotes and brackets of a script, read as strictly as the shell does."""

from __future__ import annotations

from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import TypeVar

if TYPE_CHECKING:
    from typing import NoReturn

Answer = TypeVar("Answer")
_DEPTH = 120
_ENDS = frozenset(" \t\n;&|<>()")
_PLAIN = regex(r"[A-Za-z{}!\[\]]+(?=[ \t\n;&|<>()]|\Z)|\\\Z")
_SOLID = regex(r"[^ \t\n;&|<>()'\"`$\\]+")
_REDIRECT = regex(r"(?:\d+|\{\w+\})?(?:<<<|<<-?|<>|<&|<(?!\()|>>|>&|>\||>(?!\()|&>>?)")
_GLOB = regex(r"[@!+*?]\(")


class Refused(Exception):
    """Where it begins and ends, the kind, the word, and what is wanted instead."""


def unclosed(start: int, what: str) -> Refused:
    return Refused(start, start + len(what), "unclosed", what)


class Words:
    """A script that is read from its start on."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.size = len(text)
        self.at = 0
        self.unsure = False
        self.depth = 0
        self.documents: list[tuple[str, bool]] = []

    def give_up(self) -> NoReturn:
        """Nobody can tell from here on."""
        self.unsure = True
        raise Refused(self.at, self.at, "", "")

    def enter(self) -> None:
        """Counts how deep statements, quotes and expansions are in each other."""
        self.depth += 1
        if self.depth > _DEPTH:
            self.give_up()

    def leave(self, answer: Answer) -> Answer:
        self.depth -= 1
        return answer

    def refuse(self, start: int, word: str) -> NoReturn:
        raise Refused(start, min(start + max(len(word), 1), self.size), "unexpected", word)

    def refuse_here(self) -> NoReturn:
        self.refuse(self.at, self.plain_word() or self.text[self.at : self.at + 1])

    def skip_blanks(self) -> None:
        """Blanks, continued lines and a comment."""
        while self.at < self.size:
            char = self.text[self.at]
            if char in " \t":
                self.at += 1
            elif self.text.startswith("\\\n", self.at):
                self.at += 2
            elif char == "#" and (self.at == 0 or self.text[self.at - 1] in _ENDS):
                end = self.text.find("\n", self.at)
                self.at = self.size if end < 0 else end
            else:
                return

    def skip_lines(self) -> None:
        """The same, and line ends with the here-documents after them."""
        while True:
            self.skip_blanks()
            if self.at >= self.size or self.text[self.at] != "\n":
                return
            self.line_end()

    def line_end(self) -> None:
        self.at += 1
        for delimiter, tabs in self.documents:
            while self.at < self.size:
                end = self.text.find("\n", self.at)
                end = self.size if end < 0 else end
                line = self.text[self.at : end]
                self.at = min(end + 1, self.size)
                if (line.lstrip("\t") if tabs else line) == delimiter:
                    break
        self.documents = []

    def operator(self, known: tuple[str, ...]) -> str:
        found = next((each for each in known if self.text.startswith(each, self.at)), "")
        self.at += len(found)
        return found

    def plain_word(self) -> str:
        """The word here where it may be a reserved one."""
        match = _PLAIN.match(self.text, self.at)
        return match[0] if match else ""

    def redirections(self) -> None:
        self.skip_blanks()
        while self.redirection():
            self.skip_blanks()

    def redirection(self) -> bool:
        match = _REDIRECT.match(self.text, self.at)
        if match is None:
            return False
        self.at = match.end()
        self.skip_blanks()
        start = self.at
        if self.at >= self.size or (self.text[self.at] in _ENDS and not self.text.startswith(("<(", ">("), self.at)):
            if match[0].endswith("&") and self.at < self.size:
                self.give_up()
            self.refuse_here()
        self.word()
        if match[0].lstrip("0123456789").startswith("<<") and not match[0].endswith("<<<"):
            delimiter = self.text[start : self.at]
            if "$" in delimiter or "`" in delimiter:
                self.give_up()
            self.documents.append((delimiter.translate(_NO_QUOTES), match[0].endswith("-")))
        return True

    def words_of_line(self) -> None:
        while True:
            self.skip_blanks()
            if self.at >= self.size or self.text[self.at] in "\n;&|":
                return
            if self.text[self.at] in "()<>":
                if not self.text.startswith(("<(", ">("), self.at):
                    self.refuse_here()
            self.word()

    def array(self, start: int) -> None:
        self.at += 1
        while True:
            self.skip_lines()
            if self.at >= self.size:
                raise unclosed(start, "(")
            if self.text[self.at] == ")":
                self.at += 1
                return
            if self.text[self.at] in _ENDS and not self.text.startswith(("<(", ">("), self.at):
                self.give_up()
            self.word()
            if self.text.startswith("(", self.at):
                self.give_up()

    def condition(self, start: int) -> None:
        """What follows ``[[``."""
        while True:
            self.skip_lines()
            if self.at >= self.size:
                raise unclosed(start, "[[")
            if self.plain_word() == "]]":
                self.at += 2
                return
            if self.text[self.at] in ";":
                self.refuse_here()
            if self.text[self.at] in _ENDS:
                self.at += 1
            else:
                self.word(in_condition=True)

    def arithmetic(self, start: int) -> None:
        """``((...))``; what may be two subshells is left alone."""
        depth, at = 0, start
        while at < self.size:
            char = self.text[at]
            if char in "'\"`\\":
                self.at = at
                self.give_up()
            depth += (char == "(") - (char == ")")
            at += 1
            if depth == 0:
                break
        if depth or self.text[at - 2] != ")":
            self.at = start
            self.give_up()
        self.at = at

    def word(self, in_condition: bool = False) -> None:
        """One word; nothing where none begins."""
        while self.at < self.size:
            solid = _SOLID.match(self.text, self.at)
            if solid:
                self.at = solid.end()
                continue
            char = self.text[self.at]
            if char == "(" and _GLOB.match(self.text, self.at - 1):
                self.give_up()
            if char in "<>" and self.text.startswith("(", self.at + 1) and not in_condition:
                self.process()
            elif char in _ENDS:
                return
            else:
                self.quoted_or_expanded(char, False)

    def process(self) -> None:
        """``<(...)``."""
        start = self.at
        self.at += 2
        self.substitution(start, self.text[start : start + 2])

    def substitution(self, start: int, opened: str) -> None:
        raise NotImplementedError

    def quoted_or_expanded(self, char: str, in_quotes: bool) -> None:
        start = self.at
        self.enter()
        if char == "\\":
            self.at = min(start + 2, self.size)
        elif char == "'":
            self.at = self.closing("'", start + 1, start, char)
        elif char == '"':
            self.double_quoted(start)
        elif char == "`":
            self.escaped(start, "`", "`")
        elif self.text.startswith("$'", start) and not in_quotes:
            self.escaped(start, "$'", "'")
        elif self.text.startswith("$((", start):
            self.at += 1
            self.arithmetic(start + 1)
        elif self.text.startswith("$(", start):
            self.at += 2
            self.substitution(start, "$(")
        elif self.text.startswith("${", start):
            self.parameter(start, in_quotes)
        else:
            self.at += 1
        self.leave(None)

    def closing(self, what: str, at: int, start: int, opened: str) -> int:
        end = self.text.find(what, at)
        if end < 0:
            raise unclosed(start, opened)
        return end + 1

    def double_quoted(self, start: int) -> None:
        self.at += 1
        while self.at < self.size:
            char = self.text[self.at]
            if char == '"':
                self.at += 1
                return
            if char in "\\`$":
                self.quoted_or_expanded(char, True)
            else:
                self.at += 1
        raise unclosed(start, '"')

    def escaped(self, start: int, opened: str, end: str) -> None:
        """What the first end without a backslash before it ends."""
        self.at += len(opened)
        while self.at < self.size and self.text[self.at] != end:
            self.at += 2 if self.text[self.at] == "\\" else 1
        if self.at >= self.size:
            raise unclosed(start, opened)
        self.at += 1

    def parameter(self, start: int, in_quotes: bool) -> None:
        """``${...}``; where a quote in it means one thing or another is left alone."""
        self.at += 2
        while self.at < self.size:
            char = self.text[self.at]
            if char == "}":
                self.at += 1
                return
            if char == "'" and in_quotes:
                self.give_up()
            if char in "\\'\"`$":
                self.quoted_or_expanded(char, in_quotes)
            else:
                self.at += 1
        raise unclosed(start, "${")


_NO_QUOTES = dict.fromkeys(map(ord, "'\"\\"))
