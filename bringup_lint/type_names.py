"""The names of ``typing`` that the modules of every run need, without ``typing``, which takes as long to import as
forty of these. Annotations are not evaluated, so that most names need not mean anything. Type checkers see the real
ones."""

from __future__ import annotations

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import Any as Any
    from typing import AnyStr as AnyStr
    from typing import BinaryIO as BinaryIO
    from typing import Generic as Generic
    from typing import Literal as Literal
    from typing import TypeVar as TypeVar
    from typing import cast as cast
else:
    Any = AnyStr = BinaryIO = object

    class Generic:
        """A class of some type: ``Generic[Value]``."""

        def __class_getitem__(cls, _):
            return cls

    class Literal(Generic):
        """One of some values: ``Literal["one", "other"]``."""

    def TypeVar(name, **_):
        return object

    def cast(kind, value):
        return value
