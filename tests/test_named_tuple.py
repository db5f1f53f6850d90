"""Named tuples whose constructor is made late are as Python's own."""

from __future__ import annotations

import copy
import pickle

import pytest

from bringup_lint.named_tuple import NamedTuple
from tests.architecture.imports import paths


class Address(NamedTuple):
    """Where a topic goes."""

    host: str
    port: int = 7400

    @property
    def text(self) -> str:
        return f"{self.host}:{self.port}"


class Local(Address):
    pass


def test_objects_are_as_those_of_typing() -> None:
    one = Address("10.0.0.1")
    assert one == ("10.0.0.1", 7400) == Address(port=7400, host="10.0.0.1")
    assert (one.host, one.port, one.text) == ("10.0.0.1", 7400, "10.0.0.1:7400")
    assert repr(one) == "Address(host='10.0.0.1', port=7400)"
    assert one._replace(port=1) == Address("10.0.0.1", 1)
    assert one._asdict() == {"host": "10.0.0.1", "port": 7400}
    assert Address._make(["a", 2]) == Address("a", 2)
    assert Address._fields == ("host", "port")
    assert Address._field_defaults == {"port": 7400}
    assert Address.__doc__ == "Where a topic goes."
    assert pickle.loads(pickle.dumps(one)) == copy.deepcopy(one) == one
    match one:
        case Address(host, port):
            assert (host, port) == ("10.0.0.1", 7400)


def test_what_is_given_is_checked() -> None:
    with pytest.raises(TypeError):
        Address()  # type: ignore[call-arg]
    with pytest.raises(TypeError):
        Address._make(["a"])
    with pytest.raises(ValueError, match="unexpected field names: \\['road'\\]"):
        Address("a")._replace(road=1)  # type: ignore[call-arg]
    with pytest.raises(AttributeError):
        Address("a").host = "b"  # type: ignore[misc]


def test_a_class_that_extends_another() -> None:
    one = Local("10.0.0.1")
    assert isinstance(one, Local) and one.text == "10.0.0.1:7400"
    assert repr(one._replace(port=1)) == "Local(host='10.0.0.1', port=1)"


def test_the_package_has_no_other_named_tuples() -> None:
    for path in paths():
        text = path.read_text("utf-8")
        if path.name != "named_tuple.py":
            assert "from typing import NamedTuple\n" not in text and "namedtuple(" not in text, path
