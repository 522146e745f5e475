"""Writes clients/java/generated/: one class per interface in the package playhouse.client.wire, standard library only.

A class NAMEMessages has the interface's constants, a record per struct, and a MessageType per message, with Player's name
without the prefix (PLAYER_POSITION2D_CMD_VEL is Position2dMessages.CMD_VEL). Interfaces has the table of them all.
"""

from __future__ import annotations

import re
import textwrap

from codegen.checks import SchemaError
from codegen.model import COMMON, OPAQUE, SCALARS, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/java/generated"
PACKAGE = f"{FOLDER}/playhouse/client/wire"
WIDTH = 110

# Scalar type -> type of a component, and of an array of it.
TYPES = {
    "char": "int", "int8": "int", "uint8": "int", "int16": "int", "uint16": "int", "int32": "int", "uint32": "long",
    "int64": "long", "float32": "float", "float64": "double",
}
# What cannot be the name of a component or a variable of the generated code.
RESERVED = set("""abstract assert boolean break byte case catch char class const continue default do double else enum extends final
    finally float for goto if implements import in instanceof int interface long native new out package private protected public
    return short static strictfp super switch synchronized this throw throws transient try void volatile while true false null
    clone finalize getClass hashCode notify notifyAll toString wait encode decode read write that""".split())


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{PACKAGE}/{class_name(i)}.java": _class(schema, i) for i in schema.all()}
    files[f"{PACKAGE}/Interfaces.java"] = _index(schema)
    return files


def class_name(interface: Interface) -> str:
    """speech_recognition -> SpeechRecognitionMessages."""
    return _class_of(interface.name)


def _class_of(name: str) -> str:
    return "".join(part[0].upper() + part[1:] for part in name.split("_")) + "Messages"


def component(f: Field) -> str:
    """min_angle -> minAngle; with a _ after it if Java reserves the word."""
    name = re.sub(r"_(\w)", lambda found: found[1].upper(), f.name)
    return name + "_" if name in RESERVED else name


def _is_found_again(f: Field) -> bool:
    """Whether the wire's name follows from the component's."""
    return re.sub(r"([A-Z])", lambda found: "_" + found[1].lower(), component(f)) == f.name


def _banner(source: str) -> str:
    return f"// Generated from {source} by codegen (python3 -m codegen). Do not edit."


def _javadoc(text: str, indent: int, parameters: dict[str, str] | None = None) -> list[str]:
    """A documentation comment; each parameter is a paragraph of its own."""
    text, before = _escaped(text.strip()), " " * indent
    if not parameters and len(text) <= WIDTH - indent - 7:
        return [f"{before}/** {text} */"]
    lines = textwrap.wrap(text, WIDTH - indent - 3) + ([""] if parameters else [])
    for name, about in (parameters or {}).items():
        lines += textwrap.wrap(f"@param {name} {_escaped(about)}", WIDTH - indent - 3, subsequent_indent="    ")
    return [f"{before}/**", *(f"{before} * {line}".rstrip() for line in lines), f"{before} */"]


def _escaped(text: str) -> str:
    """Without what Javadoc takes for HTML or for a tag."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("@", "&#64;").replace("*/", "*&#47;")


def _class(schema: Schema, interface: Interface) -> str:
    _check_names(interface)
    shared = interface.code is None
    title = "What every interface shares" if shared else f"Interface {interface.name}, code {interface.code}"
    lines = [_banner(interface.source), "package playhouse.client.wire;", "", *_imports(interface), ""]
    lines += [*_javadoc(f"{title}. {interface.doc}", 0), f"public final class {class_name(interface)} {{"]
    if not shared:
        lines += [*_javadoc("The interface's code.", 2), f"  public static final int CODE = {interface.code};", ""]
    for constants in interface.constants:
        lines += _constants(interface, constants)
    for struct in interface.structs:
        lines += [*_record(schema, interface, struct), ""]
    for message in interface.messages:
        lines += [*_message(interface, message), ""]
    lines += ["  static final List<MessageType<?>> MESSAGES = List.of("]
    lines += textwrap.wrap(", ".join(m.constant for m in interface.messages) + ");", WIDTH,
                           initial_indent="      ", subsequent_indent="      ")
    return "\n".join([*lines, "", f"  private {class_name(interface)}() {{}}", "}", ""])


def _check_names(interface: Interface) -> None:
    names = [s.name for s in interface.structs] + [m.constant for m in interface.messages]
    names += [interface.constant(n) for c in interface.constants for n in c.values]
    for name in names:
        if names.count(name) > 1 or name in ("CODE", "MESSAGES"):
            raise SchemaError(f"{interface.source}: {name} would stand for two things in Java")
    if any(s.name in ("String", "List", "Override", "Struct", "Reader", "Writer", "Kind", "MessageType", "Nothing")
           for s in interface.structs):
        raise SchemaError(f"{interface.source}: a struct hides a class that the generated code needs in Java")


def _imports(interface: Interface) -> list[str]:
    names = {"List"}
    for s in interface.structs:
        if any(_is_list(f) and f.length is not None for f in s.fields):
            names.add("Collections")
        if any(_is_java_array(f) for f in s.fields):
            names.add("Arrays")
            if len(s.fields) > 1:
                names.add("Objects")
    return [f"import java.util.{name};" for name in sorted(names)]


def _constants(interface: Interface, constants: Constants) -> list[str]:
    lines = [f"  // {line}" for line in textwrap.wrap(constants.doc, WIDTH - 5)]
    return lines + [f"  public static final int {interface.constant(name)} = {value};"
                    for name, value in constants.values.items()] + [""]


# --- records -------------------------------------------------------------------------------------------------------


def _is_list(f: Field) -> bool:
    return f.is_array and not f.is_scalar


def _is_java_array(f: Field) -> bool:
    return f.is_array and f.is_scalar


def _struct_name(interface: Interface, f: Field) -> str:
    return f.type if f.owner == interface.name else f"{_class_of(f.owner)}.{f.type}"


def _type(interface: Interface, f: Field) -> str:
    if f.is_raw:
        return "byte[]"
    if f.is_scalar:
        return TYPES[f.type] + ("[]" if f.is_array else "")
    one = _struct_name(interface, f)
    return f"List<{one}>" if f.is_array else one


def _default(interface: Interface, f: Field) -> str:
    if _is_java_array(f):
        return f"new {_type(interface, f)[:-2]}[{f.length or 0}]"
    if f.is_scalar:
        return {"float": "0f", "long": "0L", "double": "0.0"}.get(TYPES[f.type], "0")
    one = f"new {_struct_name(interface, f)}()"
    if not f.is_array:
        return one
    return "List.of()" if f.length is None else f"Collections.nCopies({f.length}, {one})"


def _record(schema: Schema, interface: Interface, s: Struct) -> list[str]:
    shown = ", ".join(_declared(interface, f) for f in s.fields)
    head = f"  public record {s.name}({shown}) implements Struct {{"
    if len(head) > WIDTH:
        head = "\n".join([f"  public record {s.name}(",
                          *textwrap.wrap(shown + ")", WIDTH, initial_indent="      ", subsequent_indent="      "),
                          "      implements Struct {"])
    parts = [_empty(interface, s), _decoding(schema, interface, s), _encoding(s)]
    parts += [_comparison(s)] if any(_is_java_array(f) for f in s.fields) else []
    body = [line for part in parts for line in [*part, ""]][:-1]
    return [*_javadoc(f"{s.doc} ({s.c_name})", 2, {component(f): _about(f) for f in s.fields}), head, *body, "  }"]


def _empty(interface: Interface, s: Struct) -> list[str]:
    nothing = ", ".join(_default(interface, f) for f in s.fields)
    return [*_javadoc("Every number 0, every list empty.", 4), f"    public {s.name}() {{", *_filled(f"this({nothing});", 6), "    }"]


def _decoding(schema: Schema, interface: Interface, s: Struct) -> list[str]:
    lines = [*_javadoc("Decodes a body; bytes after the last field are ignored. Throws WireException.", 4),
             f"    public static {s.name} decode(byte[] body) {{",
             f'      return Reader.decode("{interface.name}.{s.name}", body, {s.name}::read);', "    }", "",
             f"    static {s.name} read(Reader in) {{"]
    for step, f in s.steps():
        lines += _filled(_read_count(f) if step == "count" else _read(schema, interface, f), 6)
    made = ", ".join(component(f) for f in s.fields)
    return [*lines, *_filled(f"return new {s.name}({made});", 6), "    }"]


def _encoding(s: Struct) -> list[str]:
    lines = ["    @Override", "    public void write(Writer out) {"]
    for step, f in s.steps():
        lines += [f"      {line}" for line in (_write_count(f) if step == "count" else _write(f))]
    return [*lines, "    }"]


def _declared(interface: Interface, f: Field) -> str:
    name = "" if _is_found_again(f) else f'@WireName("{f.name}") '
    return f"{name}{_type(interface, f)} {component(f)}"


def _about(f: Field) -> str:
    text = f.described(f"{f.length} elements" if f.length else "")
    return text or f.name.replace("_", " ").capitalize() + "."


def _filled(text: str, indent: int) -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent=" " * indent, subsequent_indent=" " * (indent + 4), break_long_words=False)


def _count(f: Field) -> str:
    return component(f) + "Count"


def _read_count(f: Field) -> str:
    return f"long {_count(f)} = in.uint32();" if f.dynamic else "in.uint32();"


def _function(f: Field) -> str:
    """That of Reader and Writer for one number; a char is a signed byte."""
    return "int8" if f.type == "char" else f.type


def _read(schema: Schema, interface: Interface, f: Field) -> str:
    name = component(f)
    if not f.is_array:
        one = f"in.{_function(f)}()" if f.is_scalar else f"{_struct_name(interface, f)}.read(in)"
        return f"{_type(interface, f)} {name} = {one};"
    length = str(f.length)
    if f.length is None:
        least = 1 if f.type in OPAQUE else SCALARS[f.type] if f.is_scalar else schema.struct_of(f).min_bytes
        length = f'in.length("{f.name}", {_count(f) if f.dynamic else f.max}, {least})'
    call = "bytes" if f.is_raw else f"{_function(f)}s" if f.is_scalar else "structs"
    reader = "" if f.is_scalar else f", {_struct_name(interface, f)}::read"
    return f"{_type(interface, f)} {name} = in.{call}({length}{reader});"


def _size(f: Field) -> str:
    return f"{component(f)}.length" if f.is_scalar else f"{component(f)}.size()"


def _write_count(f: Field) -> list[str]:
    return [f'out.length("{f.name}", {_size(f)}, {f.max});']


def _write(f: Field) -> list[str]:
    lines, name = _write_count(f) if f.has_count else [], component(f)
    if not f.is_array:
        return [f"out.{_function(f)}({name});" if f.is_scalar else f"{name}.write(out);"]
    if f.is_raw:
        return [f'out.fixed("{f.name}", {name}, {f.length});'] if f.length is not None else [*lines, f"out.bytes({name});"]
    if f.length is not None:
        lines.append(f'out.exactly("{f.name}", {_size(f)}, {f.length});')
    return [*lines, f"out.{_function(f)}s({name});" if f.is_scalar else f"out.structs({name});"]


def _comparison(s: Struct) -> list[str]:
    """Values are equal if their elements are, which arrays by themselves are not."""
    def same(f: Field) -> str:
        name = component(f)
        if _is_java_array(f):
            return f"Arrays.equals({name}, that.{name})"
        if not f.is_scalar or f.is_array:
            return f"{name}.equals(that.{name})"
        boxed = {"float": "Float", "double": "Double"}.get(TYPES[f.type])
        return f"{boxed}.compare({name}, that.{name}) == 0" if boxed else f"{name} == that.{name}"

    arrays = [f"Arrays.hashCode({component(f)})" for f in s.fields if _is_java_array(f)]
    plain = [component(f) for f in s.fields if not _is_java_array(f)]
    hashed = f"Objects.hash({', '.join(plain + arrays)})" if len(s.fields) > 1 else arrays[0]
    conditions = [f"other instanceof {s.name} that", *(f"&& {same(f)}" for f in s.fields)]
    whole = " ".join(condition.replace(" ", "\N{NO-BREAK SPACE}") for condition in conditions)
    lines = [line.replace("\N{NO-BREAK SPACE}", " ") for line in _filled(f"return {whole};", 6)]
    return ["    @Override", "    public boolean equals(Object other) {", *lines, "    }", "",
            "    @Override", "    public int hashCode() {", *_filled(f"return {hashed};", 6), "    }"]


# --- messages ------------------------------------------------------------------------------------------------------


def _message(interface: Interface, m: Message) -> list[str]:
    payload = m.payload if m.owner == interface.name else f"{_class_of(m.owner)}.{m.payload}" if m.payload else "Nothing"
    name = interface.full_name(m)
    decoder = f"{payload}::decode" if m.payload else "null"
    made = f'new MessageType<>({interface.code or 0}, Kind.{m.kind}, {m.subtype}, "{name}", {decoder});'
    head = f"  public static final MessageType<{payload}> {m.constant} ="
    lines = [f"{head} {made}"] if len(head) + 1 + len(made) <= WIDTH else [head, *_filled(made, 6)]
    return [*_javadoc(m.doc, 2), *lines]


def _index(schema: Schema) -> str:
    rows = ",\n".join(f'      Map.entry({i.code}, "{i.name}")' for i in schema.interfaces)
    cases = "\n".join(f"      case {i.code} -> {class_name(i)}.MESSAGES;" for i in schema.interfaces)
    return f"""{_banner("interfaces/")}
package playhouse.client.wire;

import java.util.List;
import java.util.Map;

/** Every interface of the Player protocol. */
public final class Interfaces {{
  /** Code of an interface, and its name. */
  public static final Map<Integer, String> NAMES = Map.ofEntries(
{rows});

  /** The messages of an interface, without the shared ones; none if there is no such interface. */
  static List<MessageType<?>> messagesOf(int code) {{
    return switch (code) {{
{cases}
      default -> List.of();
    }};
  }}

  /** The messages that all interfaces share. */
  static List<MessageType<?>> sharedMessages() {{
    return {_class_of(COMMON)}.MESSAGES;
  }}

  private Interfaces() {{}}
}}
"""
