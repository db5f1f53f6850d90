"""Run by an interpreter that has ROS's own launch and launch_ros: say which XML and YAML launch files it loads.

Usage: python launch_grammar_runner.py < QUESTIONS; a JSON list of pairs of a file name and its text. Prints a list with
null for a file that is loaded, else the error in one line. Nothing is started.
"""

from __future__ import annotations

import io
import json
import sys
import types

sys.modules.setdefault("composition_interfaces", types.ModuleType("composition_interfaces"))
services = types.ModuleType("composition_interfaces.srv")
services.LoadNode = type("LoadNode", (), {"Request": object})
sys.modules.setdefault("composition_interfaces.srv", services)
sys.modules["composition_interfaces"].srv = services

import launch_ros.actions  # noqa: E402
import launch_ros.substitutions  # noqa: E402, F401
from launch.frontend import Parser  # noqa: E402
from launch_xml.parser import Parser as XmlParser  # noqa: E402
from launch_yaml.parser import Parser as YamlParser  # noqa: E402

Parser.extensions_loaded = True
Parser.frontend_parsers = {"xml": XmlParser, "yaml": YamlParser}


class Named(io.StringIO):
    name = ""


def verdict(name: str, text: str) -> str | None:
    file = Named(text)
    file.name = name
    try:
        entity, parser = Parser.load(file)
        parser.parse_description(entity)
    except Exception as error:
        return f"{type(error).__name__}: {error}".strip().split("\n")[0][:120]
    return None


json.dump([verdict(*question) for question in json.load(sys.stdin)], sys.stdout)
