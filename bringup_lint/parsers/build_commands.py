"""``docker build`` in scripts, makefiles, workflows and instructions: the names that it gives, and the Dockerfile."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.model.image_build import ImageBuild
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_COMMAND = regex(
    r"\b(?:docker|podman|nerdctl)[ \t]+(?:buildx[ \t]+|image[ \t]+)?build\b((?:\\\r?\n|[^\n`;|&>])*)",
    hints="docker podman nerdctl",
)
_WORD = regex(r"""(?:"[^"\n]*"|'[^'\n]*'|[^\s"'])+""")
_ASSIGNMENT = regex(
    r"""^[ \t]*(?:export[ \t]+|readonly[ \t]+)?(\w+)[ \t]*[:?]?=[ \t]*["']?([\w./:-]+)["']?[ \t]*$""", re.M
)
_VARIABLE = regex(r"\$(?:\{(\w+)\}|\((\w+)\)|(\w+))")
_CD = regex(r"(?<![\w-])cd[ \t]+([\w./-]+)[ \t]*(?:&&|;)")
_VALUED = frozenset(
    "--add-host --build-arg --build-context --builder --cache-from --cache-to --cgroup-parent --file --iidfile --label"
    " --load --memory --metadata-file --network --no-cache-filter --output --platform --progress --secret --shm-size"
    " --ssh --tag --target --ulimit -f -m -o -t".split()
) - {"--load"}


def parse(source: Source) -> list[ImageBuild]:
    """The build commands that name an image. Variables are put in where the file assigns them once."""
    found = list(_COMMAND.finditer(source.text))
    values = _values(source.text) if found else {}
    return [build for match in found if (build := _build(source, match, values)).names]


def _values(text: str) -> dict[str, str]:
    found: dict[str, set[str]] = {}
    for name, value in _ASSIGNMENT.findall(text):
        found.setdefault(name, set()).add(value)
    return {name: next(iter(values)) for name, values in found.items() if len(values) == 1}


def _build(source: Source, match: re.Match[str], values: dict[str, str]) -> ImageBuild:
    options, context = _options(_words(match[1], values))
    names = tuple(value for option, value in options if option in ("-t", "--tag"))
    last = dict(options)
    dockerfile = last.get("-f") or last.get("--file") or ""
    folder = _folder(source.text, match.start())
    if folder:
        context = posixpath.join(folder, context or ".")
        dockerfile = dockerfile and posixpath.join(folder, dockerfile)
    return ImageBuild(names, context, dockerfile, last.get("--target", ""), source.located(match.start(), match.end()))


def _folder(text: str, at: int) -> str:
    """Where ``cd`` goes before a command on the same line; empty when it does not."""
    before = text[text.rfind("\n", 0, at) + 1 : at]
    found = [match[1] for match in _CD.finditer(before)]
    return posixpath.join(*found) if found else ""


def _words(text: str, values: dict[str, str]) -> Iterator[str]:
    for word in _WORD.findall(text.replace("\\\n", " ").replace("\\\r\n", " ")):
        plain = word.replace('"', "").replace("'", "")
        yield _VARIABLE.sub(lambda match: values.get(match[1] or match[2] or match[3], match[0]), plain)


def _options(words: Iterator[str]) -> tuple[list[tuple[str, str]], str]:
    """The options with their values, and the context."""
    options: list[tuple[str, str]] = []
    context = ""
    for word in words:
        name, equals, value = word.partition("=")
        if word.startswith("-") and equals:
            options.append((name, value))
        elif word in _VALUED:
            options.append((word, next(words, "")))
        elif not word.startswith("-") and not context:
            context = word
    return options, context
