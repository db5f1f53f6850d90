"""What comes after ``--ros-args`` against rcl, through rclpy."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from bringup_lint.parsers.ros_arguments import FLAGS
from bringup_lint.parsers.ros_arguments import SWITCHES
from bringup_lint.parsers.ros_arguments import problems
from bringup_lint.source import Located
from bringup_lint.source import Source
from tests.oracles.answers import Oracle
from tests.oracles.ros_python import rclpy

REMAPS = """
foo:=bar /foo:=/bar ~/foo:=bar foo:=~/bar foo:= :=bar foo foo:bar := foo:=bar:=baz n:foo:=bar /n:foo:=bar n/m:foo:=bar
rosservice://foo:=bar rostopic:///foo:=/bar rostopic://foo:=bar rosservice:foo:=bar __ns:=/foo __ns:=foo __ns:= __ns:=/
__ns:=/foo/ __ns:=/a/b __ns:=~/x __node:=abc __node:=a/b __node:= __name:=abc __name:=/abc __name:=1abc n:__node:=abc
n:__ns:=/x __foo:=bar foo__bar:=x foo:=x__y foo/:=bar foo:=bar/ foo//x:=bar /:=bar foo:=/ ~:=bar foo:=~ *:=bar **:=bar
*/foo:=bar foo-bar:=x foo:=b-c 1foo:=bar foo:=1bar foo/1b:=c {node}/a:=b foo:={node} foo.x:=y foo:=x.y _foo:=bar
foo:=_bar __:=a _:=a foo_:=b rosparam://a:=b a:b:c:=d ns:=/x __log:=x __params:=f
""".split()
PARAMETERS = """
foo:=1 foo:=bar foo foo:= :=1 n:foo:=1 /n:foo:=1 foo.bar:=1 foo/bar:=1 foo:=[1,2] foo:=[1,a] foo:={a:1} foo.:=1 .foo:=1
foo..bar:=1 /foo:=1 foo:=1:=2 foo-bar:=1 1foo:=1 foo:=[1 foo:='a foo:=true foo:=[] **:foo:=1 *:foo:=1 n/m:foo:=1 foo=1
foo:1 foo:="" ~foo:=1 foo.1bar:=1 _foo:=1 foo:=null foo:=~ foo:=& foo:=a:b a.b.c:=x n:a.b:=x foo:=2024-01-01 foo:=0x1F
foo:=.5 foo:=-1 foo:=[[1],[2]]
""".split()
LEVELS = "debug DEBUG info warn warning error fatal unset foo n:=debug n:=foo n.m:=info n:debug :=debug n:= a/b:=info"
OTHERS = [
    ["--ros-args"],
    ["--ros-args", "-p", "foo:=a b"],
    ["--ros-args", "-p", "foo:={a: 1}"],
    ["--ros-args", "-p", "foo:=[1, 2.0]"],
    ["--ros-args", "-p", "foo: =1"],
    ["--ros-args", "-r", "foo :=bar"],
    ["--ros-args", "-r a:=b"],
    ["--ros-args", "--loglevel", "debug"],
    ["--ros-args", "--enable-rosout-log"],
    ["--ros-args", "__ns:=/x"],
    ["--ros-args", "-r", "a:=b", "--", "x"],
    ["--", "--ros-args", "-r"],
    ["--ros-args", "--", "--ros-args", "-p", "a:=1"],
    ["x", "-r", "y"],
    ["--ros-args", "--log-level", "info", "debug"],
    ["--ros-args", "--", "--"],
    ["--ros-args", "-r", "__ns:=/a", "-r", "__node:=b"],
    ["--ros-args", "--enclave", "/a/b"],
]


def questions() -> list[list[str]]:
    rules = [("-r", REMAPS), ("--remap", REMAPS[:8]), ("-p", PARAMETERS), ("--param", PARAMETERS[:8])]
    found = [["--ros-args", flag, word] for flag, words in [*rules, ("--log-level", LEVELS.split())] for word in words]
    found += [["--ros-args", flag] for flag in (*FLAGS, *SWITCHES)]
    return found + OTHERS


def reference(asked: list[list[str]], folder: Path) -> list[str | None]:
    environment = {**os.environ, "ROS_LOG_DIR": str(folder)}
    command = [sys.executable, str(Path(__file__).parent / "ros_arguments_runner.py")]
    run = subprocess.run(command, input=json.dumps(asked), capture_output=True, text=True, env=environment, check=False)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout.strip().split("\n")[-1])


def refused(words: list[str]) -> bool:
    source = Source("command", " ".join(words))
    return any(problems([Located(word, source.whole) for word in words]))


def test_refused_as_by_rcl(answers: Oracle, tmp_path: Path) -> None:
    given = answers.of("rcl/arguments", rclpy(), questions(), lambda asked: reference(asked, tmp_path))
    assert [words for words, error in given.pairs if refused(words) is (error is None)] == []
