"""Functions, macros and included files of CMakeLists.txt."""

from __future__ import annotations

from bringup_lint.model.package import Build
from bringup_lint.parsers import cmake
from bringup_lint.parsers.cmake_language import LISTED
from bringup_lint.parsers.cmake_language import Around
from bringup_lint.source import Source


def read(text: str, **files: str) -> Build:
    sources = {f"cmake/{name}.cmake": Source(f"cmake/{name}.cmake", each) for name, each in files.items()}
    around = Around(lambda path: sources.get(path.removeprefix("./")), lambda folder: ())
    return cmake.parse(Source("CMakeLists.txt", text), "kite", around)


NODE = """\
function(node name)
  add_executable(${name} src/${name}.cpp)
  install(TARGETS ${name} DESTINATION lib/kite)
endfunction()
"""
MACRO = """\
macro(node)
  install(PROGRAMS reel.py DESTINATION lib/kite)
endmacro()
"""
PARSING = """\
function(node)
  cmake_parse_arguments(ARG "" NAME "" ${ARGN})
  add_executable(${ARG_NAME} a.cpp)
endfunction()
"""


def test_a_function_of_an_included_file_is_known() -> None:
    for include in ("include(cmake/nodes.cmake)", "list(APPEND CMAKE_MODULE_PATH cmake)\ninclude(nodes)"):
        build = read(f"{include}\nnode(line)\n", nodes=NODE)
        assert build.targets == {"line": ["src/line.cpp"]}
        assert list(build.executables) == ["line"]
        assert build.executables_known


def test_a_call_is_where_a_program_is_named() -> None:
    text = f"{NODE}node(line)\n"
    span = read(text).built["line"].span
    assert text[span.start - 5 : span.end] == "node(line"


def test_an_included_file_that_is_not_there_may_make_anything() -> None:
    build = read("include(cmake/gone.cmake)\n")
    assert not build.executables_known
    build = read("include(cmake/self.cmake)\n", self="include(cmake/self.cmake)\n")
    assert not build.executables_known


def test_a_function_that_calls_itself_ends() -> None:
    text = "function(node name)\n  add_executable(${name} a.cpp)\n  node(${name}x)\nendfunction()\nnode(line)\n"
    build = read(text)
    assert "linex" in build.targets
    assert not build.executables_known


def test_what_a_call_does_under_a_condition_is_not_sure() -> None:
    text = f"{MACRO}if(WITH_REEL)\n  node()\nendif()\nnode()\n"
    assert [each.sure for each in read(text).installs] == [False, True]


def test_arguments_that_are_not_known() -> None:
    assert read(f"{PARSING}node(NAME ${{SOMETHING}})\n").names_computed
    assert not read("cmake_parse_arguments(ARG)\n").executables_known
    assert not read("function()\nendfunction()\nnode()\n").executables_known


def test_an_executable_of_ament_cmake_auto_links_the_libraries_before_it() -> None:
    build = read(
        "ament_auto_add_library(reel src/reel.cpp)\n"
        "ament_auto_add_executable(line src/line.cpp)\n"
        "ament_auto_add_executable(bar src/bar.cpp NO_TARGET_LINK_LIBRARIES)\n"
    )
    assert build.links == {"line": ["reel"]}


def test_the_class_of_a_program_that_is_made_for_a_component() -> None:
    build = read('rclcpp_components_register_node(reel PLUGIN "Reel" EXECUTABLE reel_node)\n')
    assert build.main_plugins == {"reel_node": "Reel"}
    assert not read("rclcpp_components_register_node(reel PLUGIN ${CLASS} EXECUTABLE reel_node)\n").main_plugins


def test_many_patterns_are_not_all_followed() -> None:
    around = Around(lambda path: None, lambda folder: ["src/reel.cpp"])
    many = "file(GLOB REEL src/*.cpp)\n" * LISTED
    text = many + "file(GLOB LINE src/*.cpp)\nadd_library(reel ${REEL})\nadd_library(line ${LINE})\n"
    build = cmake.parse(Source("CMakeLists.txt", text), "kite", around)
    assert build.targets == {"reel": ["src/reel.cpp"], "line": []}
    assert build.open_targets == {"line"}


def test_patterns_that_are_not_known() -> None:
    around = Around(lambda path: None, lambda folder: ["src/reel.cpp"])
    for words in ("REEL ${FOLDER}/*.cpp", "REEL RELATIVE src src/*.cpp", "REEL src/*.txt"):
        text = f"file(GLOB {words})\nadd_library(reel ${{REEL}})\n"
        assert cmake.parse(Source("CMakeLists.txt", text), "kite", around).open_targets == {"reel"}


def test_the_sources_of_a_folder() -> None:
    around = Around(lambda path: None, lambda folder: ["src/reel.cpp", "src/reel.md", "src/arm/joint.cpp"])
    text = "ament_auto_add_library(reel SHARED DIRECTORY src)\nament_auto_add_library(line DIRECTORY lib)\n"
    build = cmake.parse(Source("CMakeLists.txt", text), "kite", around)
    assert build.targets == {"reel": ["src/reel.cpp"], "line": []}
    assert build.open_targets == {"line"}


def test_a_program_under_another_name_links_what_its_target_does() -> None:
    text = (
        "add_executable(line_exe src/line.cpp)\ntarget_link_libraries(line_exe reel)\n"
        "set_target_properties(line_exe PROPERTIES OUTPUT_NAME line)\ninstall(TARGETS line_exe DESTINATION lib/kite)\n"
    )
    assert read(text).links["line"] == ["reel"]
