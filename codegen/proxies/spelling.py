"""How emitters spell the making of a value: one dispatcher of the ways (docs/adr/0029)."""

from __future__ import annotations

import re
from typing import Any, ClassVar

from codegen.proxies import WAYS, Call, Expr, Read, Shortcut, Take


def camel(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(part[:1].upper() + part[1:] for part in rest)


def snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def lower_first(name: str) -> str:
    return name[0].lower() + name[1:]


def indented(lines: list[str], indent: int) -> list[str]:
    return [" " * indent + line if line else line for line in lines]


class Spelling:
    """Base of an emitter's class, which has each of WAYS as an entry of TEXTS or as a method way_NAME().

    A text may have {one}, the first path or what is at hand, {all} paths, {constant}, {type} and {function}. A method gets the
    Expr, what {one} is, and what paths begin with. A way that a language lacks is refused when its emitter is loaded, one that
    nobody knows when a value is to be made by it.
    """

    TEXTS: ClassVar[dict[str, Any]] = {}
    SEPARATOR: ClassVar[str] = ", "

    def __init_subclass__(cls) -> None:
        missing = [way for way in WAYS if way not in cls.TEXTS and not hasattr(cls, f"way_{way}")]
        if missing:
            raise TypeError(f"{cls.__module__} does not spell {', '.join(missing)}")

    def _member(self, member: Read | Shortcut | Call | Take) -> Any:
        return {Read: self._read, Shortcut: self._shortcut, Call: self._call, Take: self._take}[type(member)](member)

    def _plain(self, e: Expr, at: Any) -> Any:
        if e.how not in WAYS:
            raise ValueError(f"a value is made by {e.how!r}, which is none of {', '.join(WAYS)}")
        paths = self._paths(e, at)
        one = paths[0] if paths else self._at_hand(at)
        if e.how not in self.TEXTS:
            return getattr(self, f"way_{e.how}")(e, one, at)
        constant = self._constant(e.constant) if e.constant else ""
        given = {"one": one, "all": paths, "constant": constant, "type": self._type_name(e), "function": self._function(e.function)}
        return self._filled_in(self.TEXTS[e.how], given)

    def _filled_in(self, text: Any, given: dict[str, Any]) -> Any:
        return text.format(**given | {"all": self.SEPARATOR.join(given["all"])})

    def _paths(self, e: Expr, at: Any) -> list[Any]:
        return [self._path(p, at) for p in e.paths]

    def _at_hand(self, at: Any) -> Any:
        return at

    def _constant(self, name: str) -> str:
        """Of the interface."""
        return f"{self.wire}.{name}"

    def _function(self, name: str) -> str:
        """That the library has by hand."""
        return name

    def _type_name(self, e: Expr) -> str:
        return e.type.name

    def way_is(self, e: Expr, one: Any, at: Any) -> Any:
        return f"{one} * {e.factor}" if e.factor else one
