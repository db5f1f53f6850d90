"""The YAML reader: exact places, recovery, and protection against hostile documents."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers.yaml_nodes import DEEPEST
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Source


def read(text):
    return parse(Source("robot.yaml", text))


def scalars(text):
    return [node for node in read(text).nodes if isinstance(node, Scalar)]


@pytest.mark.parametrize(
    "text",
    [
        "mast: camera",
        "\ufeffmast: camera",
        "mast: camera\r\nbase: wheels\r\n",
        "\U0001f916: \U0001f6de  # wheel\nmast: [left, 'right']\n",
        'mast: "left"\n',
        "mast: &side left\nbase: *side\n",
        "mast: !side left\n",
        "a:\n- b\n- c: {d: e}\n",
    ],
)
def test_a_plain_value_is_the_text_of_its_span(text):
    for scalar in scalars(text):
        assert scalar.value.span.text == scalar.value


@pytest.mark.parametrize(
    ("text", "value", "origins"),
    [
        ("k: 'it''s'", "it's", {0: 4, 2: 6, 3: 8}),
        ('k: "a\\tb\\u0041c"', "a\tbAc", {1: 5, 2: 7, 3: 8, 4: 14}),
        ("k: one\n  two\n\n  three", "one two\nthree", {4: 9, 8: 16}),
        ("k: |\n  one\n  two\n", "one\ntwo\n", {0: 7, 4: 13}),
        ("k: |\r\n  one\r\n  two\r\n", "one\ntwo\n", {0: 8, 4: 15}),
        ("k: >-\n  one\n  two\n\n  three\n", "one two\nthree", {0: 8, 4: 14, 8: 21}),
        ("k: |2\n   one\n  two\n", " one\ntwo\n", {0: 8, 1: 9, 5: 15}),
        ('k: "one \\\n  two"', "one two", {4: 12}),
    ],
)
def test_every_character_knows_its_origin(text, value, origins):
    found = read(text).root.get("k").value
    assert found == value
    assert {index: found.origin(index) for index in origins} == origins


def test_a_part_of_a_block_scalar_stands_on_its_own_line():
    found = read("run: |\n  first\n  exec ros2 launch\n").root.get("run").value
    at = found.index("ros2")
    assert found.part(at, at + 4).line == 3


def test_duplicate_keys_are_kept_and_told():
    file = read("lidar: 1\nlidar: 2\nmast: {a: 1, a: 2}\n")
    assert [value.value for key, value in file.root.entries if key.value == "lidar"] == ["1", "2"]
    assert [(first.value.line, again.value.line) for first, again in file.duplicates] == [(1, 2), (3, 3)]


def test_merge_keys_are_followed():
    root = read("base: &base {user: robot, image: x}\ndriver:\n  <<: *base\n  image: y\n").root
    assert root.get("driver").get("user").value == "robot"
    assert root.get("driver").get("image").value == "y"


def test_several_documents():
    assert [document.root.value for document in read("--- a\n--- b\n...\n").documents] == ["a", "b"]


def test_spans_of_block_collections_end_with_their_last_word():
    text = "a:\n  b: c\n\n# later\nd: e\n"
    assert read(text).root.get("a").span.text == "b: c"


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        ("a:\n\tb: 1\n", "tab", 2),
        ("a: [1, 2\n", "syntax", 2),
        ("a: b: c\n", "syntax", 1),
        ("a: \0b\n", "control-character", 1),
        ("a: *b\n", "undefined-alias", 1),
        ("a: &a [*a]\n", "recursive-alias", 1),
        ("[" * (DEEPEST + 5), "too-deep", 1),
    ],
)
def test_problems(text, code, line):
    problem = read(text).problems[0]
    assert (problem.code, problem.where.line) == (code, line)


def test_what_stands_before_an_error_is_kept():
    file = read("a: 1\nb: 2\nc: [\n")
    assert file.root.get("b").value == "2"
    assert not file.complete


def test_lone_surrogates_are_read():
    assert read("a: \udce9t\u00e9\n").root.get("a").span.text == "\udce9t\u00e9"


def test_an_alias_bomb_stays_small():
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    for i in range(1, 12):
        lines.append(f"a{i}: &a{i} [" + ", ".join([f"*a{i - 1}"] * 9) + "]")
    file = read("\n".join(lines))
    assert "alias-bomb" in {problem.code for problem in file.problems}
    assert file.root.size < 300_000


WORDS = ["a", "b: ", "- ", "\n", "  ", "[", "]", "{", "}", ",", "&x ", "*x", "!t ", "'", '"', "\\", "\\u0041"]
SIGNS = [
    "|",
    ">-",
    "|2",
    "#",
    "\t",
    "\r\n",
    "\r",
    "\0",
    "\ufeff",
    "\U0001f916",
    "\u2028",
    "\x85",
    "--- ",
    "...\n",
]
RARE = ["<<: ", "? ", "%YAML 1.1\n", "\ud800", "''", "\\\n"]
YAML_BITS = st.lists(st.sampled_from(WORDS + SIGNS + RARE), max_size=60).map("".join)


@given(st.one_of(YAML_BITS, st.text(max_size=80)))
def test_no_text_raises_and_every_span_lies_inside(text):
    file = read(text)
    for node in file.nodes:
        spans = [node.span] + ([node.value.span] if isinstance(node, Scalar) else [])
        for span in spans:
            assert 0 <= span.start <= span.end <= len(text)
        if isinstance(node, Scalar):
            origins = [node.value.origin(i) for i in range(len(node.value))]
            assert origins == sorted(origins)
            assert all(0 <= origin <= len(text) for origin in origins)
    for problem in file.problems:
        assert 0 <= problem.where.start <= problem.where.end <= len(text)


def test_types():
    root = read("a: [yes, 'yes', ~, 12, 012]").root
    items = list(root.get("a").scalars)
    assert isinstance(root, Mapping) and isinstance(root.get("a"), Sequence)
    assert [item.boolean for item in items] == [True, None, None, None, None]
    assert [item.is_null for item in items] == [False, False, True, False, False]
    assert [item.integer for item in items] == [None, None, None, 12, None]


def test_only_the_document_that_breaks_off_is_incomplete():
    file = read("a: 1\n---\nb: 2\n---\nc: [\n")
    assert [document.complete for document in file.documents] == [True, True, False]
