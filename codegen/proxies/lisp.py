"""Writes clients/lisp/generated/proxies/: one file per interface with its class, and index.lisp with what they share (docs/adr/0029)."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, field
from typing import Any

from codegen import emit_lisp
from codegen.checks import SchemaError
from codegen.emit_lisp import WIDTH, lisp, package
from codegen.model import Field, Interface, Message, Struct
from codegen.proxies import Argument, Call, Expr, Node, Path, Proxies, Proxy, Read, Shortcut, Take, Value, spelled
from codegen.proxies.spelling import Spelling

FOLDER = f"{emit_lisp.FOLDER}/proxies"

# Classes and functions whose names Common Lisp, or another proxy with other arguments, has for something else.
CLASSES = {"map": "grid-map"}
FUNCTIONS = {("aio", "set"): "set-voltage", ("blinkenlight", "set"): "set-light", ("blinkenlight", "set_power"): "set-light-power"}
# What a text calls otherwise.
WORDS = {"close()": "close-device", "read()": "read-data"}
BASES = {"Device": "device", "Keeping": "keeping", "Mobile": "base", "Selecting": "selecting"}
# What classes that are written by hand do by functions that proxies have as well, or that several of them share.
BY_HAND = {
    "go-to": ("planner", "Drives by a path on the map, after stop from resume on."),
    "points": ("scan", "The end points of its beams, a list of x and y in the sensor's frame each."),
    "send": ("imu", "Selects the data message, one of playhouse.imu:+data-state+ (pose), +data-calib+ (inertia), +data-quat+ (inertia and "
                    "quaternion), +data-euler+ (inertia and attitude) and +data-fullstate+ (pose and velocity), for all subscribers."),
    "state": ("planner", "A planner-state."),
    "stop": ("base and of planner", "Stops the robot; the planner keeps its goal, until resume."),
}
# Values that are given as their numbers.
SPREAD = {"Attitude": ("roll", "pitch", "yaw")}
# Forms with a body, and how many of their parts come before it.
BODIES = {"define-operation": 2, "defmethod": 2, "defclass": 3, "lambda": 1, "let": 1, "multiple-value-bind": 2, "etypecase": 1}

Form = str | list


def emit(proxies: Proxies) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    classes = {p.interface.name: _Class(proxies, p) for p in proxies.generated()}
    functions = [f for c in classes.values() for f in c.functions]
    shared = _shared(functions)
    files = {f"{FOLDER}/{lisp(i.name)}.lisp": _file(proxies, i, classes.get(i.name), shared) for i in proxies.modules()}
    names = " ".join(f'"{lisp(i.name)}"' for i in proxies.modules())
    files[f"{FOLDER}/files.lisp-expr"] = _wrapped(f";;;; The files of this folder but index.lisp, in the order of loading. {MADE}", ";;;; ") \
        + "\n\n" + _wrapped(f"({names})", " ") + "\n"
    files[f"{FOLDER}/index.lisp"] = _index(proxies, functions, shared)
    return files


MADE = "Generated from interfaces/ by codegen; do not edit."


@dataclass
class _Function:
    """What a proxy does: a method of a generic function."""

    name: str
    of: str                                 # the class
    doc: str
    body: list[Form]
    given: list[str] = field(default_factory=list)
    optional: list[Form] = field(default_factory=list)


def _shared(functions: list[_Function]) -> dict[str, list[_Function]]:
    """The functions of several classes, which take the same arguments; what may be left out is a keyword then."""
    by_name: dict[str, list[_Function]] = {}
    for f in functions:
        by_name.setdefault(f.name, []).append(f)
    shared = {name: those for name, those in sorted(by_name.items()) if len(those) > 1 or name in BY_HAND}
    for name, those in shared.items():
        if len({len(f.given) for f in those}) > 1:
            raise SchemaError(f"interfaces/: {name} of {' and '.join(f.of for f in those)} would be one function of Lisp with different arguments")
    return shared


# Forms, and how they are laid out

def _text(form: Form) -> str:
    return form if isinstance(form, str) else f"({' '.join(map(_text, form))})"


def _laid(form: Form, column: int, body: bool = False) -> str:
    """On one line if it fits, and has no body that must be on lines of its own."""
    flat = _text(form)
    if isinstance(form, str) or (not body and "\n" not in flat and column + len(flat) <= WIDTH):
        return flat
    head = form[0]
    if isinstance(head, str) and head in BODIES:
        count = BODIES[head] + 1
        out = f"({head}"
        for part in form[1:count]:
            out += " " + _laid(part, column + len(out.rpartition("\n")[2]) + 1)
        return out + "".join(f"\n{' ' * (column + 2)}{_laid(part, column + 2)}" for part in form[count:]) + ")"
    out = f"({head} " if isinstance(head, str) and len(form) > 1 else "("
    rest = form[1:] if isinstance(head, str) else form
    indent = column + len(out)
    lines, skip = [], False
    for part, after in zip(rest, [*rest[1:], ""]):
        if skip:
            skip = False
        elif isinstance(part, str) and part.startswith(":") and after:
            lines.append(f"{part} {_laid(after, indent + len(part) + 1)}")
            skip = True
        else:
            lines.append(_laid(part, indent))
    return out + f"\n{' ' * indent}".join(lines) + ")"


def _wrapped(text: str, prefix: str) -> str:
    return "\n".join(textwrap.wrap(text, WIDTH, subsequent_indent=prefix, break_long_words=False, break_on_hyphens=False))


def _doc(text: str, indent: int = 2) -> str:
    """A string; its lines but the first begin at the margin, as those of Lisp do."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    lines = [line for part in escaped.split("\n") for line in
             textwrap.wrap(part, WIDTH - indent - 2, break_long_words=False, break_on_hyphens=False)]
    return '"' + "\n".join(lines) + '"'


def _file(proxies: Proxies, interface: Interface, made: _Class | None, shared: dict[str, list[_Function]]) -> str:
    title = f";;;; {'The proxy of' if made else 'Values of'} {interface.name}. Generated from {interface.source} by codegen; do not edit."
    forms = [title, "(in-package #:playhouse-client)"]
    forms += [_struct(proxies, value) for value in proxies.values_of(interface)]
    return "\n\n".join(forms + (made.forms(shared) if made else [])) + "\n"


def _struct(proxies: Proxies, value: Value) -> str:
    name = lisp(value.name)
    doc = "\n".join([_said(proxies, value.interface, value.doc),
                     *(f"- {_slot(part)}: {_said(proxies, value.interface, part.doc)}" for part in value.fields if part.doc)])
    slots = " ".join(_slot(part) for part in value.fields)
    head = f"(defstruct ({name} (:constructor make-{name}"
    given = f" ({slots})))" if len(head) + len(slots) + 4 <= WIDTH else "\n" + _wrapped(f"             ({slots})))", " " * 14)
    return f"{head}{given}\n  {_doc(doc)}\n" + _wrapped(f"  {slots})", "  ")


def _slot(part) -> str:
    return lisp(part.name) + ("-p" if part.type.name == "bool" and not part.type.is_list else "")


def _function(interface: str, name: str, is_truth: bool = False) -> str:
    return FUNCTIONS.get((interface, name), lisp(name) + ("-p" if is_truth else ""))


def _class(interface: Interface) -> str:
    return CLASSES.get(interface.name, lisp(interface.name))


def _constant(proxy: Proxy, name: str) -> str:
    return f"+{_class(proxy.interface)}-{lisp(name)}+"


def _said(proxies: Proxies, interface: str, doc: str) -> str:
    by_class = {p.name: p for p in proxies.proxies}

    def name(text: str, call: str) -> str:
        *outer, last = text.split(".")
        if last + call in WORDS:
            return WORDS[last + call]
        value = proxies.values.get(outer[0]) if outer else None
        if value:
            return f"{lisp(value.name)}-{next((_slot(p) for p in value.fields if p.name == last), lisp(last))}"
        proxy = by_class[outer[0]] if outer else next((p for p in proxies.proxies if p.interface.name == interface), None)
        if proxy and last in {c.name for c in proxy.constants}:
            return _constant(proxy, last)
        function = _function(proxy.interface.name if proxy else interface, last)
        given = call.strip("()").replace("true", "t")
        return f"({function} device {given})" if given else function

    text = spelled(doc, name, lambda what: f"Signals {lisp(what)}")
    for word, ours in WORDS.items():
        text = re.sub(rf"(?<![\w-]){re.escape(word)}", ours, text)
    return text


class _Class(Spelling):
    TEXTS = {"truth": ["/=", "0", "{one}"], "equals": ["=", "{one}", "{constant}"], "bit": ["logtest", "{constant}", "{one}"],
             "text": ["text", "{one}"], "convert": ["{type}-of", "{one}"], "unpack": ["{type}-of", "{one}"], "call": ["{function}", "{all}"],
             "time": "time", "whole": "{one}"}

    def __init__(self, proxies: Proxies, proxy: Proxy) -> None:
        self.proxies, self.proxy, self.schema = proxies, proxy, proxies.schema
        self.wire, self.name = proxy.interface.name, _class(proxy.interface)
        self.constants = {c.name: _constant(proxy, c.name) for c in proxy.constants}
        self.roots: dict[str, Struct] = {k.name: k.struct for k in proxy.kept}
        self.functions: list[_Function] = []
        self.meaning: list[Form] = []
        for k in proxy.kept:
            body = ["slot-value", "device", f"'{lisp(k.name)}"]
            self.functions.append(_Function(lisp(k.name), self.name, f"{self._said(k.doc[:-1])}: a {self._type(k.struct, k.message.owner)}.", [body]))
        for member in proxy.members:
            made = self._member(member)
            self.functions.append(made)

    def forms(self, shared: dict[str, list[_Function]]) -> list[str]:
        p = self.proxy
        slots: list[Form] = [[lisp(k.name), ":initform", [self._maker(k.struct, k.message.owner)]] for k in p.kept]
        head: list[Form] = ["defclass", self.name, [BASES[p.base]], slots, [":documentation", _doc(self._said(p.doc), 19)]]
        if not slots:
            head[3] = "()"
        out = [_laid(head, 0, True)]
        out += [f"(defconstant {self.constants[c.name]} {c.value}\n  {_doc(self._said(c.doc))})" for c in p.constants]
        if p.kept:
            out.append(_laid(["defmethod", "prepare", [["device", self.name]], ["setf", *(part for k in p.kept for part in self._asked(k))]], 0, True))
        if self.meaning:
            out.append(_laid(self.meaning, 0, True))
        for f in self.functions:
            several = f.name in shared
            word = ["&key" if several else "&optional"] if f.optional or (several and any(o.optional for o in shared[f.name])) else []
            kind = "defmethod" if several else "define-operation"
            out.append(_laid([kind, f.name, [["device", self.name], *f.given, *word, *f.optional], _doc(f.doc), *f.body], 0, True))
        if p.updates:
            out.append(f"(define-updates {self.name} {_function(self.wire, p.updates.name)})")
        return out

    def _said(self, doc: str) -> str:
        return _said(self.proxies, self.wire, doc)

    # Names of the wire

    def _type(self, struct: Struct, owner: str) -> str:
        return f"{package(owner)}:{lisp(struct.name)}"

    def _maker(self, struct: Struct, owner: str) -> str:
        return f"{package(owner)}:make-{lisp(struct.name)}"

    def _payload(self, message: Message) -> Struct:
        assert message.payload
        struct = self.schema.interface(message.owner).struct(message.payload)
        assert struct is not None
        return struct

    def _message(self, message: Message) -> str:
        return f"{package(self.wire)}:+{lisp(message.constant)}+"

    def _constant(self, name: str) -> str:
        return f"{package(self.wire)}:+{lisp(name)}+"

    def _asked(self, kept) -> list[Form]:
        return [["slot-value", "device", f"'{lisp(kept.name)}"], ["answer-of", "device", self._message(kept.message)]]

    # Members

    def _about(self, doc: str, expr: Expr | None, message: Message | None) -> str:
        """What a member's text says; without one what its value or its message says."""
        if doc:
            return self._said(doc)
        if expr and expr.type.name in self.proxies.values:
            value = self.proxies.values[expr.type.name]
            return f"{_article(lisp(value.name))}: {self._said(value.doc[0].lower() + value.doc[1:])}"
        if expr and expr.how == "whole":
            return f"A {package(expr.type.owner)}:{lisp(expr.type.name)}."
        return self._said(message.doc) if message else ""

    def _read(self, read: Read) -> _Function:
        doc = self._about(read.doc, read.expr, read.messages[0] if read.messages else None)
        if read.messages and "Signals no-data" not in doc:
            doc += " Signals no-data before the first."
        e = read.expr
        if not read.messages:
            self.roots["message"] = self.roots[read.kept]
            body: Form = ["let", [["data", ["slot-value", "device", f"'{lisp(read.kept)}"]]], self._expr(e, "data", self.roots[read.kept])]
        elif read.variants:
            body = ["let", [["data", ["newest-of", "device", *(self._message(m) for m in read.messages)]]], self._of_variants(read)]
        else:
            struct = self._of_message(read.messages[0])
            asked = ["newest", "device", self._message(read.messages[0])]
            body = ["multiple-value-bind", ["data", "time"], asked, self._expr(e, "data", struct)] if e.has_time \
                else ["let", [["data", asked]], self._expr(e, "data", struct)]
        return _Function(_function(self.wire, read.name, e.type.name == "bool" and not e.type.is_list), self.name, doc, [body])

    def _of_message(self, message: Message) -> Struct:
        self.roots["message"] = self._payload(message)
        return self.roots["message"]

    def _of_variants(self, read: Read) -> Form:
        """What is made may be of a part of the message, of one type in all."""
        makes = read.expr.how == "make"
        cases: list[Form] = []
        struct = None
        for message, e in zip(read.messages, read.variants):
            payload = self._of_message(message)
            if not makes:
                made = self._expr(e, "data", payload)
            else:
                made = self._path(e.path, "data", payload) if e.paths else "data"
                struct = self.schema.struct_of(e.path.last) if e.paths else payload
            cases.append([self._type(payload, message.owner), made])
        chosen: Form = ["etypecase", "data", *cases]
        if not makes:
            return chosen
        assert struct is not None
        plain = Expr("make", read.expr.type, parts=read.expr.parts)
        return ["let", [["one", chosen]], self._expr(plain, "one", struct)]

    def _shortcut(self, s: Shortcut) -> _Function:
        read, accessor = [_function(self.wire, s.read.name), "device"], lisp(s.read.expr.type.name)
        part = next(p for p in self.proxies.values[s.read.expr.type.name].fields if p.name == s.field)
        doc = self._said(s.doc or part.doc or f"The {s.field} of {{{s.read.name}()}}.")
        doc = doc if "Signals no-data" in doc else f"{doc} Signals no-data before the first."
        one: Form = ["first-of", "device", read, f'"{s.none}"'] if s.none else read
        name = _function(self.wire, s.name, s.type.name == "bool" and not s.type.is_list)
        return _Function(name, self.name, doc, [[f"{accessor}-{_slot(part)}", one]])

    def _take(self, t: Take) -> _Function:
        self.meaning = ["defmethod", "meaning", [["device", self.name], "data"], self._expr(t.expr, "data", self._of_message(t.message))]
        return _Function(lisp(t.name), self.name, self._said(t.doc), [["take-all", ["kept", "device"]]])

    def _call(self, c: Call) -> _Function:
        body = self._checks(c)
        if c.moves:
            names = [lisp(name) for name in c.moves] if isinstance(c.moves, list) else []
            moving: Form = "t" if not names else ["not", ["zerop", names[0]]] if len(names) == 1 else ["notevery", "#'zerop", ["list", *names]]
            body.append(["setf", ["movingp", "device"], moving])
        sent: list[Form] = ["device", self._message(c.message)]
        if c.payload:
            sent.append(lisp(c.payload.name) if isinstance(c.payload, Argument) else self._node(c.payload))
        if c.answer is None:
            body.append(["command" if c.is_command else "request", *sent])
        elif c.answer.how == "whole" and not c.answer.paths:
            body.append(["answer-of", *sent])
        else:
            body.append(["let", [["data", ["answer-of", *sent]]], self._expr(c.answer, "data", self._of_message(c.message))])
        body += [["setf", *self._asked(k)] for k in self.proxy.kept if k.name in c.then]
        made = _Function(_function(self.wire, c.name), self.name, self._about(c.doc, c.answer, c.message), body)
        for a in c.arguments:
            if a.default:
                made.optional.append([lisp(a.name), self._default(a)])
            else:
                made.given += SPREAD.get(a.type.name, [lisp(a.name)])
        return made

    def _default(self, a: Argument) -> str:
        text = self.constants.get(a.default, a.default)
        return {"false": "nil", "true": "t"}.get(text, f"{text}d0" if "." in text else text)

    def _checks(self, c: Call) -> list[Form]:
        first: list[Form] = []
        finite: list[str] = []
        for a in c.arguments:
            name = lisp(a.name)
            if a.type.name in SPREAD:
                finite += [word for part in SPREAD[a.type.name] for word in (f'"{part}"', part)]
            elif a.type.owner:
                continue
            elif a.least is not None:
                first.append(["insist-on-whole", "device", f'"{a.name}"', name, str(a.least), "2147483647"])
            elif a.type.name == "float" and a.type.is_list:
                first.append(["insist-on-numbers", "device", f'"{a.name[:-1]}"', name])
            elif a.type.name == "float":
                finite += [f'"{a.name}"', name]
            elif a.type.name == "bytes":
                first.append(["insist-on-octets", "device", name])
            elif a.type.name not in ("bool", "int", "text"):
                first.append([f"insist-on-{lisp(a.type.name)}", "device", name])
        return first + ([["insist-on-finite", "device", *finite]] if finite else [])

    def _node(self, node: Node) -> Form:
        return [self._maker(node.struct, node.owner), *(part for f, value in node.entries for part in (f":{lisp(f.name)}", self._sent(f, value)))]

    def _sent(self, f: Field, value) -> Form:
        if isinstance(value, Node):
            return self._node(value)
        if isinstance(value, list):
            return ["concatenate", "'octets", *(self._sent(f, a) for a in value)]
        if not isinstance(value, Argument):
            return str(value)
        kind, name = value.type.name, lisp(value.name)
        if value.choice:
            no, yes = value.choice
            return ["if", name, self._constant(yes), self._constant(no)]
        if kind in SPREAD:
            struct = self.schema.struct_of(f)
            return [self._maker(struct, f.owner), *(word for part in SPREAD[kind] for word in (f":p{part}", part))]
        if kind == "bool":
            return ["if", name, "1", "0"]
        if kind == "text":
            return ["c-string", name]
        return name if kind in ("float", "int", "bytes") else [f"wire-{lisp(kind)}", name]

    # Expressions

    def _path(self, path: Path, at: str, struct: Struct) -> Form:
        if path.root:
            at, struct = ("data", self.roots["message"]) if path.root == "message" else (f"(slot-value device '{lisp(path.root)})", self.roots[path.root])
        made: Form = at
        for f in path.fields:
            owner = next(i.name for i in self.schema.all() if any(s is struct for s in i.structs))
            made = [f"{package(owner)}:{lisp(struct.name)}-{lisp(f.name)}", made]
            struct = struct if f.is_scalar or f.is_array else self.schema.struct_of(f)
        return made

    def _expr(self, e: Expr, at: str, struct: Struct) -> Form:
        made = self._plain(e, (at, struct))
        if e.absent:
            made = ["unless-number", e.absent, made]
        if e.only_if:
            flags, constant = e.only_if
            made = ["and", ["logtest", self._constant(constant), self._path(flags, at, struct)], made]
        return made

    def _paths(self, e: Expr, at: tuple[str, Struct]) -> list[Form]:
        return [self._path(p, *at) for p in e.paths]

    def _at_hand(self, at: tuple[str, Struct]) -> Form:
        return at[0]

    def _function(self, name: str) -> str:
        return lisp(name)

    def _type_name(self, e: Expr) -> str:
        return lisp(e.type.name)

    def _filled_in(self, text: Form, given: dict[str, Any]) -> Form:
        if isinstance(text, str):
            return text.format(**given) if text != "{one}" else given["one"]
        return [part for word in text for part in (given["all"] if word == "{all}" else [self._filled_in(word, given)])]

    def way_is(self, e: Expr, one: Form, at: tuple[str, Struct]) -> Form:
        return ["*", one, e.factor.replace("e", "d") if "e" in e.factor else f"{e.factor}d0"] if e.factor else one

    def way_gather(self, e: Expr, one: Form, at: tuple[str, Struct]) -> Form:
        return ["pose3d-at" if e.type.name == "Pose3d" else "list", *self._paths(e, at)]

    def way_each(self, e: Expr, one: Form, at: tuple[str, Struct]) -> Form:
        assert e.one is not None
        f = e.path.last
        made = self._expr(e.one, "one", at[1] if f.is_scalar else self.schema.struct_of(f))
        bare = isinstance(made, list) and len(made) == 2 and made[1] == "one"
        return ["map", "'list", f"#'{made[0]}" if bare else ["lambda", ["one"], made], one]

    def way_make(self, e: Expr, one: Form, at: tuple[str, Struct]) -> Form:
        return [f"make-{lisp(e.type.name)}", *(self._expr(part, *at) for _, part in e.parts)]


def _index(proxies: Proxies, functions: list[_Function], shared: dict[str, list[_Function]]) -> str:
    """What is exported, the class of each interface, and the functions that several classes have."""
    names = [_class(p.interface) for p in proxies.proxies]
    for p in proxies.generated():
        names += [_constant(p, c.name) for c in p.constants]
    for value in proxies.values.values():
        if not value.by_hand:
            name = lisp(value.name)
            names += [name, *(f"{name}-{_slot(part)}" for part in value.fields)]
    names += [f.name for f in functions]
    listed = _wrapped(" ".join(dict.fromkeys(names)), "          ")
    rows = "\n    ".join(f'("{p.interface.name}" . {_class(p.interface)})' for p in proxies.proxies)
    parts = [f";;;; What the proxies share. {MADE}", "(in-package #:playhouse-client)", f"(export '({listed}))",
             f"(defparameter *proxies*\n  '({rows})\n  \"The class of the proxy of each interface that has one.\")"]
    for name, those in shared.items():
        word = ["&key"] if any(f.optional for f in those) else []
        given = next((f.given for f in those), [])
        parts.append(_laid(["define-operation", name, ["device", *given, *word], _doc(_merged(name, those))], 0, True))
    return "\n\n".join(parts) + "\n"


def _merged(name: str, those: list[_Function]) -> str:
    """The text of all classes: once if it is the same."""
    by_doc: dict[str, list[str]] = {}
    for f in those:
        by_doc.setdefault(f.doc, []).append(f.of)
    if name in BY_HAND:
        who, doc = BY_HAND[name]
        by_doc.setdefault(doc, []).append(who)
    if len(by_doc) == 1:
        return next(iter(by_doc))
    return "\n".join(f"Of {_listed(of)}: {doc}" for doc, of in by_doc.items())


def _listed(names: list[str]) -> str:
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def _article(name: str) -> str:
    return f"{'An' if name[0] in 'aeiou' else 'A'} {name}"
