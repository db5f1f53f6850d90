"""The protocol: which message asks for what. Runs in a thread of its own; what reads files is left to the worker."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Mapping
from typing import TYPE_CHECKING
from typing import BinaryIO
from typing import TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.uris import to_fs_path

from bringup_lint import __version__
from bringup_lint.config import ConfigError
from bringup_lint.server.actions import FIX_ALL
from bringup_lint.server.actions import code_actions
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Document
from bringup_lint.server.analysis import uri_of
from bringup_lint.server.diagnostics import diagnostics
from bringup_lint.server.folder import Folder
from bringup_lint.server.folder import Stale
from bringup_lint.server.hover import hover
from bringup_lint.server.navigation import definition
from bringup_lint.server.navigation import document_links
from bringup_lint.server.publisher import Published
from bringup_lint.server.publisher import Timers
from bringup_lint.server.publisher import result_id
from bringup_lint.server.session import Session

if TYPE_CHECKING:
    from bringup_lint.registry import Registry
    from bringup_lint.server.folder import Known
    from bringup_lint.server.worker import Worker

Answer = TypeVar("Answer")


class Server(LanguageServer):
    """A connection to one editor."""

    def __init__(self, worker: Worker, registry: Registry, known: Known) -> None:
        super().__init__("bringup-lint", __version__)
        self.session = Session(worker, registry, known, self.documents)
        self.published = Published(self.text_document_publish_diagnostics, self.documents)
        self.timers = Timers(self._start)
        self.changed = asyncio.Event()
        self._tasks: set[asyncio.Task[None]] = set()
        self._complaint = ""

    def documents(self) -> dict[str, Document]:
        """What is open in the editor, by its absolute path."""
        shown = self.workspace.text_documents.values()
        return {path: Document(each.uri, each.source, each.version) for each in shown if (path := to_fs_path(each.uri))}

    @property
    def pulls(self) -> bool:
        """Whether the editor asks for diagnostics itself."""
        documents = self.client_capabilities.text_document
        return documents is not None and documents.diagnostic is not None

    def begin(self) -> None:
        """Take the folders and settings that the editor names at its start."""
        workspace = self.workspace
        self.session.encoding = workspace.position_encoding or types.PositionEncodingKind.Utf16
        paths = [path for folder in workspace.folders.values() if (path := to_fs_path(folder.uri))]
        root = to_fs_path(workspace.root_uri) if workspace.root_uri else None
        self.session.add(paths or ([root] if root else []))

    def touch(self, folders: Iterable[Folder]) -> None:
        """Something has changed in these folders: run over them, soon."""
        for folder in folders:
            folder.change()
            self.timers.restart(folder)

    def touch_document(self, uri: str) -> None:
        path = to_fs_path(uri)
        if path:
            self.touch([self.session.folder_of(path)])

    def _start(self, folder: Folder) -> None:
        task = asyncio.ensure_future(self._refresh(folder))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _refresh(self, folder: Folder) -> None:
        found = await self.ask(folder, _all_diagnostics)
        if found is None:
            return
        if not self.pulls:
            self.published.show(folder, found)
        self.changed.set()
        self.changed = asyncio.Event()

    async def ask(self, folder: Folder, question: Callable[[Analysis], Answer]) -> Answer | None:
        """The answer to a question about a folder as it is now; None when there is none. A wrong configuration is
        shown, once."""
        try:
            answer = await self.session.ask(folder, question)
        except Stale:
            return None
        except ConfigError as error:
            self.complain(str(error))
            return None
        self._complaint = ""
        return answer

    def complain(self, message: str) -> None:
        if message != self._complaint:
            self._complaint = message
            self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"bringup-lint: {message}"))


def _all_diagnostics(analysis: Analysis) -> dict[str, list[types.Diagnostic]]:
    return {path: diagnostics(analysis, path) for path in analysis.by_path}


def serve(worker: Worker, registry: Registry, known: Known, stdin: BinaryIO, stdout: BinaryIO) -> None:
    """Talk to an editor until it is done."""
    server = Server(worker, registry, known)
    _lifecycle(server)
    _documents(server)
    _diagnostics(server)
    _questions(server)
    _navigation(server)
    server.start_io(stdin, stdout)


def _lifecycle(server: Server) -> None:
    @server.feature(types.INITIALIZED)
    def initialized(params: types.InitializedParams) -> None:
        server.begin()
        _watch(server)
        server.touch(server.session.all())

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(params: types.DidChangeWorkspaceFoldersParams) -> None:
        gone = [path for folder in params.event.removed if (path := to_fs_path(folder.uri))]
        for path in gone:
            folder = server.session.folders.get(path)
            if folder is not None and not server.pulls:
                server.published.forget(folder)
        server.session.remove(gone)
        server.session.add(path for folder in params.event.added if (path := to_fs_path(folder.uri)))
        server.touch(server.session.all())

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(params: types.DidChangeWatchedFilesParams) -> None:
        paths = [path for change in params.changes if (path := to_fs_path(change.uri))]
        server.touch({server.session.folder_of(path) for path in paths if server.session.is_looked_at(path)})


def _watch(server: Server) -> None:
    """Ask the editor to tell of files that change on the disk, where it can."""
    workspace = server.client_capabilities.workspace
    watched = workspace and workspace.did_change_watched_files
    if not watched or not watched.dynamic_registration:
        return
    options = types.DidChangeWatchedFilesRegistrationOptions(watchers=[types.FileSystemWatcher(glob_pattern="**/*")])
    registration = types.Registration("watched-files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)
    server.client_register_capability(types.RegistrationParams([registration]))


def _documents(server: Server) -> None:
    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(params: types.DidOpenTextDocumentParams) -> None:
        server.touch_document(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(params: types.DidChangeTextDocumentParams) -> None:
        server.touch_document(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(params: types.DidSaveTextDocumentParams) -> None:
        server.touch_document(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: types.DidCloseTextDocumentParams) -> None:
        path = to_fs_path(params.text_document.uri)
        if path and server.session.is_alone(path):
            server.published.forget(server.session.folder_of(path))
            server.session.forget(path)
        else:
            server.touch_document(params.text_document.uri)


def _diagnostics(server: Server) -> None:
    options = types.DiagnosticOptions(
        inter_file_dependencies=True, workspace_diagnostics=True, identifier="bringup-lint"
    )

    @server.feature(types.TEXT_DOCUMENT_DIAGNOSTIC, options)
    async def document(params: types.DocumentDiagnosticParams) -> types.DocumentDiagnosticReport:
        path = to_fs_path(params.text_document.uri) or ""
        folder = server.session.folder_of(path)
        items = await server.ask(folder, lambda analysis: diagnostics(analysis, path)) or []
        now = result_id(items)
        if now == params.previous_result_id:
            return types.RelatedUnchangedDocumentDiagnosticReport(now)
        return types.RelatedFullDocumentDiagnosticReport(items, result_id=now)

    @server.feature(types.WORKSPACE_DIAGNOSTIC)
    async def everywhere(params: types.WorkspaceDiagnosticParams) -> types.WorkspaceDiagnosticReport:
        before = {each.uri: each.value for each in params.previous_result_ids}
        reports = await _reports(server, before)
        if before and not reports:
            await server.changed.wait()
            reports = await _reports(server, before)
        return types.WorkspaceDiagnosticReport(reports)


async def _reports(server: Server, before: Mapping[str, str]) -> list[types.WorkspaceDocumentDiagnosticReport]:
    """What is found now in all files, of which the editor does not know it yet."""
    found: dict[str, list[types.Diagnostic]] = {}
    for folder in server.session.all():
        found |= await server.ask(folder, _all_diagnostics) or {}
    shown = server.documents()
    uris = {path: shown[path].uri if path in shown else uri_of(path) for path in found}
    uris |= {path: uri for uri in before if (path := to_fs_path(uri))}
    reports: list[types.WorkspaceDocumentDiagnosticReport] = []
    for path, uri in sorted(uris.items()):
        items = found.get(path, [])
        now = result_id(items)
        if now != before.get(uri):
            version = shown[path].version if path in shown else None
            reports.append(types.WorkspaceFullDocumentDiagnosticReport(uri, items, version, result_id=now))
    return reports


def _questions(server: Server) -> None:
    kinds = [types.CodeActionKind.QuickFix, FIX_ALL]

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=kinds))
    async def actions(params: types.CodeActionParams) -> list[types.CodeAction]:
        folder = server.session.folder_of(to_fs_path(params.text_document.uri) or "")
        return await server.ask(folder, lambda analysis: code_actions(analysis, params)) or []

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hovered(params: types.HoverParams) -> types.Hover | None:
        path = to_fs_path(params.text_document.uri) or ""
        return await server.ask(server.session.folder_of(path), lambda analysis: hover(analysis, path, params.position))


def _navigation(server: Server) -> None:
    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def defined(params: types.DefinitionParams) -> list[types.Location]:
        path = to_fs_path(params.text_document.uri) or ""
        folder = server.session.folder_of(path)
        return await server.ask(folder, lambda analysis: definition(analysis, path, params.position)) or []

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def links(params: types.DocumentLinkParams) -> list[types.DocumentLink]:
        path = to_fs_path(params.text_document.uri) or ""
        return await server.ask(server.session.folder_of(path), lambda analysis: document_links(analysis, path)) or []


def standard_streams() -> tuple[BinaryIO, BinaryIO]:
    """The streams of the protocol. What anything prints from now on goes to standard error."""
    stdin, stdout = sys.stdin.buffer, sys.stdout.buffer
    sys.stdout = sys.stderr
    return stdin, stdout
