"""A name that is renamed does not become one that is there already."""

from __future__ import annotations

from collections import Counter

from bringup_lint.parsers.names_beside import MOST_NAMES
from bringup_lint.parsers.names_beside import attributes_beside
from bringup_lint.parsers.names_beside import elements_beside
from bringup_lint.parsers.names_beside import is_free
from bringup_lint.parsers.names_beside import is_free_key
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Located
from bringup_lint.source import Source


def located(source: Source, word: str) -> Located:
    at = source.text.index(word)
    return source.located(at, at + len(word))


def test_a_key_becomes_no_key_of_its_mapping() -> None:
    source = Source("a.yaml", "a:\n  adresses: 1\n  'addresses': 2\nb:\n  adreses: 1\n")
    assert not is_free_key("addresses", located(source, "adresses"))
    assert is_free_key("addresses", located(source, "adreses"))


def test_two_keys_do_not_become_the_same() -> None:
    assert not is_free("addresses", "adresses", Counter(["adresses", "addreses"]))
    assert not is_free("addresses", "adresses", Counter(["adresses", "adresses"]))
    assert is_free("gateway4", "gatway4", Counter(["gatway4", "gateway6"]), {"gateway4", "gateway6"})


def test_nobody_compares_all_keys_of_a_large_mapping() -> None:
    assert not is_free("addresses", "adresses", Counter(["adresses", *map(str, range(MOST_NAMES))]))


def test_the_attributes_of_a_tag() -> None:
    source = Source("a.launch.xml", "<launch>\n<node\n  type = 'a>b'\n  exec='b'/><other exec='c'/></launch>")
    assert attributes_beside(located(source, "type")) == Counter(["type", "exec"])
    assert not attributes_beside(located(source, "node"))
    assert not attributes_beside(located(source, "a>b"))


def test_the_elements_of_a_parent() -> None:
    document = parse(Source("a.xml", "<a><b><c/></b><x:b/><d/></a>"))
    assert document.root is not None
    assert elements_beside(document, document.root.children[2].name) == Counter({"b": 2, "d": 1})
    assert not elements_beside(document, document.root.name)
