"""Writes the proxies to clients/cpp/generated/: playhouse_client/NAME.h and NAME.cc per interface, and RobotDevices, which opens
those of a robot (docs/adr/0029)."""

from __future__ import annotations

import re
import textwrap

from codegen.emit_cpp import SCALAR_TYPES, WIDTH, banner, constant_name
from codegen.model import COMMON, Field, Message
from codegen.proxies import (Argument, Call, Expr, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Type, Value, spelled)
from codegen.proxies.spelling import Spelling, snake, indented

FOLDER = "clients/cpp/generated"
HEADERS = f"{FOLDER}/playhouse_client"

TYPES = {"float": "double", "bool": "bool", "text": "std::string", "bytes": "std::vector<std::uint8_t>", "rgb": "Rgb",
         "rgba": "std::array<std::uint8_t, 4>", "Vector": "std::array<double, 3>", "Quaternion": "std::array<double, 4>"}
# Values whose names the library has for something else, and those that are members of their class.
RENAMED = {"Point": "CloudPoint"}
NESTED = {"State", "State3d"}
# Values written by hand -> their header.
BY_HAND = {"Pose": "pose", "Pose3d": "pose", "Size": "pose", "Velocity": "pose", "Geometry": "pose", "Attitude": "attitude", "Rgb": "color",
           "Scan": "scan", "Marker": "marker", "Image": "image", "Covariance": "covariance", "Charging": "charging"}
# Of the standard library -> its header.
STANDARD = {"std::array": "array", "std::optional": "optional", "std::span": "span", "std::string": "string", "std::string_view": "string_view",
            "std::vector": "vector", "std::uint": "cstdint", "std::int": "cstdint", "std::move": "utility"}
APART = {"Pose": ("x", "y", "a"), "Pose3d": ("x", "y", "z", "roll", "pitch", "yaw"), "Attitude": ("roll", "pitch", "yaw")}


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files: dict[str, str] = {}
    for proxy in proxies.generated():
        made = _Class(proxies, proxy)
        source = made.source()
        files[f"{HEADERS}/{proxy.interface.name}.h"] = made.header()
        files[f"{FOLDER}/{proxy.interface.name}.cc"] = source
    files[f"{HEADERS}/robot_devices.h"] = _robot_header(proxies)
    files[f"{FOLDER}/robot_devices.cc"] = _robot_source(proxies)
    return files


def _value_name(name: str) -> str:
    return "State" if name in NESTED else RENAMED.get(name, name)


def _type(type_: Type) -> str:
    if type_.owner:
        name = f"wire::{type_.owner}::{type_.name}"
    elif type_.name == "int":
        name = {"uint8": "std::uint32_t", "uint16": "std::uint32_t", "uint32": "std::uint32_t", "": "std::int64_t",
                "int64": "std::int64_t"}.get(type_.wire, "std::int32_t")
    else:
        name = TYPES.get(type_.name, _value_name(type_.name))
    if type_.is_list:
        return f"std::vector<{name}>"
    return f"std::optional<{name}>" if type_.optional else name


def _read_type(type_: Type) -> str:
    """Of what there may be none yet: an empty list, or nothing."""
    is_list = type_.is_list or type_.name == "bytes"
    return _type(type_) if is_list else f"std::optional<{_type(type_)}>"


def _spelled(doc: str) -> str:
    def name(text: str, call: str) -> str:
        *outer, last = text.split(".")
        last = constant_name(last) if last.isupper() else last
        return "::".join([*map(_value_name, outer), last]) + call

    return spelled(doc, name, lambda what: "Nothing" if what == "NoData" else "An error")


def _comment(doc: str, indent: str = "") -> list[str]:
    return [f"{indent}/// {line}" for line in textwrap.wrap(_spelled(doc), WIDTH - len(indent) - 4)] if doc else []


def _includes(text: str, own: set[str]) -> list[str]:
    standard = sorted({f"#include <{header}>" for name, header in STANDARD.items() if name in text})
    return [*standard, *([""] if standard else []), *(f'#include "{path}"' for path in sorted(own))]


class _Class(Spelling):
    TEXTS = {"truth": "{one} != 0", "equals": "{one} == {constant}", "bit": "({one} & {constant}) != 0", "text": "client::text_of({one})",
             "convert": "client::{type}({one})", "unpack": "client::{type}({one})", "call": "client::{function}({all})",
             "time": "device_.timestamp()", "whole": "{one}"}

    def __init__(self, proxies: Proxies, proxy: Proxy) -> None:
        self.proxies, self.proxy, self.wire = proxies, proxy, proxy.interface.name
        self.makers: dict[str, list[str]] = {}  # functions that make a value of a struct of the wire
        self.inside = ""  # "client::" where a member of the class has the name of a converter

    # The header

    def header(self) -> str:
        p = self.proxy
        values = self.proxies.values_of(p.interface)
        outside = [line for v in values if v.name not in NESTED for line in [*self._value(v, ""), ""]]
        lines = [*_comment(p.doc), f"class {p.name}{self._base()} {{", " public:"]
        lines += [line for v in values if v.name in NESTED for line in [*self._value(v, "  "), ""]]
        for c in p.constants:
            lines.append(f"  static constexpr std::int32_t {constant_name(c.name)} = {c.value};  // "
                         + _spelled(c.doc)[0].lower() + _spelled(c.doc)[1:-1])
        lines += [""] if p.constants else []
        lines += [f"  static Result<{p.name}> open(Client& client, std::uint16_t index, Access access = Access::kAll);", ""]
        if p.base == "Mobile":
            lines += [f"  {p.name}({p.name}&&) noexcept = default;", f"  {p.name}& operator=({p.name}&& other) noexcept;", "  /// As close().",
                      f"  ~{p.name}();", ""]
        for k in p.kept:
            lines += [*_comment(k.doc, "  "), f"  const wire::{self.wire}::{k.struct.name}& {k.name}() const {{ return {k.name}_; }}"]
        for member in p.members:
            lines += [line for doc, text in self._declared(member) for line in [*_comment(doc, "  "), *_fitted_declaration(text)]]
        if p.base == "Mobile":
            lines += ["  Result<void> stop() { return drive(0.0); }",
                      *_comment("Requests why the driver (nd, vfh) does not drive to the goal of the last go_to(), as its log says; empty if it does, "
                                "has arrived, or is a driver that gives no reasons.", "  "), "  Result<std::string> why_refused();",
                      "  /// Stops the robot if the last command was a motion, and closes the device.", "  Result<void> close();"]
        lines += self._private()
        body = "\n".join([*outside, *lines])
        own = {f"playhouse/wire/generated/{self.wire}.h", "playhouse_client/client.h"}
        own |= {f"playhouse_client/{header}.h" for name, header in BY_HAND.items() if re.search(rf"\b{name}\b", re.sub("//.*", "", body))}
        own |= {f"playhouse_client/{p.base.lower()}.h"} if p.base in ("Keeping", "Selecting") else set()
        head = [banner(p.interface.source).rstrip(), "#pragma once", "", *_comment(f"The proxy of {self.wire}."), "", *_includes(body, own), "",
                "namespace playhouse::client {", ""]
        return "\n".join([*head, body, "", "}  // namespace playhouse::client", ""])

    def _base(self) -> str:
        return f" : public {self.proxy.base}" if self.proxy.base in ("Keeping", "Selecting") else ""

    def _private(self) -> list[str]:
        p = self.proxy
        has_base = bool(self._base())
        lines = [] if has_base else ["", "  Device& device() { return device_; }"]
        lines += ["", " private:", "  friend class RobotDevices;"]
        lines += [f"  static Result<{p.name}> prepare(Device device);"] if p.kept else []
        lines.append(f"  explicit {p.name}(Device device) : {p.base if has_base else 'device_'}(std::move(device)) {{}}")
        lines += [] if has_base else ["", "  Device device_;"]
        lines += [f"  wire::{self.wire}::{k.struct.name} {k.name}_;" for k in p.kept]
        lines += ["  bool moving_ = false;"] if p.base == "Mobile" else []
        return [*lines, "};"]

    def _value(self, value: Value, indent: str) -> list[str]:
        lines = [*_comment(value.doc, indent), f"{indent}struct {_value_name(value.name)} {{"]
        for f in value.fields:
            assert f.type is not None
            name = "std::array<double, 3>" if f.type.name == "Attitude" else _type(f.type)
            by_hand = f.type.name in BY_HAND and not name.startswith("std::array")
            initial = "" if "optional" in name or "vector" in name or name == "std::string" or by_hand else \
                " = false" if name == "bool" else "{}" if "array" in name or name == "Rgb" else " = 0"
            lines += [*_comment(f.doc, indent + "  "), f"{indent}  {name} {f.name}{initial};"]
        lines.append(f"{indent}  friend bool operator==(const {_value_name(value.name)}&, const {_value_name(value.name)}&) = default;")
        return [*lines, f"{indent}}};"]

    def _declared(self, member) -> list[tuple[str, str]]:
        """Documentation and declaration of each function, without the name of the class."""
        if isinstance(member, Read):
            if not member.messages:
                return [(member.doc, f"{_type(member.expr.type)} {member.name}() const")]
            none = "empty" if member.expr.type.is_list or member.expr.type.name == "bytes" else "none"
            doc = member.doc or f"The newest {member.name.replace('_', ' ')}."
            return [(f"{doc[:-1]}; {none} before the first data.", f"{_read_type(member.expr.type)} {member.name}() const")]
        if isinstance(member, Shortcut):
            none = "empty" if member.type.is_list else "none"
            doc = member.doc or f"Of the newest {member.read.name}."
            return [(f"{doc[:-1]}; {none} before the first data.", f"{_read_type(member.type)} {member.name}() const")]
        if isinstance(member, Take):
            return [(member.doc, f"std::vector<{self._taken(member)}> {member.name}()")]
        made = [(member.doc, self._signature(member, True))]
        whole = self._settable(member)
        return made + ([(f"The same as {self._settable_getter(member)}() gives them.",
                         f"Result<void> {member.name}(const {whole}& all)")] if whole else [])

    def _taken(self, take: Take) -> str:
        return "std::string" if take.expr.type.name == "bytes" else _type(take.expr.type)

    def _settable_getter(self, call: Call) -> str:
        """The request that is answered with the struct that this one sends."""
        if not isinstance(call.payload, Node) or call.answer or call.is_command:
            return ""
        struct = call.payload.struct
        return next((m.name for m in self.proxy.members if isinstance(m, Call) and m.answer and m.answer.how == "whole"
                     and not m.answer.paths and m.answer.type.name == struct.name), "")

    def _settable(self, call: Call) -> str:
        return f"wire::{call.payload.owner}::{call.payload.struct.name}" if self._settable_getter(call) else ""  # type: ignore[union-attr]

    def _signature(self, call: Call, defaults: bool) -> str:
        answer = _type(call.answer.type) if call.answer else "void"
        return f"Result<{answer}> {call.name}({', '.join(self._parameter(a, defaults) for a in call.arguments)})"

    def _parameter(self, a: Argument, defaults: bool) -> str:
        if a.type.is_list:
            type_ = "std::span<const double>"
        elif a.type.name in ("text", "bytes"):
            type_ = "std::string_view"
        elif a.type.name == "int":
            type_ = SCALAR_TYPES[a.type.wire]
        else:
            type_ = _type(a.type)
            type_ = type_ if type_ in ("double", "bool") else f"const {type_}&"
        default = constant_name(a.default) if a.default[:1].isupper() else a.default
        default = f"{default}.0" if a.type.name == "float" and default.isdigit() else default
        return f"{type_} {a.name}" + (f" = {default}" if defaults and default else "")

    # The source

    def source(self) -> str:
        p = self.proxy
        self.inside = "client::"
        functions = [self._open(), *self._mobile()]
        for member in p.members:
            functions += self._member(member)
        makers = [line for maker in self.makers.values() for line in [*maker, ""]]
        hidden = ["namespace {", "", *makers, "}  // namespace", ""] if makers else []
        body = "\n".join([f"namespace {self.wire} = wire::{self.wire};", "", *hidden, *("\n".join(f) + "\n" for f in functions)])
        own = {"convert.h", "done.h", "finite.h"}
        own = {h for h in own if re.search({"convert.h": r"client::\w+\(|on_wire\(|_on_wire|each\(", "done.h": r"done\(|stop_and_close",
                                            "finite.h": r"finite|floats\("}[h], body)}
        own |= {"refusal.h"} if p.base == "Mobile" else set()
        standard = sorted({f"#include <{h}>" for n, h in STANDARD.items() if n in body} & {"#include <utility>"})
        return "\n".join([banner(p.interface.source).rstrip(), f'#include "playhouse_client/{self.wire}.h"', "", *standard, *([""] if standard else []),
                          *(f'#include "{h}"' for h in sorted(own)), *([""] if own else []), "namespace playhouse::client {", "", body,
                          "}  // namespace playhouse::client", ""])

    def _open(self) -> list[str]:
        p = self.proxy
        made = "prepare" if p.kept else p.name
        lines = [f"Result<{p.name}> {p.name}::open(Client& client, std::uint16_t index, Access access) {{",
                 f"  Result<Device> device = Device::open(client, {self.wire}::kCode, index, access);",
                 "  if (!device) return device.error();", f"  return {made}(std::move(*device));", "}"]
        if p.kept:
            lines += ["", f"Result<{p.name}> {p.name}::prepare(Device device) {{", f"  {p.name} made(std::move(device));"]
            lines += [f"  if (auto {k.name} = made.device_.request<{self.wire}::{k.struct.name}>({self._message(k.message)}))\n"
                      f"    made.{k.name}_ = std::move(*{k.name});" for k in p.kept]
            lines += ['  if (!made.device_.connected()) return Error{"", made.device_.name() + ": the server is gone"};', "  return made;", "}"]
        return lines

    def _mobile(self) -> list[list[str]]:
        name = self.proxy.name
        if self.proxy.base != "Mobile":
            return []
        return [[f"{name}& {name}::operator=({name}&& other) noexcept {{", "  if (this == &other) return *this;",
                 "  static_cast<void>(close().ok());", "  device_ = std::move(other.device_);", "  moving_ = other.moving_;", "  return *this;", "}"],
                [f"{name}::~{name}() {{", "  static_cast<void>(close().ok());", "}"],
                [f"Result<std::string> {name}::why_refused() {{", "  return refusal_of(device_);", "}"],
                [f"Result<void> {name}::close() {{", "  return stop_and_close(*this, moving_);", "}"]]

    def _message(self, message: Message) -> str:
        return f"{self.wire}::{constant_name(message.constant)}"

    def _latest(self, message: Message) -> str:
        return f"device_.latest<{self.wire}::{message.payload}>({self._message(message)})"

    def _head(self, returned: str, rest: str) -> list[str]:
        nested = returned.replace("<State>", f"<{self.proxy.name}::State>") if any(v.name in NESTED for v in
                                                                                    self.proxies.values_of(self.proxy.interface)) else returned
        return _fitted_declaration(f"{nested} {self.proxy.name}::{rest} {{", "")

    def _read(self, read: Read) -> list[list[str]]:
        if not read.messages:
            return [[*self._head(_type(read.expr.type), f"{read.name}() const"), *_return(self._expr(read.expr, f"{read.kept}_.")), "}"]]
        is_list = read.expr.type.is_list or read.expr.type.name == "bytes"
        if read.variants:
            body = self._variants(read)
        else:
            const = "" if any(e.how == "is" and e.type.name == "bytes" for e in read.expr.all()) else "const "
            body = [f"  {const}auto data = {self._latest(read.messages[0])};", f"  if (!data) return {'{}' if is_list else 'std::nullopt'};",
                    *_return(self._expr(read.expr, "data->"))]
        return [[*self._head(_read_type(read.expr.type), f"{read.name}() const"), *body, "}"]]

    def _variants(self, read: Read) -> list[str]:
        """The newest; of those with one time the first."""
        first, *others = [self._message(m) for m in read.messages]
        lines = [f"  std::uint8_t newest = {first};"]
        lines.append(f"  for (const std::uint8_t other : {{{', '.join(others)}}})")
        lines.append("    if (device_.timestamp(other) > device_.timestamp(newest)) newest = other;")
        for i, (message, e) in enumerate(zip(read.messages, read.variants)):
            last = i == len(read.messages) - 1
            inside = e.paths[0] if e.how == "make" and e.paths else None
            struct = f"wire::{inside.last.owner}::{inside.last.type}" if inside else f"{self.wire}::{message.payload}"
            if e.how == "make":
                made = self._maker(e, struct).format(self._path(inside, "data->") if inside else "*data")
            else:
                made = self._expr(e, "data->")
            pad = "  " if last else "    "
            lines += [] if last else [f"  if (newest == {self._message(message)}) {{"]
            lines += [f"{pad}const auto data = {self._latest(message)};", f"{pad}if (!data) return std::nullopt;", f"{pad}return {made};"]
            lines += [] if last else ["  }"]
        return lines

    def _shortcut(self, shortcut: Shortcut) -> list[list[str]]:
        head = self._head(_read_type(shortcut.type), f"{shortcut.name}() const")
        if shortcut.none:
            return [[*head, f"  const auto all = {shortcut.read.name}();", "  if (all.empty()) return std::nullopt;",
                     f"  return all.front().{shortcut.field};", "}"]]
        none = "{}" if shortcut.type.is_list else "std::nullopt"
        return [[*head, f"  auto newest = {shortcut.read.name}();", f"  if (!newest) return {none};",
                 f"  return std::move(newest->{shortcut.field});" if shortcut.type.is_list else f"  return newest->{shortcut.field};", "}"]]

    def _take(self, take: Take) -> list[list[str]]:
        made = self._expr(take.expr, "data.")
        begin = f"{made}.begin(), {made}.end()" if take.expr.type.name == "bytes" else made
        kind = f"{self.wire}::{take.message.payload}"
        return [[*self._head(f"std::vector<{self._taken(take)}>", f"{take.name}()"), f"  std::vector<{self._taken(take)}> taken;",
                 "  for (const std::vector<std::byte>& body : take_kept()) {",
                 f"    const {kind} data = *wire::decode<{kind}>(body);  // validated on arrival", f"    taken.emplace_back({begin});", "  }",
                 "  return taken;", "}"]]

    def _call(self, call: Call) -> list[list[str]]:
        before = self._checks(call)
        if call.moves:
            moving = "true" if call.moves is True else " || ".join(f"{name} != 0.0" for name in call.moves)
            before.append(f"  moving_ = {moving};")
        sent = self._message(call.message)
        if call.payload:
            node, lines = self._payload(call)
            before += lines
            if len(node) + len(sent) > WIDTH - 34:
                kind, _, rest = node.partition("{")
                line = f"  const {kind} body{{{rest};"
                before += [line] if len(line) <= WIDTH else _broken(line, "{", 6)
                node = "body"
            sent += f", {node}"
        if call.is_command:
            body = _return(f"device_.command({sent})")
        elif call.answer and call.answer.how == "whole" and not call.answer.paths:
            body = _return(f"device_.request<{_type(call.answer.type)[6:]}>({sent})")
        elif call.answer:
            body = [f"  const auto data = device_.request<{self.wire}::{call.message.payload}>({sent});", "  if (!data) return data.error();",
                    *_return(self._expr(call.answer, "data->"))]
        elif call.then:
            body = [f"  if (const auto set = device_.request({sent}); !set) return set.error();"]
            for k in self.proxy.kept:
                if k.name in call.then:
                    body += [f"  auto made = device_.request<{self.wire}::{k.struct.name}>({self._message(k.message)});", "  if (!made) return made.error();",
                             f"  {k.name}_ = std::move(*made);"]
            body.append("  return {};")
        else:
            body = _return(f"done(device_.request({sent}))")
        returned, rest = self._signature(call, False).split("> ", 1)
        made = [[*self._head(returned + ">", rest), *before, *body, "}"]]
        whole = self._settable(call)
        if whole:
            made.append([*self._head("Result<void>", f"{call.name}(const {whole}& all)"), f"  return done(device_.request({sent.split(',')[0]}, all));", "}"])
        return made

    def _checks(self, call: Call) -> list[str]:
        wide, narrow = [], []
        for a in call.arguments:
            if a.type.name == "float" and not a.type.is_list:
                (narrow if a.type.wire == "float32" else wide).append(a.name)
            elif a.type.name in APART:
                wide += [f"{a.name}.{part}" for part in APART[a.type.name]]
            elif a.type.name in self.proxies.values:
                wide += [f"{a.name}.{f.name}" for f in self.proxies.values[a.type.name].fields]
        lines = []
        for function, names in (("finite", wide), ("finite_floats", narrow)):
            if names:
                check = f'{function}(device_, "{call.name}", {{{", ".join(names)}}});'
                line = f"  if (const auto sound = {check} !sound) return sound;"
                lines += [line] if len(line) <= WIDTH else ["  if (const auto sound =", *indented(textwrap.wrap(check, WIDTH - 14), 10),
                                                            "      !sound)", "    return sound;"]
        return lines

    def _payload(self, call: Call) -> tuple[str, list[str]]:
        """What is sent, and the lines before it."""
        payload = call.payload
        assert payload is not None
        if isinstance(payload, Argument):
            return payload.name, []
        lines: list[str] = []
        for f, value in payload.entries:
            first = value[0] if isinstance(value, list) else value
            if not isinstance(first, Argument):
                continue
            if f.type == "uint8" and f.is_array:
                parts = [(f"wire::c_string({a.name})" if a.type.name == "text" else a.name) for a in (value if isinstance(value, list) else [value])]
                text = parts[0] + "".join(f".append({part})" for part in parts[1:])
                lines += [f"  const auto sent = bytes_on_wire(device_, {text});", "  if (!sent) return sent.error();"]
            elif first.type.is_list:
                lines += [f'  const auto sent = floats(device_, "{call.name}", {first.name});', "  if (!sent) return sent.error();"]
        return self._node(payload, True), lines

    def _node(self, node: Node, named: bool) -> str:
        made = [f".{f.name} = {self._sent(f, value)}" for f, value in node.entries]
        name = f"{'wire' if node.owner == COMMON else node.owner}::{node.struct.name}" if named else ""
        return f"{name}{{{', '.join(made)}}}"

    def _sent(self, f: Field, value) -> str:
        if isinstance(value, Node):
            return self._node(value, False)
        if isinstance(value, list) or (isinstance(value, Argument) and (value.type.is_list or value.type.name == "bytes")):
            return "*sent"
        if not isinstance(value, Argument):
            return str(value)
        kind, exact = value.type.name, SCALAR_TYPES.get(f.type, "")
        if value.choice:
            no, yes = (f"{self.wire}::{constant_name(name)}" for name in value.choice)
            return f"static_cast<{exact}>({value.name} ? {yes} : {no})"
        if kind == "Attitude":
            return f"on_wire(Pose3d{{0, 0, 0, {', '.join(f'{value.name}.{part}' for part in APART[kind])}}})"
        if kind in APART or kind in self.proxies.values or kind == "rgb":
            return f"on_wire({value.name})"
        if kind == "text":
            return f"wire::c_string({value.name})"
        return f"static_cast<{exact}>({value.name})" if kind == "bool" or f.type == "float32" else value.name

    # Expressions

    def _path(self, path: Path, at: str) -> str:
        root = {"": at, "message": "data."}.get(path.root, f"{path.root}_.")
        return root + ".".join(path.names)

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if e.only_if:
            flags, constant = e.only_if
            some = f"({self._path(flags, at)} & {self._constant(constant)}) != 0"
            return f"{some} ? {_type(e.type)}({text}) : std::nullopt"
        return f"{text} == {e.absent} ? std::nullopt : {_type(e.type)}({text})" if e.absent else text

    def _at_hand(self, at: str) -> str:
        return f"*{at[:-2]}" if at.endswith("->") else at[:-1]

    def _constant(self, name: str) -> str:
        return f"{self.wire}::{constant_name(name)}"

    def _type_name(self, e: Expr) -> str:
        return self._converter(e.type)

    def way_is(self, e: Expr, one: str, at: str) -> str:
        if e.type.is_list and e.type.wire == "float32":
            return f"std::vector<double>({one}.begin(), {one}.end())"
        if e.type.name == "bytes" and at == "data->":
            return f"std::move({one})"
        return super().way_is(e, one, at)

    def way_gather(self, e: Expr, one: str, at: str) -> str:
        paths = ", ".join(self._paths(e, at))
        return f"client::pose({paths})" if e.type.name == "Pose3d" else f"{_type(e.type)}{{{paths}}}"

    def way_make(self, e: Expr, one: str, at: str) -> str:
        return f"{_value_name(e.type.name)}{{{', '.join(f'.{name} = {self._part(part, at)}' for name, part in e.parts)}}}"

    def _part(self, e: Expr, at: str) -> str:
        """Of a value, which has the angles of an orientation as an array."""
        if e.how == "convert" and e.type.name == "Attitude":
            return f"client::angles({self._path(e.path, at)})"
        return self._expr(e, at)

    def _converter(self, type_: Type) -> str:
        return {"Pose": "pose", "Pose3d": "pose", "Velocity": "velocity", "Size": "size", "Vector": "vector", "Attitude": "attitude", "rgb": "rgb",
                "rgba": "rgba"}.get(type_.name, snake(type_.name))

    def way_each(self, e: Expr, one: str, at: str) -> str:
        assert e.one is not None
        f = e.path.last
        struct = f"wire::{f.type}" if f.owner == COMMON else f"{self.wire}::{f.type}" if not f.is_scalar else SCALAR_TYPES[f.type]
        if e.one.how == "make":
            call = self._maker(e.one, struct)
            if not e.one.has_outer:
                return f"client::each({one}, {call.split('(')[0]})"
            outer = f"*{at[:-2]}" if at.endswith("->") else "data"
            return f"client::each({one}, [&](const {struct}& one) {{ return {call.format('one').replace('data', outer)}; }})"
        made = self._expr(Expr(e.one.how, e.one.type, [], constant=e.one.constant), "one.")
        return f"client::each({one}, [](const {struct}& one) {{ return {made}; }})"

    def _maker(self, e: Expr, struct: str) -> str:
        """A call, with {} for the struct, of a function that makes the value."""
        name = f"{snake(_value_name(e.type.name))}_of"
        outer = f", const {self.wire}::Data& data" if e.has_outer else ""
        self.makers[name] = [f"{_value_name(e.type.name)} {name}(const {struct}& one{outer}) {{", *_return(self._expr(e, "one.")), "}"]
        return f"{name}({{}}{', data' if outer else ''})"


def _return(made: str) -> list[str]:
    line = f"  return {made};"
    return [line] if len(line) <= WIDTH else _broken(line, "{", 6)


def _broken(line: str, opening: str, indent: int) -> list[str]:
    """A long line with its parts on lines of their own, from the first opening brace or parenthesis on."""
    at = min((line.index(c) for c in (opening, "(") if c in line), default=-1)
    start, parts, depth, part = line[:at + 1], [], 0, ""
    for i, c in enumerate(line[at + 1:], at + 1):
        if depth < 0:
            break
        depth += (c in "{([") - (c in "})]")
        if depth < 0 or (c == "," and depth == 0):
            parts.append(part.strip())
            part = ""
            end = line[i:]
        else:
            part += c
    lines = [start]
    for i, one in enumerate(parts):
        more = "," if i < len(parts) - 1 else end
        if len(lines) > 1 and len(lines[-1]) + len(one) + len(more) < WIDTH - 1 and "= " not in one:
            lines[-1] += f" {one}{more}"
        else:
            lines.append(" " * indent + one + more)
    return lines


def _fitted_declaration(text: str, indent: str = "  ") -> list[str]:
    text = text if text.endswith("{") else text + ";"
    if len(indent + text) <= WIDTH:
        return [indent + text]
    start, rest = text.split("(", 1)
    lines = textwrap.wrap(rest, WIDTH - len(indent) - 4)
    return [f"{indent}{start}(", *(f"{indent}    {line}" for line in lines)]


# What opens those of a robot


def _robot_header(proxies: Proxies) -> str:
    mine = [p for p in proxies.proxies if p.of_robot]
    lines = [banner("interfaces/").rstrip(), "#pragma once", "", "/// What opens the devices of a robot: base of Robot.", "", "#include <cstddef>",
             "#include <string_view>", "", *(f'#include "playhouse_client/{p.interface.name}.h"' for p in sorted(mine, key=lambda p: p.interface.name)),
             "", "namespace playhouse::client {", "", "class RobotDevices {", " public:",
             "  /// Opens the n-th device of an interface, n from 0. An error lists the devices there are."]
    lines += [f"  Result<{p.name}> {p.opener}(std::size_t n = 0, Access access = Access::kAll) const;" for p in mine]
    return "\n".join([*lines, "  /// Opens a device of any interface, by the interface's name.",
                      "  virtual Result<Device> device(std::string_view interf, std::size_t n = 0, Access access = Access::kAll) const = 0;", "",
                      " protected:", "  ~RobotDevices() = default;", "};", "", "}  // namespace playhouse::client", ""])


def _robot_source(proxies: Proxies) -> str:
    lines = [banner("interfaces/").rstrip(), '#include "playhouse_client/robot_devices.h"', "", "#include <utility>", "", "namespace playhouse::client {"]
    for p in proxies.proxies:
        if p.of_robot:
            lines += ["", f"Result<{p.name}> RobotDevices::{p.opener}(std::size_t n, Access access) const {{",
                      f'  Result<Device> opened = device("{p.interface.name}", n, access);', "  if (!opened) return opened.error();",
                      f"  return {f'{p.name}::prepare' if p.kept else p.name}(std::move(*opened));", "}"]
    return "\n".join([*lines, "", "}  // namespace playhouse::client", ""])
