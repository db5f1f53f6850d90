"""Whether the arguments of a call fit the function that it calls."""

from __future__ import annotations

import ast

MOST = 250
"""Arguments of a function that are looked at."""


def misfit(call: ast.Call, taken: ast.arguments, is_method: bool) -> str | None:
    """What is wrong with the arguments of a call, in words; None when nothing is, or ``*`` or their number hides it."""
    if len(taken.posonlyargs) + len(taken.args) + len(taken.kwonlyargs) > MOST:
        return None
    if any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords):
        return None
    names = [each.arg for each in (*taken.posonlyargs, *taken.args)][1 if is_method else 0 :]
    given = len(call.args)
    if given > len(names) and taken.vararg is None:
        return f"takes {_counted(len(names))} and gets {given}"
    keywords = {str(each.arg) for each in call.keywords}
    known = {*names, *(each.arg for each in taken.kwonlyargs)}
    unknown = next((str(each.arg) for each in call.keywords if each.arg not in known), None)
    if unknown is not None and taken.kwarg is None:
        return f"has no argument '{unknown}'"
    required = names[given : max(len(names) - len(taken.defaults), given)]
    required += [each.arg for each, value in zip(taken.kwonlyargs, taken.kw_defaults) if value is None]
    missing = next((each for each in required if each not in keywords), None)
    return f"needs '{missing}'" if missing is not None else None


def _counted(number: int) -> str:
    return f"{number or 'no'} argument{'' if number == 1 else 's'}"
