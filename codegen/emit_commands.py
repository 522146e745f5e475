"""What a page may ask, at both ends: playhouse/replicate/generated/ and web/src/protocol/generated/, and its page of the docs."""

from __future__ import annotations

from codegen.commands import PERSON_LETTERS, RIGHTS, Command
from codegen.emit_kinds_cpp import _comment, enumerator

FOLDER = "playhouse/replicate/generated"
WEB_FILE = "web/src/protocol/generated/commands.ts"
PAGE = "docs/viewer-commands.md"
SOURCE = "viewer/commands.toml"
NOTE = f"Generated from {SOURCE} by codegen (python3 -m codegen). Do not edit."


def emit(commands: list[Command]) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/commands.h": _structs(commands), f"{FOLDER}/read_commands.cc": _reader(commands),
            WEB_FILE: _typescript(commands), PAGE: _page(commands)}


def _structs(commands: list[Command]) -> str:
    lines = [f"// {NOTE}", "#pragma once", "", "/// What a page may ask of the program; docs/viewer-commands.md has the units and ranges.", "",
             "#include <cstdint>", "#include <optional>", "#include <string>", "#include <variant>", "",
             '#include "playhouse/world/model_id.h"', "", "namespace playhouse::replicate {", ""]
    for command in commands:
        lines += _comment(command.doc.replace("`", ""))
        if not command.fields:
            lines += [f"struct {command.name} {{}};", ""]
            continue
        lines += [f"struct {command.name} {{", *(f"  {f.type.cpp.format(f.name)};" for f in command.fields), "};", ""]
    lines += ["using Command =", f"    std::variant<{', '.join(c.name for c in commands)}>;", "",
              "/// Whose a command is: everybody's, or of those who have a right.",
              f"enum class May : std::uint8_t {{ {', '.join(enumerator(right) for right in RIGHTS)} }};", "",
              "constexpr May who_may(const Command& command) {", "  constexpr May kMay[] = {",
              *(f"      May::{enumerator(c.may)},  // {c.name}" for c in commands), "  };", "  return kMay[command.index()];", "}", "",
              "}  // namespace playhouse::replicate", ""]
    return "\n".join(lines)


def _read(field) -> str:
    function, _, limit = field.type.read.partition(":")
    return f'in.{function}("{field.name}"' + (f", {limit})" if limit else ")")


def _reader(commands: list[Command]) -> str:
    words = ", ".join(f'"{c.word}"' for c in commands)
    lines = [f"// {NOTE}", "", "#include <string_view>", "", '#include "playhouse/base/limits.h"', '#include "playhouse/base/nearest_word.h"',
             '#include "playhouse/replicate/command_members.h"', "", "namespace playhouse::replicate {", "",
             f"static_assert(limits::kPersonNameBytes == {PERSON_LETTERS});", "", "Command read_command(Members& in) {",
             f"  constexpr std::string_view kWords[] = {{{words}}};", '  const std::string_view word = in.word("do");']
    for c in commands:
        lines.append(f'  if (word == "{c.word}") {{')
        lines.append(f"    {c.name} out;" if c.fields else f"    return {c.name}{{}};")
        lines += [f"    out.{f.name} = {_read(f)};" for f in c.fields]
        lines += ["    return out;", "  }"] if c.fields else ["  }"]
    lines += ['  in.fault("no such command" + did_you_mean(word, kWords));', f"  return {commands[0].name}{{}};", "}", "",
              "}  // namespace playhouse::replicate", ""]
    return "\n".join(lines)


def _typescript(commands: list[Command]) -> str:
    lines = [f"// {NOTE}", "", "/** What a page may ask of the program (docs/viewer-commands.md). Models by id. */", "export type Command ="]
    for c in commands:
        members = "".join(f"; {f.name}{'?' if f.type.optional else ''}: {f.type.typescript}" for f in c.fields)
        lines.append(f"  | {{ do: '{c.word}'{members} }}" + (";" if c is commands[-1] else ""))
    lines += ["", "/** Letters that the name of a person has at most. */", f"export const kNameLetters = {PERSON_LETTERS};", ""]
    return "\n".join(lines)


def _page(commands: list[Command]) -> str:
    lines = [f"<!-- {NOTE} -->", "# Commands of viewers", "",
             "What a page asks of the program, over the connection of [viewer-protocol.md](viewer-protocol.md). One JSON object per message, at most 4096 bytes. An unknown key, a",
             "missing one or a number out of its range refuses the command with a notice; the sixteenth refusal closes the connection. Between two pictures (at least 33 ms, and a tick)",
             "64 messages are read; more wait, in order, on the way. What a viewer's role does not allow is refused with a notice ([guests.md](guests.md)). A command for a model that has",
             "gone meanwhile does nothing; one for a model that never was is refused.", ""]
    for right, people in RIGHTS.items():
        lines += [f"## Of {people}", "", "| command | what it does | keys |", "|---|---|---|"]
        for c in (c for c in commands if c.may == right):
            keys = "; ".join(f"`{f.name}`: {f.type.range}" for f in c.fields)
            lines.append(f"| `{c.example()}` | {c.doc} | {keys} |")
        lines.append("")
    return "\n".join(lines[:-1]) + "\n"
