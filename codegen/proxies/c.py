"""Writes the proxies of the library in C to clients/c/generated/: a header of include/playhouse/c/ and a source of src/ per interface, and
src/classes.h and .c with the list of all (docs/adr/0029)."""

from __future__ import annotations

import re
import textwrap

from codegen.emit_c import SCALAR_TYPES, WIDTH, struct_name
from codegen.model import Field, Message
from codegen.proxies import Argument, Call, Expr, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Value, made_by, spelled
from codegen.proxies.spelling import Spelling, snake

FOLDER = "clients/c/generated"
HEADERS = f"{FOLDER}/include/playhouse/c"
SOURCES = f"{FOLDER}/src"

# Values and functions whose names C, which has one space of names, has for something else.
VALUES = {"Point": "cloud_point", "PowerState": "battery_state", "GripperState": "fingers_state", "GripperGeometry": "fingers_geometry",
          "WifiState": "radio_state"}
FUNCTIONS = {("localize", "set_pose"): "set_estimate"}
# Values by hand -> their header.
BY_HAND = {"Marker": "marker", "Image": "image", "Covariance": "covariance", "Charging": "charging"}
# Values that are given as their numbers, and that are arrays of them.
SPREAD = {"Attitude": ("roll", "pitch", "yaw")}
ARRAYS = {"Attitude": ("double", 3), "Vector": ("double", 3), "Quaternion": ("double", 4), "rgb": ("uint8_t", 3), "rgba": ("uint8_t", 4)}
# What stands for a value that is missing.
NONE = {"float": "(double)NAN", "Charging": "PH_CHARGING_UNKNOWN"}
MISSING = {"float": "NAN if it is missing.", "Charging": "PH_CHARGING_UNKNOWN if it is missing."}


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files: dict[str, str] = {}
    for proxy in proxies.generated():
        made = _Class(proxies, proxy)
        files[f"{HEADERS}/{proxy.interface.name}.h"] = made.header()
        files[f"{SOURCES}/{proxy.interface.name}.c"] = made.source()
    return files | _classes(proxies)


BANNER = "Generated from {} by codegen; do not edit."


def _value_type(name: str) -> str:
    return f"ph_{VALUES.get(name, snake(name))}"


def _function(proxy: Proxy, name: str) -> str:
    """A function may not be called as a struct of the wire."""
    own = FUNCTIONS.get((proxy.interface.name, name), name)
    taken = {struct_name(proxy.interface.name, s.name) for s in proxy.interface.structs}
    made = f"ph_{proxy.interface.name}_{own}"
    return f"ph_{proxy.interface.name}_get_{own}" if made in taken else made


def _comment(doc: str, indent: str = "") -> list[str]:
    lines = textwrap.wrap(doc, WIDTH - len(indent) - 7, break_long_words=False)
    if not lines:
        return []
    made = [f"{indent}/** {lines[0]}", *(f"{indent} * {line}" for line in lines[1:])]
    return [*made[:-1], made[-1] + " */"]


def _declared(head: str, parameters: list[str], end: str) -> list[str]:
    return _fitted(f"{head}({', '.join(parameters)}){end}", len(head) + 1)


def _fitted(line: str, indent: int) -> list[str]:
    """On several lines, broken between parameters, members and operands alone."""
    if len(line) <= WIDTH:
        return [line]
    kept = re.sub(r"(?<![,=]) (?![|][|])", "\0", line.strip())
    first = " " * (len(line) - len(line.lstrip()))
    return [part.replace("\0", " ") for part in textwrap.wrap(kept, WIDTH, initial_indent=first, subsequent_indent=" " * indent, break_long_words=False,
                                                             break_on_hyphens=False)]


class _Class(Spelling):
    TEXTS = {"truth": "{one} != 0", "equals": "{one} == {constant}", "bit": "({one} & {constant}) != 0", "convert": "{type}({one})",
             "unpack": "{type}({one})", "gather": "ph_pose3d_at({all})", "call": "ph_{function}_of({all})", "time": "value->timestamp",
             "whole": "{one}"}

    def __init__(self, proxies: Proxies, proxy: Proxy) -> None:
        self.proxies, self.proxy, self.schema = proxies, proxy, proxies.schema
        self.wire, self.type = proxy.interface.name, f"ph_{proxy.interface.name}"
        self.lists: dict[str, None] = {}    # that are given out, and belong to the proxy
        self.beams = False
        self.parts = {e.type.name: dict(e.parts) for m in proxy.members for root in made_by(m) for e in root.all() if e.how == "make"}

    # The header

    def header(self) -> str:
        p = self.proxy
        values = [line for v in self.proxies.values_of(p.interface) for line in [*self._value(v), ""]]
        lines = [*_comment(self._said(p.doc)), f"PH_PROXY({self.wire})", "", *values]
        for c in p.constants:
            lines += [*_comment(self._said(c.doc)), f"enum {{ PH_{self.wire.upper()}_{c.name} = {c.value} }};", ""]
        if p.base == "Mobile":
            lines += [f"ph_status {self.type}_stop({self.type} *proxy, ph_error *error);"]
        if p.base == "Selecting":
            lines += [*_comment("Selects the data message, for all subscribers of the device: one of its data messages."),
                      *_declared(f"ph_status {self.type}_send", [f"{self.type} *proxy", "const ph_message_type *datatype", "ph_error *error"], ";")]
        for k in p.kept:
            lines += [*_comment(f"{self._said(k.doc)} Zero for a device that refused to tell; valid until the release of the device, or until it is "
                                "requested again."),
                      f"const {struct_name(k.message.owner, k.struct.name)} *{_function(p, k.name)}(const {self.type} *proxy);"]
        for m in p.members:
            if self._is_given(m):
                lines += [*_comment(self._about(m)), *self._signature(m, ";")]
        body = "\n".join(lines)
        own = {"generated/" + self.wire, "proxy"} | {h for name, h in BY_HAND.items() if re.search(rf"\b{_value_type(name)}\b", body)}
        guard = f"PLAYHOUSE_C_{self.wire.upper()}_H"
        head = [*_comment(f"The proxy of {self.wire}. {BANNER.format(p.interface.source)}"), f"#ifndef {guard}", f"#define {guard}", "",
                *(f'#include "playhouse/c/{name}.h"' for name in sorted(own)), "", "#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
        return "\n".join([*head, body, "", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {guard} */", ""])

    def _is_given(self, member) -> bool:
        """A field of a value that is read is written as one."""
        return not isinstance(member, Shortcut) or bool(member.none)

    def _said(self, doc: str) -> str:
        classes = {p.name: p for p in self.proxies.proxies}

        def name(text: str, call: str) -> str:
            *outer, last = text.split(".")
            if outer and outer[0] in self.proxies.values:
                return f"{_value_type(outer[0])}.{last}"
            proxy = classes[outer[0]] if outer else self.proxy
            if last in {c.name for c in proxy.constants}:
                return f"PH_{proxy.interface.name.upper()}_{last}"
            return _function(proxy, last) + (call or "()")

        codes = {"NoData": "PH_NO_DATA", "RequestRefused": "PH_REQUEST_REFUSED"}
        return spelled(doc, name, lambda what: codes[what])

    def _about(self, member) -> str:
        if isinstance(member, Take):
            what = "The bytes are" if member.expr.type.name == "bytes" else "It is"
            return "The oldest message of the reads so far that was not taken yet; none if there is none. A device keeps the last 1024. " \
                   f"{what} valid until the next call for this device."
        expr = member.answer if isinstance(member, Call) else None if isinstance(member, Shortcut) else member.expr
        doc = self._said(member.doc)
        if not doc and expr and expr.type.name in self.proxies.values:
            doc = self._said(self.proxies.values[expr.type.name].doc)
        if not doc and isinstance(member, Call):
            doc = self._said(member.message.doc)
        lists = isinstance(member, Call) and expr is not None and any(e.how == "each" for e in expr.all())
        return f"{doc} Valid until the next call for this device." if lists else doc

    def _value(self, value: Value) -> list[str]:
        lines = [*_comment(self._said(value.doc)), f"typedef struct {_value_type(value.name)} {{"]
        for part in value.fields:
            expr = self.parts[value.name][part.name]
            missing = MISSING[expr.type.name] if expr.type.optional else ""
            lines += _comment(" ".join(filter(None, [self._said(part.doc), missing])), "  ")
            lines += [f"  {line};" for line in self._members(part.name, expr)]
        return [*lines, f"}} {_value_type(value.name)};"]

    def _members(self, name: str, e: Expr) -> list[str]:
        if e.how == "each":
            return [f"const {self._plain_type(e.one)} *{name}", f"size_t {name}_count"]
        return [self._declaration(name, e)]

    def _declaration(self, name: str, e: Expr) -> str:
        if e.how == "text":
            return f"char {name}[{_text_size(e.path.last)}]"
        if e.type.name in ARRAYS:
            kind, count = ARRAYS[e.type.name]
            return f"{kind} {name}[{count}]"
        return f"{self._plain_type(e)} {name}"

    def _plain_type(self, e: Expr | None) -> str:
        assert e is not None
        kind = e.type.name
        if e.type.owner:
            return struct_name(e.type.owner, kind)
        if kind == "int":
            return {"int8": "int32_t", "int16": "int32_t", "int32": "int32_t", "": "int64_t", "int64": "int64_t"}.get(e.type.wire, "uint32_t")
        return {"float": "double", "bool": "bool"}.get(kind) or _value_type(kind)

    def _signature(self, m, end: str) -> list[str]:
        name, own = _function(self.proxy, m.name), f"{self.type} *proxy"
        if isinstance(m, Take):
            name = name.removesuffix("s")
            return _declared(f"const char *{name}", [own], end) if m.expr.type.name == "text" else \
                _declared(f"bool {name}", [own, "const uint8_t **bytes", "size_t *size"], end)
        if isinstance(m, Read) and not m.messages:
            return _declared(f"{self._plain_type(m.expr)} {name}", [f"const {own}"], end)
        parameters = [own]
        if isinstance(m, Call):
            parameters += [text for a in m.arguments for text in self._parameters(a)]
            parameters += self._results(m.name, m.answer) if m.answer else []
        elif isinstance(m, Shortcut):
            parameters.append(f"{_value_type(m.type.name)} *{m.name}")
        else:
            parameters += self._results(m.name, m.expr)
        return _declared(f"ph_status {name}", [*parameters, "ph_error *error"], end)

    def _results(self, name: str, e: Expr) -> list[str]:
        if self._is_wire_list(e):
            f = e.path.last
            return [f"const {SCALAR_TYPES[f.type]} **{name}", "size_t *count"]
        if e.how == "each":
            return [f"const {self._plain_type(e.one)} **{name}", "size_t *count"]
        if e.how == "text" or e.type.name in ARRAYS:
            return [self._declaration(name, e)]
        return [f"{self._plain_type(e)} *{name}"]

    def _is_wire_list(self, e: Expr) -> bool:
        """Given out as it came."""
        return (e.how == "is" and (e.type.is_list or e.type.name == "bytes")) or (e.how == "each" and e.path.last.is_scalar)

    def _parameters(self, a: Argument) -> list[str]:
        kind = a.type.name
        if kind in SPREAD:
            return [f"double {part}" for part in SPREAD[kind]]
        if a.type.owner:
            return [f"const {struct_name(a.type.owner, kind)} *{a.name}"]
        if a.type.is_list:
            return [f"const double *{a.name}", "size_t count"]
        if kind == "int":
            return [f"{SCALAR_TYPES[a.type.wire]} {a.name}"]
        known = {"float": f"double {a.name}", "bool": f"bool {a.name}", "text": f"const char *{a.name}", "rgb": f"const uint8_t {a.name}[3]"}
        if kind == "bytes":
            return ["const void *bytes", "size_t size"]
        return [known.get(kind) or f"{_value_type(kind)} {a.name}"]

    # The source

    def source(self) -> str:
        p = self.proxy
        functions: list[list[str]] = []
        for k in p.kept:
            struct = struct_name(k.message.owner, k.struct.name)
            functions.append([f"const {struct} *{_function(p, k.name)}(const {self.type} *proxy) {{", f"  static const {struct} none;",
                              f"  return proxy->{k.name} != NULL ? proxy->{k.name}->data : &none;", "}"])
        for m in p.members:
            if self._is_given(m):
                body = self._member(m)
                functions.append([*self._signature(m, " {"), *(part for line in body for part in _fitted(f"  {line}", 6)), "}"])
        if p.base == "Mobile":
            drive = next(m for m in p.members if isinstance(m, Call) and m.name == "drive")
            zeros = ", ".join("0.0" for _ in drive.arguments)
            functions.append([f"ph_status {self.type}_stop({self.type} *proxy, ph_error *error) {{",
                              f"  return {self.type}_drive(proxy, {zeros}, error);", "}"])
        if p.base == "Selecting":
            functions.append([*_declared(f"ph_status {self.type}_send", [f"{self.type} *proxy", "const ph_message_type *datatype", "ph_error *error"], " {"),
                              "  return ph_select(&proxy->device, datatype, error);", "}"])
        text = "\n".join(line for f in functions for line in [*f, ""])
        standard = [f"#include <{h}.h>" for h, word in (("math", "NAN"), ("stdlib", "free("), ("string", "memcpy(")) if word in text + self._release()]
        head = [*_comment(BANNER.format(p.interface.source)), f'#include "playhouse/c/{self.wire}.h"', "", *standard, *([""] if standard else []),
                '#include "proxy.h"', ""]
        return "\n".join([*head, *self._struct(), text])

    def _struct(self) -> list[str]:
        p = self.proxy
        members = [f"  ph_value *{k.name}; /**< an answer; NULL: it refused to tell */" for k in p.kept]
        members += ["  bool moving; /**< by the last command */"] if p.base == "Mobile" else []
        members += ["  ph_kept kept;"] if p.base == "Keeping" else []
        members += [f"  void *{name};" for name in self.lists]
        members += ["  ph_beams beams;"] if self.beams else []
        own = f"(({self.type} *)device)"
        hooks: dict[str, list[str]] = {}
        if p.kept:
            asked = [f"ph_device_ask_again(device, {self._message(k.message)}, &{own}->{k.name}, error)" for k in p.kept]
            hooks["prepare"] = ["static ph_status prepare(ph_device *device, ph_error *error) {", *(f"  PH_TRY({a});" for a in asked), "  return PH_OK;", "}"]
        if p.base == "Keeping":
            hooks["take"] = ["static void take(ph_device *device, const ph_value *value) {", f"  ph_kept_add(&{own}->kept, value);", "}"]
            hooks["forget"] = ["static void forget(ph_device *device) {", f"  ph_kept_clear(&{own}->kept);", "}"]
        if p.base == "Mobile":
            hooks["before_close"] = ["static void before_close(ph_device *device) {",
                                     f"  if ({own}->moving) {self.type}_stop(({self.type} *)device, NULL);", "}"]
        if self._release():
            hooks["release"] = ["static void release(ph_device *device) {", self._release(), "}"]
        named = "".join(f", .{h} = {h}" for h in hooks)
        return [f"struct {self.type} {{", "  ph_device device;", *members, "};", "", *(line for h in hooks.values() for line in [*h, ""]),
                *_fitted(f"const ph_class {self.type}_class = {{.interface_name = \"{self.wire}\", .size = sizeof({self.type}){named}}};", 4),
                f"PH_DEFINE_PROXY({self.wire})", ""]

    def _release(self) -> str:
        own = f"(({self.type} *)device)->"
        lines = [f"  ph_value_free({own}{k.name});" for k in self.proxy.kept] + [f"  free({own}{name});" for name in self.lists]
        lines += [f"  ph_kept_free(&{own}kept);"] if self.proxy.base == "Keeping" else []
        lines += [f"  ph_beams_free(&{own}beams);"] if self.beams else []
        return "\n".join(lines)

    def _message(self, m: Message) -> str:
        return f"PH_{self.wire.upper()}_{m.kind}_{m.name}"

    def _constant(self, name: str) -> str:
        return f"PH_{self.wire.upper()}_{name}"

    def _payload(self, m: Message) -> str:
        assert m.payload
        return struct_name(m.owner, m.payload)

    def _newest(self, message: Message) -> list[str]:
        asked = "ph_selected" if self.proxy.base == "Selecting" else "ph_device_stamped"
        return ["const ph_value *value = NULL;", f"PH_TRY({asked}(&proxy->device, {self._message(message)}, &value, error));",
                f"const {self._payload(message)} *data = value->data;"]

    def _read(self, m: Read) -> list[str]:
        if not m.messages:
            kept = next(k for k in self.proxy.kept if k.name == m.kept)
            made = f"{self._plain_type(m.expr)} {m.name}"
            return [f"const {struct_name(kept.message.owner, kept.struct.name)} *data = {_function(self.proxy, kept.name)}(proxy);", f"{made};",
                    *self._filled(m.name, m.expr, "data->", []), f"return {m.name};"]
        if m.variants:
            return self._of_variants(m)
        return [*self._newest(m.messages[0]), *self._given(m.name, m.expr, []), "return PH_OK;"]

    def _of_variants(self, m: Read) -> list[str]:
        """Of a part of the newest message: a pointer of the type that all have."""
        count = len(m.messages)
        lines = [f"const ph_message_type *const messages[] = {{{', '.join(map(self._message, m.messages))}}};", "const ph_value *value = NULL;",
                 f"PH_TRY(ph_newest_of(&proxy->device, messages, {count}, &value, error));"]
        makes = m.expr.how == "make"
        fields = [e.path.last if e.paths else None for e in m.variants]
        whole = next((msg for msg, f in zip(m.messages, fields) if f is None), None)
        some = next((f for f in fields if f), None)
        struct = self._payload(whole) if whole else struct_name(some.owner, some.type)  # type: ignore[union-attr]
        lines.append(f"const {struct} *data = {'value->data' if whole else 'NULL'};")
        for message, e in zip(m.messages, m.variants):
            if e.paths:
                lines.append(f"if (value->message == {self._message(message)}) data = &((const {self._payload(message)} *)value->data)->"
                             f"{'.'.join(e.path.names)};")
        if makes:
            return [*lines, *self._filled(f"(*{m.name})", Expr("make", m.expr.type, parts=m.expr.parts), "data->", []), "return PH_OK;"]
        return [*lines, f"*{m.name} = {self._converter(m.expr)}(*data);", "return PH_OK;"]

    def _shortcut(self, s: Shortcut) -> list[str]:
        """Of the first of a list."""
        read, part = s.read, self.parts[s.read.expr.type.name][s.field]
        items = f"data->{'.'.join(read.expr.path.names)}"
        return [*self._newest(read.messages[0]),
                f'if ({items}_count == 0) return ph_fail_none(&proxy->device, "{s.none}", error);',
                *self._filled(f"(*{s.name})", part, f"{items}[0].", []), "return PH_OK;"]

    def _take(self, m: Take) -> list[str]:
        data = f"const {self._payload(m.message)} *data = value->data;"
        field = f"data->{'.'.join(m.expr.path.names)}"
        lines = ["const ph_value *value = ph_kept_take(&proxy->kept);"]
        if m.expr.type.name == "text":
            return [*lines, "if (value == NULL) return NULL;", data, f"return {field};"]
        return [*lines, "if (value == NULL) return false;", data, f"*bytes = {field};", f"*size = {field}_count;", "return true;"]

    def _call(self, c: Call) -> list[str]:
        lines = self._checks(c)
        payload, before, after = "NULL", [], []
        if isinstance(c.payload, Argument):
            payload = c.payload.name
        elif c.payload:
            payload = "&body"
            lines.append(f"{struct_name(c.payload.owner, c.payload.struct.name)} body = {{0}};")
            sent, after = self._body(c.payload, "body.")
            before = sent
        lines += before
        if c.moves:
            lines.append(f"proxy->moving = {'true' if c.moves is True else ' || '.join(f'{name} != 0.0' for name in c.moves)};")
        message = self._message(c.message)
        if c.answer:
            return [*lines, "ph_value *answer = NULL;", f"PH_TRY(ph_device_ask(&proxy->device, {message}, {payload}, &answer, error));",
                    f"const {self._payload(c.message)} *data = answer->data;", *self._given(c.name, c.answer, ["ph_value_free(answer);"]),
                    "ph_value_free(answer);", "return PH_OK;"]
        do = "ph_device_command" if c.is_command else "ph_device_tell"
        sent = f"{do}(&proxy->device, {message}, {payload}, error)"
        if after:
            return [*lines, f"const ph_status status = {sent};", *after, "return status;"]
        again = [f"ph_device_ask_again(&proxy->device, {self._message(k.message)}, &proxy->{k.name}, error)" for k in self.proxy.kept if k.name in c.then]
        return [*lines, *(f"PH_TRY({step});" for step in [sent, *again][:-1]), f"return {[sent, *again][-1]};"]

    def _checks(self, c: Call) -> list[str]:
        first, finite = [], []
        for a in c.arguments:
            if a.type.name in SPREAD:
                finite += SPREAD[a.type.name]
            elif a.type.owner or a.type.name in ("bool", "text", "rgb") or a.type.is_list:
                continue
            elif a.least is not None:
                first.append(f'PH_TRY(ph_insist_on_least(&proxy->device, "{a.name}", {a.name}, {a.least}, error));')
            elif a.type.name == "float":
                finite.append(a.name)
            elif a.type.name == "bytes":
                first.append(f'PH_TRY(ph_insist_on_size("{next(f.name for f, v in c.payload.entries if v is a or (isinstance(v, list) and a in v))}", '  # type: ignore[union-attr]
                             "size, error));")
            elif a.type.name != "int":
                first.append(f"PH_TRY(ph_insist_on_{snake(a.type.name)}(&proxy->device, {a.name}, error));")
        named = ", ".join(f'{{"{name}", {name}}}' for name in finite)
        return first + ([f"PH_INSIST_ON_FINITE(&proxy->device, error, {named});"] if finite else [])

    def _body(self, node: Node, at: str) -> tuple[list[str], list[str]]:
        """Statements that fill the body, and those for after it was sent."""
        lines: list[str] = []
        after: list[str] = []
        for f, value in node.entries:
            to = at + f.name
            if isinstance(value, Node):
                lines += self._body(value, to + ".")[0]
            elif isinstance(value, list):
                text, bytes_ = value
                lines += ["ph_buffer joined = {NULL, 0, 0};", f"PH_TRY(ph_join(&joined, {text.name}, bytes, size, error));",
                          f"{to} = joined.bytes;", f"{to}_count = (uint32_t)joined.size;"]
                after.append("ph_buffer_free(&joined);")
            elif not isinstance(value, Argument):
                lines.append(f"{to} = {value};")
            elif value.type.is_list:
                lines += ["float *sent = NULL;", f'PH_TRY(ph_to_floats(&proxy->device, "{value.name[:-1]}", {value.name}, count, &sent, error));',
                          f"{to} = sent;", f"{to}_count = (uint32_t)count;"]
                after.append("free(sent);")
            else:
                lines += self._sent(f, value, to)
        return lines, after

    def _sent(self, f: Field, a: Argument, to: str) -> list[str]:
        kind = a.type.name
        if a.choice:
            return [f"{to} = {a.name} ? {self._constant(a.choice[1])} : {self._constant(a.choice[0])};"]
        if kind in SPREAD:
            return [f"{to}.p{part} = {part};" for part in SPREAD[kind]]
        if kind == "float" and f.type == "float32":
            return [f"PH_TRY(ph_to_float(&proxy->device, {a.name}, &{to}, error));"]
        if kind == "text":
            return [f"{to} = {a.name};", f"{to}_count = ph_text_count({a.name});"]
        if kind == "bytes":
            return [f"{to} = bytes;", f"{to}_count = (uint32_t)size;"]
        if kind in self.proxies.values:
            return [f"ph_wire_{snake(kind)}({a.name}, {to});"]
        return [f"{to} = {a.name if kind in ('float', 'int', 'bool') else f'ph_wire_{snake(kind)}({a.name})'};"]

    # What is given

    def _given(self, name: str, e: Expr, failed: list[str]) -> list[str]:
        """Statements that fill what the caller has. `failed` comes before a return."""
        if self._is_wire_list(e):
            return [f"*{name} = {self._path(e.path, 'data->')};", f"*count = {self._path(e.path, 'data->')}_count;"]
        if e.how == "each":
            return self._list(f"*{name}", "*count", name, e, "data->", failed)
        if e.how == "whole" and not e.paths:
            return [f"*{name} = *data;"]
        return self._filled(name if e.how == "text" or e.type.name in ARRAYS else f"(*{name})", e, "data->", failed)

    def _list(self, to: str, count: str, name: str, e: Expr, at: str, failed: list[str]) -> list[str]:
        assert e.one is not None
        memory = re.sub(r"\W+", "_", to).strip("_")  # of its own for each value: one stays valid when another is read
        self.lists[memory] = None
        made, items = f"made_{name}", self._path(e.path, at)
        no_memory = "return ph_fail_no_memory(error);"
        lines = [f"{self._plain_type(e.one)} *{made} = ph_list_new(&proxy->{memory}, {items}_count, sizeof *{made});"]
        lines += [f"if ({made} == NULL) {{", *(f"  {line}" for line in [*failed, no_memory]), "}"] if failed else [f"if ({made} == NULL) {no_memory}"]
        one = Expr(e.one.how, e.one.type, e.one.paths, parts=e.one.parts)
        inner = self._filled(f"{made}[i]", one, f"{items}[i].", failed)
        return [*lines, f"for (uint32_t i = 0; i < {items}_count; ++i) {{", *(f"  {line}" for line in inner), "}", f"{to} = {made};",
                f"{count} = {items}_count;"]

    def _filled(self, to: str, e: Expr, at: str, failed: list[str]) -> list[str]:
        kind = e.type.name
        if kind == "Scan":
            return self._scan(to, e, at)
        if e.how == "make":
            lines = []
            for name, part in e.parts:
                if part.how == "each":
                    lines += self._list(f"{to}.{name}", f"{to}.{name}_count", name, part, at, failed)
                elif part.type.name == "bytes":
                    lines += [f"{to}.{name} = {self._path(part.path, at)};", f"{to}.size = {self._path(part.path, at)}_count;"]
                else:
                    lines += self._filled(f"{to}.{name}", part, at, failed)
            return [re.sub(r"\(\*(\w+)\)\.", r"\1->", line) for line in lines]
        if e.how == "text":
            f, one = e.path.last, self._path(e.path, at)
            return [f"ph_text_of({one}, {f'{one}_count' if f.has_count else f'sizeof {one}'}, {to});"]
        if e.how == "gather" and kind != "Pose3d":
            return [f"{to}[{i}] = (double){self._path(p, at)};" for i, p in enumerate(e.paths)]
        if kind in ARRAYS:
            source = self._path(e.path, at) if e.paths else at[:-1]
            return [f"ph_{kind.lower()}_of({source}, {to});"] if e.how == "convert" else \
                [f"ph_{e.function}({', '.join(self._path(p, at) for p in e.paths)}, {to});"]
        to = re.sub(r"^\(\*(\w+)\)$", r"*\1", to)
        return [f"{to} = {self._expr(e, at)};"]

    def _scan(self, to: str, e: Expr, at: str) -> list[str]:
        self.beams = True
        parts = dict(e.parts)
        ranges = self._path(parts["ranges"].path, at)
        low, high, _, *elements = (self._path(p, at) for p in parts["angles"].paths)
        of = f"{elements[0]}, {elements[0]}_count" if elements else "NULL, 0"
        return [f"const size_t count = {ranges}_count;", "PH_TRY(ph_beams_begin(&proxy->beams, count, error));",
                f"ph_beams_direct(&proxy->beams, count, (double){low}, (double){high}, {of});", "double *ranges = proxy->beams.ranges;",
                f"for (size_t i = 0; i < count; ++i) ranges[i] = (double){ranges}[i];",
                f"{to.strip('()')} = (ph_scan){{ranges, proxy->beams.angles, count, {self._expr(parts['max_range'], at)}, value->timestamp}};"]

    def _path(self, path: Path, at: str) -> str:
        if path.root and path.root != "message":
            kept = next(k for k in self.proxy.kept if k.name == path.root)
            at = f"{_function(self.proxy, kept.name)}(proxy)->"
        return ("data->" if path.root == "message" else at) + ".".join(path.names)

    def _converter(self, e: Expr) -> str:
        return f"ph_{snake(e.type.name)}_of"

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if e.only_if:
            flags, constant = e.only_if
            return f"({self._path(flags, at)} & {self._constant(constant)}) != 0 ? {text} : {NONE[e.type.name]}"
        return f"{self._path(e.path, at)} == {e.absent} ? {NONE[e.type.name]} : {text}" if e.absent else text

    def _at_hand(self, at: str) -> str:
        return at[:-1]

    def _type_name(self, e: Expr) -> str:
        return self._converter(e)

    def way_is(self, e: Expr, one: str, at: str) -> str:
        return f"(double){one}" if e.path.last.type == "float32" and not e.factor else super().way_is(e, one, at)

    def way_make(self, e: Expr, one: str, at: str) -> str:
        raise ValueError(f"{e.how} takes statements in C, and _filled() writes them")

    way_text = way_each = way_make


def _text_size(f: Field) -> int:
    """With the NUL at its end."""
    return (f.length or f.max or 0) + 1


def _classes(proxies: Proxies) -> dict[str, str]:
    """The classes of all proxies, in a header and a list."""
    names = [f"ph_{p.interface.name}_class" for p in proxies.proxies]
    banner = _comment(f"The classes of all proxies. {BANNER.format('interfaces/')}")
    head = [*banner, "#ifndef PLAYHOUSE_C_CLASSES_H", "#define PLAYHOUSE_C_CLASSES_H", "", '#include "device.h"', ""]
    header = [*head, *textwrap.wrap(f"extern const ph_class {', '.join(names)};", WIDTH, subsequent_indent="    "), "",
              f"enum {{ PH_CLASS_COUNT = {len(names)} }};", "extern const ph_class *const ph_classes[PH_CLASS_COUNT];", "",
              "#endif /* PLAYHOUSE_C_CLASSES_H */", ""]
    source = [*banner, '#include "classes.h"', "", "const ph_class *const ph_classes[PH_CLASS_COUNT] = {", *(f"    &{n}," for n in names), "};", ""]
    guard = "PLAYHOUSE_C_PROXIES_H"
    every = [*_comment(f"The proxies of all interfaces that are generated. {BANNER.format('interfaces/')}"), f"#ifndef {guard}", f"#define {guard}", "",
             *(f'#include "playhouse/c/{name}.h"' for name in sorted(p.interface.name for p in proxies.generated())), "", f"#endif /* {guard} */", ""]
    return {f"{HEADERS}/proxies.h": "\n".join(every), f"{SOURCES}/classes.h": "\n".join(header), f"{SOURCES}/classes.c": "\n".join(source)}
