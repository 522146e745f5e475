"""Writes clients/tcl/generated/proxies/: one file per interface with its class, and index.tcl, which names them (docs/adr/0029)."""

from __future__ import annotations

import textwrap

from codegen import emit_tcl
from codegen.emit_tcl import WIDTH
from codegen.model import Field, Interface, Message
from codegen.proxies import (Argument, Call, Expr, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Value, spelled)
from codegen.proxies.spelling import Spelling, camel, lower_first

FOLDER = f"{emit_tcl.FOLDER}/proxies"

# Values that are given as their numbers.
SPREAD = {"Pose": ("x", "y", "a"), "Attitude": ("roll", "pitch", "yaw")}
# Converters of clients/tcl/values.tcl.
FROM_WIRE = {"Pose": "from::pose", "Velocity": "from::pose", "Pose3d": "from::pose3d", "Size": "from::size", "Vector": "dict values",
             "Attitude": "dict values", "rgb": "from::rgb", "rgba": "from::rgba"}


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{i.name}.tcl": _file(proxies, i) for i in proxies.modules()}
    files[f"{FOLDER}/index.tcl"] = _index(proxies)
    return files


def _file(proxies: Proxies, interface: Interface) -> str:
    proxy = proxies.proxy_of(interface)
    lines = [f"# {'The proxy of' if proxy else 'Values of'} {interface.name}. Generated from {interface.source} by codegen; do not edit."]
    for value in proxies.values_of(interface):
        lines += ["", *_value(value)]
    return "\n".join(lines + ["", *_Class(proxies, proxy).lines()] if proxy else lines) + "\n"


def _value(value: Value) -> list[str]:
    """Its keys, in a comment."""
    lines = _comment(f"{lower_first(value.name)}, a dictionary: {value.doc[0].lower()}{value.doc[1:]}", 0)
    width = max(len(camel(f.name)) for f in value.fields) + 3
    for f in value.fields:
        text = textwrap.wrap(_spelled(f.doc), WIDTH - width - 6) or [""]
        lines += [f"#     {camel(f.name):{width}}{text[0]}".rstrip(), *(f"#     {'':{width}}{line}" for line in text[1:])]
    return lines


def _spelled(doc: str, constants: dict[str, int] | None = None) -> str:
    def name(text: str, call: str) -> str:
        *outer, last = text.split(".")
        if last in (constants or {}):
            return str((constants or {})[last])
        given = call.strip("()").replace("true", "1")
        said = camel(last) + (f" {given}" if given else "")
        return f"{said} of the {lower_first(outer[0])}" if outer and not call else said

    kinds = {"NoData": "NODATA", "RequestRefused": "REFUSED"}
    return spelled(doc, name, lambda what: f"An error of kind {kinds[what]}")


def _comment(doc: str, indent: int, constants: dict[str, int] | None = None) -> list[str]:
    return [" " * indent + f"# {line}" for line in textwrap.wrap(_spelled(doc, constants), WIDTH - indent - 2)] if doc else []


class _Class(Spelling):
    TEXTS = {"truth": "[expr {{{one} != 0}}]", "equals": "[expr {{{one} == {constant}}}]", "bit": "[expr {{({one} & {constant}) != 0}}]",
             "text": "[text {one}]", "unpack": "[{type} {{*}}{one}]", "call": "[from::{function} {all}]", "time": "$time", "whole": "{one}"}
    SEPARATOR = " "

    def __init__(self, proxies: Proxies, proxy: Proxy) -> None:
        self.proxies, self.proxy, self.wire = proxies, proxy, proxy.interface.name
        self.constants = {c.name: c.value for c in proxy.constants}
        self.makers: dict[str, list[str]] = {}  # methods that make a value of an element of a list

    def lines(self) -> list[str]:
        p, updates = self.proxy, self.proxy.updates
        base = "Updating" if p.base == "Device" and updates else p.base
        head = [*_comment(p.doc, 0, self.constants), f"oo::class create ::playhouse::{p.name} {{", f"    superclass ::playhouse::{base}"]
        variables = [self._kept(k.name) for k in p.kept] + (["moving"] if p.base == "Mobile" else [])
        head += [f"    variable {' '.join(variables)}"] if variables else []
        parts = []
        if p.kept:
            parts.append(["    constructor {args} {", "        next {*}$args",
                          *(f"        set {self._kept(k.name)} [record {self.wire}.{k.struct.name}]" for k in p.kept), "    }"])
            parts += [[*_comment(f"{k.doc[:-1]}: a {self.wire}.{k.struct.name}, in the server's fields.", 4),
                       f"    method {camel(k.name)} {{}} {{return ${self._kept(k.name)}}}"] for k in p.kept]
            parts.append(["    method prepare {} {", *(f"        {self._ask_again(k)}" for k in p.kept), "    }"])
        for member in p.members:
            parts += self._member(member)
        if updates:
            parts.append([f"    method Value {{}} {{return [my {camel(updates.name)}]}}"])
        parts += list(self.makers.values())
        return [*head, *(line for part in parts for line in ["", *part]), "}"]

    def _kept(self, name: str) -> str:
        return camel(f"kept_{name}")

    def _ask_again(self, kept) -> str:
        return f"set {self._kept(kept.name)} [my Ask {self._message(kept.message)}]"

    def _message(self, message: Message) -> str:
        return self.proxy.interface.full_name(message)

    def _method(self, name: str, arguments: str, doc: str, body: list[str]) -> list[str]:
        return [*_comment(doc, 4, self.constants), f"    method {camel(name)} {{{arguments}}} {{", *(f"        {line}" for line in body), "    }"]

    def _read(self, read: Read) -> list[list[str]]:
        if not read.messages:
            return [self._method(read.name, "", read.doc, self._return(read.expr, self._kept(read.kept)))]
        if read.variants:
            body = [f"set data [my NewestOf {' '.join(self._message(m) for m in read.messages)}]", *self._inside(read)]
        elif read.expr.has_time:
            body = [f"lassign [my Stamped {self._message(read.messages[0])}] data time", *self._return(read.expr, "data")]
        else:
            body = [f"set data [my Newest {self._message(read.messages[0])}]", *self._return(read.expr, "data")]
        return [self._method(read.name, "", read.doc, body)]

    def _inside(self, read: Read) -> list[str]:
        """What the variants are made of may be a part of their message."""
        paths = {e.paths[0].names[0] for e in read.variants if e.how == "make" and e.paths}
        return [f"if {{[dict exists $data {name}]}} {{set data [dict get $data {name}]}}" for name in sorted(paths)] \
            + self._return(Expr(read.expr.how, read.expr.type, [] if paths else read.expr.paths, parts=read.expr.parts), "data")

    def _shortcut(self, shortcut: Shortcut) -> list[list[str]]:
        read = f"[my {camel(shortcut.read.name)}]"
        read = f"[my FirstOf {read} {shortcut.none}]" if shortcut.none else read
        return [self._method(shortcut.name, "", shortcut.doc, [f"return [dict get {read} {camel(shortcut.field)}]"])]

    def _take(self, take: Take) -> list[list[str]]:
        return [self._method(take.name, "", take.doc, ["return [my TakeKept]"]),
                ["    method Meaning {data} {", f"        return {self._expr(take.expr, 'data')}", "    }"]]

    def _call(self, call: Call) -> list[list[str]]:
        body = self._checks(call)
        if call.moves:
            moving = "1" if call.moves is True else f"[expr {{{' || '.join(f'${camel(name)} != 0' for name in call.moves)}}}]"
            body.append(f"set moving {moving}")
        sent = self._message(call.message)
        if call.payload:
            sent += f" {f'${camel(call.payload.name)}' if isinstance(call.payload, Argument) else self._node(call.payload)}"
        if call.is_command:
            body += self._fitted(f"my command {sent}")
        elif call.answer:
            whole = call.answer.how == "whole" and not call.answer.paths
            body += [f"return [my Ask {sent}]"] if whole else [f"set data [my Ask {sent}]", *self._return(call.answer, "data")]
        else:
            body += [*self._fitted(f"my request {sent}"), *(self._ask_again(k) for k in self.proxy.kept if k.name in call.then), "return"]
        return [self._method(call.name, " ".join(part for a in call.arguments for part in self._parameter(a)), call.doc, body)]

    def _parameter(self, a: Argument) -> list[str]:
        if a.type.name in SPREAD:
            return list(SPREAD[a.type.name])
        default = str(self.constants.get(a.default, a.default))
        default = {"false": "0", "true": "1"}.get(default, f"{default}.0" if a.type.name == "float" and default.isdigit() else default)
        return [f"{{{camel(a.name)} {default}}}" if default else camel(a.name)]

    def _checks(self, call: Call) -> list[str]:
        first, finite, last = [], [], []
        for a in call.arguments:
            name = camel(a.name)
            if a.least is not None:
                first.append(f"my InsistOnWhole {name} ${name} {a.least} 2147483647")
            elif a.type.name in SPREAD:
                finite += [f"{part} ${part}" for part in SPREAD[a.type.name]]
            elif a.type.name == "float" and a.type.is_list:
                first.append(f"foreach {name[:-1]} ${name} {{my InsistOnFinite {name[:-1]} ${name[:-1]}}}")
            elif a.type.name == "float":
                finite.append(f"{name} ${name}")
            elif a.type.name == "Pose3d":
                finite.append(f"{{*}}${name}")
                last.append(f"set {name} [to::pose3d ${name}]")
            elif a.type.name in self.proxies.values:
                first.append(f"set {name} [to::complete {lower_first(a.type.name)} ${name}]")
                finite.append(f"{{*}}${name}")
        return first + ([f"my InsistOnFinite {' '.join(finite)}"] if finite else []) + last

    def _node(self, node: Node) -> str:
        return f"[dict create {' '.join(f'{f.name} {self._sent(f, value)}' for f, value in node.entries)}]"

    def _sent(self, f: Field, value) -> str:
        if isinstance(value, Node):
            return self._node(value)
        if isinstance(value, list):
            return "".join(self._sent(f, a) for a in value)
        if not isinstance(value, Argument):
            return str(value)
        kind, name = value.type.name, f"${camel(value.name)}"
        if value.choice:
            return f"[expr {{[truth {name}] ? {self._constant(value.choice[1])} : {self._constant(value.choice[0])}}}]"
        if kind in SPREAD:
            return f"[dict create {' '.join(f'p{part} ${part}' for part in SPREAD[kind])}]"
        if kind in self.proxies.values:
            return f"[dict values {name}]"
        return {"bool": "[truth {}]", "text": "[cString {}]", "rgb": "[to::color {}]"}.get(kind, "{}").format(name)

    def _constant(self, name: str) -> str:
        return f"$::playhouse::{self.wire}::{self.proxy.interface.constant(name)}"

    # Expressions

    def _path(self, path: Path, at: str) -> str:
        root = {"": at, "message": "data"}.get(path.root, self._kept(path.root))
        return f"[dict get ${root} {' '.join(path.names)}]"

    def _expr(self, e: Expr, at: str) -> str:
        text = self._plain(e, at)
        if e.absent:
            text = f"[from::unless {e.absent} {text}]"
        if e.only_if:
            flags, constant = e.only_if
            text = f"[from::onlyIf {self._path(flags, at)} {self._constant(constant)} {text}]"
        return text

    def _at_hand(self, at: str) -> str:
        return f"${at}"

    def _function(self, name: str) -> str:
        return camel(name)

    def _type_name(self, e: Expr) -> str:
        return lower_first(e.type.name)

    def way_is(self, e: Expr, one: str, at: str) -> str:
        return f"[expr {{{one} * {e.factor}}}]" if e.factor else one

    def way_convert(self, e: Expr, one: str, at: str) -> str:
        return f"[{FROM_WIRE[e.type.name]} {one}]"

    def way_gather(self, e: Expr, one: str, at: str) -> str:
        paths = " ".join(self._paths(e, at))
        return f"[from::pose3d [dict merge {paths}]]" if e.type.name == "Pose3d" else f"[list {paths}]"

    def way_each(self, e: Expr, one: str, at: str) -> str:
        assert e.one is not None
        return f"[from::truths {one}]" if e.path.last.is_raw else f"[lmap one {one} {{{self._element(e.one)}}}]"

    def way_make(self, e: Expr, one: str, at: str) -> str:
        if self.proxies.values[e.type.name].by_hand:
            return f"[from::{lower_first(e.type.name)} {' '.join(self._expr(part, at) for _, part in e.parts)}]"
        return f"[dict create {' '.join(f'{camel(name)} {self._expr(part, at)}' for name, part in e.parts)}]"

    def _element(self, e: Expr) -> str:
        """A command that makes the value of `one`: a method if it takes more than a few words."""
        made = self._expr(e, "one")[1:-1]
        if e.how != "make" or len(made) < 70:
            return made
        given = "one data" if e.has_outer else "one"
        name = f"Make{e.type.name}"
        self.makers[name] = [f"    method {name} {{{given}}} {{", *(f"        {line}" for line in self._return(e, "one")), "    }"]
        return f"my {name} {' '.join(f'${word}' for word in given.split())}"

    def _return(self, e: Expr, at: str) -> list[str]:
        if e.how == "is" and e.type.name == "bytes":
            return [f"return [from::numbers {self._expr(e, at)}]"]
        line = f"return {self._expr(e, at)}"
        if len(line) + 8 <= WIDTH or e.how != "make" or self.proxies.values[e.type.name].by_hand:
            return self._fitted(line)
        return ["return [dict create \\", *(f"    {camel(name)} {self._expr(part, at)} \\" for name, part in e.parts[:-1]),
                f"    {camel(e.parts[-1][0])} {self._expr(e.parts[-1][1], at)}]"]

    def _fitted(self, line: str) -> list[str]:
        """On several lines, broken between words of the outermost list."""
        if len(line) + 8 <= WIDTH:
            return [line]
        pieces, depth, piece = [], 0, ""
        for c in line:
            depth += (c in "[{") - (c in "]}")
            if c == " " and depth <= 1:
                pieces.append(piece)
                piece = ""
            else:
                piece += c
        pieces.append(piece)
        lines = [""]
        for piece in pieces:
            if lines[-1] and len(lines[-1]) + len(piece) + 12 > WIDTH:
                lines[-1] += " \\"
                lines.append("   ")
            lines[-1] += (" " if lines[-1] else "") + piece
        return lines


def _index(proxies: Proxies) -> str:
    lines = ["# Every proxy. Generated from interfaces/ by codegen; do not edit.", "", "namespace eval ::playhouse {", "    # Interface -> the class of its proxy.",
             "    variable proxies {", *(f"        {p.interface.name} {p.name}" for p in proxies.proxies), "    }",
             "    # Interface of a robot's devices -> the name for all of them.", "    variable plurals {",
             *(f"        {p.interface.name} {p.plural}" for p in proxies.proxies if p.of_robot), "    }", "}"]
    return "\n".join(lines) + "\n"
