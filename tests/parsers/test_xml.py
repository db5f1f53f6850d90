"""The XML reader: spans, recovery, attacks, and agreement with libxml2 on what is well-formed."""

from __future__ import annotations

import pytest
from hypothesis import assume
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.parsers.xml import MAX_DEPTH
from bringup_lint.parsers.xml import MAX_PROBLEMS
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Source


def read(text):
    return parse(Source("a.xml", text))


def codes(text):
    return [problem.code for problem in read(text).problems]


def test_tree_with_places():
    document = read('<?xml version="1.0"?>\n<a x="1">\n  <b y=\'&lt;&#65;z\'>te&amp;xt<!-- c -->more</b><c/>\n</a>\n')
    a = document.root
    b, c = a.children
    assert document.problems == []
    assert (a.name, a.get("x"), b.get("y"), b.text) == ("a", "1", "<Az", "te&xtmore")
    assert (a.name.line, b.name.line, b.get("y").span.text) == (2, 3, "&lt;&#65;z")
    assert b.get("y").part(2, 3).span.text == "z"
    assert b.text.part(2, 3).span.text == "&"
    assert b.text.part(5, 9).span.text == "more"
    assert c.span.text == "<c/>" and b.span.text.endswith("</b>")
    assert a.span.text.startswith("<a x") and a.span.text.endswith("</a>")


def test_cdata_is_text():
    assert read("<a> <![CDATA[<x>&amp;]]> </a>").root.text == "<x>&amp;"


def test_namespaces():
    document = read('<p:a xmlns="urn:d" xmlns:p="urn:p"><b/><p:c xmlns:p="urn:q"/></p:a>')
    assert [element.namespace for element in document.elements] == ["urn:p", "urn:d", "urn:q"]
    assert [element.local for element in document.elements] == ["a", "b", "c"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "empty-document"),
        ("<!-- only -->", "empty-document"),
        ("<a>", "unclosed-element"),
        ("<a></b></a>", "stray-end-tag"),
        ("<a><b></a>", "mismatched-tag"),
        ("<a/><b/>", "second-root"),
        ("<a/>text", "text-outside-root"),
        ("<a b></a>", "bad-attribute"),
        ("<a b=1></a>", "bad-attribute"),
        ("<a b='1'c='2'/>", "missing-blank"),
        ("<a b='<'/>", "less-than-in-value"),
        ("<a b='1' b='2'/>", "duplicate-attribute"),
        ("<a>&</a>", "bad-reference"),
        ("<a>&#0;</a>", "bad-reference"),
        ("<a>&nbsp;</a>", "entity"),
        ("<a><</a>", "bad-tag"),
        ("<a\n<b/>", "unclosed-tag"),
        ("<a><!-- x", "unclosed-markup"),
        ("<a><!-- -- --></a>", "bad-comment"),
        ("<a>\0</a>", "control-character"),
        ("<p:a/>", "undeclared-prefix"),
        ('<!-- x --><?xml version="1.0"?><a/>', "late-declaration"),
        ('<?xml version="1.0" encoding="UTF-16"?><a>ä</a>', "encoding"),
        ("<?xml?><a/>", "bad-declaration"),
        ("<!DOCTYPE a><a/>", "doctype"),
        ("<a><!b c='d' /-></a>", "misplaced-declaration"),
        ("<a>]]></a>", "cdata-end"),
    ],
)
def test_problem(text, code):
    assert code in codes(text)


def test_recovery_keeps_the_rest():
    document = read('<a><b x="1" y=2 z><c><d>t</d></b><e w="5></e>\n<f/></a>')
    assert [element.name for element in document.elements] == ["a", "b", "c", "d", "e", "f"]
    assert document.root.children[0].get("y") == "2"
    assert document.root.children[1].get("w") == "5"


def nested_entities():
    layers = "".join(f'<!ENTITY l{n + 1} "{f"&l{n};" * 10}">' for n in range(9))
    return f'<!DOCTYPE a [<!ENTITY l0 "lol">{layers}]><a>&l9;</a>'


@pytest.mark.parametrize(
    "text",
    [
        nested_entities(),
        '<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]><a>&x;</a>',
        '<!DOCTYPE a SYSTEM "http://localhost/a.dtd"><a/>',
        "<a>" * 300_000,
        "<a " + "b='1' " * 300_000 + "/>",
        "<a " * 300_000,
        "<a b='" * 300_000,
        '<a b="<' * 300_000,
        "<!--" * 300_000,
        "<![CDATA[" * 100_000,
        "</a>" * 300_000,
        "&#" * 300_000,
        "<a>" + "&lt;" * 300_000 + "&x;</a>",
        "<!DOCTYPE a [" + "<!ENTITY" * 100_000,
        "<?x " * 300_000,
        "<a>" + "".join(f"<b xmlns:p{n}=''/>" for n in range(30_000)),
        "<" * 300_000,
        "\0" * 300_000,
        "<a x" + " " * 1_000_000,
        "x" * 5_000_000,
    ],
    ids=lambda text: text[:12],
)
def test_attacks_are_refused(text):
    document = read(text)
    assert document.problems
    assert len(document.problems) <= MAX_PROBLEMS + 1
    assert "root:" not in (document.root.text if document.root else "")


def test_depth_is_bounded():
    depth = 0
    element = read("<a>" * (MAX_DEPTH + 9)).root
    while element.children:
        element, depth = element.children[0], depth + 1
    assert depth < MAX_DEPTH


MARKUP = st.sampled_from(
    [
        "<",
        ">",
        "</",
        "/>",
        "<a",
        "<b",
        "</a>",
        "</b>",
        "=",
        '"',
        "'",
        "&",
        "&lt;",
        "&x;",
        "&#65;",
        "&#x;",
        ";",
        "<!--",
        "-->",
        "--",
        "<![CDATA[",
        "]]>",
        "<?",
        "?>",
        "<?xml",
        "<!DOCTYPE",
        "[",
        "]",
        ":",
        "p:",
        "xmlns:p=",
        "a",
        "b",
        "x='1'",
        'y="2"',
        "é",
        "\x00",
        "\n",
        " ",
        "\r\n",
    ]
)


@given(st.lists(MARKUP, max_size=40).map("".join))
def test_never_raises_and_spans_lie_inside(text):
    document = read(text)
    size = len(text)
    for problem in document.problems:
        span = getattr(problem.where, "span", problem.where)
        assert 0 <= span.start <= span.end <= size
    for element in document.elements:
        assert element.name.span.text == element.name
        assert 0 <= element.span.start < element.span.end <= size
        assert element.text is not None and element.namespace is not None
        for attribute in element.attributes:
            assert attribute.name.span.text == attribute.name
            assert element.tag.start < attribute.value.span.start <= attribute.value.span.end <= size


WELL_FORMED = (
    '<?xml version="1.0" encoding="UTF-8"?>\n<!-- head -->\n<r xmlns="urn:a" xmlns:p="urn:b">'
    "<p:a x='1' p:y=\"&lt;\">t &amp; &#233;<![CDATA[<&]]></p:a><?i d?><b/><c>\n<d e='f' g='h'/></c></r>\n"
)


@settings(derandomize=True)
@given(st.data())
def test_agrees_with_libxml2(data):
    etree = pytest.importorskip("lxml.etree")
    text = WELL_FORMED
    for _ in range(data.draw(st.integers(0, 3))):
        at = data.draw(st.integers(text.find("?>") + 2, len(text)))
        cut = data.draw(st.integers(0, 3))
        text = text[:at] + data.draw(st.one_of(st.just(""), MARKUP)) + text[at + cut :]
    options = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        etree.fromstring(text.encode(), options)
        accepted = True
    except etree.XMLSyntaxError as error:
        assume("URI" not in str(error))
        accepted = False
    mine = codes(text)
    assume("doctype" not in mine)
    assert accepted == (not mine), mine
