"""A comment that silences a finding leaves every value of its file as it was, on whatever line the finding is."""

from __future__ import annotations

import ast
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable

import pytest
import yaml

from bringup_lint.fix import rewritten
from bringup_lint.parsers.env_file import parse as parse_environment
from bringup_lint.source import Source
from bringup_lint.suppress.comments import read
from bringup_lint.suppress.placing import comments
from bringup_lint.suppress.unbroken import unbroken
from tests.growth import is_linear

LONG = "".join(f"        ros2 run rover part_{number}\n" for number in range(700))
YAML = f"""%YAML 1.1
---
services:
  rover:
    command: |
{LONG}
        # a comment of the shell
        exec ros2 launch rover
    folded: >-
      one

      # no comment
      two
    plain: one
      two
      three
    double: "one
      # no comment
      two \\
      three"
    single: 'one

      two'
    ? |
      key
    : [one, "two
      three",
      # a comment
      four]
    - wrong
"""
YAML_OK = YAML.replace("    - wrong\n", "    tagged: !!str |2-\n        one\n      two\n")
PYTHON = '''#!/usr/bin/env python3
# coding: utf-8
"""What it is.

# no comment
"""
from __future__ import annotations

A = """one
# no comment
""" + f"""
two {"three"}
""" + \\
    "four"
B = ["one",
     "two"]
'''
XML = """<?xml version="1.0"
  encoding="UTF-8"?>
<!-- one
  two -->
<launch>
  <node pkg="a"
    exec="b > c"
    name='d'/>
  <![CDATA[
    <one>

    two]]>
  <arg name="x">
    one

    two
  </arg> <arg name="y"
    default="1"/>
  <?rover one
    two?>
</launch>
"""
SHELL = """#!/bin/bash
cat <<EOF
one
# no comment
EOF
cat <<-'EOF' <<END
\ttwo
\tEOF
three
END
echo "four
# no comment
five" 'six
# no comment' \\
  seven
echo "$(echo eight
  echo nine)"
cat <<EOF
ten
"""
ENVIRONMENT = 'A="one\n# no comment\ntwo"\nB=one \\\n  two\n# comment \\\n goes on\nC=three\n'
JINJA = "{% if x %}\nservices:\n  a:\n    command: |\n" + LONG + "    b: 1\n{% endif %}\n"


def values_of_xml(text: str) -> str:
    return ElementTree.canonicalize(text, with_comments=False, strip_text=True)


def bash(text: str) -> str:
    if shutil.which("bash") is None:
        pytest.skip("bash is not installed")
    run = subprocess.run(["bash"], input=text, capture_output=True, text=True, check=True)
    return run.stdout


def values_of_environment(text: str) -> list[tuple[str, str]]:
    return [(str(each.name), str(each.value)) for each in parse_environment(Source("x.env", text)).entries]


def block_of(text: str) -> str:
    """The block scalar of a template: what is further to the right than its key."""
    return "".join(line for line in text.splitlines(keepends=True) if line.startswith("      "))


def loaded(text: str) -> object:
    return yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))


CASES: list[tuple[str, str, Callable[[str], object]]] = [
    ("compose", YAML_OK, loaded),
    ("ansible-vars", YAML_OK, loaded),
    ("launch-python", PYTHON, lambda text: ast.dump(ast.parse(text))),
    ("launch-xml", XML, values_of_xml),
    ("shell-script", SHELL, bash),
    ("env-file", ENVIRONMENT, values_of_environment),
    ("compose", JINJA, block_of),
]


def written(kind: str, text: str, line: int) -> str:
    source = Source("x", text, kind)
    start = source.line_starts[line - 1]
    return rewritten(text, comments(source, [(source.span(start, start + 1), "a/b")], "why"))


def tried(text: str) -> list[int]:
    """All lines but those in the middle of the long one."""
    return [line for line in range(1, text.count("\n") + 1) if line < 80 or line > 690]


@pytest.mark.parametrize(("kind", "text", "values"), CASES)
def test_values_stay(kind: str, text: str, values: Callable[[str], object]) -> None:
    before = values(text)
    for line in tried(text):
        assert values(written(kind, text, line)) == before, line


@pytest.mark.parametrize(("kind", "text", "values"), CASES)
def test_the_comment_counts_for_its_line(kind: str, text: str, values: Callable[[str], object]) -> None:
    for line in tried(text):
        (ignore,) = read(Source("x", written(kind, text, line), kind))
        comment = ignore.name.line
        assert ignore.lines is not None
        assert (line + 1 if comment <= line else line) in ignore.lines, line


@pytest.mark.parametrize(
    ("kind", "text", "groups"),
    [
        ("cpp-node", 'a;\nauto b = R"x(one\n)"\n)x";\n// /*\nc = "/*";\n/* one\ntwo */\n', [(2, 4), (7, 8)]),
        (
            "cmake",
            'set(a "one\ntwo")\n#[[ one\ntwo ]]\nset(b [=[\n]]\n]=])\n# "\nset(c\n  d)\n',
            [(1, 2), (3, 4), (5, 7)],
        ),
        ("systemd-unit", "[A]\nB=1 \\\n# no end \\\n  2\n# end \\\nC=1\n", [(2, 4)]),
        ("compose", YAML, [(5, 708)]),
        ("launch-python", "def broken(:\n", []),
    ],
)
def test_groups(kind: str, text: str, groups: list[tuple[int, int]]) -> None:
    found = unbroken(Source("x", text, kind))
    assert list(zip(found.firsts, found.lasts))[: len(groups)] == groups


@pytest.mark.parametrize("first", ["# escape=`", "# check=skip=all", "# syntax=docker/dockerfile:1"])
def test_directives_of_a_dockerfile_stay_first(first: str) -> None:
    assert written("dockerfile", f"{first}\nFROM ros:jazzy\n", 1).startswith(first)


def test_the_line_of_a_template_stays_first() -> None:
    text = "## template: jinja\n#cloud-config\nusers: []\n"
    assert written("cloud-init", text, 3).startswith("## template: jinja\n#cloud-config\n# bringup-lint:")


@pytest.mark.parametrize(
    "unit", ["a: |\n", '"\n', "'", "<a '", "<!--", "<![CDATA[", "<<E\n", 'R"(', "/*", "#[[", "\\\n", "- |\n  a\n"]
)
@pytest.mark.parametrize(
    "kind", ["compose", "launch-xml", "shell-script", "env-file", "cpp-node", "cmake", "launch-python"]
)
def test_hostile_files_take_linear_time(unit: str, kind: str) -> None:
    assert is_linear(lambda size: unbroken(Source("x", unit * size + str(size), kind)), 500)
