"""Reference pages: docs/interfaces/, one page per interface and an index."""

from __future__ import annotations

from codegen.model import COMMON, KINDS, Field, Interface, Message, Schema, Struct

FOLDER = "docs/interfaces"
KIND_NAMES = {"DATA": "data", "CMD": "command", "REQ": "request", "SYNCH": "synch"}


def emit(schema: Schema) -> dict[str, str]:
    files = {f"{FOLDER}/{page(i)}": _page(i) for i in schema.all()}
    files[f"{FOLDER}/README.md"] = _index(schema)
    return files


def page(interface: Interface) -> str:
    return f"{interface.code or 0:03d}_{interface.name}.md"


def _banner(source: str) -> str:
    return f"<!-- Generated from {source} by codegen (python3 -m codegen). Do not edit. -->"


def _index(schema: Schema) -> str:
    lines = [_banner("interfaces/"), "# Interfaces", "",
             "Purpose, messages and fields of each interface. The encoding, and the letters of the frames,",
             "are described in [wire.md](../wire.md).", "", "| code | interface | purpose |", "|---:|---|---|"]
    for i in schema.interfaces:
        lines.append(f"| {i.code} | [{i.name}]({page(i)}) | {i.doc} |")
    lines += ["", f"Shared by all: [{COMMON}]({page(schema.common)})."]
    return "\n".join(lines) + "\n"


def _page(interface: Interface) -> str:
    title = "Shared by all interfaces" if interface.code is None else f"{interface.name} (code {interface.code})"
    lines = [_banner(interface.source), f"# {title}", "", interface.doc, ""]
    lines += _messages(interface)
    if interface.reserved:
        lines += [f"Reserved request subtypes: {', '.join(str(n) for n in interface.reserved)}.", ""]
    if interface.constants:
        lines += ["## Constants", ""]
    for group in interface.constants:
        lines += [group.doc, "", "| name | value |", "|---|---:|"]
        lines += [f"| `{group.c_prefix}{name}` | {value} |" for name, value in group.values.items()] + [""]
    lines += ["## Values", ""]
    for struct in interface.structs:
        lines += _struct(struct, interface)
    return "\n".join(lines).rstrip() + "\n"


def _messages(interface: Interface) -> list[str]:
    if not interface.messages:
        return []
    lines = ["## Messages", "", "| message | kind | subtype | body | replaces older | |", "|---|---|---:|---|---|---|"]
    for m in sorted(interface.messages, key=lambda m: (KINDS[m.kind], m.subtype)):
        replaces = {"latest": "yes", "queue": "no", "": ""}[m.policy]
        lines.append(f"| `{m.name}` | {KIND_NAMES[m.kind]} | {m.subtype} | {_payload(m, interface)} | {replaces} | {m.doc} |")
    return [*lines, ""]


def _link(owner: str, name: str, inside: Interface) -> str:
    if owner == inside.name:
        return f"[{name}](#{name.lower()})"
    # The shared page has no code; other pages are linked from the index by name.
    return f"[{name}](000_common.md#{name.lower()})" if owner == COMMON else f"{owner}.{name}"


def _payload(m: Message, inside: Interface) -> str:
    return _link(m.owner, m.payload, inside) if m.payload else "none"


def _struct(struct: Struct, inside: Interface) -> list[str]:
    lines = [f"### {struct.name}", "", f"{struct.doc} In C: `{struct.c_name}`; {_size(struct)}.", "",
             "| field | type | unit | frame | |", "|---|---|---|---|---|"]
    for f in struct.fields:
        lines.append(f"| `{f.name}` | {_type(f, inside)} | {f.unit} | {_frame(f)} | {f.doc} |")
    return [*lines, ""]


def _size(struct: Struct) -> str:
    variable = any(f.has_count for f in struct.fields)
    return f"{'at least ' if variable else ''}{struct.min_bytes} bytes on the wire"


def _frame(f: Field) -> str:
    return f"`{f.frame}`" if f.frame else ""


def _type(f: Field, inside: Interface) -> str:
    one = f.original_type if f.is_scalar else _link(f.owner, f.type, inside)
    if f.signed:
        return f"{one}, signed"
    if f.length is not None:
        return f"{one} × {f.length}"
    if f.dynamic:
        return f"{one} list"
    return f"{one} list, at most {f.max}" if f.is_array else one
