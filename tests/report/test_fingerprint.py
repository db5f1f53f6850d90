"""What keeps a finding's fingerprint, and what changes it."""

from __future__ import annotations

import pytest

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.copies import merged
from bringup_lint.finding.fingerprint import fingerprints
from bringup_lint.finding.presented import presented
from bringup_lint.source import Source
from tests.growth import is_linear

TEXT = "[Service]\nUser=root\nRestartSec=5\n"


def found(
    text: str = TEXT, word: str = "root", name: str = "a.service", message: str = "runs 3 nodes", **more
) -> Finding:
    start = text.index(word)
    source = Source(name, text)
    return Finding(message, source.span(start, start + len(word)), "systemd/root-user", Severity.ERROR, **more)


def mark(finding: Finding, root: str = "/robot", cwd: str = "/robot") -> str:
    return presented([finding], root, cwd).findings[0].fingerprint


@pytest.mark.parametrize(
    "same",
    [
        found("# new\n\n" + TEXT),
        found(TEXT.replace("User=root", "  User=root  ")),
        found(message="runs 4 nodes"),
        found(name="/robot/a.service"),
        found(name="./a.service"),
        found(advice="another"),
    ],
)
def test_same(same: Finding) -> None:
    assert mark(same) == mark(found())


@pytest.mark.parametrize(
    "other",
    [
        found(name="b.service"),
        found(word="5"),
        found(message="runs all nodes"),
        found(TEXT.replace("root", "root x")),
    ],
)
def test_different(other: Finding) -> None:
    assert mark(other) != mark(found())


def test_alike_findings_are_counted() -> None:
    twins = [found(), found()]
    first, second = fingerprints(twins, "/robot")
    assert first != second
    assert first == mark(found())


def test_folder_of_the_run_does_not_matter() -> None:
    assert mark(found(name="../a.service"), cwd="/robot/src") == mark(found())


def test_secret_does_not_matter() -> None:
    def of(secret: str) -> Finding:
        source = Source("a.env", f"KEY={secret}\n")
        return Finding(
            f"{secret} is readable", source.span(0, 3), "env/key", secrets=(source.span(4, 4 + len(secret)),)
        )

    assert mark(of("orange-lighthouse")) == mark(of("green-windmill"))


def test_many_findings_of_one_long_line_take_time_as_they_are_many() -> None:
    def work(count: int) -> None:
        source = Source("a.launch.xml", "attribute " * count)
        found = [Finding(f"Unknown {n}", source.span(10 * n, 10 * n + 9), rule="launch/a") for n in range(count)]
        assert len(set(fingerprints(merged(found), "/"))) == count

    assert is_linear(work, 500)


def test_alike_findings_of_a_file_are_one() -> None:
    source = Source("a.launch.xml", "attribute attribute attribute")
    first, *others = [Finding("Unknown", source.span(at, at + 9), rule="launch/a") for at in (0, 10, 20)]
    (one,) = merged([first, *others])
    assert (one.span, one.copies) == (first.span, tuple(others))
    assert [each.span for each in one.related] == [each.span for each in others]
