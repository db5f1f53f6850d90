"""The functions and macros of CMake files against cmake itself: what they make is what it says that they make."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.parsers import cmake
from bringup_lint.robot import Robot
from bringup_lint.source import Source

needs_cmake = pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")

TOLD = 'function(add_executable)\n  message("made ${ARGV}")\nendfunction()\n'
"""Stands for the command that a script of cmake may not use, and says what it is given."""
SCRIPTS = {
    "function": """
function(node name)
  add_executable(${name} src/${name}.cpp ${ARGN})
endfunction()
node(drive)
node(arm src/joint.cpp src/wrist.cpp)
""",
    "macro": """
macro(node name folder)
  set(sources ${folder}/${name}.cpp)
  add_executable(${name}_node ${sources})
endmacro()
node(drive base)
add_executable(again ${sources})
""",
    "arguments": """
function(node name)
  cmake_parse_arguments(ARG "LIFECYCLE" "FOLDER" "SOURCES;DEPENDS" ${ARGN})
  if(ARG_LIFECYCLE)
    set(unused yes)
  endif()
  add_executable(${name} ${ARG_FOLDER}/main.cpp ${ARG_SOURCES} ${ARG_UNPARSED_ARGUMENTS})
endfunction()
node(drive LIFECYCLE FOLDER base SOURCES a.cpp b.cpp DEPENDS rclcpp)
node(arm SOURCES c.cpp FOLDER arm d.cpp)
node(lamp e.cpp FOLDER lamp LIFECYCLE f.cpp)
""",
    "given-arguments": """
function(node)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "FOLDER" "SOURCES")
  add_executable(${ARGV0} ${ARG_FOLDER}/main.cpp ${ARG_SOURCES})
endfunction()
node(drive FOLDER base SOURCES a.cpp b.cpp)
""",
    "scope": """
set(suffix _node)
function(named name output)
  set(suffix _inner)
  set(${output} ${name}${suffix} PARENT_SCOPE)
endfunction()
named(drive target)
add_executable(${target} drive.cpp)
add_executable(arm${suffix} arm.cpp)
""",
    "quotes": """
function(node name sources)
  add_executable(${name} ${sources} ${ARGN})
endfunction()
set(several a.cpp b.cpp)
node(drive "${several}" c.cpp)
node(arm ${several} c.cpp)
""",
    "nested": """
function(outer name)
  function(inner_${name} file)
    add_executable(inner ${file})
  endfunction()
  foreach(part left right)
    add_executable(${name}_${part} ${part}.cpp)
  endforeach()
endfunction()
OUTER(wheel)
inner_wheel(hub.cpp)
""",
    "left": """
function(node name)
  add_executable(${name} ${name}.cpp)
  return()
endfunction()
node(drive)
node(arm)
""",
}


def _told(script: str, folder: Path) -> list[tuple[str, list[str]]]:
    path = folder / "script.cmake"
    path.write_text(TOLD + script, "utf-8")
    answer = subprocess.run(["cmake", "-P", path], check=True, capture_output=True, text=True).stderr
    made = [line.removeprefix("made ").split(";") for line in answer.splitlines() if line.startswith("made ")]
    return [(name, files) for name, *files in made]


@needs_cmake
@pytest.mark.parametrize("name", SCRIPTS)
def test_functions_make_what_cmake_makes(name: str, tmp_path: Path) -> None:
    build = cmake.parse(Source("CMakeLists.txt", SCRIPTS[name]), "kite")
    assert list(build.targets.items()) == _told(SCRIPTS[name], tmp_path)
    assert build.installs_known
    assert build.executables_known


GLOBS = (
    "GLOB FOUND src/*.cpp",
    "GLOB_RECURSE FOUND src/*.cpp",
    "GLOB_RECURSE FOUND CONFIGURE_DEPENDS src/*.cpp include/*.hpp",
    "GLOB FOUND src/*/*.cpp",
    "GLOB FOUND ${CMAKE_CURRENT_SOURCE_DIR}/src/w?re.cpp",
)


@needs_cmake
@pytest.mark.parametrize("glob", GLOBS)
def test_patterns_find_what_cmake_finds(glob: str, tmp_path: Path) -> None:
    for name in ("src/wire.cpp", "src/arm/joint.cpp", "src/arm/hand/grip.cpp", "src/arm/README", "include/arm/arm.hpp"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    (tmp_path / "CMakeLists.txt").write_text(f"file({glob})\nadd_executable(arm ${{FOUND}})\n", "utf-8")
    script = tmp_path / "script.cmake"
    told_glob = glob.replace(" CONFIGURE_DEPENDS", "")  # no word of a script
    script.write_text(f'{TOLD}file({told_glob})\nadd_executable(arm "${{FOUND}}")\n', "utf-8")
    command = ["cmake", "-P", script]
    answer = subprocess.run(command, check=True, capture_output=True, text=True, cwd=tmp_path).stderr
    told = [path.removeprefix(f"{tmp_path}/") for path in answer.removeprefix("made arm;").strip().split(";")]
    manifest = "<package format='3'><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(manifest, "utf-8")
    robot = Robot(discover([str(tmp_path)]))
    (build,) = robot.launch.workspace.packages["arm"].builds
    assert build.targets == {"arm": [path for path in told if path.endswith(".cpp")]}
