"""The examples in the README and in ``docs/`` are what the command really prints.

``--update-expected`` rewrites them. An example is a code block below a comment that says how it was made:
``<!-- example: bringup-lint --select x . -->``, with ``in FOLDER`` before the colon when it runs elsewhere
than in the project, and ``| /runs/0`` (a JSON pointer) behind it when only a part of the output is shown.
``<!-- picture NAME: bringup-lint ... -->`` draws the output instead.
"""

from __future__ import annotations

import json
import re
import shlex
import shutil
import textwrap
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.docs.picture import picture
from tests.lint import lint

PAGES = [*PROJECT.glob("*.md"), *(PROJECT / "docs").rglob("*.md")]
EXAMPLE = re.compile(
    r"<!-- example(?: in (?P<folder>\S+))?: bringup-lint (?P<arguments>[^|>]*?)(?: \| (?P<pointer>\S+))? -->"
    r"\n```\w+\n(?P<output>.*?)```\n",
    re.DOTALL,
)
PICTURE = re.compile(r"<!-- picture (?P<name>\S+)(?: in (?P<folder>\S+))?: bringup-lint (?P<arguments>.*?) -->\n")
COMMAND = re.compile(r"^bringup-lint ?(?P<arguments>.*?)(?: \| .*| {2,}#.*)?$", re.M)
ELSEWHERE = {"/etc": "etc", "/mnt/image": ".", "RULE": "systemd/network-target"}
"""Where the example stands for what a reader has."""

LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)#\s]+)")


@pytest.fixture(autouse=True)
def eighty_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


def output(example: re.Match[str], *options: str) -> str:
    """What the command of an example prints."""
    folder = PROJECT / (example["folder"] or "")
    run = lint(*options, *shlex.split(example["arguments"]), cwd=folder)
    assert run.code in (0, 1), run.stderr
    return run.stdout


def shown(example: re.Match[str]) -> str:
    text = output(example)
    if not example["pointer"]:
        return text
    data = json.loads(text)
    for key in example["pointer"].strip("/").split("/"):
        data = data[int(key) if isinstance(data, list) else key]
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_are_true(page: Path, update_expected: bool) -> None:
    text = page.read_text("utf-8")
    for example in reversed(list(EXAMPLE.finditer(text))):
        start, end = example.span("output")
        if update_expected:
            text = text[:start] + shown(example) + text[end:]
            page.write_text(text, "utf-8")
        assert text[start:].startswith(shown(example) + "```"), example["arguments"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pictures_are_true(page: Path, update_expected: bool) -> None:
    for example in PICTURE.finditer(page.read_text("utf-8")):
        drawn = picture(output(example, "--colour"), "bringup-lint")
        file = page.parent / example["name"]
        if update_expected:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(drawn, "utf-8")
        assert file.read_text("utf-8") == drawn


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    prose = re.sub(r"```.*?```", "", page.read_text("utf-8"), flags=re.DOTALL)
    for target in LINK.findall(prose):
        assert (page.parent / target).exists(), target


def commands() -> list[str]:
    text = "\n".join(page.read_text("utf-8") for page in PAGES)
    shells = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    named = re.findall(r"`bringup-lint ([a-z-][^`]*)`", text)
    return sorted({command["arguments"] for shell in shells for command in COMMAND.finditer(shell)} | {*named})


@pytest.mark.parametrize("command", commands())
def test_commands_run(command: str, tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "docs" / "example", tmp_path / "robot")
    arguments = [ELSEWHERE.get(word, word) for word in shlex.split(command)]
    if arguments[0] == "live":
        arguments.append("--help")  # which robot would be running here?
    run = lint(*arguments, cwd=tmp_path / "robot")
    assert run.code in (0, 1) and "bringup-lint: " not in run.stderr, run.stderr


def test_rule_of_the_way_in_works(tmp_path: Path) -> None:
    text = (PROJECT / "CONTRIBUTING.md").read_text("utf-8")
    block = text.partition("   ```python\n")[2].partition("\n   ```\n\n   The docstring")[0]
    rule = tmp_path / "rules" / "systemd" / "no_tabs.py"
    rule.parent.mkdir(parents=True)
    rule.write_text(textwrap.dedent(block), "utf-8")
    (tmp_path / "rover.service").write_text('[Service]\nExecStart=/usr/bin/rover "front\tleft"\n', "utf-8")
    run = lint("--rules", "rules", "--select", "systemd/no-tabs", "--output-format", "concise", ".", cwd=tmp_path)
    assert run.stdout == "rover.service:2:11: warning[systemd/no-tabs] What will happen on the robot\n"


def test_every_page_is_in_the_index() -> None:
    index = (PROJECT / "docs" / "README.md").read_text("utf-8")
    pages = [path.name for path in (PROJECT / "docs").iterdir() if path.suffix in (".md", ".json")]
    assert [name for name in pages if name != "README.md" and f"({name})" not in index] == []


def test_every_layer_is_in_the_map() -> None:
    text = (PROJECT / "CONTRIBUTING.md").read_text("utf-8")
    layers = [path.parent.name for path in (PROJECT / "bringup_lint" / "graph").glob("*/__init__.py")]
    assert [name for name in layers if f"`{name}`" not in text] == []
