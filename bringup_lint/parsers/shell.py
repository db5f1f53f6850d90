"""Shell scripts as far as a linter needs them: simple commands, and the loops, branches and functions around them
(POSIX.1-2017, 2.9; bash(1), "Compound Commands"). Nothing is expanded; what cannot be read is passed over."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import replace
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.model.shell import Redirect
from bringup_lint.parsers.shell_tokens import ASSIGNMENT
from bringup_lint.parsers.shell_tokens import HERE
from bringup_lint.parsers.shell_tokens import REDIRECTS
from bringup_lint.parsers.shell_tokens import Token
from bringup_lint.parsers.shell_tokens import tokens
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.templates import with_variables

_DEPTH = 40
_SEPARATORS = frozenset({";", "\n", "&", "&&", "||", "|"})
_ENDS_BRANCH = frozenset({";;", ";&", ";;&"})


def blocks(script: Located) -> tuple[Block, ...]:
    """The statements of a script. Never raises; what cannot be read is passed over."""
    return _Reader(tokens(script)).statements(frozenset(), 0)


def script_text(source: Source) -> Located:
    """The text of a whole script file; where a template has a placeholder, a variable that nothing sets."""
    whole = source.located(0, len(source.text))
    return Located(with_variables(source.text, source.template), whole.span) if source.template else whole


def script_blocks(source: Source) -> tuple[Block, ...]:
    """The statements of a whole script file, read once for all layers."""
    return source.once(script_blocks, lambda: blocks(script_text(source)))


def commands(script: Located) -> list[Command]:
    """The simple commands of a script, in the order in which they appear. Never raises."""
    key = (commands, script, script.span.start, script.span.end, script.pieces)
    return list(script.span.source.once(key, lambda: tuple(flatten(blocks(script)))))


def shell_commands(source: Source) -> list[Command]:
    """The simple commands of a whole script file."""
    return list(source.once(shell_commands, lambda: tuple(flatten(script_blocks(source)))))


def shell_blocks(source: Source) -> tuple[Block, ...]:
    """The statements of a whole script file."""
    return script_blocks(source)


def words(line: Located) -> Iterator[Located]:
    """The words of a command line; operators, which only a shell would read, are left out."""
    for command in commands(line):
        yield from command.assignments
        yield from command.words


def split(text: str) -> list[str]:
    """The words of a command line whose place nobody needs."""
    return [str(word) for word in words(Source("", text).located(0, len(text)))]


def flatten(found: Iterable[Block], depth: int = 0) -> Iterator[Command]:
    """The simple commands of statements, each with the number of compound commands around it."""
    for block in found:
        if block.command is not None and (block.command.words or block.command.assignments):
            yield replace(block.command, depth=depth) if depth else block.command
        yield from flatten(block.condition, depth + 1)
        for body in block.bodies:
            yield from flatten(body, depth + 1)


class _Reader:
    def __init__(self, found: list[Token]) -> None:
        self.tokens = found
        self.at = 0
        self.after_process: dict[int, str] = {}

    def peek(self, ahead: int = 0) -> Token | None:
        at = self.at + ahead
        return self.tokens[at] if at < len(self.tokens) else None

    def is_operator(self, text: str, ahead: int = 0) -> bool:
        token = self.peek(ahead)
        return token is not None and token.operator and token.text == text

    def keyword(self) -> str:
        """The next word when it is plain, so that it may be a reserved word."""
        token = self.peek()
        if token is None or token.operator or token.text.span.text != token.text:
            return ""
        return str(token.text)

    def taken(self) -> str:
        """The word before the place where reading goes on; empty past the end."""
        return str(self.tokens[self.at - 1].text) if 0 < self.at <= len(self.tokens) else ""

    def statements(self, stops: frozenset[str], depth: int) -> tuple[Block, ...]:
        """Statements up to one of the stop words, which is taken."""
        found: list[Block] = []
        while (token := self.peek()) is not None:
            text = str(token.text)
            if (token.operator and text in stops) or self.keyword() in stops:
                self.at += 1
                break
            if token.operator and text in _SEPARATORS | _ENDS_BRANCH:
                self.at += 1
                continue
            before = self.at
            block = self.statement(depth)
            if block is not None:
                found.append(block)
            if self.at == before:
                self.at += 1
        return tuple(found)

    def statement(self, depth: int) -> Block | None:
        block = self.command(depth)
        if block is None or block.command is not None:
            return block
        redirects = tuple(self.redirects([]))
        return replace(block, redirects=redirects, ends=self.end())

    def command(self, depth: int) -> Block | None:
        word = self.keyword()
        if depth > _DEPTH:
            return self.simple()
        if word in ("!", "time"):
            self.at += 1
            return self.statement(depth + 1)
        if word in ("for", "select"):
            return self.for_loop(depth)
        if word in ("while", "until"):
            self.at += 1
            condition = self.statements(frozenset({"do"}), depth + 1)
            return Block("loop", condition=condition, bodies=(self.statements(frozenset({"done"}), depth + 1),))
        if word == "if":
            return self.branches(depth)
        if word == "case":
            return self.case(depth)
        if word == "{":
            self.at += 1
            return Block("group", bodies=(self.statements(frozenset({"}"}), depth + 1),))
        if word == "function" or (self.is_operator("(", 1) and self.is_operator(")", 2)):
            return self.function(depth)
        if self.is_operator("("):
            if self.is_operator("(", 1):
                return Block("command", arithmetic=self.arithmetic())
            self.at += 1
            return Block("group", bodies=(self.statements(frozenset({")"}), depth + 1),))
        return self.simple()

    def arithmetic(self) -> Located:
        """The text between ``((`` and ``))``."""
        start = self.tokens[self.at + 1].text.span
        self.at += 2
        end = start
        while (token := self.peek()) is not None and not (self.is_operator(")") and self.is_operator(")", 1)):
            end = token.text.span
            self.at += 1
        self.at += 2
        return start.source.located(start.end, end.end)

    def for_loop(self, depth: int) -> Block:
        self.at += 1
        name, items = "", []
        if self.is_operator("(") and self.is_operator("(", 1):
            start = self.tokens[self.at].text
            self.arithmetic()
            end = self.tokens[min(self.at, len(self.tokens)) - 1].text
            source = start.span.source
            items = [source.located(start.span.start, end.span.end)]
        elif (token := self.peek()) is not None and not token.operator:
            name = str(token.text)
            self.at += 1
            if self.keyword() == "in":
                self.at += 1
                while (token := self.peek()) is not None and not token.operator:
                    items.append(token.text)
                    self.at += 1
            else:
                items = [token.text.part(0, 0)] if token.text else []
        self.statements(frozenset({"do"}), depth + 1)
        return Block("for", name=name, items=tuple(items), bodies=(self.statements(frozenset({"done"}), depth + 1),))

    def branches(self, depth: int) -> Block:
        self.at += 1
        condition: list[Block] = []
        bodies: list[tuple[Block, ...]] = []
        condition += self.statements(frozenset({"then"}), depth + 1)
        while True:
            start = self.at
            bodies.append(self.statements(frozenset({"elif", "else", "fi"}), depth + 1))
            ended = self.taken() if self.at > start else "fi"
            if ended == "elif":
                condition += self.statements(frozenset({"then"}), depth + 1)
            elif ended != "else":
                return Block("branches", condition=tuple(condition), bodies=tuple(bodies))

    def case(self, depth: int) -> Block:
        while (token := self.peek()) is not None and self.keyword() != "in":
            self.at += 1
        self.at += 1
        bodies = []
        patterns = []
        while (token := self.peek()) is not None and self.keyword() != "esac":
            self.at += 1
            if token.operator and token.text == ")":
                patterns.append(self.tokens[max(self.at - 2, 0)].text)
                bodies.append(self.statements(_ENDS_BRANCH | {"esac"}, depth + 1))
                if self.taken() == "esac":
                    return Block("branches", bodies=tuple(bodies), items=tuple(patterns))
        self.at += 1
        return Block("branches", bodies=tuple(bodies), items=tuple(patterns))

    def function(self, depth: int) -> Block:
        if self.keyword() == "function":
            self.at += 1
        token = self.peek()
        name = str(token.text) if token else ""
        self.at += 1
        while (token := self.peek()) is not None and token.operator and token.text in ("(", ")", "\n"):
            self.at += 1
        if self.keyword() == "{":
            self.at += 1
            return Block("function", name=name, bodies=(self.statements(frozenset({"}"}), depth + 1),))
        body = self.statement(depth + 1)
        return Block("function", name=name, bodies=((body,) if body else (),))

    def simple(self) -> Block | None:
        words: list[Located] = []
        assignments: list[Located] = []
        arrays: list[tuple[str, int]] = []
        redirects: list[Redirect] = []
        while (token := self.peek()) is not None:
            text = str(token.text)
            if not token.operator:
                if not words and ASSIGNMENT.match(text):
                    if text.endswith("=") and self.is_operator("(", 1):
                        arrays.append((text.rstrip("=").rstrip("+"), self.array()))
                        continue
                    assignments.append(token.text)
                else:
                    words.append(token.text)
                self.at += 1
            elif text in REDIRECTS or text in HERE:
                redirects += self.redirects(words)
            else:
                break
        if not (words or assignments or arrays or redirects):
            return None
        command = Command(tuple(words), tuple(assignments), self.end(), redirects=tuple(redirects))
        return Block("command", command, arrays=tuple(arrays))

    def end(self) -> str:
        """The operator that ends the command before it."""
        token = self.peek()
        text = str(token.text) if token is not None and token.operator else ""
        if text == "(" and self.is_process(self.at):
            return self.end_after_process()
        return ";" if text in ("(", ")") else text

    def is_process(self, at: int) -> bool:
        """Whether the bracket there is that of ``<(`` or ``>(``."""
        before, bracket = self.tokens[at - 1], self.tokens[at]
        is_arrow = before.operator and before.text in ("<", ">")
        return is_arrow and before.text.span.end == bracket.text.span.start

    def end_after_process(self) -> str:
        """The ``&&`` or ``||`` behind the words of a command, some of which are ``<(...)``."""
        at = self.at
        passed: list[int] = []
        end = ";"
        while at < len(self.tokens):
            token = self.tokens[at]
            if at in self.after_process:
                end = self.after_process[at]
                break
            if not token.operator or token.text in REDIRECTS or token.text in HERE:
                at += 1
            elif token.text == "(" and self.is_process(at):
                passed.append(at)
                at = self.closing.get(at, len(self.tokens)) + 1
            else:
                end = str(token.text) if token.text in ("&&", "||") else ";"
                break
        self.after_process.update(dict.fromkeys(passed, end))
        return end

    @cached_property
    def closing(self) -> dict[int, int]:
        """Where each bracket is closed."""
        found: dict[int, int] = {}
        opened: list[int] = []
        for at, token in enumerate(self.tokens):
            if token.operator and token.text == "(":
                opened.append(at)
            elif token.operator and token.text == ")" and opened:
                found[opened.pop()] = at
        return found

    def redirects(self, before: list[Located]) -> Iterator[Redirect]:
        """The redirections here. A number right before the operator, the last word of ``before``, belongs to it; not
        to ``&>``."""
        while (token := self.peek()) is not None and token.operator:
            operator = str(token.text)
            if operator not in REDIRECTS and operator not in HERE:
                return
            self.at += 1
            number = ""
            is_number = bool(before) and before[-1].isdecimal() and not operator.startswith("&")
            if is_number and before[-1].span.end == token.text.span.start:
                number = str(before.pop())
            target = None
            after = self.peek()
            if operator in REDIRECTS and after is not None and not after.operator:
                target = after.text
                self.at += 1
            yield Redirect(operator, number, target, token.document)

    def array(self) -> int:
        """The number of words of ``NAME=(...)``."""
        self.at += 2
        count = 0
        while (token := self.peek()) is not None and not (token.operator and token.text == ")"):
            count += not token.operator
            self.at += 1
        self.at += 1
        return count
