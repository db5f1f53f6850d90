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


_MOST_BRANCHES = 16


def parse(source: Source) -> list[ImageBuild]:
    """The build commands that name an image. Variables are put in where the file assigns them once, and where each of
    several branches assigns all those of the command, for one branch after the other."""
    found = list(_COMMAND.finditer(source.text))
    values = _values(source.text) if found else {}
    once = {name: given[0] for name, given in values.items() if len(set(given)) == 1}
    builds = (_build(source, match, each) for match in found for each in _branches(match[1], values, once))
    return [build for build in builds if build.names]


def _values(text: str) -> dict[str, list[str]]:
    """Each variable with its values, in their order."""
    found: dict[str, list[str]] = {}
    for name, value in _ASSIGNMENT.findall(text):
        found.setdefault(name, []).append(value)
    return found


def _branches(command: str, values: dict[str, list[str]], once: dict[str, str]) -> Iterator[dict[str, str]]:
    """The values that a command may meet together: the first ones of all variables, the second ones, and so on."""
    used = {match[1] or match[2] or match[3] for match in _VARIABLE.finditer(command)}
    chosen = {name: values[name] for name in used if name in values and name not in once}
    counts = {len(given) for given in chosen.values()}
    if len(chosen) < 2 or len(counts) != 1 or max(counts) > _MOST_BRANCHES:
        yield once
        return
    for at in range(max(counts)):
        yield {**once, **{name: given[at] for name, given in chosen.items()}}


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
