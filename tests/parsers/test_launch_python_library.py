"""What the classes of launch and launch_ros stand for in a launch file that is only read."""

from __future__ import annotations

import pytest

from bringup_lint.model.launch import Emit
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import parse
from bringup_lint.source import Source

HEAD = """\
from launch import LaunchDescription
from launch.actions import (EmitEvent, ExecuteProcess, IncludeLaunchDescription, LogInfo, RegisterEventHandler,
    Shutdown)
from launch.conditions import IfCondition, LaunchConfigurationEquals, LaunchConfigurationNotEquals, UnlessCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.events import Shutdown as ShutdownEvent, matches_action
from launch.events.process import ShutdownProcess, SignalProcess
from launch.substitutions import (AllSubstitution, AndSubstitution, AnonName, AnySubstitution, Command,
    EnvironmentVariable, EqualsSubstitution, FindExecutable, IfElseSubstitution, LaunchConfiguration, LaunchLogDir,
    LocalSubstitution, NotEqualsSubstitution, NotSubstitution, OrSubstitution, PathJoinSubstitution, PathSubstitution,
    PythonExpression, StringJoinSubstitution, TextSubstitution, ThisLaunchFile, ThisLaunchFileDir)
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events import matches_node_name
from launch_ros.events.lifecycle import ChangeState
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.substitutions import ExecutableInPackage, FindPackage, FindPackagePrefix, FindPackageShare
from launch.substitutions.launch_configuration import LaunchConfigAsBool
from lifecycle_msgs.msg import Transition
from nav2_common.launch import ReplaceString, RewrittenYaml
from pathlib import Path
import os
from ament_index_python.packages import get_package_share_directory
"""


def described(items: str, before: str = "") -> LaunchFile:
    body = "".join(f"    {line}\n" for line in before.splitlines())
    text = f"{HEAD}\ndef generate_launch_description():\n{body}    return LaunchDescription([{items}])\n"
    return parse(Source("robot.launch.py", text))


def shape(value: Value | None) -> str:
    """A value in one line: what it is of, without places."""
    match value:
        case None:
            return "-"
        case Literal():
            return repr(str(value.value) if isinstance(value.value, str) else value.value)
        case Argument():
            default = f"={shape(value.default)}" if value.default is not None else ""
            return f"{'text of ' if value.performed else ''}{value.name}{default}"
        case Env():
            return f"${value.name}" + (f"={shape(value.default)}" if value.default is not None else "")
        case PackageShare():
            return f"share({shape(value.package)})"
        case PackagePrefix():
            return f"prefix({shape(value.package)})"
        case FileDir():
            return "this file" if value.itself else "this folder"
        case Concat():
            return "+".join(map(shape, value.parts))
        case PathJoin():
            return "/".join(map(shape, value.parts))
        case ListValue():
            return f"[{', '.join(map(shape, value.items))}{', ...' if value.open else ''}]"
        case DictValue():
            return "{" + ", ".join(f"{shape(key)}: {shape(item)}" for key, item in value.items) + "}"
        case Operation():
            return f"{value.name}({', '.join(map(shape, value.operands))})"
        case Choice():
            return " | ".join(shape(option) for _, option in value.options)
        case Command():
            return f"output of {shape(value.command)}"
        case ParameterFile():
            return f"file({shape(value.file)}, {shape(value.allow_substs)})"
        case TypedValue():
            return f"{value.type or '?'}({shape(value.value)})"
        case DerivedFile():
            return f"{value.helper}({shape(value.base)}, {shape(value.rewrites)}, {shape(value.root_key)})"
    return "?"


SUBSTITUTIONS = {
    "LaunchConfiguration('a')": "a",
    "LaunchConfiguration('a', default='b')": "a='b'",
    "LaunchConfiguration(LaunchConfiguration('a'))": "?",
    "LaunchConfigAsBool('a')": "as-bool(a)",
    "LaunchConfigAsBool(LaunchConfiguration('a'))": "?",
    "EnvironmentVariable('HOME', default_value='/root')": "$HOME='/root'",
    "EnvironmentVariable(LaunchConfiguration('a'))": "?",
    "PathJoinSubstitution([FindPackageShare('p'), 'a', 'b'])": "share('p')/'a'/'b'",
    "PathJoinSubstitution([])": "''",
    "PathJoinSubstitution(unknown())": "?",
    "PathSubstitution(FindPackageShare('p')) / 'a'": "share('p')/'a'",
    "FindPackagePrefix('p')": "prefix('p')",
    "FindPackage('p')": "prefix('p')",
    "ExecutableInPackage('e', 'p')": "prefix('p')/'lib'/'p'/'e'",
    "FindExecutable(name='xacro')": "'xacro'",
    "Command(['xacro ', FindPackageShare('p'), '/a.xacro'])": "output of 'xacro '+share('p')+'/a.xacro'",
    "PythonExpression([\"'\", LaunchConfiguration('a'), \"' == 'b'\"])": "python(\"'\"+a+\"' == 'b'\")",
    "AndSubstitution(LaunchConfiguration('a'), 'true')": "and(a, 'true')",
    "OrSubstitution(LaunchConfiguration('a'), 'true')": "or(a, 'true')",
    "NotSubstitution(LaunchConfiguration('a'))": "not(a)",
    "AllSubstitution('true', LaunchConfiguration('a'))": "and('true', a)",
    "AnySubstitution(['true', LaunchConfiguration('a')])": "or('true', a)",
    "EqualsSubstitution(LaunchConfiguration('a'), 'b')": "equals(a, 'b')",
    "NotEqualsSubstitution(LaunchConfiguration('a'), 'b')": "not-equals(a, 'b')",
    "IfElseSubstitution(LaunchConfiguration('a'), if_value='b')": "if(a, 'b', '')",
    "IfElseSubstitution(LaunchConfiguration('a'), 'b', 'c')": "if(a, 'b', 'c')",
    "ThisLaunchFile()": "this file",
    "ThisLaunchFileDir()": "this folder",
    "TextSubstitution(text='a')": "'a'",
    "StringJoinSubstitution(['a', LaunchConfiguration('b')], delimiter='-')": "'a'+'-'+b",
    "StringJoinSubstitution([])": "''",
    "StringJoinSubstitution(unknown())": "?",
    "LaunchLogDir()": "?",
    "AnonName('a')": "?",
    "LocalSubstitution('event.reason')": "?",
    "Path('a').parent": "'.'",
    "Path('a', 'b').parent / 'c'": "'a'/'c'",
    "Path(__file__).parent": "this folder",
    "Path(__file__).parent.parent": "this folder/'..'",
    "Path(get_package_share_directory('p')).joinpath('a').name": "?",
    "os.path.dirname(os.path.realpath(__file__))": "this folder",
    "os.path.basename('a/b.yaml')": "'b.yaml'",
    "os.path.join(LaunchConfiguration('a'), 'b')": "?",
    "os.environ['HOME']": "$HOME",
    "os.getenv('HOME', '/root')": "$HOME='/root'",
    "os.sep": "'/'",
    "'a' + LaunchConfiguration('b')": "'a'+b",
    "unknown().parent": "?",
}


@pytest.mark.parametrize("text", SUBSTITUTIONS)
def test_a_substitution_stands_for(text: str) -> None:
    file = described(f"ExecuteProcess(cmd=[{text}])")
    (process,) = file.actions
    assert isinstance(process, Process)
    assert [shape(word) for word in process.cmd] == [SUBSTITUTIONS[text]]


PARAMETERS = {
    "{'a': LaunchConfiguration('b')}": "{'a': b}",
    "{'a': ['x', LaunchConfiguration('b')]}": "{'a': 'x'+b}",
    "{'a': [1, 2.5, True]}": "{'a': [1, 2.5, True]}",
    "{'a': {'b': 1}}": "{'a': {'b': 1}}",
    "Parameter('a', 5)": "{'a': 5}",
    "ParameterFile(FindPackageShare('p'), allow_substs=True)": "file(share('p'), True)",
    "ParameterFile('a.yaml')": "file('a.yaml', -)",
    "{'a': ParameterValue(LaunchConfiguration('b'), value_type=str)}": "{'a': str(b)}",
    "{'a': ParameterValue(LaunchConfiguration('b'), value_type=unknown())}": "{'a': ?(b)}",
    "RewrittenYaml(source_file='a.yaml', root_key='n', param_rewrites={'b': LaunchConfiguration('c')})": (
        "RewrittenYaml('a.yaml', {'b': c}, 'n')"
    ),
    "ReplaceString(source_file='a.yaml', replacements={'<b>': 'c'})": "ReplaceString('a.yaml', {'<b>': 'c'}, -)",
}


@pytest.mark.parametrize("text", PARAMETERS)
def test_parameters_are(text: str) -> None:
    (node,) = described(f"Node(package='p', executable='e', parameters=[{text}])").actions
    assert [shape(each) for each in node.parameters] == [PARAMETERS[text]]


CONDITIONS = {
    "IfCondition(LaunchConfiguration('a'))": ("a", True),
    "UnlessCondition(LaunchConfiguration('a'))": ("a", False),
    "LaunchConfigurationEquals('a', 'b')": ("==(a, 'b')", True),
    "LaunchConfigurationNotEquals('a', 'b')": ("==(a, 'b')", False),
    "LaunchConfigurationEquals(unknown(), 'b')": ("?", True),
}


@pytest.mark.parametrize("text", CONDITIONS)
def test_a_condition_asks(text: str) -> None:
    (node,) = described(f"Node(package='p', executable='e', condition={text})").actions
    (condition,) = node.conditions
    assert (shape(condition.predicate), condition.wanted) == CONDITIONS[text]


NODE = "n = LifecycleNode(package='p', executable='e', name='n', namespace='')"
CONFIGURE = "transition_id=Transition.TRANSITION_CONFIGURE"
HANDLERS = {
    "OnProcessExit(target_action=n, on_exit=[EmitEvent(event=ShutdownEvent())])": ("OnProcessExit", True, 1),
    "OnProcessExit(n, [EmitEvent(event=ShutdownEvent())])": ("OnProcessExit", True, 1),
    "OnProcessStart(target_action=n, on_start=[Shutdown()])": ("OnProcessStart", True, 1),
    "OnExecutionComplete(target_action=n, on_completion=[Shutdown()])": ("OnExecutionComplete", True, 1),
    "OnShutdown(on_shutdown=[LogInfo(msg='bye')])": ("OnShutdown", False, 1),
    "OnShutdown([LogInfo(msg='bye')])": ("OnShutdown", False, 1),
    "OnProcessIO(on_stdout=lambda event: LogInfo(msg='a'))": ("OnProcessIO", False, 0),
    "OnStateTransition(target_lifecycle_node=n, goal_state='inactive', entities=[Shutdown()])": (
        "OnStateTransition",
        True,
        1,
    ),
    "unknown()": ("", False, 0),
}


@pytest.mark.parametrize("text", HANDLERS)
def test_a_handler_waits_for(text: str) -> None:
    *_, handler = described(f"n, RegisterEventHandler({text})", NODE).actions
    assert isinstance(handler, EventHandler)
    event, has_target, count = HANDLERS[text]
    assert (handler.event, handler.target is not None) == (event, has_target)
    assert len(handler.actions) == count or text.startswith("OnProcessIO")


EMITTED = {
    "EmitEvent(event=ShutdownEvent(reason='a'))": ("shutdown", False, [], "-"),
    "Shutdown()": ("shutdown", False, [], "-"),
    "EmitEvent(event=SignalProcess(signal_number=2, process_matcher=matches_action(n)))": (
        "SignalProcess",
        False,
        [],
        "-",
    ),
    "EmitEvent(event=ShutdownProcess(process_matcher=matches_action(n)))": ("ShutdownProcess", False, [], "-"),
    f"EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(n), {CONFIGURE}))": (
        "change-state",
        True,
        [],
        "'TRANSITION_CONFIGURE'",
    ),
    "EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_node_name('/n'), transition_id=1))": (
        "change-state",
        False,
        ["'/n'"],
        "1",
    ),
    "EmitEvent(event=ChangeState(lifecycle_node_matcher=lambda each: True, transition_id=unknown()))": (
        "change-state",
        False,
        ["?"],
        "?",
    ),
    "EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(unknown()), transition_id=1))": (
        "change-state",
        False,
        ["?"],
        "1",
    ),
    "EmitEvent(event=unknown())": ("", False, [], "-"),
    "LifecycleTransition(lifecycle_node_names=['a', 'b'], transition_ids=[1])": (
        "change-state",
        False,
        ["'a'", "'b'"],
        "-",
    ),
}


@pytest.mark.parametrize("text", EMITTED)
def test_an_event_is(text: str) -> None:
    *_, emit = described(f"n, {text}", NODE).actions
    assert isinstance(emit, Emit)
    names = [shape(name) for name in emit.names]
    assert (emit.event, emit.target is not None, names, shape(emit.transition)) == EMITTED[text]
