"""The values of variables in a Dockerfile: global ARGs, the ARGs of a stage, and ENV.

Source: docs.docker.com/reference/dockerfile, "Environment replacement", "ARG", "Understand how ARG and FROM interact".
"""

from __future__ import annotations

from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.dockerfile import substituted
from bringup_lint.parsers.dockerfile import assignments
from bringup_lint.parsers.dockerfile import environment_of
from bringup_lint.source import Located


def variables(stage: Stage, until: Instruction | None = None) -> dict[str, str]:
    """The values of the variables before an instruction of a stage, or after all of them.

    An argument has its default. ENV hides an argument of the same name. The ENV of the stages below is inherited,
    their arguments are not.
    """
    environment = variables_of_env(stage.base) if stage.base else {}
    arguments: dict[str, str] = {}
    for instruction in stage.instructions:
        if instruction is until:
            break
        if instruction.name == "ENV":
            values = {**arguments, **environment}
            environment.update({name: substituted(text, values) for name, text in assignments(instruction)})
        elif instruction.name == "ARG":
            arguments.update(_declared(stage, instruction, {**arguments, **environment}))
    return {**arguments, **environment}


def variables_of_env(stage: Stage) -> dict[str, str]:
    """The variables that an image hands on to the images that build on it."""
    names = {name for name, _ in environment_of(stage)}
    return {name: value for name, value in variables(stage).items() if name in names}


def _declared(stage: Stage, instruction: Instruction, values: dict[str, str]) -> dict[str, str]:
    """The arguments of an ARG that have a value; one without a default takes that of the global argument."""
    found = {name: substituted(text, values) for name, text in assignments(instruction)}
    for word in instruction.value.words():
        default = stage.arguments.get(str(word))
        if default is not None:
            found[str(word)] = str(default)
    return found


def expanded(stage: Stage, instruction: Instruction) -> Located:
    """The value of an instruction with its variables replaced; a variable without a value stays as it is written."""
    value = instruction.value
    if "$" not in value:
        return value
    return Located(substituted(value, variables(stage, instruction)), value.span)


def last_user(stage: Stage) -> Located | None:
    """The value of the USER that counts, looked for in the stages below too."""
    for one in stage.chain:
        instructions = list(one.all("USER"))
        if instructions:
            return expanded(one, instructions[-1])
    return None
