"""Writes clients/lisp/generated/: one package per interface, in a file of its own.

A package playhouse.NAME has the interface's constants, one structure per struct and one message type per message, with
Player's names without the prefix, spelled as in Lisp: PLAYER_POSITION2D_CMD_VEL is playhouse.position2d:+cmd-vel+. The files
only declare; the macros of clients/lisp/src/define.lisp expand them to structures, readers and writers.
"""

from __future__ import annotations

import re
import textwrap

from codegen.checks import SchemaError
from codegen.model import COMMON, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/lisp/generated"
WIDTH = 110
MACROS = ("define-constants", "define-interface", "define-message", "define-struct")


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{lisp(i.name)}.lisp": _file(schema, i) for i in schema.all()}
    files[f"{FOLDER}/files.lisp-expr"] = _list_of_files(schema)
    return files


def lisp(name: str) -> str:
    """CmdVel, CMD_VEL and cmd_vel become cmd-vel."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[0-9])(?=[A-Z][a-z])", "-", name).lower().replace("_", "-")


def _constant(name: str) -> str:
    return f"+{lisp(name)}+"


def package(name: str) -> str:
    return f"playhouse.{lisp(name)}"


def _file(schema: Schema, interface: Interface) -> str:
    shared = interface.code is None
    title = "What every interface shares" if shared else f"Interface {interface.name}, code {interface.code}"
    about = f"Generated from {interface.source} by codegen; do not edit."
    parts = [_comment(f"{title}. {interface.doc.strip()}", ";;;; ") + f"\n;;;;\n;;;; {about}\n", _defpackage(interface)]
    if not shared:
        parts.append(f'(define-interface +code+ {interface.code} "{interface.name}")\n')
    parts += [_constants(c) for c in interface.constants]
    parts += [_struct(schema, interface, s) for s in interface.in_order()]
    if interface.messages:
        parts.append("\n".join(_message(interface, m) for m in interface.messages) + "\n")
    return "\n".join(parts)


def _defpackage(interface: Interface) -> str:
    names = _exports(interface)
    listed = textwrap.wrap(" ".join(f"#:{name}" for name in names), WIDTH - 13, break_long_words=False, break_on_hyphens=False)
    macros = " ".join(f"#:{macro}" for macro in MACROS)
    exports = "\n           ".join(listed)
    own = package(interface.name)
    return (f"(cl:defpackage #:{own}\n  (:use)\n  (:import-from #:playhouse.wire {macros})\n"
            f"  (:export {exports}))\n\n(cl:in-package #:{own})\n")


def _exports(interface: Interface) -> list[str]:
    """Every name that the file defines. A name may stand for a type and for a function, which Lisp keeps apart."""
    types = [lisp(s.name) for s in interface.structs]
    functions = [name for s in interface.structs for name in _functions(s)]
    variables = ["+code+"] if interface.code is not None else []
    variables += [_constant(n) for c in interface.constants for n in c.values]
    variables += [_constant(m.constant) for m in interface.messages]
    for names in (types, functions, variables):
        for name in names:
            if names.count(name) > 1 or name in MACROS:
                raise SchemaError(f"{interface.source}: {name} would stand for two things in Lisp")
    return list(dict.fromkeys([*variables, *types, *functions]))


def _functions(s: Struct) -> list[str]:
    name = lisp(s.name)
    return [f"make-{name}", f"copy-{name}", f"{name}-p", *(f"{name}-{lisp(f.name)}" for f in s.fields)]


def _constants(constants: Constants) -> str:
    rows = "".join(f"\n  ({_constant(name)} {value})" for name, value in constants.values.items())
    return f"{_comment(constants.doc, ';;; ')}\n(define-constants{rows})\n"


def _struct(schema: Schema, interface: Interface, s: Struct) -> str:
    doc = _string("\n  ".join(textwrap.wrap(f"{s.doc.strip()} ({s.c_name})", WIDTH - 6)))
    lines = [f'(define-struct ({lisp(s.name)} "{interface.name}.{s.name}")', f"  {doc}"]
    for f in s.fields:
        lines += [f"  ;; {line}" for line in textwrap.wrap(f.described(), WIDTH - 6)]
        moved = f" :count-before {lisp(f.count_before)}" if f.count_before else ""
        lines.append(f'  ({lisp(f.name)} "{f.name}" {_type(schema, interface, f)}{moved})')
    return "\n".join(lines) + ")\n"


def _type(schema: Schema, interface: Interface, f: Field) -> str:
    one = f":{f.type}" if f.is_scalar else _name_of(interface, f.owner, f.type)
    if f.length is not None:
        return f"(:array {one} {f.length})"
    if f.max is None:
        return one
    least = "" if f.is_scalar else f" {schema.struct_of(f).min_bytes}"
    return f"({':counted' if f.dynamic else ':bounded'} {one} {f.max}{least})"


def _name_of(interface: Interface, owner: str, name: str) -> str:
    return lisp(name) if owner == interface.name else f"{package(owner)}:{lisp(name)}"


def _message(interface: Interface, m: Message) -> str:
    name = interface.full_name(m)
    row = [_constant(m.constant), str(interface.code or 0), f":{m.kind.lower()}", str(m.subtype), f'"{name}"']
    row += [_name_of(interface, m.owner, m.payload)] if m.payload else []
    made = f"(define-message {' '.join(row)})"
    if len(made) > WIDTH:
        made = f"(define-message {' '.join(row[:-1])}\n  {row[-1]})"
    return f"{_comment(m.doc, ';; ')}\n{made}"


def _list_of_files(schema: Schema) -> str:
    """The files in an order in which each follows those that it needs."""
    done: list[str] = []

    def add(interface: Interface) -> None:
        for owner in [] if interface.name == COMMON else [COMMON, *interface.needs()]:
            add(schema.interface(owner))
        if interface.name not in done:
            done.append(interface.name)

    for interface in schema.all():
        add(interface)
    rows = "\n ".join(f'"{lisp(name)}"' for name in done)
    return f";;;; The files of this folder, in the order of loading.\n;;;;\n;;;; Generated from interfaces/ by codegen; do not edit.\n\n({rows})\n"


def _comment(text: str, prefix: str) -> str:
    return "\n".join(prefix + line for line in textwrap.wrap(text.strip(), WIDTH - len(prefix)))


def _string(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
