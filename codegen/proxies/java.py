"""Writes the proxies to clients/java/generated/playhouse/client/: a record per value, a class per proxy, and Openers and Robot's
Devices, which open them (docs/adr/0029)."""

from __future__ import annotations

import re

from codegen import emit_java
from codegen.emit_java import WIDTH, component
from codegen.model import Field, Message
from codegen.proxies import (Argument, Call, Expr, Kept, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Type, Value,
                             spelled)
from codegen.proxies.spelling import Spelling, camel, lower_first, indented

FOLDER = f"{emit_java.FOLDER}/playhouse/client"

TYPES = {"float": "double", "int": "int", "bool": "boolean", "text": "String", "bytes": "byte[]", "rgb": "Color", "rgba": "Color",
         "Vector": "Vector3"}
BOXES = {"double": "Double", "int": "Integer", "long": "Long", "boolean": "Boolean"}
# Values and classes whose names Java or the library has for something else.
RENAMED = {"Point": "CloudPoint", "Map": "GridMap"}
STANDARD = ("Pose", "Velocity", "Pose3d", "Size", "Vector", "Attitude", "rgb", "rgba")


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files: dict[str, str] = {}
    for interface in proxies.modules():
        for value in proxies.values_of(interface):
            files[f"{FOLDER}/{_renamed(value.name)}.java"] = _value(proxies, value)
    for proxy in proxies.generated():
        files[f"{FOLDER}/{_renamed(proxy.name)}.java"] = _Class(proxies, proxy).text()
    files[f"{FOLDER}/Openers.java"] = _openers(proxies)
    files[f"{FOLDER}/Devices.java"] = _devices(proxies)
    return files


def _renamed(name: str) -> str:
    return RENAMED.get(name, name)


def _type(type_: Type) -> str:
    if type_.owner:
        name = f"{emit_java._class_of(type_.owner)}.{type_.name}"
    elif type_.name == "int":
        name = "long" if type_.wire in ("uint32", "int64", "") else "int"
    else:
        name = TYPES.get(type_.name, _renamed(type_.name))
    if type_.is_list:
        return "double[]" if name == "double" else f"List<{BOXES.get(name, name)}>"
    if type_.optional:
        return "OptionalDouble" if name == "double" else f"Optional<{BOXES.get(name, name)}>"
    return name


def _boxed(type_: Type) -> str:
    return BOXES.get(_type(type_), _type(type_))


def _spelled(doc: str) -> str:
    def name(text: str, call: str) -> str:
        *outer, last = text.split(".")
        return ".".join([*map(_renamed, outer), camel(last)]) + (call or ("()" if outer and last[0].islower() else ""))

    return spelled(doc, name, lambda what: f"Throws {what}Exception")


def _javadoc(doc: str, indent: int = 2, parameters: dict[str, str] | None = None) -> list[str]:
    return emit_java._javadoc(_spelled(doc), indent, parameters) if doc else []


def _file(source: str, imports: set[str], lines: list[str]) -> str:
    listed = [f"import {name};" for name in sorted(imports)]
    return "\n".join([emit_java._banner(source), "package playhouse.client;", "", *listed, *([""] if listed else []), *lines, ""])


def _needed(text: str) -> set[str]:
    """What a file has to import."""
    known = {name: f"java.util.{name}" for name in ("List", "Optional", "OptionalDouble")}
    known |= {name: f"playhouse.client.wire.{name}" for name in ("MessageType", "Struct", "Text")}
    known |= {name: f"playhouse.client.wire.{name}" for name in re.findall(r"\b[A-Z]\w*Messages\b", text)}
    code = re.sub(r"/\*\*.*?\*/", "", text, flags=re.S)
    return {path for name, path in known.items() if re.search(rf"\b{name}\b", code)}


def _value(proxies: Proxies, value: Value) -> str:
    parts = [f"{_type(f.type)} {camel(f.name)}" for f in value.fields if f.type]
    told = {camel(f.name): _spelled(f.doc) for f in value.fields if f.doc}
    head = f"public record {_renamed(value.name)}("
    line = f"{head}{', '.join(parts)}) {{}}"
    body = [line] if len(line) <= WIDTH else [head, *_filled(", ".join(parts) + ") {}", 4)]
    lines = [*_javadoc(value.doc, 0, told), *body]
    return _file(proxies.schema.interface(value.interface).source, _needed("\n".join(body)), lines)


class _Class(Spelling):
    TEXTS = {"truth": "{one} != 0", "equals": "{one} == {constant}", "bit": "({one} & {constant}) != 0", "text": "Text.of({one})",
             "convert": "{type}.of({one})", "unpack": "{type}.of({one})", "call": "Convert.{function}({all})", "time": "stamped.time()",
             "whole": "{one}"}

    def __init__(self, proxies: Proxies, proxy: Proxy) -> None:
        self.proxies, self.proxy, self.name = proxies, proxy, _renamed(proxy.name)
        self.wire = emit_java.class_name(proxy.interface)
        self.makers: dict[str, list[str]] = {}  # functions that make a value of a struct of the wire

    def text(self) -> str:
        p, updates = self.proxy, self.proxy.updates
        take = next((m for m in p.members if isinstance(m, Take)), None)
        base = p.base
        if take or updates:
            base = f"{base if base != 'Device' else 'Updating'}<{_boxed(take.expr.type if take else updates.expr.type)}>"
        parts = [[*_javadoc(c.doc), f"  public static final int {c.name} = {c.value};"] for c in p.constants]
        parts += [[f"  private {self._struct(k)} {camel(k.name)} = new {self._struct(k)}();" for k in p.kept]] if p.kept else []
        parts.append([f"  {self.name}(Opening opening) {{", "    super(opening);", "  }"])
        if p.kept:
            parts.append(["  @Override", "  void prepare() {", *(f"    {self._keep(k)}" for k in p.kept), "  }"])
            parts += [[*_javadoc(f"{k.doc[:-1]}; all zero if the driver tells none."), f"  public {self._struct(k)} {camel(k.name)}() {{",
                       f"    return {camel(k.name)};", "  }"] for k in p.kept]
        for member in p.members:
            parts += self._member(member)
        if updates:
            parts.append(["  @Override", f"  {_boxed(updates.expr.type)} newest() {{", f"    return {camel(updates.name)}();", "  }"])
        parts += list(self.makers.values())
        body = "\n".join([f"public final class {self.name} extends {base} {{", "\n\n".join("\n".join(part) for part in parts), "}"])
        return _file(p.interface.source, _needed(body), [*_javadoc(p.doc, 0), body])

    def _struct(self, kept: Kept) -> str:
        return f"{self.wire}.{kept.struct.name}"

    def _keep(self, kept: Kept) -> str:
        return f"this.{camel(kept.name)} = answer({self._message(kept.message)});"

    def _message(self, message: Message) -> str:
        return f"{self.wire}.{message.constant}"

    def _read(self, read: Read) -> list[list[str]]:
        if not read.messages:
            doc, body = read.doc, self._return(read.expr, camel(read.kept))
        else:
            doc = read.doc or f"The newest {read.name.replace('_', ' ')}."
            doc += "" if "{raises NoData}" in doc else " {raises NoData}."
            body = self._variants(read) if read.variants else self._of_message(read)
        return [[*_javadoc(doc), f"  public {_type(read.expr.type)} {camel(read.name)}() {{", *indented(body, 4), "  }"]]

    def _of_message(self, read: Read) -> list[str]:
        message = read.messages[0]
        kind = f"{self.wire}.{message.payload}"
        if not read.expr.has_time:
            return [f"{kind} data = stamped({self._message(message)}).value();", *self._return(read.expr, "data")]
        return [f"Stamped<{kind}> stamped = stamped({self._message(message)});", f"{kind} data = stamped.value();",
                *self._return(read.expr, "data")]

    def _variants(self, read: Read) -> list[str]:
        lines = [f"Struct data = newestOf({', '.join(self._message(m) for m in read.messages)});"]
        for i, (message, e) in enumerate(zip(read.messages, read.variants)):
            kind = f"{self.wire}.{message.payload}"
            inside = e.paths[0] if e.how == "make" and e.paths else None
            struct = (f"{emit_java._class_of(inside.last.owner)}.{inside.last.type}" if inside else kind)
            at = self._path(inside, "one") if inside else "one"
            made = self._maker(e, struct).format(at) if e.how == "make" else self._expr(e, at)
            if i < len(read.messages) - 1:
                lines += [f"if (data instanceof {kind} one) {{", f"  return {made};", "}"]
            else:
                lines += [f"{kind} one = ({kind}) data;", f"return {made};"]
        return lines

    def _shortcut(self, shortcut: Shortcut) -> list[list[str]]:
        is_truth = shortcut.type.name == "bool"
        name = camel(f"is_{shortcut.name}" if is_truth else shortcut.name)
        read = f"{camel(shortcut.read.name)}()"
        read = f'firstOf({read}, "{shortcut.none}")' if shortcut.none else read
        doc = shortcut.doc or f"Of the newest {shortcut.read.name}."
        doc += "" if "{raises NoData}" in doc else " {raises NoData}."
        return [[*_javadoc(doc), f"  public {_type(shortcut.type)} {name}() {{", f"    return {read}.{camel(shortcut.field)}();", "  }"]]

    def _take(self, take: Take) -> list[list[str]]:
        type_, kind = _boxed(take.expr.type), f"{self.wire}.{take.message.payload}"
        return [[*_javadoc(take.doc), f"  public List<{type_}> {camel(take.name)}() {{", "    return takeKept();", "  }"],
                ["  @Override", f"  {type_} meaning(Struct value) {{", f"    {kind} data = ({kind}) value;",
                 *indented(self._return(take.expr, "data"), 4), "  }"]]

    # Commands and requests

    def _call(self, call: Call) -> list[list[str]]:
        answer = _type(call.answer.type) if call.answer else "void"
        body = self._checks(call)
        if call.moves:
            moving = "true" if call.moves is True else " || ".join(f"{camel(name)} != 0" for name in call.moves)
            body.append(f"setMoving({moving});")
        sent = [self._message(call.message)] + ([self._payload(call.payload)] if call.payload else [])
        if call.answer and call.answer.how == "whole" and not call.answer.paths:
            body += _fitted("return answer(", sent, ");", 4)
        elif call.answer:
            body += _fitted(f"{self.wire}.{call.message.payload} data = answer(", sent, ");", 4)
            body += self._return(call.answer, "data")
        else:
            body += _fitted("command(" if call.is_command else "request(", sent, ");", 4)
        body += [self._keep(k) for k in self.proxy.kept if k.name in call.then]
        head = _fitted(f"  public {answer} {camel(call.name)}(", [self._parameter(a) for a in call.arguments], ") {", 0)
        return [*self._overloads(call, answer), [*_javadoc(call.doc), *head, *indented(body, 4), "  }"]]

    def _overloads(self, call: Call, answer: str) -> list[list[str]]:
        """With defaults for the last arguments."""
        made = []
        required = sum(not a.default for a in call.arguments)
        for count in range(required, len(call.arguments)):
            given = call.arguments[:count]
            passed = ", ".join([camel(a.name) for a in given] + [a.default for a in call.arguments[count:]])
            made.append([f"  /** The same as {camel(call.name)}({passed}). */",
                         f"  public {answer} {camel(call.name)}({', '.join(map(self._parameter, given))}) {{",
                         f"    {'return ' if answer != 'void' else ''}{camel(call.name)}({passed});", "  }"])
        return made

    def _parameter(self, a: Argument) -> str:
        return f"{'int' if a.type.name == 'int' else _type(a.type)} {camel(a.name)}"

    def _checks(self, call: Call) -> list[str]:
        lines = []
        for a in call.arguments:
            name = camel(a.name)
            if a.least is not None:
                lines.append(f'insistOnWhole("{a.name}", {name}, {a.least}, Integer.MAX_VALUE);')
            elif a.type.name in ("Pose", "Pose3d"):
                lines.append(f"insistOnFinite({name});")
            elif a.type.name == "float" and a.type.wire == "float64":
                lines.append(f'insistOnFinite("{a.name}", {name});')
            elif a.type.name == "Attitude":
                lines += [f'insistOnFinite("{part}", {name}.{part}());' for part in ("roll", "pitch", "yaw")]
            elif a.type.name in self.proxies.values:
                lines += [f'insistOnFinite("{f.name}", {name}.{camel(f.name)}());' for f in self.proxies.values[a.type.name].fields]
        return lines

    def _payload(self, payload: Node | Argument) -> str:
        if isinstance(payload, Argument):
            return camel(payload.name)
        made = {f.name: self._sent(f, value) for f, value in payload.entries}
        parts = [made.get(f.name) or _zero(f) for f in payload.struct.fields]
        return f"new {emit_java._class_of(payload.owner)}.{payload.struct.name}({', '.join(parts)})"

    def _sent(self, f: Field, value) -> str:
        if isinstance(value, Node):
            return self._payload(value)
        if isinstance(value, list):
            return f"Convert.joined({', '.join(self._sent(f, a) for a in value)})"
        if not isinstance(value, Argument):
            return str(value)
        name, kind = camel(value.name), value.type.name
        if value.choice:
            return f"{name} ? {self.wire}.{value.choice[1]} : {self.wire}.{value.choice[0]}"
        if kind in ("Pose", "Pose3d", "Attitude", "rgb") or kind in self.proxies.values:
            return f"{name}.onWire()"
        if kind == "float" and f.type == "float32":
            return f'narrowed("{value.name[:-1] if value.type.is_list else value.name}", {name})'
        return {"bool": "{} ? 1 : 0", "text": "Text.field({})"}.get(kind, "{}").format(name)

    # Expressions

    def _path(self, path: Path, at: str) -> str:
        root = {"": at, "message": "data"}.get(path.root, camel(path.root))
        return root + "".join(f".{component(f)}()" for f in path.fields)

    def _number(self, path: Path, at: str) -> str:
        text = self._path(path, at)
        return f"Doubles.of({text})" if path.last.is_array and path.last.type == "float32" else text

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if not e.type.optional:
            return text
        if e.only_if:
            flags, constant = e.only_if
            return f"Convert.onlyIf({self._path(flags, at)}, {self.wire}.{constant}, {text})"
        return f"Convert.unless({e.absent}, {text})"

    def _paths(self, e: Expr, at: str) -> list[str]:
        return [self._number(p, at) for p in e.paths]

    def _function(self, name: str) -> str:
        return camel(name)

    def _type_name(self, e: Expr) -> str:
        return _type(e.type)

    def way_gather(self, e: Expr, one: str, at: str) -> str:
        of = f"{_type(e.type)}.of" if e.type.name == "Pose3d" else f"new {_type(e.type)}"
        return f"{of}({', '.join(self._paths(e, at))})"

    def way_make(self, e: Expr, one: str, at: str) -> str:
        return f"{self._made(e)}({', '.join(self._expr(part, at) for _, part in e.parts)})"

    def _made(self, e: Expr) -> str:
        return f"{e.type.name}.of" if self.proxies.values[e.type.name].by_hand else f"new {_type(e.type)}"

    def way_each(self, e: Expr, one: str, at: str) -> str:
        assert e.one is not None
        if e.path.last.is_raw:
            return f"Convert.truths({one})"
        f = e.path.last
        if e.one.how == "convert":
            made = f"{_type(e.one.type)}::of"
        elif e.one.how == "make" and len(self._expr(e.one, "one")) > 60:
            text = self._maker(e.one, f"{emit_java._class_of(f.owner)}.{f.type}")
            made = f"{self.name}::{text.split('(')[0]}" if not e.one.has_outer else f"one -> {text.format('one')}"
        else:
            made = f"one -> {self._expr(e.one, 'one')}"
        return f"{one}.stream().map({made}).toList()"

    def _maker(self, e: Expr, struct: str) -> str:
        """A call, with {} for the struct, of a function that makes the value."""
        name = f"{lower_first(e.type.name)}Of"
        outer = f", {self.wire}.Data data" if e.has_outer else ""
        made = self._return(e, "one")
        self.makers[name] = [f"  private static {_type(e.type)} {name}({struct} one{outer}) {{", *indented(made, 4), "  }"]
        return f"{name}({{}}{', data' if outer else ''})"

    def _return(self, e: Expr, at: str) -> list[str]:
        made = f"return {self._expr(e, at)};"
        if len(made) + 4 <= WIDTH or e.how not in ("make", "each"):
            return [made]
        if e.how == "each":
            start, end = made.split(".stream()")
            return [f"{start}.stream()", f"    .{end[1:]}"]
        return [f"return {self._made(e)}(", *_filled(",\n".join(self._expr(part, at) for _, part in e.parts) + ");", 4)]


def _zero(f: Field) -> str:
    if f.is_raw:
        return "new byte[0]"
    if f.is_array and not f.is_scalar:
        return "List.of()"
    return "0" if f.is_scalar else f"new {emit_java._class_of(f.owner)}.{f.type}()"


def _filled(text: str, indent: int) -> list[str]:
    """Words that belong together are separated by spaces; parts by line ends, or by ", "."""
    parts = text.split("\n") if "\n" in text else [part + "," for part in text.split(", ")]
    parts[-1] = parts[-1].rstrip(",")
    lines = [""]
    for part in parts:
        if lines[-1] and len(lines[-1]) + 1 + len(part) + indent + 4 > WIDTH:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + part
    return indented(lines, indent)


def _fitted(start: str, parts: list[str], end: str, offset: int) -> list[str]:
    """The parts on one line, or if that is too long, on more."""
    line = start + ", ".join(parts) + end
    if len(line) + offset <= WIDTH:
        return [line]
    return [start, *_filled(",\n".join(parts) + end, len(start) - len(start.lstrip()) + 4)]


# What opens them


def _plural(proxy: Proxy) -> str:
    name = lower_first(proxy.name)
    return name + proxy.plural[len(proxy.interface.name):]


def _openers(proxies: Proxies) -> str:
    lines = ["/** Opens a device by the method of its interface: base of Client. */", "abstract class Openers {",
             "  /** Interface -> its proxy. */", "  static final Map<String, Function<Opening, Device>> PROXIES = Map.ofEntries("]
    rows = [f'      Map.entry("{p.interface.name}", {_renamed(p.name)}::new)' for p in proxies.proxies]
    lines += [",\n".join(rows) + ");", "",
              "  abstract <D extends Device> D open(Function<Opening, D> proxy, String interfaceName, int index, Access access);"]
    for p in proxies.proxies:
        name, method = _renamed(p.name), lower_first(p.name)
        lines += ["", f"  public {name} {method}(int index) {{", f"    return {method}(index, Access.ALL);", "  }", "",
                  f"  public {name} {method}(int index, Access access) {{", f'    return open({name}::new, "{p.interface.name}", index, access);', "  }"]
    return _file("interfaces/", {"java.util.Map", "java.util.function.Function"}, [*lines, "}"])


def _devices(proxies: Proxies) -> str:
    lines = ["/** The first device of each interface, and all of them: base of Robot. */", "abstract class Devices {",
             "  abstract Device device(String interfaceName);", "",
             "  abstract <D extends Device> List<D> all(Class<D> type, String interfaceName);"]
    for p in proxies.proxies:
        if p.of_robot:
            name = _renamed(p.name)
            lines += ["", f"  public {name} {lower_first(p.name)}() {{", f'    return ({name}) device("{p.interface.name}");', "  }", "",
                      f"  public List<{name}> {_plural(p)}() {{", f'    return all({name}.class, "{p.interface.name}");', "  }"]
    return _file("interfaces/", {"java.util.List"}, [*lines, "}"])
