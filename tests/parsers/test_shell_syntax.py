"""What the shell refuses: compared with bash itself, and hostile texts."""

from __future__ import annotations

import random
import shutil
import subprocess
import time

import pytest

from bringup_lint.parsers.shell_syntax import syntax_mistake
from tests.conftest import PROJECT

SCRIPTS = sorted((PROJECT / "fixtures" / "script").glob("*/good*/**/*.sh"))
PIECES = [
    "if", "then", "else", "elif", "fi", "do", "done", "case", "esac", "in", "while", "for", "function", "time", "!",
    "'", '"', "`", "(", ")", "{", "}", ";", ";;", "&&", "||", "|", "&", "$(", "${", "$((", "$'", "[[", "]]", "\n", "<<",
    "<<a", ">", "<(", "a=(", "a", "a=1", "\\", "&>", ">&", "((", "))", "#", "select", "coproc", "1",
]  # fmt: skip


def is_refused(text: str) -> bool:
    run = subprocess.run(["bash", "-n"], input=text, capture_output=True, text=True, encoding="utf-8", errors="replace")
    return run.returncode != 0 or bool(run.stderr)


def changed(chance: random.Random) -> str:
    """A script of the fixtures with a piece more, or a few pieces in a row."""
    pieces = [chance.choice(PIECES) for _ in range(chance.randint(1, 6))]
    if chance.random() < 0.3:
        return " ".join(pieces)
    text = chance.choice(SCRIPTS).read_text("utf-8")
    at = chance.randint(0, len(text))
    return f"{text[:at]} {pieces[0]} {text[at + chance.randint(0, 3) :]}"


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
def test_what_is_found_is_refused_by_bash() -> None:
    chance = random.Random(28)
    texts = [text for text in (changed(chance) for _ in range(300)) if syntax_mistake(text) is not None]
    assert len(texts) > 50
    assert [text for text in texts if not is_refused(text)] == []


@pytest.mark.parametrize(
    "text",
    [
        "for a; do b; done",
        "for a in b c\ndo d\ndone",
        "select a in b; do c; done",
        "function f { a; }\nfunction g() { b; }",
        "a && ! b || { c; }",
        "time -p a",
        "coproc a { b; }",
        "for a in b; { c; }",
        "cat <<$a\n$a\n",
        "a=(b @(c|d))",
        "a=(b (c))",
        "echo $((a ? '1' : 2))",
        "((a) || (b))",
        'echo "${a:-\'}"',
        "time coproc a",
        "]]",
        "[[ a =~ (b|c) && ! d < e ]]",
    ],
)
def test_nothing_is_found(text: str) -> None:
    assert syntax_mistake(text) is None


@pytest.mark.parametrize(
    ("text", "kind", "word"),
    [
        ("echo 'a", "unclosed", "'"),
        ('echo "a $(b', "unclosed", "$("),
        ("echo $'a\\'", "unclosed", "$'"),
        ("echo ${a", "unclosed", "${"),
        ("diff <(a", "unclosed", "<("),
        ("a=(b", "unclosed", "("),
        ("(a", "unclosed", "("),
        ("[[ a", "unclosed", "[["),
        ("[[ a ; b ]]", "unexpected", ";"),
        ("while a; b; done", "unexpected", "done"),
        ("while a", "missing", "while"),
        ("for a in b; c", "unexpected", "c"),
        ("for a in b", "missing", "for"),
        ("for a in b (c); do d; done", "unexpected", "("),
        ("for a in", "missing", "for"),
        ("case a b in c) d ;; esac", "unexpected", "b"),
        ("case a in b) c", "missing", "case"),
        ("case a in b c) d ;; esac", "unexpected", "c"),
        ("case a in", "missing", "case"),
        ("if a; then b; else c; d", "missing", "if"),
        ("if a; then b; elif c; then d", "missing", "if"),
        ("if a; then fi", "unexpected", "fi"),
        ("a; ; b", "unexpected", ";"),
        ("a |", "unexpected", "|"),
        ("a | | b", "unexpected", "|"),
        ("a b (c)", "unexpected", "("),
        ("f( a", "unexpected", "a"),
        ("()", "unexpected", ")"),
        ("a )", "unexpected", ")"),
        ("a >", "unexpected", ""),
        ("a ;;", "unexpected", ";;"),
        ("[[ a ]] b", "unexpected", "b"),
        ("function f( a", "unexpected", "a"),
    ],
)
def test_mistake(text: str, kind: str, word: str) -> None:
    mistake = syntax_mistake(text)
    assert mistake is not None
    assert (mistake.kind, mistake.word) == (kind, word)
    assert 0 <= mistake.at <= mistake.end <= len(text)


@pytest.mark.parametrize(
    "piece", ["(", "((", "$(", "${", '"$(', "{ ", "if ", "f()", "a|", "<<a ", "`", "[[ ", "! ", "a=("]
)
def test_hostile_text_ends_soon(piece: str) -> None:
    started = time.process_time()
    syntax_mistake(piece * 20_000)
    assert time.process_time() - started < 5


@pytest.mark.parametrize("text", ["\0'", "'\r\n", "'" * 200_001])
def test_unreadable_text(text: str) -> None:
    assert syntax_mistake(text) is None
