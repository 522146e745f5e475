"""Writes clients/typescript/src/generated/proxies/: one module per interface with its values and its proxy, and index.ts with
what opens them (docs/adr/0029)."""

from __future__ import annotations

import re
import textwrap

from codegen import emit_typescript
from codegen.emit_typescript import TYPED_ARRAYS, WIDTH
from codegen.model import Field, Interface, Message
from codegen.proxies import (Argument, Call, Expr, Kept, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Type, Value,
                             spelled)
from codegen.proxies.spelling import Spelling, camel, indented, lower_first

FOLDER = f"{emit_typescript.FOLDER}/proxies"

TYPES = {"float": "number", "int": "number", "bool": "boolean", "text": "string", "bytes": "Uint8Array", "rgb": "Rgb", "rgba": "Rgba"}
BY_HAND = ("Pose", "Pose3d", "Size", "Velocity", "Vector", "Attitude", "Quaternion", "Rgb", "Rgba")
# Parameters that are taken apart, since their numbers are checked by name.
APART = {"Pose": ("x", "y", "a"), "Attitude": ("roll", "pitch", "yaw"), "Pose3d": ("x", "y", "z", "roll", "pitch", "yaw")}
# Converters of src/proxies/convert.ts.
FROM_WIRE = {"Pose": "poseOf", "Velocity": "poseOf", "Pose3d": "pose3dOf", "Size": "sizeOf", "Vector": "vectorOf", "Attitude": "attitudeOf",
             "rgb": "rgbOf", "rgba": "rgbaOf"}


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{i.name}.ts": _Module(proxies, i).text() for i in proxies.modules()}
    files[f"{FOLDER}/index.ts"] = _index(proxies)
    return files


def _maker_of(named: Type | Value) -> str:
    return f"{lower_first(named.name)}Of"


class _Module(Spelling):
    TEXTS = {"truth": "{one} !== 0", "equals": "{one} === {constant}", "bit": "({one} & {constant}) !== 0", "text": "text({one})",
             "call": "{function}({all})", "time": "time", "whole": "{one}"}

    def __init__(self, proxies: Proxies, interface: Interface) -> None:
        self.proxies, self.interface, self.wire, self.proxy = proxies, interface, interface.name, proxies.proxy_of(interface)
        self.makers: dict[str, str] = {}  # functions that make a value of an element of a list

    def text(self) -> str:
        parts = [self._value(v) for v in self.proxies.values_of(self.interface)] + ([self._class(self.proxy)] if self.proxy else [])
        body = "\n\n".join([*parts, *self.makers.values()])
        about = f"{'The proxy of' if self.proxy else 'Values of'} {self.wire}. Generated from {self.interface.source} by codegen; do not edit."
        imports = self._imports(body)
        return f"/** {about} */\n\n{imports}{body}\n"

    def _imports(self, body: str) -> str:
        """What the body names."""
        code = re.sub(r"/\*\*.*?\*/", "", body, flags=re.S)
        words = set(re.findall(r"\w+", code))
        lines = []
        if self.proxy:
            base = self.proxy.base
            lines.append(f"import {{ {base} }} from '../../{'device' if base == 'Device' else 'proxies/bases'}.js';")
        convert = {*FROM_WIRE.values(), "contents", "wireColor", *map(camel, self.proxies.functions())}
        convert |= {_maker_of(v) for v in self.proxies.values.values() if v.by_hand}
        if convert & words - set(self.makers):
            lines.append(f"import {{ {', '.join(sorted(convert & words - set(self.makers)))} }} from '../../proxies/convert.js';")
        texts = sorted(set(re.findall(r"(?<![.])\b(bytesOf|cString|joined|text)\(", code)))
        if texts:
            lines.append(f"import {{ {', '.join(texts)} }} from '../../text.js';")
        made = {v.name for v in self.proxies.values.values() if v.by_hand}
        names = [name if f"new {name}(" in code else f"type {name}" for name in sorted((made | set(BY_HAND)) & words)]
        if names:
            lines.append(_import(names, "../../values.js"))
        modules = sorted({self.wire, "common"} & set(re.findall(r"\b(\w+)\.[A-Z]", code)))
        if modules:
            used = {m for m in modules if re.search(rf"\b{m}\.(?:[A-Z_]+\d?[A-Z_]*\b|\w+\.make)", code)}
            lines.append(_import([m if m in used else f"type {m}" for m in modules], "../index.js"))
        for name in sorted(v.name for v in self.proxies.values.values() if not v.by_hand and v.interface != self.wire and v.name in words):
            lines.append(f"import type {{ {name} }} from './{self.proxies.values[name].interface}.js';")
        return "\n".join(lines) + ("\n\n" if lines else "")

    # Values

    def _value(self, value: Value) -> str:
        lines = [*_comment(_spelled(value.doc), 0), f"export interface {value.name} {{"]
        for f in value.fields:
            assert f.type is not None
            lines += [*_comment(_spelled(f.doc), 2), f"  {camel(f.name)}: {self._type(f.type)};"]
        return "\n".join([*lines, "}"])

    def _type(self, type_: Type) -> str:
        name = f"{type_.owner}.{type_.name}" if type_.owner else TYPES.get(type_.name, type_.name)
        if type_.is_list:
            return TYPED_ARRAYS[type_.wire] if type_.name == "float" else f"{name}[]"
        return f"{name} | undefined" if type_.optional else name

    # The class

    def _class(self, p: Proxy) -> str:
        take = next((m for m in p.members if isinstance(m, Take)), None)
        base = f"{p.base}<{self._type(take.expr.type)}>" if take else p.base
        parts = [[*_comment(_spelled(c.doc), 2), f"  static readonly {c.name} = {c.value};"] for c in p.constants]
        parts += [[*_comment(k.doc, 2), f"  {camel(k.name)} = {self.wire}.{k.struct.name}.make();"] for k in p.kept]
        if p.kept:
            parts.append(["  override async prepare(): Promise<void> {", *(f"    {self._keep(k)}" for k in p.kept), "  }"])
        for member in p.members:
            parts += self._member(member)
        head = [*_comment(_spelled(p.doc), 0), f"export class {p.name} extends {base} {{"]
        return "\n".join(head) + "\n" + "\n\n".join("\n".join(part) for part in parts) + "\n}"

    def _keep(self, kept: Kept) -> str:
        return f"this.{camel(kept.name)} = await contents(this.request({self._message(kept.message)}));"

    def _message(self, message: Message) -> str:
        return f"{self.wire}.{message.constant}"

    def _read(self, read: Read) -> list[list[str]]:
        head = f"  {'' if read.as_method else 'get '}{camel(read.name)}(): {self._type(read.expr.type)} {{"
        if not read.messages:
            body = self._return(read.expr, f"this.{camel(read.kept)}")
        elif read.variants:
            body = self._variants(read)
        else:
            stamped = f"this.stamped({self._message(read.messages[0])})"
            body = [f"const {{ value, time }} = {stamped};"] if read.expr.has_time else [f"const {{ value }} = {stamped};"]
            body += self._return(read.expr, "value")
        made = [*_comment(_spelled(read.doc), 2), head, *indented(body, 4), "  }"]
        return [made] + (self._updates(read) if read.updates else [])

    def _variants(self, read: Read) -> list[str]:
        kinds = " | ".join(f"{self.wire}.{m.payload}" for m in read.messages)
        inside = [self._path(v.paths[0], "value") if v.how == "make" and v.paths else "value" for v in read.variants]
        lines = _fitted(f"const value = this.newestOf<{kinds}>(", [self._message(m) for m in read.messages], ");", 4)
        if len(set(inside)) == 1:
            return [*lines, *self._return(read.variants[0], inside[0])]
        chosen = "value"
        for text in sorted({text for text in inside if text != "value"}):
            chosen = f"'{text.split('.')[1]}' in value ? {text} : {chosen}"
        return [*lines, f"const one = {chosen};", *self._return(read.variants[0], "one")]

    def _updates(self, read: Read) -> list[list[str]]:
        type_ = read.expr.type
        what = "list" if type_.is_list else type_.name
        call = "()" if read.as_method else ""
        return [[f"  /** Reads for ever: one {what} per new data message. Throws RequestTimeout after `timeout` s without. */",
                 f"  updates(timeout?: number): AsyncGenerator<{self._type(type_)}, never, void> {{",
                 f"    return this.follow(() => this.{camel(read.name)}{call}, timeout);", "  }"]]

    def _shortcut(self, shortcut: Shortcut) -> list[list[str]]:
        read = f"this.{camel(shortcut.read.name)}" + ("()" if shortcut.read.as_method else "")
        if shortcut.none:
            read = f"this.firstOf({read}, '{shortcut.none}')"
        return [[*_comment(_spelled(shortcut.doc), 2), f"  get {camel(shortcut.name)}(): {self._type(shortcut.type)} {{",
                 f"    return {read}.{camel(shortcut.field)};", "  }"]]

    def _take(self, take: Take) -> list[list[str]]:
        type_ = self._type(take.expr.type)
        return [[*_comment(_spelled(take.doc), 2), f"  {camel(take.name)}(): {type_}[] {{", "    return this.takeKept();", "  }"],
                [f"  protected override meaning(value: {self.wire}.{take.message.payload}): {type_} {{",
                 *indented(self._return(take.expr, "value"), 4), "  }"]]

    def _call(self, call: Call) -> list[list[str]]:
        answer = self._type(call.answer.type) if call.answer else "void"
        whole = call.answer is not None and call.answer.how == "whole" and not call.answer.paths
        body = self._checks(call)
        if call.moves:
            moving = "true" if call.moves is True else " || ".join(f"{camel(name)} !== 0" for name in call.moves)
            body.append(f"this.moving = {moving};")
        sent = [self._message(call.message)] + ([self._payload(call.payload)] if call.payload else [])
        if whole and not body:
            body = [f"return contents(this.request({', '.join(sent)}));"]
        elif call.answer:
            body += [f"const value = await contents(this.request({', '.join(sent)}));", *self._return(call.answer, "value")]
        else:
            body += _fitted(f"await this.{'command' if call.is_command else 'request'}(", sent, ");", 4)
        body += [self._keep(k) for k in self.proxy.kept if k.name in call.then] if self.proxy else []
        head = _fitted(f"  {'' if body[0].startswith('return') else 'async '}{camel(call.name)}(",
                       [self._parameter(a) for a in call.arguments], f"): Promise<{answer}> {{", 0)
        return [[*_comment(_spelled(call.doc), 2), *head, *indented(body, 4), "  }"]]

    def _apart(self, type_: Type) -> tuple[str, ...]:
        if type_.name in APART:
            return APART[type_.name]
        if type_.name in self.proxies.values:
            return tuple(camel(f.name) for f in self.proxies.values[type_.name].fields)
        return ()

    def _parameter(self, a: Argument) -> str:
        apart = self._apart(a.type)
        if apart:
            return f"{{ {', '.join(apart)} }}: {a.type.name}"
        if a.default:
            if self.proxy and any(c.name == a.default for c in self.proxy.constants):
                return f"{camel(a.name)}: {self._type(a.type)} = {self.proxy.name}.{a.default}"
            return f"{camel(a.name)} = {a.default}"
        return f"{camel(a.name)}: " + ("readonly number[]" if a.type.is_list else
                                       "Uint8Array | string" if a.type.name == "bytes" else self._type(a.type))

    def _checks(self, call: Call) -> list[str]:
        lines, finite = [], []
        for a in call.arguments:
            name = camel(a.name)
            if a.least is not None:
                lines.append(f"this.insistOnWhole('{a.name}', {name}, {a.least}, 2 ** 31 - 1);")
            elif a.type.name == "float" and a.type.is_list:
                lines.append(f"for (const {name[:-1]} of {name}) this.insistOnFinite({{ {name[:-1]} }});")
            elif a.type.name == "float":
                finite.append(name)
            else:
                finite += self._apart(a.type)
        return lines + ([f"this.insistOnFinite({{ {', '.join(finite)} }});"] if finite else [])

    def _payload(self, payload: Node | Argument, inner: bool = False) -> str:
        if isinstance(payload, Argument):
            return camel(payload.name)
        entries = [self._entry(f, value) for f, value in payload.entries]
        made = f"{{ {', '.join(entries)} }}"
        is_whole = len(entries) == len(payload.struct.fields)
        return made if is_whole or not inner else f"{payload.owner}.{payload.struct.name}.make({made})"

    def _entry(self, f: Field, value) -> str:
        name, sent = camel(f.name), self._sent(f, value)
        return name if name == sent else f"{name}: {sent}"

    def _sent(self, f: Field, value) -> str:
        if isinstance(value, Node):
            return self._payload(value, True)
        if isinstance(value, list):
            return f"joined([{', '.join(self._sent(f, a) for a in value)}])"
        if not isinstance(value, Argument):
            return str(value)
        name = camel(value.name)
        if value.choice:
            no, yes = value.choice
            return f"{name} ? {self.wire}.{yes} : {self.wire}.{no}"
        kind, apart = value.type.name, self._apart(value.type)
        if kind in self.proxies.values:
            return f"{TYPED_ARRAYS[f.type]}.of({', '.join(apart)})"
        if apart:
            made = f"{{ {', '.join(f'p{part}: {part}' for part in apart)} }}"
            return f"common.{f.type}.make({made})" if kind == "Attitude" and f.type == "Pose3d" else made
        if value.type.is_list:
            return f"{TYPED_ARRAYS[f.type]}.from({name})"
        made = {"bool": "Number({})", "text": "cString({})", "bytes": "bytesOf({})", "rgb": "wireColor({})"}
        return made.get(kind, "{}").format(name)

    # Expressions

    def _path(self, path: Path, at: str) -> str:
        root = {"": at, "message": "value"}.get(path.root, f"this.{camel(path.root)}")
        return ".".join([root, *map(camel, path.names)])

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if e.absent:
            text = f"{text} === {e.absent} ? undefined : {text}"
        if e.only_if:
            flags, constant = e.only_if
            text = f"{self._path(flags, at)} & {self.wire}.{constant} ? {text} : undefined"
        return text

    def _function(self, name: str) -> str:
        return camel(name)

    def way_convert(self, e: Expr, one: str, at: str) -> str:
        return f"{FROM_WIRE[e.type.name]}({one})"

    def way_gather(self, e: Expr, one: str, at: str) -> str:
        paths = self._paths(e, at)
        return f"pose3dOf({{ ...{paths[0]}, ...{paths[1]} }})" if e.type.name == "Pose3d" else f"[{', '.join(paths)}]"

    def way_unpack(self, e: Expr, one: str, at: str) -> str:
        return f"{_maker_of(e.type)}({one})"

    def way_each(self, e: Expr, one: str, at: str) -> str:
        made = self._element(e)
        made = f"({made})" if made.startswith("{") else made
        call = re.fullmatch(r"(\w+)\(one\)", made)
        mapped = call[1] if call else f"(one) => {made}"
        return f"Array.from({one}, {mapped})" if e.path.last.is_raw else f"{one}.map({mapped})"

    def way_make(self, e: Expr, one: str, at: str) -> str:
        if self.proxies.values[e.type.name].by_hand:
            return f"new {e.type.name}({', '.join(self._expr(part, at) for _, part in e.parts)})"
        return f"{{ {', '.join(self._parts(e, at))} }}"

    def _element(self, e: Expr) -> str:
        """Of `one`: by a function of the module if it takes more than a few words."""
        assert e.one is not None
        made = self._expr(e.one, "one")
        if e.one.how != "make" or len(made) < 70:
            return made
        name, f = _maker_of(e.one.type), e.path.last
        typed = f"one: {f.owner}.{f.type}" + (f", value: {self.wire}.Data" if e.one.has_outer else "")
        self.makers[name] = "\n".join([f"function {name}({typed}): {e.one.type.name} {{", *indented(self._return(e.one, "one", 2), 2), "}"])
        return f"{name}({'one, value' if e.one.has_outer else 'one'})"

    def _parts(self, e: Expr, at: str) -> list[str]:
        made = [(camel(name), self._expr(part, at)) for name, part in e.parts]
        return [name if name == text else f"{name}: {text}" for name, text in made]

    def _return(self, e: Expr, at: str, indent: int = 4) -> list[str]:
        made = f"return {self._expr(e, at)};"
        if len(made) + indent <= WIDTH or e.how != "make":
            return [made]
        if self.proxies.values[e.type.name].by_hand:
            return _fitted(f"return new {e.type.name}(", [self._expr(part, at) for _, part in e.parts], ");", indent)
        return ["return {", *(f"  {part}," for part in self._parts(e, at)), "};"]


def _import(names: list[str], source: str) -> str:
    if all(name.startswith("type ") for name in names):
        return f"import type {{ {', '.join(name[5:] for name in names)} }} from '{source}';"
    return f"import {{ {', '.join(names)} }} from '{source}';"


def _spelled(doc: str) -> str:
    def name(text: str, call: str) -> str:
        return ".".join(camel(part) if part[0].islower() else part for part in text.split(".")) + call

    return spelled(doc, name, lambda what: f"Throws {what}")


def _comment(doc: str, indent: int) -> list[str]:
    if not doc:
        return []
    return emit_typescript._comment(textwrap.wrap(doc, WIDTH - indent - 7), indent).split("\n")


def _fitted(start: str, parts: list[str], end: str, offset: int) -> list[str]:
    """The parts on one line, or if that is too long, on lines of their own."""
    line = start + ", ".join(parts) + end
    if len(line) + offset <= WIDTH:
        return [line]
    space = " " * (len(start) - len(start.lstrip()))
    return [start, *(f"{space}  {part}," for part in parts), space + end]


# What opens them


def _index(proxies: Proxies) -> str:
    by_hand = [p for p in proxies.proxies if p.by_hand]
    modules = [i.name for i in proxies.modules()]
    lines = ["/** Every proxy, and what opens them. Generated from interfaces/ by codegen; do not edit. */", "",
             "import { Access, type Device } from '../../device.js';"]
    lines += [f"import {{ {p.name} }} from '../../proxies/{p.interface.name}.js';" for p in by_hand]
    lines += [f"import {{ {p.name} }} from './{p.interface.name}.js';" for p in proxies.generated()]
    lines += ["", f"export {{ {', '.join(p.name for p in by_hand)} }};"]
    lines += [f"export * from './{name}.js';" for name in modules]
    lines += ["", "/** Interface -> its proxy. */", "export const PROXIES = {"]
    lines += [f"  {p.interface.name}: {p.name}," for p in proxies.proxies] + ["} as const;", ""]
    lines += ["/** The class of a device of this interface. */", "export type ProxyOf<Name extends string> =",
              "  Name extends keyof typeof PROXIES ? InstanceType<(typeof PROXIES)[Name]> : Device;", ""]
    lines += ["/** Opens a device by the method of its interface: base of Client. */", "export abstract class Openers {",
              "  abstract device<Name extends string>(name: Name, index?: number, access?: Access): Promise<ProxyOf<Name>>;"]
    for p in proxies.proxies:
        lines += ["", f"  {camel(p.opener)}(index = 0, access: Access = Access.ALL): Promise<{p.name}> {{",
                  f"    return this.device('{p.interface.name}', index, access);", "  }"]
    mine = [p for p in proxies.proxies if p.of_robot]
    lines += ["}", "", "/** The device of each interface at an index from 0, and all of them: base of Robot. */", "export abstract class Devices {",
              "  abstract device<Name extends string>(name: Name, nth?: number): Promise<ProxyOf<Name>>;", "",
              "  protected abstract all<Name extends string>(name: Name): Promise<ProxyOf<Name>[]>;"]
    for p in mine:
        lines += ["", f"  {camel(p.opener)}(nth = 0): Promise<{p.name}> {{", f"    return this.device('{p.interface.name}', nth);", "  }"]
    for p in mine:
        lines += ["", f"  {camel(p.plural)}(): Promise<{p.name}[]> {{", f"    return this.all('{p.interface.name}');", "  }"]
    return "\n".join([*lines, "}", ""])
