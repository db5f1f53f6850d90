"""What runs inside a container: the words of its entrypoint and command, and the files of the tree at its paths."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.folders import joined
from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.following import follow
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.containers.base_images import runs_as_root
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.runner import DEFAULT_STOP
from bringup_lint.graph.runners.runner import Stop
from bringup_lint.model.compose import Service
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.dockerfile import Stage
from bringup_lint.parsers.dockerfile import assignments
from bringup_lint.parsers.dockerfile_variables import last_user
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_WORD = regex(r'"((?:[^"\\]|\\.)*)"')
_FOLDERS_ABOVE = 4
"""The folder of the Dockerfile, and those above it, that may be the build context."""


def words_of(instruction: Instruction | None) -> list[Located]:
    """The words of CMD or ENTRYPOINT; those of the shell form as ``sh -c`` gets them."""
    if instruction is None:
        return []
    if instruction.exec_form is None:
        value = instruction.value
        return [Located("sh", value.span), Located("-c", value.span), value]
    return [_unescaped(instruction.value.part(*word.span(1))) for word in _WORD.finditer(instruction.value)]


def _unescaped(word: Located) -> Located:
    if "\\" not in word:
        return word
    import json

    return Located(json.loads(f'"{word}"'), word.span)


def container_line(words: list[Located], reads: Callable[[str], Source | None]) -> CommandLine | None:
    """The command line of a container. An entry script that is not in the tree is taken to run what it is given."""
    if not words:
        return None
    line = CommandLine(words[0], _program(tuple(words), reads))
    follow(line, lambda path: reads(str(path)))
    return line


def _program(words: tuple[Located, ...], reads: Callable[[str], Source | None]) -> tuple[Located, ...]:
    plain = unwrapped(words) or words
    if reads(str(plain[0])) is not None:
        return plain
    names = [word.rpartition("/")[2] for word in plain]
    for at, name in enumerate(names):
        if name in SHELLS and at + 2 < len(plain) and re.fullmatch(r"-\w*c", plain[at + 1]):
            return plain[at:]
    return plain[names.index("ros2") :] if "ros2" in names else plain


def image_variables(stage: Stage) -> Iterator[Variable]:
    """What the ENV instructions of a stage set."""
    for instruction in stage.all("ENV"):
        for name, value in assignments(instruction):
            yield Variable(name, value, None if "$" in value else str(value), "ENV")


def image_environment(stage: Stage | None, image: str | None = None) -> Environment:
    """The variables of an image, the stages below included. It is complete where the image at the bottom is an official
    one, which sets no variable that configures ROS; what another image sets is unknown."""
    origin = stage.origin if stage is not None else image
    environment = Environment(complete=origin is not None and runs_as_root(origin))
    for one in reversed(list(stage.chain) if stage else []):
        for variable in image_variables(one):
            environment.set(variable)
    return environment


def image_user(stage: Stage | None, image: str | None = None) -> str | None:
    """The user that an image runs as; None when it is not known. Either its stage or its name may be unknown."""
    set_user = last_user(stage) if stage is not None else None
    if set_user is not None:
        return user_name(set_user)
    origin = stage.origin if stage is not None else image
    return "root" if origin is not None and runs_as_root(origin) else None


def user_name(text: str) -> str | None:
    """The user in ``USER:GROUP``, ``root`` for the id 0; None when a variable hides it."""
    name = text.partition(":")[0]
    if "$" in name or not name:
        return None
    return "root" if not name.strip("0") else name


def image_stop(stage: Stage | None, image: str | None = None) -> Stop:
    """How an image wants to be stopped. What an image from elsewhere sets is only known of the official ones."""
    instruction = stage.last("STOPSIGNAL") if stage is not None else None
    if instruction is not None:
        return Stop(str(instruction.value), None, instruction.value)
    origin = stage.origin if stage is not None else image
    return DEFAULT_STOP if origin is not None and runs_as_root(origin) else Stop(None)


def mounted(files: Files, service: Service, path: str) -> Source | None:
    """The file that a bind mount puts at a path of the container."""
    for volume in service.volumes:
        if volume.target is None or volume.source is None or "$" in volume.source:
            continue
        target = str(volume.target).rstrip("/")
        if path == target or path.startswith(f"{target}/"):
            below = f"{volume.source.rstrip('/')}{path[len(target) :]}"
            return files.tree.find(below) if below.startswith("/") else files.tree.beside(service.source, below)
    return None


def in_image(stage: Stage | None, path: str, folder: str | None = None) -> str | None:
    """A path as the processes of an image mean it: a relative one starts in ``folder`` or the last WORKDIR. None for
    a bare name, which is looked for in PATH, and where the folder is not known."""
    if path.startswith("/"):
        return joined("/", path)
    if not ("/" in path or path.endswith((".sh", ".bash", ".py"))):
        return None
    if folder is None:
        folder = next((at for at, _ in reversed(list(_steps(stage)))), None) if stage is not None else None
    return joined(folder, path) if folder and folder.startswith("/") else None


def _steps(stage: Stage) -> Iterator[tuple[str | None, Instruction]]:
    """The instructions of an image from the bottom on, each with the WORKDIR that counts after it; those of all stages
    that may be at the bottom."""
    folder: str | None = None
    chain = list(stage.chain)
    for one in (*chain[-1].earlier, *reversed(chain)):
        for instruction in one.instructions:
            if instruction.name == "WORKDIR":
                value = str(instruction.value).strip("\"'")
                known = "$" not in value and (folder is not None or value.startswith("/"))
                folder = joined(folder or "/", value) if known else None
            yield folder, instruction


def copied(files: Files, stage: Stage, path: str) -> Source | None:
    """The file that COPY or ADD puts at a path of the image, looked for beside the Dockerfile and in the folders above
    it, which may be the build context."""
    for folder, instruction in reversed(list(_steps(stage))):
        if instruction.name not in ("COPY", "ADD") or any(flag.startswith("--from") for flag in instruction.flags):
            continue
        for name in _copied_by(instruction, path, folder):
            found = _in_context(files, instruction.keyword.span.source, name)
            if found is not None:
                return found
    return None


def may_hold(files: Files, stage: Stage, path: str) -> bool:
    """Whether an instruction may put a file at a path of the image that ``copied`` does not find: from another image,
    an archive, a folder or a name that is not known, or a file that the tree lacks."""
    for folder, instruction in _steps(stage):
        if instruction.name not in ("COPY", "ADD"):
            continue
        words = [str(word) for word in words_of(instruction)] if instruction.exec_form else instruction.value.split()
        *sources, written = words or [""]
        if "$" in written or (folder is None and not written.startswith("/")):
            return True
        target = joined(folder or "/", written).rstrip("/")
        if path != target and not path.startswith(f"{target}/"):
            continue
        if any(flag.startswith("--from") for flag in instruction.flags) or any(map(_is_unknown, sources)):
            return True
        below = path.removeprefix(target).lstrip("/")
        if not all(_in_folders(files, instruction.keyword.span.source, name) for name in sources):
            return True
        if any(_is_left_out(files, instruction.keyword.span.source, os.path.join(name, below)) for name in sources):
            return True
    return False


def _is_unknown(source: str) -> bool:
    return bool(re.search(r"[$*?\[<]|://|\.(?:tar|tgz|zip|gz|xz|deb)\b", source))


def _in_folders(files: Files, dockerfile: Source, name: str) -> bool:
    """Whether the tree surely holds a file or folder that an instruction copies."""
    return any(map(files.tree.exists, _of_contexts(dockerfile, name)))


def _is_left_out(files: Files, dockerfile: Source, name: str) -> bool:
    """Whether the tree may lack what is there when an image is built: what git leaves out, and submodules."""
    paths = list(_of_contexts(dockerfile, name))
    return any(map(files.tree.is_ignored, paths)) or any(
        path.startswith(f"{module}/") for module in files.tree.submodules for path in paths
    )


def _of_contexts(dockerfile: Source, name: str) -> Iterator[str]:
    """Where a file of a build context may lie in the tree."""
    beside = os.path.dirname(dockerfile.absolute)
    for up in range(_FOLDERS_ABOVE):
        yield os.path.normpath(os.path.join(beside, "../" * up, name.lstrip("/")))


def _copied_by(instruction: Instruction, path: str, folder: str | None) -> Iterator[str]:
    """The paths in the build context from which an instruction may put a file there."""
    words = [str(word) for word in words_of(instruction)] if instruction.exec_form else instruction.value.split()
    if len(words) < 2 or "$" in words[-1]:
        return
    *sources, written = words
    if not written.startswith("/") and folder is None:
        return
    is_folder = written.endswith(("/", ".")) or len(sources) > 1
    target = joined(folder or "/", written).rstrip("/")
    for name in sources:
        if "$" in name:
            continue
        if path == target and not is_folder:
            yield name
        if path == f"{target}/{posixpath.basename(name)}":
            yield name
        if path.startswith(f"{target}/"):
            yield f"{name.rstrip('/')}{path[len(target) :]}"


def _in_context(files: Files, dockerfile: Source, name: str) -> Source | None:
    relative = name.lstrip("/")
    for above in range(_FOLDERS_ABOVE):
        found = files.tree.beside(dockerfile, "../" * above + relative)
        if found is not None:
            return found
    return None
