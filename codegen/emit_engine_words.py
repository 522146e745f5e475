"""C++ that finds the words of a scene with a full effect in one engine only: playhouse/scene/generated/engine_words.h/.cc."""

from __future__ import annotations

from codegen.emit_kinds_cpp import BANNER, FOLDER, _comment, _text, described, differs
from codegen.kinds import BASE, Kind, Kinds


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/engine_words.h": _header(kinds), f"{FOLDER}/engine_words.cc": _source(kinds)}


def _own(kinds: Kinds) -> list[Kind]:
    """Kinds whose words are found in a description of their own: the world, and what all models have."""
    return [k for k in described(kinds) if k.entity == "world" or k.name == BASE]


def _signature(desc: str) -> str:
    return f"void add_arena_words(const {desc}& from, std::set<std::string_view>& words)"


def _header(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", "", "#include <set>", "#include <string_view>", "",
             '#include "playhouse/scene/generated/kind_descs.h"', "", "namespace playhouse::scene {", ""]
    lines += _comment('Adds the words with `engine = "arena"` in kinds/ whose values in `from` are not the defaults.')
    lines += [f"{_signature(desc)};" for desc in [*(k.desc for k in _own(kinds)), "KindDescs"]]
    return "\n".join([*lines, "", "}  // namespace playhouse::scene", ""])


def _source(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), f'#include "{FOLDER}/engine_words.h"', "", "#include <algorithm>", "", "namespace playhouse::scene {"]
    inner = [k for k in described(kinds) if k not in _own(kinds) and any(w.engine for w in k.members)]
    lines += ["namespace {", "", *(line for kind in inner for line in [*_adder(kind), ""]), "}  // namespace", ""]
    lines += [line for kind in _own(kinds) for line in [*_adder(kind), ""]]
    lines.append(f"{_signature('KindDescs')} {{")
    for kind in inner:
        if kind.entity == "part":
            lines.append(f"  for (const {kind.desc}& part : from.{kind.table}) add_arena_words(part, words);")
        else:
            lines.append(f"  if (from.{kind.name}) add_arena_words(*from.{kind.name}, words);")
    return "\n".join([*lines, "}", "", "}  // namespace playhouse::scene", ""])


def _adder(kind: Kind) -> list[str]:
    lines = [f"  if ({differs(w)}) words.insert({_text(w.name)});" for w in kind.members if w.engine]
    if any("unsaid." in line for line in lines):
        lines.insert(0, f"  static const {kind.desc} unsaid;")
    return [f"{_signature(kind.desc)} {{", *lines, "}"]
