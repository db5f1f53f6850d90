"""The grammars of compose files, with the values that compose-go takes and refuses."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.parsers.compose_schema import remarks
from bringup_lint.parsers.compose_values import bad_substitutions
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Located
from bringup_lint.source import Source


def located(text: str) -> Located:
    return Source("compose.yaml", text).located(0, len(text))


@pytest.mark.parametrize(
    ("key", "good", "bad"),
    [
        ("stop_grace_period", ["10s", "1m30s", "1.5h", "0"], ["ten", "10 s", "5x"]),
        ("mem_limit", ["512m", "1gb", "1.5g", "100 kib", "1048576"], ["1gig", "m", "-5m"]),
        ("privileged", ["true", "yes", "Off"], ["maybe", "si"]),
        ("restart", ["no", "always", "on-failure:5"], ["on-fail", "never"]),
        ("pull_policy", ["missing", "every_12h"], ["sometimes"]),
    ],
)
def test_values_are_taken_as_compose_does(key: str, good: list[str], bad: list[str]) -> None:
    for values, refused in ((good, False), (bad, True)):
        for value in values:
            text = f'services: {{a: {{image: b, {key}: "{value}"}}}}'
            assert bool(list(remarks(parse(Source("compose.yaml", text))))) is refused, value


@pytest.mark.parametrize(
    ("key", "good", "bad"),
    [
        ("ports", ["80", "8080:80", "1.2.3.4:8080:80/udp", "3000-3005:3000-3005", "[::1]:80:80"], ["a", "80:99999"]),
        ("volumes", ["data:/a", "./b:/b:ro,z", "C:/c:/c", "/d"], [":/a", "a:b:c:d", "", "./a:/a:r"]),
        ("devices", ["/dev/a", "/dev/a:/dev/b", "/dev/a:/dev/b:rm"], ["/dev/a:/dev/b:rx", "a:b:c:d"]),
    ],
)
def test_entries_of_lists(key: str, good: list[str], bad: list[str]) -> None:
    for values, refused in ((good, False), (bad, True)):
        for value in values:
            text = f'services: {{a: {{image: b, {key}: ["{value}"]}}}}'
            assert bool(list(remarks(parse(Source("compose.yaml", text))))) is refused, value


def test_substitutions() -> None:
    good = ["$A", "${A}", "${A:-b}", "${A-}", "${A:?b c}", "${A:+${B:-c}}", "$$", "$${#a}", "$1", "a$", "${A} }"]
    bad = ["${", "${}", "${A", "${A%b}", "${1}", "${A:-${B!}}", "${A B}"]
    assert not [text for text in good if list(bad_substitutions(located(text)))]
    assert not [text for text in bad if not list(bad_substitutions(located(text)))]


@given(st.text("ab${}:-?1\n", max_size=40))
def test_every_text_is_read(text: str) -> None:
    for bad in bad_substitutions(located(text)):
        assert 0 <= bad.span.start <= bad.span.end <= len(text)
