"""package.xml against catkin_pkg, with which colcon, rosdep and ament read it: both refuse the same files."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.parsers import package_grammar
from bringup_lint.parsers import xml
from bringup_lint.source import Source

catkin = pytest.importorskip("catkin_pkg.package")

FIXTURES = Path(__file__).parents[2] / "fixtures"
_PLACE = re.compile(r'[\w/-]{4,}|<[^>]*>|"[^"]*"|\n[^\n]*')
MUTANTS = 4


def _texts() -> Iterator[str]:
    """The manifests of the fixtures, and each with a letter, a word or a line twice or left out."""
    chance = random.Random(0)
    for path in sorted(FIXTURES.glob("*/*/*/**/package.xml")):
        text = path.read_text(encoding="utf-8", errors="replace")
        # Templates are not judged, and expat reads DOCTYPE, which our reader does not.
        if "{" in text or "DOCTYPE" in text or "$" in text:
            continue
        yield text
        places = list(_PLACE.finditer(text))
        for _ in range(MUTANTS if places else 0):
            place = chance.choice(places)
            at = chance.randrange(place.start(), place.end())
            yield chance.choice(
                (
                    text[:at] + text[at] + text[at:],
                    text[:at] + text[at + 1 :],
                    text[: place.end()] + text[place.start() :],
                    text[: place.start()] + text[place.end() :],
                )
            )


def _is_refused(text: str) -> bool:
    try:
        catkin.parse_package_string(text.encode(), "package.xml", [])
    except (AssertionError, ValueError, catkin.InvalidPackage):
        return True
    return False


def test_refused() -> None:
    texts = [text for text in _texts() if "<?xml" not in text or text.startswith('<?xml version="1.0"?>\n')]
    ours = [any(package_grammar.refused(xml.parse(Source("package.xml", text)))) for text in texts]
    different = [text for text, refused in zip(texts, ours) if refused != _is_refused(text)]
    assert not different
    assert 100 < sum(ours) < len(texts)
