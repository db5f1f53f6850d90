"""setup.py and setup.cfg: what a Python package installs, as far as it is certain."""

from __future__ import annotations

import pytest

from bringup_lint.model.package import Build
from bringup_lint.parsers.setup_py import parse
from bringup_lint.parsers.setup_py import parse_cfg
from bringup_lint.source import Source


def read(text: str) -> Build:
    return parse(Source("setup.py", text))


def setup(arguments: str, before: str = "") -> Build:
    return read(f"import os\nfrom glob import glob\nfrom setuptools import setup\n{before}\nsetup({arguments})\n")


def installs(build: Build) -> list[tuple[str, str]]:
    return [(install.destination, install.source) for install in build.installs]


def test_scripts_and_their_entry_points() -> None:
    build = setup("entry_points={'console_scripts': ['drive = base.drive:main', 'arm=base.arm:run [gui]']}")
    assert build.entry_points == {"drive": "base.drive:main", "arm": "base.arm:run"}
    assert build.executables["drive"].span.text == "drive"
    assert build.executables_known and build.installs_known


def test_data_files() -> None:
    build = setup(
        "data_files=[('share/' + name, ['package.xml']), (os.path.join('share', name, 'launch'), glob('launch/*.py')),"
        " ('share/base/config', [os.path.join('config', 'base.yaml'), glob('config/*.rviz')])]",
        "name = 'base'",
    )
    assert installs(build) == [
        ("share/base", "package.xml"),
        ("share/base/launch", "launch/*.py"),
        ("share/base/config", "config/base.yaml"),
        ("share/base/config", "config/*.rviz"),
    ]


@pytest.mark.parametrize(
    ("files", "known"),
    [
        ("glob('a/*.py') + glob('a/*.xml') + ['a/b.yaml']", ["a/*.py", "a/*.xml", "a/b.yaml"]),
        ("['a/b.yaml', *glob('a/*.py')]", ["a/b.yaml", "a/*.py"]),
        ("glob('a/*.py') if os.path.exists('a') else []", ["a/*.py"]),
        ("[each for each in glob('a/*')]", ["a/*"]),
    ],
)
def test_lists_that_are_put_together(files: str, known: list[str]) -> None:
    build = setup(f"data_files=[('share/base', {files})]")
    assert [source for _, source in installs(build)] == known
    assert build.installs_known
    assert not any(install.sure for install in build.installs if "*" in install.source)


@pytest.mark.parametrize(
    "arguments",
    [
        "data_files=unheard_of()",
        "data_files=[('share', glob('a/*') + unheard_of())]",
        "data_files=[('share', glob('a/*') if os.path.exists('a') else unheard_of())]",
        "data_files=[unheard_of()]",
        "data_files=[(unheard_of(), ['a'])]",
        "data_files=[('share', unheard_of())]",
        "data_files=[('share', [unheard_of()])]",
        "data_files=[('share', ['a'], 'b')]",
        "data_files=[(os.path.join('share', unheard_of()), ['a'])]",
    ],
)
def test_unknown_data_files_are_not_guessed(arguments: str) -> None:
    build = setup(arguments)
    assert not build.installs_known
    assert build.executables_known


@pytest.mark.parametrize(
    "arguments",
    [
        "entry_points=unheard_of()",
        "entry_points={'console_scripts': unheard_of()}",
        "entry_points={'console_scripts': [unheard_of()]}",
        "scripts=glob('bin/*')",
    ],
)
def test_unknown_scripts_are_not_guessed(arguments: str) -> None:
    build = setup(arguments)
    assert not build.executables_known
    assert build.installs_known


@pytest.mark.parametrize("arguments", ["name='base'", "entry_points={'gui_scripts': ['a = b:c']}"])
def test_nothing_is_installed(arguments: str) -> None:
    build = setup(arguments)
    assert (build.executables, build.installs) == ({}, [])
    assert build.executables_known and build.installs_known


@pytest.mark.parametrize("text", ["", "def broken(", "\0", "setup()\nsetup()\n", "x = " + "(" * 500])
def test_what_is_no_single_setup_is_not_known(text: str) -> None:
    build = read(f"from setuptools import setup\n{text}")
    assert not build.executables_known and not build.installs_known


def test_cfg() -> None:
    build = parse_cfg(
        Source(
            "setup.cfg",
            "[options.entry_points]\nconsole_scripts =\n    drive = base.drive:main\n    arm=base.arm:run\n"
            "[options.data_files]\nshare/base = package.xml\n    base.yaml\n",
        )
    )
    assert build.entry_points == {"drive": "base.drive:main", "arm": "base.arm:run"}
    assert installs(build) == [("share/base", "package.xml"), ("share/base", "base.yaml")]


def test_cfg_that_is_broken_or_empty() -> None:
    assert not parse_cfg(Source("setup.cfg", "no section\n")).executables_known
    empty = parse_cfg(Source("setup.cfg", "[metadata]\nname = base\n"))
    assert empty.executables_known and empty.executables == {}


def test_scripts_have_their_own_names() -> None:
    build = setup("scripts=['bin/drive', 'arm']")
    assert list(build.executables) == ["drive", "arm"]
    assert build.executables_known
