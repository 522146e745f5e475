"""Reference pages for people: docs/kinds/, one page per kind and an index."""

from __future__ import annotations

from codegen.emit_kinds_text import default_text, doc_text, form_text, limits_text, unit_text
from codegen.kind_old import OldType
from codegen.kind_words import Word
from codegen.kinds import BASE, INDICES, NEEDS, Kind, Kinds, Served

FOLDER = "docs/kinds"
VALUES = {
    "flag": "0 or 1", "integer": "a whole number; a fraction is cut off", "count": "a whole number that is not negative",
    "number": "a number, in the unit that is told whatever the file's", "length": "a number, in the file's unit of length",
    "angle": "a number, in the file's unit of angle", "text": "in quotes", "texts": "one text, or several in brackets",
    "choices": "words in quotes, in brackets, one of each list",
    "color": "a name in quotes", "colors": "one name of a color in quotes, or several in brackets",
}
TIMES = {"start": "with the scene", "changed": "when it differs", "selected": "while the robot is selected",
         "shown": "while the robot is selected or its sensors are shown"}
CODES = {"json": "JSON", "difference": "difference, zigzag varint", "turn": "16 bits of a turn", "bit": "a bit of its state",
         "rgba": "32 bits", "fraction": "16 bits", "varint": "varint", "zigzag": "zigzag varint", "text": "UTF-8"}


def emit(kinds: Kinds) -> dict[str, str]:
    files = {f"{FOLDER}/{kind.name}.md": _page(kinds, kind) for kind in kinds.all}
    files[f"{FOLDER}/README.md"] = _index(kinds)
    return files


def _banner(source: str) -> str:
    return f"<!-- Generated from {source} by codegen (python3 -m codegen). Do not edit. -->"


def _table(heads: list[str], rows: list[list[str]]) -> list[str]:
    """Without the columns that are empty in every row."""
    kept = [i for i in range(len(heads)) if any(row[i] for row in rows)]
    lines = ["| " + " | ".join(heads[i] for i in kept) + " |", "|" + "---|" * len(kept)]
    return [*lines, *("| " + " | ".join(row[i].replace("|", "\\|") for i in kept) + " |" for row in rows), ""]


def _now(old: OldType) -> str:
    return "an error" if old.type is None else f"`{old.type}`" if old.type else "nothing"


def _index(kinds: Kinds) -> str:
    lines = [_banner("kinds/"), "# What world files hold", "",
             "Each page lists the words of a kind, their values, units and defaults. How a file is written is in",
             "[worldfile.md](../worldfile.md); `playhouse kinds NAME` prints the same.", "",
             "Units are those of files that choose none: with `unit_length` and `unit_angle` lengths and angles have others.", ""]
    lines += ["## Models", "", *_rows(kinds.simulated())]
    if plain := [k for k in kinds.models() if not k.simulated]:
        lines += ["Other types of Stage 4 load as plain bodies, with one warning each:", "", *_rows(plain)]
    lines += ["## Besides models", "", *_rows([k for k in kinds.all if k.entity != "model"])]
    lines += ["## Values", "", *_table(["value", "in a file"], [[name, text] for name, text in VALUES.items()])]
    old = sorted((each for kind in kinds.all for each in kind.old_types), key=lambda each: each.name)
    lines += ["## Types of older versions", "",
              "Most are read as what they mean now ([worldfile.md](../worldfile.md)); the others are errors, and the line says what to write.", "",
              *_table(["type", "is read as", "in its place"], [[f"`{each.name}`", _now(each), each.instead] for each in old])]
    return "\n".join(lines).rstrip() + "\n"


def _rows(kinds: list[Kind]) -> list[str]:
    return _table(["name", "what it is", "interfaces"],
                  [[f"[{k.name}]({k.name}.md)", k.doc, ", ".join(f"`{s.name}`" for s in k.interfaces)] for k in kinds])


def _page(kinds: Kinds, kind: Kind) -> str:
    lines = [_banner(kind.source), f"# {kind.name}", "", kind.doc, "", *_place(kinds, kind)]
    read = [w for w in kind.words if w.use == "read"]
    if read:
        lines += ["## Words", "", *_words(read)]
    if kind.entity == "model" and kind.name != BASE:
        lines += [f"Besides, it has the [words and devices of every model]({BASE}.md).", ""]
    for part in kinds.parts_of(kind):
        lines += [f"`{part.name}( ... )` inside it is described on [a page of its own]({part.name}.md).", ""]
    lines += _devices(kind) + _idle(kind) + _state(kind)
    return "\n".join(lines).rstrip() + "\n"


def _place(kinds: Kinds, kind: Kind) -> list[str]:
    if kind.entity == "part":
        return [f"`{kind.name}( ... )` stands inside a [{kind.inside}]({kind.inside}.md)"
                f"{', of whatever kind' if kind.inside == BASE else ''}.", ""]
    if kind.entity == "trait":
        words = ", ".join(f"`{name}`" for name in kind.given_by)
        return [f"A [model]({BASE}.md) of any kind has one if it says one of {words}.", ""]
    if kind.entity == "window":
        return [f"`{kind.name}( ... )` stands at the top level.", ""]
    if kind.body is None:
        return []
    size = " ".join(f"{v:g}" for v in kind.body.size)
    color = " ".join(f"{v:g}" for v in kind.body.color)
    form = kind.body.form or "a box that fills its size"
    body = f"{form}, unless blocks or a bitmap say otherwise" if kind.body.solid else "none, unless blocks or a bitmap make one"
    lines = [f"`{kind.name}( ... )` stands at the top level or inside another model. Without words of its own: size [{size}] m, "
             f"color [{color}]; body: {body}.", ""]
    draws = [("", kind)] + [(f" for each `{p.name}`", p) for p in kinds.parts_of(kind) if kind.name != BASE]
    told = [f"{each.watts:g} W{of}" for of, each in draws if each.watts is not None]
    if told:
        lines += [f"While it is subscribed it draws {' and '.join(told)} from its battery, whatever `watts` says.", ""]
    if not kind.simulated:
        lines += ["It is not simulated yet: it loads as a plain model, with one warning, and its words have no effect.", ""]
    return lines


def _words(words: list[Word]) -> list[str]:
    rows = [[f"`{w.name}{'[i]' if w.indexed else ''}`", _value(w), unit_text(w), _default(w), limits_text(w), doc_text(w)]
            for w in words]
    return _table(["word", "value", "unit", "default", "limits", "meaning"], rows)


def _value(word: Word) -> str:
    form = form_text(word)
    return f"`{form}`" if form else word.type


def _default(word: Word) -> str:
    text = default_text(word)
    return f"`{text}`" if text else word.default_text


def _devices(kind: Kind) -> list[str]:
    if not kind.interfaces:
        return []
    lines = ["## Devices", ""]
    if not kind.simulated:
        names = ", ".join(f"[{s.name}](../interfaces/{s.code:03d}_{s.name}.md)" for s in kind.interfaces)
        return [*lines, f"Player's interface for it: {names}.", ""]
    lines += ["`playhouse run` gives every model its devices; a configuration file chooses its own.", ""]
    rows = [[f"[{s.name}](../interfaces/{s.code:03d}_{s.name}.md)", INDICES[s.index], _needs(s)] for s in kind.interfaces]
    return [*lines, *_table(["interface", "index", "needs"], rows)]


def _needs(served: Served) -> str:
    if served.when:
        return NEEDS[served.when]
    return f"{NEEDS[served.listed_when]}; by a configuration file none" if served.listed_when else ""


def _idle(kind: Kind) -> list[str]:
    """Words that do nothing."""
    lines = []
    later = [w for w in kind.words if w.use == "later"]
    if later:
        lines += ["## Not simulated yet", "", "These have no effect, with one warning each.", "", *_words(later)]
    if kind.silent:
        lines += ["## Without effect", "", "Stage 4 knows these, for its window or its scheduling; here they change nothing:",
                  ", ".join(f"`{name}`" for name in kind.silent) + ".", ""]
    if kind.old:
        rows = [[f"`{old.name}`", "no" if old.how == "none" else "yes", old.instead] for old in kind.old]
        lines += ["## Words of older versions", "", "Those that are read mean what is in their place; there is one warning for each ([worldfile.md](../worldfile.md)).", "",
                  *_table(["word", "read", "in its place"], rows)]
    return lines


def _state(kind: Kind) -> list[str]:
    lines = []
    if kind.state.columns:
        rows = [[f"`{c.name}`", _type(c), c.unit, f"`{c.frame}`" if c.frame else "", c.role, c.writer, f"`{c.word}`" if c.word else "", c.doc]
                for c in kind.state.columns]
        lines += ["## State", "", f"The table `{kind.table}` of the world, for those who work on the program.", "",
                  *_table(["column", "type", "unit", "frame", "role", "written by", "word", ""], rows)]
    for record in kind.state.records:
        rows = [[f"`{f.name}`", f.type, f.unit, f.doc] for f in record.fields]
        lines += [f"### {record.name}", "", record.doc, "", *_table(["field", "type", "unit", ""], rows)]
    if kind.state.viewer:
        rows = [[f"`{s.field}`", f"`{s.source}`", s.unit or s.quantum, CODES[s.code], TIMES[s.when]] for s in kind.state.viewer]
        lines += ["## What a page gets", "", *_table(["field", "from", "unit or quantum", "as", "when"], rows)]
    return lines


def _type(column) -> str:
    return column.type + (" list" if column.list else "") + (f", one per {column.per}" if column.per else "")
