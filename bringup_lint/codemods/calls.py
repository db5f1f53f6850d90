"""Arguments of calls: keywords that are added and removed, lists that get an element, calls that are wrapped.

What is added gets the line and the indentation of what is before it. The comments of a line stay with it.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.codemods.imports import Import
from bringup_lint.codemods.module import Module
from bringup_lint.codemods.module import read
from bringup_lint.finding import Codemod
from bringup_lint.finding import span_of
from bringup_lint.model.python import syntax_of
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    import libcst

Change = Callable[[str], str]


def with_keyword(call: Span, name: str, value: str, *imports: Import) -> Codemod | None:
    """Give a call a keyword argument that it does not have; None where ``**`` may hold it."""
    written = _call(call)
    if written is None or any(each.arg in (name, None) for each in written.keywords):
        return None
    return Codemod(call.source, partial(_keyword_added, call=call, name=name, value=value, imports=imports))


def with_item(call: Span, name: str, item: str, *imports: Import) -> Codemod | None:
    """Append to the list that a keyword argument is, or add the argument with a list of this one element; None where
    the argument is something else."""
    written = _call(call)
    if written is None or any(each.arg is None for each in written.keywords):
        return None
    given = next((each.value for each in written.keywords if each.arg == name), None)
    if given is None:
        return with_keyword(call, name, f"[{item}]", *imports)
    if not isinstance(given, ast.List):
        return None
    return Codemod(call.source, partial(_item_appended, call=call, name=name, item=item, imports=imports))


def with_items(call: Span, name: str, *items: str) -> Codemod | None:
    """The same for several elements."""
    codemods = [with_item(call, name, item) for item in items]
    if None in codemods:
        return None
    change = partial(_items_appended, call=call, name=name, items=items)
    return Codemod(call.source, change)


def without_keyword(value: Span) -> Codemod | None:
    """Remove the keyword argument with this value; None where the text is not Python."""
    if not value.source.name.endswith(".py"):
        return None
    return Codemod(value.source, partial(_keyword_removed, value=value))


def renamed_keyword(call: Span, name: str, new: str) -> Codemod | None:
    """Call a keyword argument by another name."""
    written = _call(call)
    given = {each.arg for each in written.keywords} if written is not None else set()
    if name not in given or new in given or None in given:
        return None
    return Codemod(call.source, partial(_keyword_renamed, call=call, name=name, new=new))


def in_list(value: Located | Span) -> Codemod | None:
    """Put an expression into a list of its own."""
    return _wrapped(span_of(value), "[", "]")


def in_call(value: Span, function: Import) -> Codemod | None:
    """Put an expression into a list, as the only argument of a call: ``GroupAction([...])``."""
    return _wrapped(value, f"{function.name}([", "])", function)


def all_of(*codemods: Codemod | None) -> Codemod | None:
    """Several changes of one file as one, from the last place to the first; None if one of them is."""
    made = [each for each in codemods if each is not None]
    if not made or len(made) < len(codemods) or any(each.source is not made[0].source for each in made):
        return None
    return Codemod(made[0].source, partial(_in_turn, changes=[each.change for each in reversed(made)]))


def _call(span: Span) -> ast.Call | None:
    """The call whose text a span is, and nothing else; None in other files than Python."""
    written = _expression(span)
    return written if isinstance(written, ast.Call) else None


def _expression(span: Span) -> ast.expr | None:
    if not span.source.name.endswith(".py"):
        return None
    tree = syntax_of(f"({span.text})")
    statement = tree.body[0] if tree is not None and len(tree.body) == 1 else None
    return statement.value if isinstance(statement, ast.Expr) else None


def _wrapped(value: Span, before: str, after: str, *imports: Import) -> Codemod | None:
    if _expression(value) is None:
        return None
    return Codemod(value.source, partial(_put_into, value=value, before=before, after=after, imports=imports))


def _in_turn(text: str, changes: list[Change]) -> str:
    for change in changes:
        text = change(text)
    return text


def _found(text: str, call: Span) -> tuple[Module, libcst.Call | None]:
    import libcst

    module = read(text)
    return module, module.node(libcst.Call, call.start, call.end)


def _keyword_added(text: str, call: Span, name: str, value: str, imports: tuple[Import, ...]) -> str:
    import libcst

    module, found = _found(text, call)
    if found is None or any(_name(each) == name for each in found.args):
        return text
    equal = libcst.AssignEqual(libcst.SimpleWhitespace(""), libcst.SimpleWhitespace(""))
    added = libcst.Arg(libcst.parse_expression(value), keyword=libcst.Name(name), equal=equal)
    return module.replaced(found, _with_argument(found, added), imports)


def _with_argument(call: libcst.Call, added: libcst.Arg) -> libcst.Call:
    import libcst

    if not call.args:
        return call.with_changes(args=[added])
    *before, last = call.args
    between = before[0].comma.whitespace_after if before and isinstance(before[0].comma, libcst.Comma) else None
    if between is None:
        own_line = isinstance(call.whitespace_before_args, libcst.ParenthesizedWhitespace)
        between = call.whitespace_before_args if own_line else libcst.SimpleWhitespace(" ")
    trailing = last.comma
    end = trailing.whitespace_after if isinstance(trailing, libcst.Comma) else last.whitespace_after_arg
    comma = libcst.Comma(whitespace_after=_with_comments(_plain(between), end))
    kept = last.with_changes(comma=comma, whitespace_after_arg=libcst.SimpleWhitespace(""))
    if isinstance(trailing, libcst.Comma):
        added = added.with_changes(comma=trailing.with_changes(whitespace_after=_plain(end)))
    else:
        added = added.with_changes(whitespace_after_arg=_plain(end))
    return call.with_changes(args=[*before, kept, added])


def _plain(gap: libcst.BaseParenthesizableWhitespace) -> libcst.BaseParenthesizableWhitespace:
    """The same blanks and line ends without comments and empty lines."""
    import libcst

    if not isinstance(gap, libcst.ParenthesizedWhitespace):
        return gap
    newline = gap.first_line.newline
    return gap.with_changes(first_line=libcst.TrailingWhitespace(newline=newline), empty_lines=[])


def _with_comments(
    gap: libcst.BaseParenthesizableWhitespace, end: libcst.BaseParenthesizableWhitespace
) -> libcst.BaseParenthesizableWhitespace:
    """A gap that takes the comments over from the end of a list of arguments."""
    import libcst

    if not isinstance(end, libcst.ParenthesizedWhitespace):
        return gap
    if isinstance(gap, libcst.ParenthesizedWhitespace):
        return gap.with_changes(first_line=end.first_line, empty_lines=end.empty_lines)
    return end if end.first_line.comment or end.empty_lines else gap


def _items_appended(text: str, call: Span, name: str, items: tuple[str, ...]) -> str:
    """The call starts where it did; each element makes its text longer."""
    for item in items:
        length = len(text)
        text = _item_appended(text, call, name, item, ())
        call = Span(call.source, call.start, call.end + len(text) - length)
    return text


def _item_appended(text: str, call: Span, name: str, item: str, imports: tuple[Import, ...]) -> str:
    import libcst

    module, found = _found(text, call)
    given = next((each for each in found.args if _name(each) == name), None) if found is not None else None
    if found is None:
        return text
    if given is None:
        return _keyword_added(text, call, name, f"[{item}]", imports)
    added = libcst.Element(libcst.parse_expression(item))
    if not isinstance(given.value, libcst.List):
        return text
    return module.replaced(given.value, _with_element(given.value, added), imports)


def _with_element(node: libcst.List, added: libcst.Element) -> libcst.List:
    import libcst

    if not node.elements:
        return node.with_changes(elements=[added])
    *before, last = node.elements
    between = before[0].comma.whitespace_after if before and isinstance(before[0].comma, libcst.Comma) else None
    if between is None:
        own_line = isinstance(node.lbracket.whitespace_after, libcst.ParenthesizedWhitespace)
        between = node.lbracket.whitespace_after if own_line else libcst.SimpleWhitespace(" ")
    end = node.rbracket.whitespace_before
    kept = last.with_changes(comma=libcst.Comma(whitespace_after=_with_comments(_plain(between), end)))
    return node.with_changes(
        elements=[*before, kept, added.with_changes(comma=last.comma)],
        rbracket=node.rbracket.with_changes(whitespace_before=_plain(end)),
    )


def _keyword_removed(text: str, value: Span) -> str:
    import libcst

    module = read(text)
    wanted = (module.offset(value.start), module.offset(value.end))
    for call in module.offsets:
        if not isinstance(call, libcst.Call):
            continue
        for at, argument in enumerate(call.args):
            if argument.keyword is not None and module.offsets.get(argument.value) == wanted:
                return module.replaced(call, _without(call, at))
    return text


def _without(call: libcst.Call, at: int) -> libcst.Call:
    """The call without an argument; where it was the last one, the one before it ends the list as it did."""
    gone = call.args[at]
    rest = [each for index, each in enumerate(call.args) if index != at]
    if rest and at == len(rest):
        rest[-1] = rest[-1].with_changes(comma=gone.comma, whitespace_after_arg=gone.whitespace_after_arg)
    return call.with_changes(args=rest)


def _keyword_renamed(text: str, call: Span, name: str, new: str) -> str:
    module, found = _found(text, call)
    if found is None:
        return text
    keyword = next((each.keyword for each in found.args if _name(each) == name), None)
    return text if keyword is None else module.replaced(keyword, keyword.with_changes(value=new))


def _put_into(text: str, value: Span, before: str, after: str, imports: tuple[Import, ...]) -> str:
    import libcst

    module = read(text)
    found = module.node(libcst.BaseExpression, value.start, value.end)  # type: ignore[type-abstract]
    if found is None:
        return text
    holder = libcst.parse_expression(f"{before}_{after}")
    return module.replaced(found, holder.deep_replace(_placeholder(holder), found), imports)


def _placeholder(holder: libcst.BaseExpression) -> libcst.BaseExpression:
    import libcst
    from libcst import matchers

    found = matchers.findall(holder, matchers.Name("_"))
    return next(each for each in found if isinstance(each, libcst.Name))


def _name(argument: libcst.Arg) -> str | None:
    return argument.keyword.value if argument.keyword is not None else None
