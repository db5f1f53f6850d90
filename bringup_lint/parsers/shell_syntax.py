"""What bash and dash refuse to read of a script: quotes that are not closed, and compound commands that do not fit
together (POSIX.1-2017, 2.10; bash(1), "SHELL GRAMMAR"). Says nothing wherever an option of the shell may decide."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell_words import Refused
from bringup_lint.parsers.shell_words import Words
from bringup_lint.parsers.shell_words import unclosed

_SIZE = 200_000
_OPENS = {"if": "fi", "while": "done", "until": "done", "for": "done", "select": "done", "case": "esac", "{": "}"}
_CLOSES = frozenset(("then", "elif", "else", "fi", "do", "done", "esac", "}"))
_BETWEEN = (";;&", ";;", ";&")


class Mistake(NamedTuple):
    at: int
    """Where in the text."""
    end: int
    kind: str
    """``unclosed`` (a quote or bracket), ``missing`` (what ends a compound command) or ``unexpected``."""
    word: str
    """The word or character of that place."""
    wanted: str = ""
    """What is missing."""


def syntax_mistake(text: str) -> Mistake | None:
    """The first place of a script that the shell does not understand; None when there is none, or nobody can tell."""
    if len(text) > _SIZE or "\0" in text or "\r" in text:
        return None
    reader = _Grammar(text)
    try:
        reader.list_until(())
        if reader.at < len(text):
            reader.refuse_here()
    except Refused as refused:
        return None if reader.unsure else Mistake(*refused.args)
    return None


class _Grammar(Words):
    """A script, statement by statement."""

    def list_until(self, stops: tuple[str, ...]) -> str:
        """Statements up to a word or operator that ends them, which is taken; ``)`` is left to who opened it."""
        self.enter()
        count = 0
        while True:
            self.skip_lines()
            start = self.at
            if start >= self.size or self.text[start] == ")":
                return self.leave("")
            separator = next((each for each in _BETWEEN if self.text.startswith(each, start)), "")
            word = separator or self.plain_word()
            if word in stops:
                if not count and word not in ("esac", *_BETWEEN):
                    self.refuse(start, word)
                self.at = start + len(word)
                return self.leave(word)
            if word in _CLOSES or separator:
                self.refuse(start, word)
            self.and_or()
            count += 1

    def and_or(self) -> None:
        """Pipelines joined with ``&&``, ``||`` and ``|``, and what ends them."""
        while True:
            is_compound = self.command()
            self.skip_blanks()
            operator = self.operator(("&&", "||", "|&", "|"))
            if not operator:
                break
            self.skip_lines()
            if self.at >= self.size:
                self.refuse(self.at - 1, operator)
            if self.plain_word() in _CLOSES or self.is_separator(");&|"):
                self.refuse_here()
        if self.text.startswith(_BETWEEN, self.at) or (is_compound and self.plain_word() in _CLOSES):
            return
        ended = self.operator((";", "&"))
        self.skip_blanks()
        if ended and self.at < self.size and self.is_separator(";&|"):
            if not self.text.startswith(_BETWEEN, self.at):
                self.refuse_here()
        elif not ended and self.at < self.size and self.text[self.at] not in "\n)":
            self.refuse_here()

    def is_separator(self, known: str) -> bool:
        return self.text[self.at] in known and not self.text.startswith("&>", self.at)

    def command(self) -> bool:
        """One command, and whether it is a compound one, after which a reserved word needs no ``;``."""
        self.enter()
        self.skip_blanks()
        start = self.at
        word = self.plain_word()
        while word in ("!", "time"):
            self.at += len(word)
            self.skip_blanks()
            word = self.plain_word()
            if word.startswith("-") or word in ("time", "coproc"):
                self.give_up()
        if word in ("coproc", "]]"):
            self.give_up()
        if word in ("function", "[[") or word in _OPENS or self.text.startswith("(", self.at):
            start = self.at
            self.compound(word, start)
            self.redirections()
            return self.leave(True)
        if word in _CLOSES:
            self.refuse_here()
        is_function = self.simple()
        if self.at == start:
            self.refuse_here()
        return self.leave(is_function)

    def compound(self, word: str, start: int) -> None:
        if not word:
            self.parentheses(start)
            return
        self.at += len(word)
        if word == "[[":
            self.condition(start)
        elif word == "function":
            self.skip_blanks()
            self.word()
            self.skip_blanks()
            if self.operator(("(",)):
                self.skip_blanks()
                self.expect(start, ")", "function")
            self.skip_lines()
            self.command()
        elif word == "if":
            self.branches(start)
        elif word == "case":
            self.case(start)
        elif word == "{":
            self.closed(start, word, self.list_until(("}",)))
        else:
            if word in ("for", "select"):
                self.head_of_for(start, word)
            else:
                self.closed(start, word, self.list_until(("do",)), "do")
            self.closed(start, word, self.list_until(("done",)))

    def closed(self, start: int, word: str, ended: str, wanted: str = "") -> None:
        if not ended:
            self.missing(start, word, wanted or _OPENS[word])

    def missing(self, start: int, word: str, wanted: str) -> None:
        """Says that the text ended, or a bracket came, before what was wanted."""
        if self.at < self.size:
            self.refuse_here()
        raise Refused(start, start + len(word), "missing", word, wanted)

    def branches(self, start: int) -> None:
        self.closed(start, "if", self.list_until(("then",)), "then")
        while True:
            ended = self.list_until(("elif", "else", "fi"))
            self.closed(start, "if", ended)
            if ended == "fi":
                return
            if ended == "else":
                self.closed(start, "if", self.list_until(("fi",)))
                return
            self.closed(start, "if", self.list_until(("then",)), "then")

    def head_of_for(self, start: int, word: str) -> None:
        self.skip_blanks()
        if self.text.startswith("((", self.at):
            self.arithmetic(self.at)
        else:
            self.word()
            self.skip_lines()
            if self.plain_word() == "in":
                self.at += 2
                self.words_of_line()
        self.skip_blanks()
        self.operator((";",))
        self.skip_lines()
        if self.plain_word() == "{":
            self.give_up()
        if self.plain_word() != "do":
            self.missing(start, word, "do")
        self.at += 2

    def case(self, start: int) -> None:
        self.skip_blanks()
        self.word()
        self.skip_lines()
        if self.plain_word() != "in":
            self.missing(start, "case", "in")
        self.at += 2
        while True:
            self.skip_lines()
            if self.plain_word() == "esac":
                self.at += 4
                return
            if self.at >= self.size:
                self.missing(start, "case", "esac")
            self.patterns(start)
            ended = self.list_until((*_BETWEEN, "esac"))
            self.closed(start, "case", ended)
            if ended == "esac":
                return

    def patterns(self, start: int) -> None:
        self.operator(("(",))
        while True:
            self.skip_blanks()
            self.word()
            self.skip_blanks()
            if not self.operator(("|",)):
                break
        self.expect(start, ")", "case")

    def expect(self, start: int, operator: str, word: str) -> None:
        if not self.operator((operator,)):
            self.missing(start, word, operator)

    def parentheses(self, start: int) -> None:
        """A subshell, or arithmetic."""
        if self.text.startswith("((", start):
            self.arithmetic(start)
            return
        self.at += 1
        before = self.at
        self.list_until(())
        if not self.text[before : self.at].strip():
            self.refuse_here()
        if not self.operator((")",)):
            raise unclosed(start, "(")

    def substitution(self, start: int, opened: str) -> None:
        self.list_until(())
        if not self.operator((")",)):
            raise unclosed(start, opened)

    def simple(self) -> bool:
        """A simple command, or a function, which is compound."""
        first = self.at
        count = 0
        while True:
            self.skip_blanks()
            if self.redirection():
                continue
            before = self.at
            if self.at >= self.size or self.text[self.at] in "\n;&|)":
                return False
            if self.text[self.at] == "(":
                if count != 1 or "=" in self.text[first:before]:
                    self.refuse_here()
                self.at += 1
                self.skip_blanks()
                self.expect(first, ")", "(")
                self.skip_lines()
                self.command()
                return True
            self.word()
            count += 1
            if self.text[self.at - 1] == "=" and self.text.startswith("(", self.at):
                self.array(self.at)
