"""Draws mutants of the code: Cosmic Ray says what can be changed in a line, a seed says which changes are tried.

    pip install -e '.[test,mutation]'
    python benchmarks/mutant_sample.py [SEED] [COUNT]

Writes ``benchmarks/mutants.tsv``, COUNT mutants of each area, which ``benchmarks/mutants.py`` judges. Annotations are
left out, which nothing evaluates.
"""

from __future__ import annotations

import ast
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from typing import NamedTuple

PROJECT = Path(__file__).resolve().parent.parent
AREAS = {"graph": "bringup_lint/graph", "parsers": "bringup_lint/parsers", "rules": "rules"}
RECORD = Path(__file__).with_name("mutants.tsv")
NEEDS_ARGUMENTS = ("core/VariableReplacer", "core/VariableInserter")


class Mutant(NamedTuple):
    """A line of a file as it is and as it becomes, and what the tests said of the change."""

    path: str
    line: int
    was: str
    became: str
    verdict: str = ""
    """``killed``, ``survived`` or ``equivalent``."""
    why: str = ""
    """The test that fails, why none can, or what no test asks yet."""


def main(seed: int, count: int) -> None:
    chance = random.Random(seed)
    mutants = [mutant for folder in AREAS.values() for mutant in sorted(drawn(PROJECT / folder, count, chance))]
    write(mutants, f"# seed {seed}, {count} mutants of each area")


def write(mutants: list[Mutant], head: str) -> None:
    rows = ["\t".join(map(str, mutant)) for mutant in mutants]
    RECORD.write_text("\n".join([head, "\t".join(Mutant._fields), *rows, ""]), "utf-8")


def read() -> tuple[list[Mutant], str]:
    """The mutants of the record, and its first line."""
    head, _, *rows = RECORD.read_text("utf-8").rstrip("\n").split("\n")
    cells = [row.split("\t") for row in rows]
    return [Mutant(path, int(line), *rest) for path, line, *rest in cells], head


def drawn(folder: Path, count: int, chance: random.Random) -> set[Mutant]:
    """So many mutants, each of a line that is drawn from all lines with the same chance."""
    files = {path: path.read_text("utf-8").split("\n") for path in sorted(folder.rglob("*.py"))}
    lines = [(path, number) for path, text in files.items() for number in range(1, len(text) + 1)]
    found: dict[tuple[Path, int], Mutant] = {}
    while len(found) < count:
        path, line = chance.choice(lines)
        mutants = sorted(mutants_of(path, line)) if (path, line) not in found else []
        if mutants:
            found[path, line] = chance.choice(mutants)
    return set(found.values())


def mutants_of(path: Path, line: int) -> Iterator[Mutant]:
    """What Cosmic Ray makes of a line, without what goes over several lines."""
    from cosmic_ray.mutating import mutate_code
    from cosmic_ray.plugins import get_operator

    text = path.read_text("utf-8")
    for name, occurrence in occurrences(text, line):
        try:
            changed = mutate_code(text, get_operator(name)(), occurrence)
        except AttributeError:  # exceptions that are named with their module
            continue
        old, new = text.split("\n"), (changed or "").split("\n")
        if changed and len(old) == len(new) and old[line:] == new[line:] and is_python(changed):
            yield Mutant(str(path.relative_to(PROJECT)), line, old[line - 1].strip(), new[line - 1].strip())


def is_python(text: str) -> bool:
    try:
        ast.parse(text)
    except SyntaxError:
        return False
    return True


def occurrences(text: str, line: int) -> Iterator[tuple[str, int]]:
    """Operator and number of each change that begins in a line."""
    from cosmic_ray.ast import ast_nodes
    from cosmic_ray.ast import get_ast
    from cosmic_ray.plugins import get_operator
    from cosmic_ray.plugins import operator_names

    nodes, notes = list(ast_nodes(get_ast(text))), annotations(text)
    near = [node for node in nodes if node.start_pos[0] <= line <= node.end_pos[0]]
    for name in sorted(set(operator_names()) - set(NEEDS_ARGUMENTS)):
        operator = get_operator(name)()
        if not any(start[0] == line for start, _ in positions(operator, near)):
            continue
        for number, (start, _) in enumerate(positions(operator, nodes)):
            if start[0] == line and not any(first <= start < last for first, last in notes):
                yield name, number


def positions(operator: Any, nodes: list[Any]) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    for node in nodes:
        yield from operator.mutation_positions(node)


def annotations(text: str) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Where the annotations of a file begin and end: lines and columns."""
    found = []
    for node in ast.walk(ast.parse(text)):
        for note in (getattr(node, "annotation", None), getattr(node, "returns", None)):
            if isinstance(note, ast.expr):
                end = (note.end_lineno or note.lineno, note.end_col_offset or note.col_offset)
                found.append(((note.lineno, note.col_offset), end))
    return found


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:3] or (606, 120)))
