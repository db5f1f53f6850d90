"""Statements that become others."""

from __future__ import annotations

from functools import partial

from bringup_lint.codemods.module import read
from bringup_lint.finding import Codemod
from bringup_lint.source import Span


def wait_in_loop(call: Span, message: str) -> Codemod | None:
    """``self.client.wait_for_service()`` as a loop that waits for a second and logs, until the context is shut down;
    None where the call is not a statement of its own."""
    text = call.source.text
    line = text[text.rfind("\n", 0, call.start) + 1 : call.end].strip()
    rest = text[call.end :].partition("\n")[0].strip()
    if line != call.text or (rest and not rest.startswith("#")) or not call.text.startswith("self."):
        return None
    return Codemod(call.source, partial(_looped, call=call, message=message))


def _looped(text: str, call: Span, message: str) -> str:
    import libcst

    module = read(text)
    found = module.node(libcst.Call, call.start, call.end)
    holders = (each for each in module.offsets if isinstance(each, libcst.SimpleStatementLine))
    old = next((each for each in holders if len(each.body) == 1 and _value(each.body[0]) is found), None)
    if old is None or found is None:
        return text
    waiting = module.tree.code_for_node(found.with_changes(args=[]))[: -len("()")]
    loop = libcst.parse_statement(
        f"while self.context.ok() and not {waiting}(timeout_sec=1.0):\n"
        f"{module.tree.default_indent}self.get_logger().info({message!r})\n",
        module.tree.config_for_parsing,
    )
    if not isinstance(loop, libcst.While):
        return text
    body = loop.body.with_changes(header=old.trailing_whitespace)
    return module.replaced(old, loop.with_changes(leading_lines=old.leading_lines, body=body))


def _value(statement: object) -> object:
    import libcst

    return statement.value if isinstance(statement, libcst.Expr) else None
