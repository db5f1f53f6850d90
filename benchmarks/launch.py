"""How fast launch files are read: ``python benchmarks/launch.py FOLDER...``, folders with checkouts of ROS 2 packages.

Python launch files are compared with the standard library's ``ast`` and YAML with PyYAML's C loader: the aim is 3
times their time or less. XML is compared with lxml, which keeps no columns and does not recover: no aim. CPU time,
best of several rounds.
"""

from __future__ import annotations

import ast
import sys
import time
from collections.abc import Callable
from collections.abc import Iterator
from pathlib import Path

PROJECT = Path(__file__).parent.parent
sys.path.insert(0, str(PROJECT))

from bringup_lint.discover.kinds import HEAD_SIZE  # noqa: E402
from bringup_lint.discover.kinds import kind_of  # noqa: E402
from bringup_lint.parsers import launch_python  # noqa: E402
from bringup_lint.parsers import launch_xml  # noqa: E402
from bringup_lint.parsers import launch_yaml  # noqa: E402
from bringup_lint.source import Source  # noqa: E402

ROUNDS = 5


def sources(folders: list[str]) -> Iterator[tuple[str, str, str]]:
    """Kind, path and text of every launch file."""
    for folder in folders:
        for path in sorted(Path(folder).rglob("*")):
            if path.suffix in (".py", ".xml", ".yaml", ".yml", ".launch") and path.is_file():
                text = path.read_text("utf-8", errors="replace")
                kind = kind_of(str(path), lambda text=text: text[:HEAD_SIZE])
                if kind.startswith("launch-"):
                    yield kind, str(path), text


def best(action: Callable[[], object]) -> float:
    times = []
    for _ in range(ROUNDS):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return min(times)


def with_lxml(texts: list[str]) -> None:
    from lxml import etree

    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False, recover=True)
    for text in texts:
        etree.fromstring(text.encode(), parser)


def with_yaml(texts: list[str]) -> None:
    import yaml

    for text in texts:
        yaml.load(text, Loader=yaml.CSafeLoader)


def with_ast(texts: list[str]) -> None:
    for text in texts:
        try:
            ast.parse(text)
        except SyntaxError:
            continue


PEERS = {
    "launch-python": (launch_python.parse, with_ast, "ast"),
    "launch-xml": (launch_xml.parse, with_lxml, "lxml"),
    "launch-yaml": (launch_yaml.parse, with_yaml, "PyYAML"),
}


def main(folders: list[str]) -> None:
    found = list(sources(folders))
    for kind, (parse, peer, name) in PEERS.items():
        files = [(path, text) for each, path, text in found if each == kind]
        if not files:
            continue
        size = sum(len(text.encode()) for _, text in files)
        ours = best(lambda files=files, parse=parse: [parse(Source(path, text)) for path, text in files])
        theirs = best(lambda files=files, peer=peer: peer([text for _, text in files]))
        speed = size / ours / 1e6
        aim = "no aim" if name == "lxml" else "aim 3"
        print(
            f"{kind}: {len(files)} files, {size / 1e3:.0f} kB, {speed:.2f} MB/s, {ours / theirs:.2f} x {name} ({aim})"
        )


if __name__ == "__main__":
    main(sys.argv[1:] or [str(PROJECT / "fixtures" / "launch")])
