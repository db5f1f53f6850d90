"""The JSON schema of the compose specification: which documents it refuses, and which our table does."""

from __future__ import annotations

import copy
import json
import os
import random
from pathlib import Path
from typing import Any

import yaml

from bringup_lint.model.schema import Code
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.compose_schema import remarks
from bringup_lint.source import Source
from tests.oracles.answers import Oracle

SCHEMA = os.environ.get("BRINGUP_LINT_COMPOSE_SCHEMA", "")
"""compose-spec.json of https://github.com/compose-spec/compose-spec; without it, the record answers."""
SEEDS = sorted((Path(__file__).parents[2] / "fixtures/compose").glob("*/good*/**/*compose*.y*ml"))
WRONG: tuple[Any, ...] = (None, True, 7, 0.5, "word", [], ["word"], [1], {}, {"word": "word"}, {"word": [1]})
OF_THE_SCHEMA = frozenset({Code.UNKNOWN, Code.SHAPE, Code.UNQUOTED, Code.ENUM, Code.RANGE, Code.NAME, Code.MISSING})
"""What the schema says; the grammars of values are those of the programs that read the file."""
MUTANTS = 60
"""For each seed."""
KEYS = (
    "image build user privileged command ports volumes environment deploy healthcheck depends_on x-note retires".split()
)


def ask(documents: list[Any]) -> list[bool]:
    """Whether the schema accepts each document. Lists may repeat entries: compose makes them unique before it asks."""
    import jsonschema  # type: ignore[import-untyped]

    schema = json.loads(Path(SCHEMA).read_text("utf-8"))
    _drop(schema, "uniqueItems")
    validator = jsonschema.validators.validator_for(schema)(schema)
    return [validator.is_valid(document) for document in documents]


def _drop(node: Any, name: str) -> None:
    for each in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        _drop(each, name)
    if isinstance(node, dict) and isinstance(node.get(name), bool):
        del node[name]


def mutants() -> list[Any]:
    chance = random.Random(20)
    found = []
    for path in SEEDS:
        seed = _plain(path)
        for _ in range(MUTANTS if seed else 0):
            document = copy.deepcopy(seed)
            _mutate(document, chance)
            found.append(document)
    return found


def _plain(path: Path) -> Any:
    """The document with plain values only; None when it has tags, substitutions or merge keys of its own."""
    text = path.read_text("utf-8")
    if "!" in text or "${" in text or "{{" in text or "{%" in text:
        return None
    return json.loads(json.dumps(yaml.safe_load(text), default=str))


def _mutate(document: Any, chance: random.Random) -> None:
    places = list(_places(document))
    holder, key = chance.choice(places)
    kind = chance.randrange(4)
    if kind == 0 and isinstance(holder, dict):
        holder[chance.choice(KEYS)] = holder.pop(key)
    elif kind == 1 and isinstance(holder, dict):
        del holder[key]
    elif kind == 2 and isinstance(holder, dict):
        holder[chance.choice(KEYS)] = chance.choice(WRONG)
    else:
        holder[key] = chance.choice(WRONG)


def _places(node: Any) -> Any:
    keys = list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else ()
    for key in keys:
        yield node, key
        yield from _places(node[key])


def test_documents_are_refused_as_by_the_schema(answers: Oracle) -> None:
    given = answers.of("compose/documents", "compose-spec 2026-07" if SCHEMA else "", mutants(), ask)
    refused = [document for document, accepted in given.pairs if not accepted]
    assert len(given.pairs) > 500 and len(refused) > 100
    wrong = [(document, accepted) for document, accepted in given.pairs if accepts(document) != accepted]
    assert not wrong, f"{len(wrong)} of {len(given.pairs)}, the first: {wrong[0]}"


def accepts(document: Any) -> bool:
    file = yaml_nodes.parse(Source("compose.yaml", json.dumps(document)))
    assert not file.problems
    return not any(remark.code in OF_THE_SCHEMA for remark in remarks(file))
