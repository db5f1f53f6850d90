"""What is marked as secret is masked wherever it is."""

from __future__ import annotations

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.redact import mask_of
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.source import Source


def report_on(text: str, *secrets: str, message: str = "readable") -> str:
    source = Source("robot.env", text)
    starts = [text.index(secret) for secret in secrets]
    spans = tuple(source.span(start, start + len(secret)) for start, secret in zip(starts, secrets, strict=True))
    return render("text", Report((Finding(message, source.span(0, 3), "env/secret", Severity.ERROR, secrets=spans),)))


def test_short_secret_is_masked_where_it_is_marked() -> None:
    text = report_on("KEY=abc\nOTHER=abc\n", "abc")
    assert "KEY=***\n" in text
    assert "OTHER=abc" in text


def test_long_secret_is_masked_everywhere() -> None:
    text = report_on("KEY=abcdefgh\nOTHER=abcdefgh\n", "abcdefgh", message="abcdefgh is readable")
    assert "abcdefgh" not in text
    assert "******** is readable" in text


def test_secret_of_several_lines_keeps_its_lines() -> None:
    text = report_on("KEY=-----BEGIN\nabcdefgh\nijklmnop-----\nX=1\n", "-----BEGIN\nabcdefgh\nijklmnop-----")
    assert "2 | ********\n" in text


def test_secrets_that_overlap() -> None:
    assert "KEY=*******\n" in report_on("KEY=abcdefg\n", "abcde", "cdefg")


def test_what_no_rule_marks_is_masked_by_its_name() -> None:
    text = report_on("KEY=1\nMQTT_PASSWORD=abcdefgh\n", message="abcdefgh is odd")
    assert "abcdefgh" not in text
    assert "2 | MQTT_PASSWORD=********" in text


def test_value_that_repeats_its_name_leaves_prose_alone() -> None:
    text = report_on("KEY=1\nMQTT_PASSWORD=password\n", message="the password is known")
    assert "the password is known" in text
    assert "MQTT_PASSWORD=********" in text


def test_common_word_is_masked_where_it_is_a_secret_and_near_there() -> None:
    lines = "\n" * 9
    text = report_on(f"KEY=1\nPASSWORD=jetson\n# it is jetson\n{lines}HOST=jetson\n", message="the jetson is slow")
    assert "PASSWORD=******" in text
    assert "it is jetson" not in text
    assert "the ****** is slow" in text, "the finding is about a line near it"


def test_common_word_stays_in_what_is_about_other_lines() -> None:
    source = Source("etc/robots/panther.env", "PASSWORD=panther\n" + "\n" * 9 + "HOST=panther\n")
    host = source.span(source.text.index("HOST"), len(source.text))
    finding = Finding("panther is no address", host, "env/x", Severity.ERROR, advice="write password=panther")
    text = render("text", Report((finding,)))
    assert "HOST=panther" in text
    assert "panther is no address" in text
    assert "write password=*******" in text


def test_word_that_no_path_has_is_masked_everywhere() -> None:
    source = Source("etc/robots/rover.env", "PASSWORD=kestrel\n" + "\n" * 9 + "HOST=kestrel\n")
    host = source.span(source.text.index("HOST"), len(source.text))
    text = render("text", Report((Finding("kestrel is no address", host, "env/x", Severity.ERROR),)))
    assert "kestrel" not in text


def test_without_secrets_nothing_is_copied() -> None:
    finding = Finding("fine", Source("a", "b").whole, "env/x", Severity.INFO)
    assert mask_of([finding]) is None
    assert Report((finding,)).findings[0].source is finding.source


def test_masked_findings_have_nothing_to_mask() -> None:
    source = Source("robot.env", "KEY=abcdefgh\n")
    report = Report(
        (Finding("readable", source.span(0, 3), "env/secret", Severity.ERROR, secrets=(source.span(4, 12),)),)
    )
    assert mask_of(report.findings) is None
    assert source.text == "KEY=abcdefgh\n", "fixes still need the text itself"
