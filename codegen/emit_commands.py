"""Commands of viewers: playhouse/replicate/generated/, web/src/protocol/generated/ and their reference page."""

from __future__ import annotations

import re

from codegen.commands import PERSON_LETTERS, PERSON_RULE, PERSON_SETS, RIGHTS, WAVE, Command
from codegen.emit_kinds_cpp import _comment, enumerator

FOLDER = "playhouse/replicate/generated"
GESTURES = "playhouse/world/generated/gestures.h"
WEB_FILE = "web/src/protocol/generated/commands.ts"
PAGE = "docs/viewer-commands.md"
SOURCE = "viewer/commands.toml"
NOTE = f"Generated from {SOURCE} by codegen (python3 -m codegen). Do not edit."


def emit(commands: list[Command]) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/commands.h": _structs(commands), f"{FOLDER}/read_commands.cc": _reader(commands),
            f"{FOLDER}/person_name.h": _person_name(), GESTURES: _gestures(),
            WEB_FILE: _typescript(commands), PAGE: _page(commands)}


def _structs(commands: list[Command]) -> str:
    lines = [f"// {NOTE}", "#pragma once", "", "/// Commands of a page to the program; units and ranges are in docs/viewer-commands.md.", "",
             "#include <cstdint>", "#include <optional>", "#include <string>", "#include <variant>", "",
             '#include "playhouse/world/model_id.h"', "", "namespace playhouse::replicate {", ""]
    for command in commands:
        lines += _comment(command.doc.replace("`", ""))
        if not command.fields:
            lines += [f"struct {command.name} {{}};", ""]
            continue
        lines += [f"struct {command.name} {{", *(f"  {f.type.cpp.format(f.name)};" for f in command.fields), "};", ""]
    lines += ["using Command =", f"    std::variant<{', '.join(c.name for c in commands)}>;", "",
              "/// Required right of a command.",
              f"enum class May : std::uint8_t {{ {', '.join(enumerator(right) for right in RIGHTS)} }};", "",
              "constexpr May who_may(const Command& command) {", "  constexpr May kMay[] = {",
              *(f"      May::{enumerator(c.may)},  // {c.name}" for c in commands), "  };", "  return kMay[command.index()];", "}", "",
              "}  // namespace playhouse::replicate", ""]
    return "\n".join(lines)


def _read(field) -> str:
    function, _, limit = field.type.read.partition(":")
    return f'in.{function}("{field.name}"' + (f", {limit})" if limit else ")")


def _person_name() -> str:
    first, rest = (re.sub("[^ -~]|" + f"[^{PERSON_SETS[i]}]", "", "".join(map(chr, range(32, 127)))) for i in (0, 1))
    lines = [f"// {NOTE}", "#pragma once", "", "/// The name of a person who joins a world; valid as the name of a model and of a client.", "",
             "#include <string_view>", "", "namespace playhouse::replicate {", "",
             f"inline constexpr std::size_t kPersonNameBytes = {PERSON_LETTERS};",
             f'inline constexpr std::string_view kPersonNameRule = "1 to {PERSON_LETTERS} {PERSON_RULE}";', "",
             "constexpr bool is_person_name(std::string_view name) {",
             f'  constexpr std::string_view kFirst = "{first}";',
             f'  constexpr std::string_view kRest = "{rest}";',
             "  return !name.empty() && name.size() <= kPersonNameBytes && kFirst.find(name[0]) != kFirst.npos &&",
             "         name.find_first_not_of(kRest) == name.npos;", "}", "", "}  // namespace playhouse::replicate", ""]
    return "\n".join(lines)


def _gestures() -> str:
    return "\n".join([f"// {NOTE}", "#pragma once", "", "#include <string_view>", "", "namespace playhouse::world {", "",
                      "/// Text that makes a person wave.", f'inline constexpr std::string_view kWave = "{WAVE}";', "",
                      "}  // namespace playhouse::world", ""])


def _reader(commands: list[Command]) -> str:
    words = ", ".join(f'"{c.word}"' for c in commands)
    lines = [f"// {NOTE}", "", "#include <string_view>", "", '#include "playhouse/base/nearest_word.h"',
             '#include "playhouse/replicate/command_members.h"', "", "namespace playhouse::replicate {", "",
             "Command read_command(Members& in) {",
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
    lines = [f"// {NOTE}", "", "/** Commands of a page to the program (docs/viewer-commands.md). Models by id. */", "export type Command ="]
    for c in commands:
        members = "".join(f"; {f.name}{'?' if f.type.optional else ''}: {f.type.typescript}" for f in c.fields)
        lines.append(f"  | {{ do: '{c.word}'{members} }}" + (";" if c is commands[-1] else ""))
    pattern = f"[{PERSON_SETS[0]}][{PERSON_SETS[1]}]*".replace("\\", "\\\\")
    lines += ["", "/** The name of a person: maximum length, pattern, and the rule in words. */", f"export const kNameLetters = {PERSON_LETTERS};",
              f"export const kNamePattern = '{pattern}';", f"export const kNameRule = '{PERSON_RULE}';",
              "/** Text that makes a person wave. */", f"export const kWave = '{WAVE}';", ""]
    return "\n".join(lines)


def _page(commands: list[Command]) -> str:
    lines = [f"<!-- {NOTE} -->", "# Commands of viewers", "",
             "Commands of a page to the program, over the connection of [viewer-protocol.md](viewer-protocol.md). One JSON object per message, at most 4096 bytes. A command with an unknown key, a",
             "missing key or a number out of range is refused with a notice; the sixteenth refusal closes the connection. Between two frames (at least 33 ms, and a tick)",
             "64 messages are read; further ones wait, in order, in the connection. Commands that a viewer's role does not allow are refused with a notice ([guests.md](guests.md)). A command for a",
             "removed model has no effect; one for a model that never existed is refused.", ""]
    for right, people in RIGHTS.items():
        lines += [f"## For {people}", "", "| command | effect | keys |", "|---|---|---|"]
        for c in (c for c in commands if c.may == right):
            keys = "; ".join(f"`{f.name}`: {f.type.range}" for f in c.fields)
            lines.append(f"| `{c.example()}` | {c.doc} | {keys} |")
        lines.append("")
    return "\n".join(lines[:-1]) + "\n"
