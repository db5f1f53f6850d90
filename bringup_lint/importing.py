"""Imports the modules of this program from where they must be.

The importer of Python looks through folders for all forms that a module may have. A small run imports some two hundred
modules, and this search is a fifteenth of its time. Here the file is known, and its byte code is taken when it is of
this file, as Python would. All that is not as expected is left to Python: other packages, archives, byte code that is
elsewhere, optimized or of another version.
"""

from __future__ import annotations

import marshal
import os
import sys
from importlib.machinery import ModuleSpec
from importlib.machinery import SourceFileLoader
from importlib.util import MAGIC_NUMBER

from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import CodeType
    from types import ModuleType

_PACKAGE = f"{__name__.partition('.')[0]}."
_HEADER = 16
"""Bytes before the code in a file of byte code: the version, flags, and the time and size of the source (PEP 552)."""
_LOW = 0xFFFFFFFF
_IS_BESIDE = not sys.flags.optimize and sys.implementation.cache_tag is not None and sys.pycache_prefix is None
"""Whether Python keeps the byte code that it uses in the folder beside a file, under the plain name."""


class Loader(SourceFileLoader):
    """Loads a module from a file, and its byte code from the folder beside it."""

    def get_code(self, fullname: str) -> CodeType | None:
        if not _IS_BESIDE:
            return super().get_code(fullname)
        path = str(self.path)
        folder, _, name = path.rpartition("/")
        try:
            with open(f"{folder}/__pycache__/{name[:-3]}.{sys.implementation.cache_tag}.pyc", "rb") as file:
                data = file.read()
            if data[:_HEADER] == _header(os.stat(path)):
                return marshal.loads(memoryview(data)[_HEADER:])
        except (OSError, ValueError, EOFError, TypeError):
            pass
        return super().get_code(fullname)


def _header(status: os.stat_result) -> bytes:
    """What the byte code of a source begins with when it is of this source."""
    words = (0, int(status.st_mtime), status.st_size)
    return MAGIC_NUMBER + b"".join((word & _LOW).to_bytes(4, "little") for word in words)


class _Finder:
    """Finds the modules of this package; Python asks it first."""

    @staticmethod
    def find_spec(fullname: str, path: Sequence[str] | None, target: ModuleType | None = None) -> ModuleSpec | None:
        if path is None or not fullname.startswith(_PACKAGE):
            return None
        place = f"{path[0]}/{fullname.rpartition('.')[2]}"
        for file, inside in ((f"{place}.py", None), (f"{place}/__init__.py", [place])):
            if os.path.isfile(file):
                spec = ModuleSpec(fullname, Loader(fullname, file), origin=file, is_package=inside is not None)
                spec.submodule_search_locations = inside
                spec.has_location = True
                return spec
        return None


def import_directly() -> None:
    """Import what is still to come without a search."""
    if _Finder not in sys.meta_path:
        sys.meta_path.insert(0, _Finder)
