"""Shell text: commands in order, words with their places."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.parsers.shell_tokens import substitutions
from bringup_lint.source import Source

TOKENS = st.sampled_from(
    [
        "ros2",
        "launch",
        "'a b'",
        '"$X"',
        "$(",
        "${",
        ")",
        "}",
        "`",
        "'",
        '"',
        "\\",
        "\n",
        ";",
        "&&",
        "|",
        "&",
        "<<E",
        "E",
        "#",
        " ",
        "if",
        "fi",
    ]
)


def words(text: str) -> list[list[str]]:
    return [[str(word) for word in command.words] for command in commands(Source("x.sh", text).located(0, len(text)))]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("source a && exec ros2 launch p f", [["source", "a"], ["exec", "ros2", "launch", "p", "f"]]),
        ("a 'b c' \"d $e\" f\\ g", [["a", "b c", "d $e", "f g"]]),
        ("a # b\nc", [["a"], ["c"]]),
        ("a#b", [["a#b"]]),
        ("if [ -e x ]; then a; else b; fi", [["[", "-e", "x", "]"], ["a"], ["b"]]),
        ("echo $(date +%F; ls) x", [["echo", "$(date +%F; ls)", "x"]]),
        ("cat <<EOF\nros2 launch no\nEOF\na", [["cat"], ["a"]]),
        ("cat <<-'E'\n\tno\n\tE\na", [["cat"], ["a"]]),
        ("a > /tmp/x 2>&1 < y", [["a"]]),
        ("a 2>&1 b", [["a", "b"]]),
        ("f() { a; }", [["a"]]),
        ("(a; b)", [["a"], ["b"]]),
        ("a \\\n b", [["a", "b"]]),
        ("a\vb\fc\u2003d e", [["a\vb\fc\u2003d", "e"]]),
    ],
)
def test_commands(text: str, expected: list[list[str]]) -> None:
    assert words(text) == expected


def test_background_and_assignments() -> None:
    text = "A=1 B='x y' ros2 run a b &\nC=2"
    first, second = commands(Source("x.sh", text).located(0, len(text)))
    assert first.background
    assert [str(word) for word in first.assignments] == ["A=1", "B=x y"]
    assert [str(word) for word in second.assignments] == ["C=2"]
    assert not second.words


def test_words_know_their_places() -> None:
    text = "a\n  'b c'"
    _, second = commands(Source("x.sh", text).located(0, len(text)))
    assert (second.words[0].span.line, second.words[0].span.column) == (2, 3)


@settings(deadline=None)
@given(
    st.one_of(
        st.text(max_size=200), st.lists(TOKENS, max_size=40).map(" ".join), st.lists(TOKENS, max_size=40).map("".join)
    )
)
def test_never_raises_and_every_span_lies_in_the_text(text: str) -> None:
    for command in commands(Source("x.sh", text).located(0, len(text))):
        for word in (*command.words, *command.assignments):
            assert 0 <= word.span.start <= word.span.end <= len(text)


def test_placeholders_are_variables_that_nothing_sets() -> None:
    text = "source {{ workspace }}/setup.bash\n{% if arm %}\nros2 launch rover {{x}}.py\n{% endif %}\n"
    first, second = shell_commands(Source("start.sh.j2", text, template="jinja"))
    assert [str(word) for word in first.words] == ["source", "${____________}/setup.bash"]
    assert [str(word) for word in second.words] == ["ros2", "launch", "rover", "${__}.py"]
    assert second.words[3].span.text == "{{x}}.py"


def test_final_script_keeps_its_braces() -> None:
    (command,) = shell_commands(Source("start.sh", "docker ps --format '{{.Names}}'\n"))
    assert str(command.words[3]) == "{{.Names}}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("""a "$(tr -d '"')" b\nc""", [["a", """$(tr -d '"')""", "b"], ["c"]]),
        ("""a "$(b "$(c ")" )")d" e""", [["a", """$(b "$(c ")" )")d""", "e"]]),
        ("""a "${b:-"c d"}'" e""", [["a", """${b:-"c d"}'""", "e"]]),
        ("""a "`b "c"`" d""", [["a", """`b "c"`""", "d"]]),
        ("""a "\\"b(" c""", [["a", '"b(', "c"]]),
        ("""a "$(b" c "d" e""", [["a", "$(b", "c", "d", "e"]]),
    ],
)
def test_quotes_in_quotes(text: str, expected: list[list[str]]) -> None:
    assert words(text) == expected


@pytest.mark.parametrize(
    ("text", "inner"),
    [
        ("echo $(date)", ["date"]),
        ('echo "a $(cd "$(dirname "$0")") b"', ['cd "$(dirname "$0")"']),
        ("echo `id -u` $(pwd)", ["id -u", "pwd"]),
        ('echo "$(ps name=^$NAME\\$)" $(', []),
        ("echo '$(date)' $((1 + 2)) plain", []),
    ],
)
def test_substitutions(text: str, inner: list[str]) -> None:
    found = commands(Source("start.sh", text).located(0, len(text)))
    words = (word for command in found for word in command.words)
    assert [str(each) for word in words for each in substitutions(word)] == inner


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("while read -r a; do :; done < <(ls) || true", "||"),
        ("grep a <(sort b | uniq) c > d || true", "||"),
        ("diff <(a) <(b) && c", "&&"),
        ("diff <(a) <(b)\nc || true", ";"),
        ("diff <(a) <(b", ";"),
    ],
)
def test_what_ends_a_command_with_processes_among_its_words(text: str, ends: str) -> None:
    block = blocks(Source("x.sh", text).located(0, len(text)))[0]
    assert (block.command.ends if block.command else block.ends) == ends
