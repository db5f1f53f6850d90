"""Run by an interpreter that has ROS's own launch and launch_ros: say which launch files it loads.

Usage: python launch_grammar_runner.py < QUESTIONS; a JSON list of pairs of a file name and its text. Prints a list with
null for a file that is loaded, else the error in one line. A Python file is run for its description. Nothing is
started.
"""

from __future__ import annotations

import io
import json
import re
import sys
import tempfile
import types
from pathlib import Path

sys.modules.setdefault("composition_interfaces", types.ModuleType("composition_interfaces"))
services = types.ModuleType("composition_interfaces.srv")
services.LoadNode = type("LoadNode", (), {"Request": object})
sys.modules.setdefault("composition_interfaces.srv", services)
sys.modules["composition_interfaces"].srv = services

import launch_ros.actions  # noqa: E402
import launch_ros.substitutions  # noqa: E402, F401
from launch.frontend import Parser  # noqa: E402
from launch.launch_description_sources import get_launch_description_from_python_launch_file  # noqa: E402
from launch_xml.parser import Parser as XmlParser  # noqa: E402
from launch_yaml.parser import Parser as YamlParser  # noqa: E402

Parser.extensions_loaded = True
Parser.frontend_parsers = {"xml": XmlParser, "yaml": YamlParser}


class Named(io.StringIO):
    name = ""


def verdict(name: str, text: str) -> str | None:
    try:
        described(text) if name.endswith(".py") else parsed(name, text)
    except Exception as error:
        said = f"{type(error).__name__}: {error}".strip().split("\n")[0]
        return re.sub(r" \(/[^)]*\)", "", said)[:120]
    return None


def parsed(name: str, text: str) -> None:
    file = Named(text)
    file.name = name
    entity, parser = Parser.load(file)
    parser.parse_description(entity)


def described(text: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "a.launch.py")
        file.write_text(text, "utf-8")
        get_launch_description_from_python_launch_file(str(file))


json.dump([verdict(*question) for question in json.load(sys.stdin)], sys.stdout)
