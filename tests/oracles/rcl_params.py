"""A process of its own that asks the real parser: cases as JSON on stdin, what it makes of them as JSON on stdout.

Two ways in: ``table`` calls rcl_yaml_param_parser's library and gives its whole table; ``node`` starts an rclpy node
with ``--params-file`` and gives the parameters that arrive.
"""

from __future__ import annotations

import ctypes
import json
import os
import sys
import tempfile
from ctypes import POINTER
from ctypes import c_bool
from ctypes import c_char_p
from ctypes import c_double
from ctypes import c_int64
from ctypes import c_size_t
from ctypes import c_void_p


class Allocator(ctypes.Structure):
    _fields_ = [(name, c_void_p) for name in ("allocate", "deallocate", "reallocate", "zero_allocate", "state")]


def array_of(type_: type) -> type:
    return type("Array", (ctypes.Structure,), {"_fields_": [("values", POINTER(type_)), ("size", c_size_t)]})


class Strings(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("data", POINTER(c_char_p)), ("allocator", Allocator)]


class Variant(ctypes.Structure):
    _fields_ = [
        ("bool", POINTER(c_bool)),
        ("integer", POINTER(c_int64)),
        ("double", POINTER(c_double)),
        ("string", c_char_p),
        ("byte_array", c_void_p),
        ("bool_array", POINTER(array_of(c_bool))),
        ("integer_array", POINTER(array_of(c_int64))),
        ("double_array", POINTER(array_of(c_double))),
        ("string_array", POINTER(Strings)),
    ]

    def value(self) -> list:
        for name in ("bool", "integer", "double"):
            if getattr(self, name):
                return [name, shown(getattr(self, name).contents.value)]
        if self.string is not None:
            return ["string", self.string.decode()]
        for name in ("bool_array", "integer_array", "double_array"):
            if getattr(self, name):
                array = getattr(self, name).contents
                return [name, [shown(array.values[at]) for at in range(array.size)]]
        if self.string_array:
            strings = self.string_array.contents
            return ["string_array", [strings.data[at].decode() for at in range(strings.size)]]
        return ["not_set", None]


class NodeParameters(ctypes.Structure):
    _fields_ = [
        ("names", POINTER(c_char_p)),
        ("values", POINTER(Variant)),
        ("count", c_size_t),
        ("capacity", c_size_t),
    ]


class Parameters(ctypes.Structure):
    _fields_ = [
        ("nodes", POINTER(c_char_p)),
        ("parameters", POINTER(NodeParameters)),
        ("count", c_size_t),
        ("capacity", c_size_t),
        ("allocator", Allocator),
    ]


def shown(value: object) -> object:
    """JSON has no infinity and mixes up 1 and 1.0: numbers go as their text."""
    return repr(value) if isinstance(value, float) else value


def table(library: ctypes.CDLL, allocator: Allocator, path: str) -> dict | None:
    """Node key -> list of (name, type, value); None when the file is refused."""
    parameters = library.rcl_yaml_node_struct_init(allocator)
    try:
        if not library.rcl_parse_yaml_file(path.encode(), parameters):
            return None
        found = parameters.contents
        nodes = {}
        for at in range(found.count):
            node = found.parameters[at]
            nodes[found.nodes[at].decode()] = [
                [node.names[each].decode(), *node.values[each].value()] for each in range(node.count)
            ]
        return nodes
    finally:
        library.rcutils_reset_error()
        library.rcl_yaml_node_struct_fini(parameters)


def load() -> tuple[ctypes.CDLL, Allocator]:
    import rclpy  # noqa: F401 - its import loads the libraries of the wheel

    name = "librcl_yaml_param_parser.so"
    with open("/proc/self/maps") as maps:
        path = next(line.split()[-1] for line in maps if name in line)
    library = ctypes.CDLL(path)
    utilities = ctypes.CDLL(os.path.join(os.path.dirname(path), "librcutils.so"))
    utilities.rcutils_get_default_allocator.restype = Allocator
    library.rcutils_reset_error = utilities.rcutils_reset_error
    library.rcl_yaml_node_struct_init.restype = POINTER(Parameters)
    library.rcl_yaml_node_struct_init.argtypes = [Allocator]
    library.rcl_yaml_node_struct_fini.argtypes = [POINTER(Parameters)]
    library.rcl_parse_yaml_file.restype = c_bool
    library.rcl_parse_yaml_file.argtypes = [c_char_p, POINTER(Parameters)]
    return library, utilities.rcutils_get_default_allocator()


def started(path: str, name: str, namespace: str) -> dict | str:
    """Parameter -> (type, value) of a real node; ``refused`` when rcl does not take the file, ``not set`` when a
    parameter without a value stops the node."""
    import rclpy
    from rclpy.context import Context
    from rclpy.node import Node

    context = Context()
    try:
        rclpy.init(args=["--ros-args", "--params-file", path], context=context)
    except Exception:
        return "refused"
    try:
        node = Node(
            name,
            namespace=namespace,
            context=context,
            automatically_declare_parameters_from_overrides=True,
            allow_undeclared_parameters=True,
            start_parameter_services=False,
            enable_rosout=False,
        )
        found = {key: described(each) for key, each in node._parameters.items()}
        node.destroy_node()
        return found
    except ValueError:
        return "not set"
    finally:
        context.shutdown()


def described(parameter) -> list:
    value = parameter.value
    value = list(value) if not isinstance(value, (str, bool, int, float)) else value
    shape = [shown(each) for each in value] if isinstance(value, list) else shown(value)
    return [parameter.type_.name.lower(), shape]


def main() -> None:
    answers = []
    out, sys.stdout = sys.stdout, sys.stderr
    library, allocator = load()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.yaml")
        for case in json.load(sys.stdin):
            with open(path, "wb") as file:
                file.write(case["text"].encode("utf-8", "surrogateescape"))
            if "node" in case:
                answers.append(started(path, *case["node"]))
            else:
                answers.append(table(library, allocator, path))
    json.dump(answers, out)


if __name__ == "__main__":
    main()
