"""The language server, asked by a real client over its pipes."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types

from tests.server.conftest import UNIT
from tests.server.conftest import applied
from tests.server.conftest import editing

pytestmark = pytest.mark.slow
"""An editor talks to a server of its own in each; what the server does is tried quickly beside this."""

TOP = types.Range(types.Position(0, 0), types.Position(0, 0))


def run(test: Coroutine[Any, Any, None]) -> None:
    asyncio.run(asyncio.wait_for(test, 120))


def codes(found: list[types.Diagnostic]) -> list[str]:
    return [str(each.code) for each in found]


def test_unsaved_text_is_judged(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            unit = editor.open(robot / "etc/systemd/system/robot.service")
            assert "systemd/network-target" in codes(await editor.pulled(unit))
            editor.write(unit, UNIT.replace("After=network.target\n", ""))
            assert "systemd/network-target" not in codes(await editor.pulled(unit))

    run(test())


def test_an_edit_changes_what_is_found_in_another_file(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            dds = editor.open(robot / "etc/robot/cyclonedds.xml")
            plan = editor.open(robot / "etc/netplan/60-robot.yaml")
            before = codes(await editor.pulled(dds))
            editor.write(plan, "network:\n  version: 2\n  ethernets:\n    enp1s0:\n      dhcp4: true\n")
            found = [each for each in await editor.pulled(dds) if each.code not in before]
            assert codes(found) == ["cyclonedds/interface-not-in-netplan"]
            assert plan in {each.location.uri for each in found[0].related_information or []}

    run(test())


def test_diagnostics_are_pushed_to_an_editor_that_does_not_ask(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot, pull=False) as editor:
            path = robot / "etc/systemd/system/robot.service"
            await editor.pushed(path.as_uri(), "systemd/network-target")
            unit = editor.open(path, UNIT.replace("After=network.target\n", ""))
            await editor.pushed(unit, "systemd/network-target", found=False)

    run(test())


def test_a_diagnostic_says_all_that_a_finding_says(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            unit = editor.open(robot / "etc/systemd/system/robot.service")
            found = next(each for each in await editor.pulled(unit) if each.code == "systemd/network-target")
            assert found.range == types.Range(types.Position(2, 6), types.Position(2, 20))
            assert found.severity is types.DiagnosticSeverity.Warning
            assert found.source == "bringup-lint"
            assert found.code_description and "network-target" in found.code_description.href

    run(test())


EMOJI_LAUNCH = """\
<launch>
  <!-- 🤖 Überall -->
  <node args="ä🤖" pkg="demo" name="driver" type="driver"/>
</launch>
"""


@pytest.mark.parametrize(
    "encoding",
    ["utf-16", "utf-8", "utf-32"],
)
def test_a_quick_fix_changes_the_place_that_is_meant(robot: Path, encoding: str) -> None:
    path = robot / "launch/robot.launch.xml"
    path.parent.mkdir()
    path.write_text(EMOJI_LAUNCH, "utf-8")

    async def test() -> None:
        async with editing(robot, encoding=encoding) as editor:
            file = editor.open(path)
            found = await editor.pulled(file)
            assert codes(found) == ["launch/ros1-construct"]
            actions = await editor.actions(file, found[0].range, types.CodeActionKind.QuickFix)
            fixed = applied(EMOJI_LAUNCH, edits_of(actions[0], file), encoding)
            assert fixed == EMOJI_LAUNCH.replace("type=", "exec=")

    run(test())


def test_all_safe_fixes_at_once(robot: Path) -> None:
    crlf = UNIT.replace("RestartSec=2", "RestartSec=2\nStandardOutput=syslog\nStandardError=syslog").replace(
        "\n", "\r\n"
    )

    async def test() -> None:
        async with editing(robot) as editor:
            unit = editor.open(robot / "etc/systemd/system/robot.service", crlf)
            before = codes(await editor.pulled(unit))
            actions = await editor.actions(unit, TOP, "source.fixAll")
            assert [action.kind for action in actions] == ["source.fixAll.bringup-lint"]
            fixed = applied(crlf, edits_of(actions[0], unit), "utf-16")
            assert fixed.count("\n") == fixed.count("\r\n")
            editor.write(unit, fixed)
            assert len(await editor.pulled(unit)) < len(before)

    run(test())


def edits_of(action: types.CodeAction, uri: str) -> list[types.TextEdit]:
    """The edits of an action, all of which are for one document in its first version."""
    assert action.edit is not None
    edits: list[types.TextEdit] = []
    for document in action.edit.document_changes or []:
        assert isinstance(document, types.TextDocumentEdit)
        assert (document.text_document.uri, document.text_document.version) == (uri, 1)
        edits += (edit for edit in document.edits if isinstance(edit, types.TextEdit))
    return edits


def test_hover_shows_the_rule_and_the_graph(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            unit = editor.open(robot / "etc/systemd/system/robot.service")
            rule = await editor.hovered(unit, 2, 8)
            assert "# systemd/network-target" in rule
            assert "## Why it matters on a robot" in rule
            environment = await editor.hovered(unit, 7, 20)
            assert "env file" in environment
            assert "etc/robot/cyclonedds.xml" in environment

    run(test())


@pytest.mark.parametrize(
    ("file", "word", "target"),
    [
        ("etc/systemd/system/robot.service", "/etc/robot/ros.env", "etc/robot/ros.env"),
        ("etc/robot/ros.env", "/etc/robot/cyclonedds.xml", "etc/robot/cyclonedds.xml"),
        ("etc/robot/cyclonedds.xml", "eth0", "etc/netplan/60-robot.yaml"),
    ],
)
def test_a_word_leads_to_its_definition(robot: Path, file: str, word: str, target: str) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            text = (robot / file).read_text("utf-8")
            uri = editor.open(robot / file)
            before = text[: text.index(word)]
            place = types.Position(before.count("\n"), len(before.rpartition("\n")[2]) + 1)
            found = await editor.text_document_definition_async(
                types.DefinitionParams(types.TextDocumentIdentifier(uri), place)
            )
            assert isinstance(found, (list, tuple))
            assert (robot / target).as_uri() in [each.uri for each in found if isinstance(each, types.Location)]

    run(test())


def test_words_that_name_files_are_links(robot: Path) -> None:
    async def test() -> None:
        async with editing(robot) as editor:
            uri = editor.open(robot / "etc/systemd/system/robot.service")
            links = await editor.text_document_document_link_async(
                types.DocumentLinkParams(types.TextDocumentIdentifier(uri))
            )
            assert [(each.range.start.line, each.target) for each in links or []] == [
                (7, (robot / "etc/robot/ros.env").as_uri())
            ]

    run(test())
