"""The index of the rules: what it holds is what the files say, whatever lies in its place."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from bringup_lint.registry import Registry
from bringup_lint.registry import RuleError
from bringup_lint.registry import builtin_folder
from bringup_lint.registry import described
from bringup_lint.registry import families
from bringup_lint.registry import load
from bringup_lint.report.docs import HEADINGS
from bringup_lint.rule_index import stored
from bringup_lint.rule_index.stored import Index
from bringup_lint.rule_index.stored import index_of

SECTIONS = "".join(f"\n## {heading}\n" for heading in HEADINGS)
RULE = '''\
"""{title}.
{sections}"""

@rule("error", symptoms=["a line"])
def {name}(robot):
    yield from robot.sshd
'''


@pytest.fixture(autouse=True)
def written(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    yield


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write(tmp_path, "one", "One thing")
    (tmp_path / "host/family.toml").write_text('title = "Host"\n')
    return tmp_path


def write(folder: Path, name: str, title: str) -> None:
    path = folder / "host" / f"{name}.py"
    path.parent.mkdir(exist_ok=True)
    path.write_text(RULE.format(name=name, title=title, sections=SECTIONS))


def place(folder: Path) -> Path:
    return folder / "__pycache__" / f"index.{sys.implementation.cache_tag}.marshal"


def titles(index: Index | None) -> dict[str, str]:
    assert index is not None
    entries = {name: index.entry(name) for name in index.rules}
    return {name: entry.described.title for name, entry in entries.items() if entry is not None}


def test_the_index_of_the_rules_is_what_the_files_say() -> None:
    registry = Registry.of()
    assert registry.index is not None
    assert replace(Registry(families([builtin_folder()])), index=None).paths == registry.paths
    for rule in registry.all():
        own = described(rule.path, rule.id)
        assert (rule.title, rule.doc) == (own.title, own.doc)
        assert replace(rule.meta, check=own.check) == own.meta, rule.id


def test_no_rule_has_to_be_loaded_to_be_listed() -> None:
    index = Registry.of().index
    assert index is not None
    assert [name for name, entry in index.rules.items() if entry is None] == [], "write what @rule takes in its call"


def test_families_are_those_of_the_files() -> None:
    for known, read in zip(Registry.of().families, families([builtin_folder()]), strict=True):
        assert (known.mentions and known.mentions.pattern) == (read.mentions and read.mentions.pattern)
        assert replace(known, mentions=None, indexed=None) == replace(read, mentions=None)


def test_it_is_kept_beside_the_byte_code(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert titles(index_of(str(folder))) == {"host/one.py": "One thing"}
    assert place(folder).is_file()
    monkeypatch.setattr(stored, "_made", lambda *arguments: pytest.fail("made again"))
    assert index_of(str(folder)) == index_of(str(folder))


def test_it_follows_the_files(folder: Path) -> None:
    index_of(str(folder))
    write(folder, "two", "Another thing")
    assert titles(index_of(str(folder))) == {"host/one.py": "One thing", "host/two.py": "Another thing"}
    write(folder, "one", "One thing more")
    (folder / "host/two.py").unlink()
    assert titles(index_of(str(folder))) == {"host/one.py": "One thing more"}


@pytest.mark.parametrize("content", [b"", b"{", b"i\x01\x00\x00\x00", b"\xe3" + b"\x01" * 40])
def test_what_is_damaged_is_made_again(folder: Path, content: bytes) -> None:
    index_of(str(folder))
    place(folder).write_bytes(content)
    assert titles(index_of(str(folder))) == {"host/one.py": "One thing"}


def test_nothing_is_written_where_python_writes_no_byte_code(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert index_of(str(folder)) is None
    assert not place(folder).exists()


def test_nothing_is_made_where_it_cannot_be_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    assert index_of(str(folder)) is None


def test_a_rule_of_an_unusual_form_is_loaded(folder: Path) -> None:
    (folder / "host/odd.py").write_text('"""Odd.\n"""\n\n@rule(SEVERITY)\ndef odd(robot):\n    yield 1\n')
    index = index_of(str(folder))
    assert index is not None and "host/odd.py" in index.rules and index.entry("host/odd.py") is None


def test_a_rule_that_lacks_a_heading_is_loaded_and_refused(folder: Path) -> None:
    path = folder / "host/one.py"
    path.write_text(path.read_text().replace("## Bad\n", ""))
    index = index_of(str(folder))
    assert index is not None and index.entry("host/one.py") is None
    path.write_text(path.read_text().replace("@rule", "from bringup_lint.api import rule\n\n@rule"))
    with pytest.raises(RuleError, match=r"one\.py: the docstring lacks the heading Bad$"):
        load(path, "host/one")


def test_a_wheel_carries_its_own(folder: Path) -> None:
    content = stored.made_for_wheel(str(folder))
    assert content == stored.made_for_wheel(str(folder))
    (folder / stored.FILE).write_bytes(content)
    assert titles(index_of(str(folder))) == {"host/one.py": "One thing"}
    assert not place(folder).exists()
