"""Whatever the text, the spans and the secrets: every format renders, and keeps the secrets to itself."""

from __future__ import annotations

import json
import re
from html import escape

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.report import FORMATS
from bringup_lint.report import Report
from bringup_lint.report import render
from bringup_lint.source import Source
from bringup_lint.source import Span

CHARACTERS = st.one_of(st.sampled_from('ab \t\n\r=\\"#é日\u0301\u202e\x1b\x00\udc80[](){}0'), st.characters())
TEXTS = st.text(CHARACTERS, max_size=120)
SECRETS = st.text(st.characters(categories=("L", "N", "P")), min_size=8, max_size=20).map("7q{}".format)
"""None is a word of a format itself, such as ``severity``."""
NAMES = TEXTS.map(lambda text: text.encode("utf-8", "surrogatepass").decode("utf-8", "surrogateescape"))
"""As the file system gives them: what is no text is kept byte by byte."""
LENGTHS = st.integers(-5, 150)


@st.composite
def findings(draw: st.DrawFn) -> Finding:
    sources = [Source(draw(NAMES) or "x", draw(TEXTS)) for _ in range(2)]
    spans = st.builds(Span, st.sampled_from(sources), LENGTHS, LENGTHS)
    related = st.lists(st.builds(Related, spans, TEXTS), max_size=3).map(tuple)
    edits = st.lists(st.builds(Edit, spans, TEXTS), min_size=1, max_size=2).map(tuple)
    return draw(
        st.builds(
            Finding,
            message=TEXTS,
            span=spans,
            rule=st.sampled_from(["systemd/root-user", "udev/name"]),
            severity=st.sampled_from(Severity),
            advice=TEXTS,
            related=related,
            chain=related,
            fix=st.none() | st.builds(Fix, TEXTS, edits),
            suppression=st.none() | st.builds(Suppression, spans, TEXTS),
            secrets=st.lists(spans, max_size=1).map(tuple),
        )
    )


@given(st.lists(findings(), max_size=3), st.integers(0, 200), st.booleans())
def test_every_format_renders(found: list[Finding], width: int, colour: bool) -> None:
    report = Report(tuple(found), root="/robot", width=width, colour=colour)
    for output_format in FORMATS:
        text = render(output_format, report)
        assert text.encode("utf-8").decode() == text
        if output_format in ("json", "sarif", "gitlab", "rdjson"):
            json.loads(text)
        elif not colour:
            blank = {"\n", "\t"} if output_format == "html" else {"\n"}
            assert set(text) - blank == {sign for sign in text if sign.isprintable()}


@given(SECRETS, TEXTS, TEXTS, st.sampled_from(FORMATS))
def test_no_format_shows_a_secret(secret: str, before: str, after: str, output_format: str) -> None:
    source = Source("robot.env", f"{before}\nKEY={secret}\nAGAIN={secret}\n{after}", "env-file")
    start = source.text.index(f"\nKEY={secret}\n") + 5
    value = source.span(start, start + len(secret))
    place = Related(value, f"it is {secret}")
    marking = Finding("readable by all", value, "env/secret", Severity.ERROR, secrets=(value,))
    telling = Finding(
        f"the value {secret} is odd",
        source.span(max(start - 8, 0), start + 30),
        "env/odd",
        Severity.WARNING,
        advice=f"replace {secret}",
        related=(place,),
        chain=(place,),
        fix=Fix(f"drop {secret}", (Edit(value, secret),)),
        suppression=Suppression(value, secret) if output_format in ("json", "sarif", "junit") else None,
    )
    text = render(output_format, Report((marking, telling)))
    text = re.sub(r"<(style|script)>.*?</\1>|robot\.env", "", text, flags=re.DOTALL)
    for shown in (secret, json.dumps(secret)[1:-1], escape(secret)):
        assert shown not in text
