"""A real client that starts the command and talks to it over standard input and output."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator
from collections.abc import Iterable
from collections.abc import Mapping
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from lsprotocol import types
from pytest_lsp import LanguageClient

from tests.conftest import PROJECT

NETPLAN = "network:\n  version: 2\n  ethernets:\n    eth0:\n      dhcp4: true\n"
UNIT = """\
[Unit]
Description=Robot
After=network.target

[Service]
Type=simple
User=robot
EnvironmentFile=/etc/robot/ros.env
ExecStart=/opt/ros/jazzy/bin/ros2 launch robot_bringup robot.launch.py
Restart=on-failure
RestartSec=2

[Install]
WantedBy=multi-user.target
"""
FILES = {
    "etc/netplan/60-robot.yaml": NETPLAN,
    "etc/systemd/system/robot.service": UNIT,
    "etc/robot/ros.env": "ROS_DOMAIN_ID=7\nCYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml\n",
    "etc/robot/cyclonedds.xml": (
        '<CycloneDDS xmlns="https://cdds.io/config">\n  <Domain Id="any">\n    <General>\n      <Interfaces>\n'
        '        <NetworkInterface name="eth0"/>\n'
        "      </Interfaces>\n    </General>\n  </Domain>\n</CycloneDDS>\n"
    ),
}


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """A small robot in a folder with blanks and an umlaut in its name, to be encoded in URIs."""
    folder = tmp_path / "mein Röboter"
    for name, text in FILES.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    (folder / ".git").mkdir()
    return folder


class Editor(LanguageClient):
    """The client, and what a user does with it."""

    def __init__(self) -> None:
        super().__init__()
        self.versions: dict[str, int] = {}

        @self.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def receive(params: types.PublishDiagnosticsParams) -> None:
            self.diagnostics[params.uri] = params.diagnostics

    def open(self, path: Path, text: str | None = None) -> str:
        uri = path.as_uri()
        shown = path.read_text("utf-8") if text is None else text
        self.versions[uri] = 1
        self.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "plaintext", 1, shown)))
        return uri

    def write(self, uri: str, text: str) -> None:
        self.versions[uri] += 1
        self.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.versions[uri], uri),
                [types.TextDocumentContentChangeWholeDocument(text)],
            )
        )

    def kill(self) -> None:
        """End a server that has not ended by itself."""
        if self._server is not None and self._server.returncode is None:
            self._server.kill()

    async def pushed(self, uri: str, code: str, found: bool = True) -> None:
        """Wait until the diagnostics that were pushed for a document have this code, or have it no more."""
        while uri not in self.diagnostics or (code in {each.code for each in self.diagnostics[uri]}) is not found:
            await asyncio.sleep(0.02)

    async def pulled(self, uri: str) -> list[types.Diagnostic]:
        report = await self.text_document_diagnostic_async(
            types.DocumentDiagnosticParams(types.TextDocumentIdentifier(uri))
        )
        assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
        return list(report.items)

    async def actions(self, uri: str, where: types.Range, *only: str) -> list[types.CodeAction]:
        context = types.CodeActionContext([], only=list(only) or None)
        answer = await self.text_document_code_action_async(
            types.CodeActionParams(types.TextDocumentIdentifier(uri), where, context)
        )
        return [each for each in answer or [] if isinstance(each, types.CodeAction)]

    async def hovered(self, uri: str, line: int, character: int) -> str:
        answer = await self.text_document_hover_async(
            types.HoverParams(types.TextDocumentIdentifier(uri), types.Position(line, character))
        )
        if answer is None:
            return ""
        assert isinstance(answer.contents, types.MarkupContent)
        return answer.contents.value


@asynccontextmanager
async def editing(
    *folders: Path, pull: bool = True, encoding: str = "utf-16", options: Mapping[str, object] | None = None
) -> AsyncIterator[Editor]:
    """An editor with these folders in its workspace, as long as the block runs."""
    editor = Editor()
    await editor.start_io(sys.executable, "-m", "bringup_lint", "server", cwd=PROJECT)
    documents = types.TextDocumentClientCapabilities(diagnostic=types.DiagnosticClientCapabilities() if pull else None)
    try:
        await editor.initialize_session(
            types.InitializeParams(
                capabilities=types.ClientCapabilities(
                    text_document=documents,
                    general=types.GeneralClientCapabilities(position_encodings=[types.PositionEncodingKind(encoding)]),
                ),
                initialization_options=dict(options or {}),
                workspace_folders=[types.WorkspaceFolder(folder.as_uri(), folder.name) for folder in folders],
            )
        )
        yield editor
        await editor.shutdown_session()
    finally:
        editor.kill()
        await editor.stop()


def applied(text: str, edits: Iterable[types.TextEdit], encoding: str) -> str:
    """The text as an editor changes it that keeps its lines in this encoding."""
    codec = {"utf-8": "utf-8", "utf-16": "utf-16-le", "utf-32": "utf-32-le"}[encoding]
    size = {"utf-8": 1, "utf-16": 2, "utf-32": 4}[encoding]
    lines = [line.encode(codec) for line in text.splitlines(keepends=True)] + [b""]
    data = b"".join(lines)

    def place(at: types.Position) -> int:
        return len(b"".join(lines[: at.line])) + at.character * size

    for edit in sorted(edits, key=lambda edit: (edit.range.start.line, edit.range.start.character), reverse=True):
        data = data[: place(edit.range.start)] + edit.new_text.encode(codec) + data[place(edit.range.end) :]
    return data.decode(codec)
