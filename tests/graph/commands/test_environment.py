"""What a script leaves in a variable is what bash leaves there, or is not known: never something else."""

from __future__ import annotations

import shlex
import shutil
import subprocess

import pytest

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.environment import after_commands
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.source import Located
from bringup_lint.source import Source

BASH = shutil.which("bash")
NAMES = ("A", "B", "C")
SCRIPTS = [
    "A=1",
    "A='$HOME/x'",
    'A="$HOME/x"',
    'A="${HOME}/x"',
    "A=\\$HOME",
    'A="\\$HOME"',
    "A=${B:-x}",
    "A=${B-x}",
    "B=$(echo 5); A=${B:-9}",
    'B=1; [ -z "$HOME" ] || unset B; A=${B:-9}',
    'B=1; if [ -n "$HOME" ]; then unset B; fi; A=${B-9}',
    "A=${B:+x}",
    "B=;A=${B:-x}",
    "B=;A=${B-x}",
    "A=${HOME#/}",
    "A=${HOME##*/}",
    "A=${HOME/h/g}",
    "A=${#HOME}",
    "A=${HOME:1}",
    "A=${HOME^^}",
    "A=$((1+2))",
    "A=$(echo x)",
    "A=`echo x`",
    "A=x B=$A",
    "A=x; B=$A; A=y",
    "A=x export B=$A",
    "export A=x B=$A",
    "export A=x; unset A",
    "declare -x A=5",
    "declare -i A=5+3",
    "readonly A=5",
    "A=1; A+=2",
    "export A=1; export A+=2",
    "A=~/x",
    'A="~/x"',
    "A=x:~/y",
    "if true; then A=1; fi",
    "if false; then A=1; else A=2; fi",
    "A=1; if true; then A=2; fi",
    "true && A=1",
    "false && A=1",
    "false || A=1",
    "(A=1)",
    "A=1; (A=2)",
    "A=1 true",
    "A=1; { A=2; }",
    "f() { A=1; }; f",
    "f() { local A=1; }; f; A=2",
    "A=1; f() { A=2; }",
    "A=1 ; A=2 | cat",
    "A=1; echo x | read A",
    "read A <<< x",
    'read -r A B <<< "x y"',
    "printf -v A x",
    'A="x y"; B=$A',
    "A='x'\"y\"z",
    'A="a\'b"',
    'A="a\\"b"',
    'A="a\\nb"',
    "A=a\\\nb",
    'A="a\\\nb"',
    "A= B=2",
    "unset HOME; A=${HOME:-x}",
    "set -- x y; A=$1",
    "A=$0",
    "A=$?",
    "A=${B:-$HOME}",
    "A=${B:-${HOME}}",
    'A="${B:-a b}"',
    "A=${B:-'x'}",
    'A=${B:-"x"}',
    'B=x; A="$B-$B_$B"',
    "A=$HOME$HOME",
    "A=$UNSET",
    'A="x${UNSET}y"',
    "export A; A=5",
    "A=5; export A",
    "export -n A=5",
    "unset -v HOME; A=$HOME",
    "A=1 B=2 C=3",
    'A="$(pwd)"',
    "A=1;B=2",
    "A=1 # comment",
    "A=1# no comment",
    'A="#x"',
    "A=${HOME}#x",
    "let A=5",
    "A=*",
    "A=$HOME/*.x",
    "A={a,b}",
    "export A={a,b}",
    "case x in x) A=1;; esac",
    "while false; do A=1; done",
    "eval A=5",
    "source /dev/null; A=1",
    "A=1; unset -f A",
    "typeset A=3",
    "A=1; declare A",
    'export "A=1"',
    "export A=\"1\" 'B=2'",
    "X=A; export $X=5",
    "X=A; declare $X=5",
    "B=' x '; A=$B; C=\"$B\"",
    "A=1 env true",
    'A="${HOME}"\'$HOME\'"$HOME"',
    'A=$"x"',
    "A=x=y",
    "A==x",
]


def read(script: str) -> Environment:
    source = Source("start.sh", script)
    before = Environment()
    before.set(Variable("HOME", Located("/h", source.whole), "/h", "test"))
    return after_commands(before, shell_commands(source), lambda path: True)


def run(script: str) -> dict[str, str]:
    """The variables that bash has after a script."""
    assert BASH is not None
    command = [BASH, "--norc", "--noprofile", "-c", f"{script}\nset -o posix\nset"]
    done = subprocess.run(command, env={"HOME": "/h"}, capture_output=True, text=True, check=False)
    pairs = (line.partition("=") for line in done.stdout.splitlines())
    return {name: "".join(shlex.split(value)) for name, _, value in pairs if name in NAMES}


@pytest.mark.skipif(BASH is None, reason="needs bash")
@pytest.mark.parametrize("script", SCRIPTS)
def test_a_variable_is_that_of_bash_or_not_known(script: str) -> None:
    found, expected = read(script), run(script)
    for name in NAMES:
        text = found.text(name)
        assert text is None or text == expected.get(name), name
        assert name not in expected or found.defines(name) is not False, name


def test_most_variables_are_known() -> None:
    unknown = [script for script in SCRIPTS if all(read(script).text(name) is None for name in NAMES)]
    assert len(unknown) <= len(SCRIPTS) / 2, unknown
