"""Writes clients/python/playhouse_client/generated/proxies/: one module per interface with its values and its proxy, and what
opens them (docs/adr/0029)."""

from __future__ import annotations

import textwrap

from codegen import emit_python
from codegen.model import Interface, Message
from codegen.proxies import (Argument, Call, Expr, Kept, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Type, Value,
                             spelled)
from codegen.proxies.spelling import Spelling, snake, indented

FOLDER = f"{emit_python.FOLDER}/proxies"
WIDTH = 110

TYPES = {"float": "float", "int": "int", "bool": "bool", "text": "str", "bytes": "bytes", "rgb": "Rgb",
         "rgba": "Tuple[int, int, int, int]", "Vector": "Tuple[float, float, float]", "Attitude": "Tuple[float, float, float]",
         "Quaternion": "Tuple[float, float, float, float]"}
# Values that are given as their numbers.
SPREAD = {"Pose": ("x", "y", "a"), "Attitude": ("roll", "pitch", "yaw")}
# Converters of playhouse_client.convert, from and to structs of the wire.
FROM_WIRE = {"Pose": "pose_of", "Velocity": "velocity_of", "Pose3d": "pose3d_of", "Size": "size_of", "Vector": "vector_of",
             "Attitude": "attitude_of", "rgb": "rgb_of", "rgba": "rgba_of"}


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{i.name}.py": _Module(proxies, i).text() for i in proxies.modules()}
    files[f"{FOLDER}/__init__.py"] = _index(proxies)
    return files


class _Module(Spelling):
    TEXTS = {"truth": "{one} != 0", "equals": "{one} == {constant}", "bit": "bool({one} & {constant})", "text": "text({one})",
             "unpack": "{type}(*{one})", "call": "{function}({all})", "time": "time", "whole": "{one}"}

    def __init__(self, proxies: Proxies, interface: Interface) -> None:
        self.proxies, self.interface, self.wire, self.proxy = proxies, interface, interface.name, proxies.proxy_of(interface)
        self.makers: dict[str, str] = {}  # functions that make a value of an element of a list

    def text(self) -> str:
        values = [self._value(v) for v in self.proxies.values_of(self.interface)]
        classes = [self._class(self.proxy)] if self.proxy else []
        body = "\n\n\n".join([*values, *classes, *self.makers.values()])
        about = f"Generated from {self.interface.source} by codegen; do not edit."
        return f'"""{"The proxy of" if self.proxy else "Values of"} {self.wire}.\n\n{about}\n"""\n\n{self._imports(body)}\n\n\n{body}\n'

    def _imports(self, body: str) -> str:
        """What the body names."""
        words = set(_words(body))
        lines = []
        typing = sorted(words & {"Any", "Iterator", "List", "NamedTuple", "Optional", "Sequence", "Tuple"})
        if typing:
            lines += [f"from typing import {', '.join(typing)}", ""]
        modules = sorted({self.wire} & words | {"common"} & words)
        base = self.proxy.base if self.proxy else ""
        bases = [f"from ...{'bases' if base != 'Device' else 'device'} import {base}"] if base else []
        convert = {*FROM_WIRE.values(), "color_of"} | self.proxies.functions()
        if convert & words:
            bases.append(f"from ...convert import {', '.join(sorted(convert & words))}")
        lines += sorted(bases)
        by_hand = {"Pose", "Pose3d", "Size", "Velocity", "Rgb"} | {v.name for v in self.proxies.values.values() if v.by_hand}
        if by_hand & words:
            lines.append(f"from ...values import {', '.join(sorted(by_hand & words))}")
        wire = {"c_string", "text"} & {w.rstrip("(") for w in words if w.endswith("(")} | {"Struct"} & words
        if wire:
            lines.append(f"from ...wire import {', '.join(sorted(wire))}")
        for name in sorted(v.name for v in self.proxies.values.values() if not v.by_hand and v.interface != self.wire and v.name in words):
            lines.append(f"from .{self.proxies.values[name].interface} import {name}")
        if modules:
            lines.append(f"from .. import {', '.join(modules)}")
        return "\n".join(lines)

    # Values

    def _value(self, value: Value) -> str:
        about = [*_wrapped(self._spelled(value.doc), 4, 6)]
        told = [line for f in value.fields if f.doc for line in _item(f"`{f.name}`: {self._spelled(f.doc)}")]
        if told:
            about += ["", *told]
        lines = [f"class {value.name}(NamedTuple):", *_docstring(about, 4), ""]
        for f in value.fields:
            assert f.type is not None
            default = f" = {_number(f.default, f.type)}" if f.default else ""
            lines.append(f"    {f.name}: {self._type(f.type)}{default}")
        return "\n".join(lines)

    def _type(self, type_: Type) -> str:
        name = f"{type_.owner}.{type_.name}" if type_.owner else TYPES.get(type_.name, type_.name)
        name = f"List[{name}]" if type_.is_list else name
        return f"Optional[{name}]" if type_.optional else name

    # The class

    def _class(self, p: Proxy) -> str:
        take = next((m for m in p.members if isinstance(m, Take)), None)
        base = f"{p.base}[{self._type(take.expr.type)}]" if take else p.base
        parts = ["\n".join([f"class {p.name}({base}):", *_docstring(_wrapped(self._spelled(p.doc), 4, 6), 4)])]
        parts += [f"    {c.name} = {c.value}  # {self._spelled(c.doc)[0].lower()}{self._spelled(c.doc)[1:-1]}" for c in p.constants]
        if p.kept:
            parts.append("\n".join(f"    {k.name} = {self.wire}.{k.struct.name}()  # {k.doc[0].lower()}{k.doc[1:-1]}" for k in p.kept))
            parts.append("\n".join(["    def prepare(self) -> None:", *(f"        {self._keep(k)}" for k in p.kept)]))
        for member in p.members:
            parts += self._member(member)
        return "\n\n".join(parts)

    def _keep(self, kept: Kept) -> str:
        return f"self.{kept.name} = self._ask({self._message(kept.message)})"

    def _message(self, message: Message) -> str:
        return f"{self.wire}.{message.constant}"

    def _read(self, read: Read) -> list[str]:
        head = [] if read.as_method else ["    @property"]
        head.append(f"    def {read.name}(self) -> {self._type(read.expr.type)}:")
        body = self._doc(read.doc)
        if not read.messages:
            body += self._return(read.expr, f"self.{read.kept}")
        elif read.variants:
            body.append(f"data = self._newest_of({', '.join(self._message(m) for m in read.messages)})")
            body += self._variants(read)
        else:
            stamp = "data, time" if read.expr.has_time else "data, _"
            body.append(f"{stamp} = self._stamped({self._message(read.messages[0])})")
            body += self._return(read.expr, "data")
        made = ["\n".join(head + indented(body, 8))]
        return made + (self._updates(read) if read.updates else [])

    def _variants(self, read: Read) -> list[str]:
        inside = [self._path(v.paths[0], "data") if v.how == "make" and v.paths else "data" for v in read.variants]
        if len(set(inside)) == 1:
            return self._return(read.variants[0], inside[0])
        chosen = inside[-1]
        for message, text in reversed([(m, t) for m, t in zip(read.messages, inside) if t != chosen]):
            chosen = f"{text} if isinstance(data, {self.wire}.{message.payload}) else {chosen}"
        return [f"one = {chosen}", *self._return(read.variants[0], "one")]

    def _updates(self, read: Read) -> list[str]:
        type_ = read.expr.type
        what = "list" if type_.is_list else type_.name
        call = "()" if read.as_method else ""
        return ["\n".join([f"    def updates(self, timeout: Optional[float] = None) -> Iterator[{self._type(type_)}]:",
                           f'        """Reads for ever: one {what} per new data message. Raises RequestTimeout."""',
                           f"        return self._follow(lambda: self.{read.name}{call}, timeout)"])]

    def _shortcut(self, shortcut: Shortcut) -> list[str]:
        head = ["    @property", f"    def {shortcut.name}(self) -> {self._type(shortcut.type)}:"]
        body = self._doc(shortcut.doc)
        read = f"self.{shortcut.read.name}" + ("()" if shortcut.read.as_method else "")
        if shortcut.none:
            body.append(f'return self._first_of({read}, "{shortcut.none}").{shortcut.field}')
        else:
            body.append(f"return {read}.{shortcut.field}")
        return ["\n".join(head + indented(body, 8))]

    def _take(self, take: Take) -> list[str]:
        type_ = self._type(take.expr.type)
        taken = [f"    def {take.name}(self) -> List[{type_}]:", *indented([*self._doc(take.doc), "return self._take_kept()"], 8)]
        meaning = [f"    def _meaning(self, data: Any) -> {type_}:", *indented(self._return(take.expr, "data"), 8)]
        return ["\n".join(taken), "\n".join(meaning)]

    def _call(self, call: Call) -> list[str]:
        given = [f"{name}: {type_}{default}" for a in call.arguments for name, type_, default in self._parameters(a)]
        answer = self._type(call.answer.type) if call.answer else "None"
        head = _fitted(f"    def {call.name}(", ["self", *given], f") -> {answer}:", 4)
        body = self._doc(call.doc) + self._checks(call)
        if call.moves:
            names = [] if call.moves is True else call.moves
            some = f"{names[0]} != 0.0" if len(names) == 1 else f"({', '.join(names)}) != ({', '.join(['0.0'] * len(names))})"
            body.append(f"self._moving = {some if names else True}")
        sent = [self._message(call.message)] + ([self._payload(call.payload)] if call.payload else [])
        if call.is_command:
            body += _fitted("self.command(", sent, ")", 8, 8)
        elif call.answer:
            asked = f"self._ask({', '.join(sent)})"
            whole = call.answer.how == "whole" and not call.answer.paths
            body += [f"return {asked}"] if whole else [f"data = {asked}", *self._return(call.answer, "data")]
        else:
            body += _fitted("self.request(", sent, ")", 8, 8)
        body += [self._keep(k) for k in self.proxy.kept if k.name in call.then]
        return ["\n".join(head + indented(body, 8))]

    def _parameters(self, a: Argument) -> list[tuple[str, str, str]]:
        if a.type.name in SPREAD:
            return [(name, "float", "") for name in SPREAD[a.type.name]]
        type_ = f"Sequence[{TYPES[a.type.name]}]" if a.type.is_list else self._type(a.type)
        return [(a.name, type_, f" = {_number(a.default, a.type)}" if a.default else "")]

    def _checks(self, call: Call) -> list[str]:
        lines, finite = [], []
        for a in call.arguments:
            if a.least is not None:
                least = next((f"self.{c.name}" for c in self.proxy.constants if c.value == a.least), a.least)
                lines.append(f'self._insist_on_whole("{a.name}", {a.name}, {least}, (1 << 31) - 1)')
            elif a.type.name in SPREAD:
                finite += [f"{name}={name}" for name in SPREAD[a.type.name]]
            elif a.type.name == "float" and a.type.is_list:
                lines += [f"for {a.name[:-1]} in {a.name}:", f"    self._insist_on_finite({a.name[:-1]}={a.name[:-1]})"]
            elif a.type.name == "float":
                finite.append(f"{a.name}={a.name}")
            elif a.type.name == "Pose3d" or a.type.name in self.proxies.values:
                finite.append(f"**{a.type.name}(*{a.name})._asdict()")
        return lines + ([f"self._insist_on_finite({', '.join(finite)})"] if finite else [])

    def _payload(self, payload: Node | Argument) -> str:
        if isinstance(payload, Argument):
            return payload.name
        set_ = [f"{f.name}={self._sent(f, value)}" for f, value in payload.entries]
        return f"{payload.owner}.{payload.struct.name}({', '.join(set_)})"

    def _sent(self, f, value) -> str:
        if isinstance(value, Node):
            return self._payload(value)
        if isinstance(value, list):
            return " + ".join(self._sent(f, a) for a in value)
        if not isinstance(value, Argument):
            return str(value)
        if value.choice:
            no, yes = value.choice
            return f"{self.wire}.{yes} if {value.name} else {self.wire}.{no}"
        kind = value.type.name
        if kind in SPREAD:
            names = SPREAD[kind]
            return f"common.{f.type}({', '.join(f'p{name}={name}' for name in names)})"
        if kind == "Pose3d":
            return f"common.Pose3d(*{value.name})"
        if kind in self.proxies.values or value.type.is_list:
            return f"list({value.name})"
        return {"bool": "int({})", "text": "c_string({})", "bytes": "bytes({})", "rgb": "color_of({})"}.get(kind, "{}").format(value.name)

    # Expressions

    def _path(self, path: Path, at: str) -> str:
        root = {"": at, "message": "data"}.get(path.root, f"self.{path.root}")
        return ".".join([root, *path.names])

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if e.absent:
            text = f"None if {text} == {e.absent} else {text}"
        if e.only_if:
            flags, constant = e.only_if
            text = f"{text} if {self._path(flags, at)} & {self.wire}.{constant} else None"
        return text

    def way_convert(self, e: Expr, one: str, at: str) -> str:
        return f"{FROM_WIRE[e.type.name]}({one})"

    def way_gather(self, e: Expr, one: str, at: str) -> str:
        paths = self._paths(e, at)
        return f"Pose3d(*vector_of({paths[0]}), *attitude_of({paths[1]}))" if e.type.name == "Pose3d" else f"({', '.join(paths)})"

    def way_each(self, e: Expr, one: str, at: str) -> str:
        return f"[{self._element(e)} for one in {one}]"

    def way_make(self, e: Expr, one: str, at: str) -> str:
        return f"{e.type.name}({', '.join(self._parts(e, at))})"

    def _element(self, e: Expr) -> str:
        """Of `one`: by a function of the module if it takes more than a few words."""
        assert e.one is not None
        made = self._expr(e.one, "one")
        if e.one.how != "make" or len(made) < 60:
            return made
        name, f = f"_{snake(e.one.type.name)}", e.path.last
        given = "one, data" if e.one.has_outer else "one"
        typed = given.replace("one", f"one: {f.owner}.{f.type}").replace("data", f"data: {self.wire}.Data")
        self.makers[name] = "\n".join([f"def {name}({typed}) -> {e.one.type.name}:", *indented(self._return(e.one, "one", 4), 4)])
        return f"{name}({given})"

    def _parts(self, e: Expr, at: str) -> list[str]:
        return [f"{name}={self._expr(part, at)}" for name, part in e.parts]

    def _return(self, e: Expr, at: str, indent: int = 8) -> list[str]:
        made = f"return {self._expr(e, at)}"
        if len(made) + indent <= WIDTH or e.how != "make":
            return [made]
        return [f"return {e.type.name}(", *(f"    {part}," for part in self._parts(e, at)), ")"]

    def _doc(self, doc: str) -> list[str]:
        return _docstring(_wrapped(self._spelled(doc), 8, 6), 0) if doc else []

    def _spelled(self, doc: str) -> str:
        return _spelled(doc)


def _spelled(doc: str) -> str:
    return spelled(doc, lambda name, call: name + call.replace("true", "True"), lambda what: f"Raises {what}")


def _words(text: str):
    word = ""
    for c in text + " ":
        if c.isalnum() or c == "_":
            word += c
            continue
        if word:
            yield word
            if c == "(":
                yield word + "("
        word = ""


def _number(text: str, type_: Type) -> str:
    if type_.name == "bool":
        return text.capitalize()
    return f"{text}.0" if type_.name == "float" and text.isdigit() else text


def _wrapped(doc: str, indent: int, quotes: int) -> list[str]:
    return textwrap.wrap(doc, WIDTH - indent - quotes)


def _item(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH - 4, subsequent_indent="    ")


def _docstring(lines: list[str], indent: int) -> list[str]:
    *most, last = lines
    quoted = ['"""' + line if i == 0 else line for i, line in enumerate([*most, last])]
    quoted[-1] += '"""' if not quoted[-1].endswith('"') or quoted[-1] == '"""' else ' """'
    return indented(quoted, indent)


def _fitted(start: str, parts: list[str], end: str, indent: int, offset: int = 0) -> list[str]:
    """The parts on one line, or if that is too long, on lines of their own."""
    line = start + ", ".join(parts) + end
    if len(line) + offset <= WIDTH:
        return [line]
    inner = " " * (indent - offset + 4)
    return [start, *(f"{inner}{part}," for part in parts), " " * (indent - offset) + end]


# What opens them


def _index(proxies: Proxies) -> str:
    made = {i.name: sorted([*(p.name for p in proxies.generated() if p.interface is i), *(v.name for v in proxies.values_of(i))])
            for i in proxies.modules()}
    by_hand = sorted(p.name for p in proxies.proxies if p.by_hand)
    lines = ['"""Every proxy, and what opens them.', "", "Generated from interfaces/ by codegen; do not edit.", '"""', "",
             "from typing import Any, Dict, List, Type", "", "from ...device import Access, Device", f"from ...proxies import {', '.join(by_hand)}"]
    for module, names in made.items():
        lines += _fitted(f"from .{module} import (" if len(names) > 6 else f"from .{module} import ", names, ")" if len(names) > 6 else "", 0)
    everything = sorted([*by_hand, *(n for names in made.values() for n in names)])
    lines += ["", "__all__ = [", *indented(textwrap.wrap(", ".join(f'"{n}"' for n in everything) + ",", WIDTH - 4), 4), "]", ""]
    lines += ["# Interface -> its proxy.", "PROXIES: Dict[str, Type[Device]] = {"]
    lines += [f'    "{p.interface.name}": {p.name},' for p in proxies.proxies] + ["}", ""]
    lines += ["", "class Openers:", '    """Opens a device by the method of its interface: base of Client."""', "",
              "    def _open(self, proxy: Any, interface: str, index: int, access: Access) -> Any:", "        raise NotImplementedError"]
    for p in proxies.proxies:
        lines += ["", f"    def {p.opener}(self, index: int = 0, access: Access = Access.ALL) -> {p.name}:",
                  f'        return self._open({p.name}, "{p.interface.name}", index, access)']
    lines += ["", "", "class Devices:", '    """The first device of each interface, and all of them: base of Robot."""', "",
              "    def device(self, interface: str, nth: int = 0) -> Any:", "        raise NotImplementedError", "",
              "    def _all(self, interface: str) -> Any:", "        raise NotImplementedError"]
    mine = [p for p in proxies.proxies if p.of_robot]
    for p in mine:
        lines += ["", "    @property", f"    def {p.opener}(self) -> {p.name}:", f'        return self.device("{p.interface.name}")']
    for p in mine:
        lines += ["", "    @property", f"    def {p.plural}(self) -> List[{p.name}]:", f'        return self._all("{p.interface.name}")']
    return "\n".join(lines) + "\n"
