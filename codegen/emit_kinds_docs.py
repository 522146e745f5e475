"""Reference pages: docs/kinds/, one page per kind and an index."""

from __future__ import annotations

from codegen.emit_kinds_text import default_text, doc_text, form_text, limits_text, unit_text
from codegen.kind_old import OldType
from codegen.kind_words import Word
from codegen.kinds import BASE, INDICES, NEEDS, Kind, Kinds, Served

FOLDER = "docs/kinds"
VALUES = {
    "flag": "0 or 1", "integer": "an integer; fractions are truncated", "count": "a non-negative integer",
    "number": "a number, in the stated unit, independent of the file's units", "length": "a number, in the file's unit of length",
    "angle": "a number, in the file's unit of angle", "text": "in quotes", "texts": "one quoted text, or several in brackets",
    "choices": "quoted words in brackets, one of each list",
    "color": "a quoted name", "colors": "one quoted color name, or several in brackets",
}
TIMES = {"start": "with the scene", "changed": "on change", "selected": "while the robot is selected",
         "shown": "while the robot is selected or its sensors are shown"}
CODES = {"json": "JSON", "difference": "difference, zigzag varint", "turn": "16 bits of a turn", "bit": "a state bit",
         "rgba": "32 bits", "fraction": "16 bits", "varint": "varint", "zigzag": "zigzag varint", "text": "UTF-8"}


def emit(kinds: Kinds) -> dict[str, str]:
    files = {f"{FOLDER}/{kind.name}.md": _page(kinds, kind) for kind in kinds.all}
    files[f"{FOLDER}/README.md"] = _index(kinds)
    return files


def _banner(source: str) -> str:
    return f"<!-- Generated from {source} by codegen (python3 -m codegen). Do not edit. -->"


def _table(heads: list[str], rows: list[list[str]]) -> list[str]:
    """Omits columns that are empty in every row."""
    kept = [i for i in range(len(heads)) if any(row[i] for row in rows)]
    lines = ["| " + " | ".join(heads[i] for i in kept) + " |", "|" + "---|" * len(kept)]
    return [*lines, *("| " + " | ".join(row[i].replace("|", "\\|") for i in kept) + " |" for row in rows), ""]


def _now(old: OldType) -> str:
    return "an error" if old.type is None else f"`{old.type}`" if old.type else "nothing"


def _index(kinds: Kinds) -> str:
    lines = [_banner("kinds/"), "# Kinds of scene entities", "",
             "Each page lists the words of a kind with values, units and defaults. The syntax of world files is described in",
             "[worldfile.md](../worldfile.md); `playhouse kinds NAME` prints the same.", "",
             "Units are the defaults; `unit_length` and `unit_angle` of a file change those of lengths and angles.", ""]
    lines += ["## Models", "", *_rows(kinds.simulated())]
    if plain := [k for k in kinds.models() if not k.simulated]:
        lines += ["Other types of Stage 4 load as plain bodies, with one warning each:", "", *_rows(plain)]
    lines += ["## Other entities", "", *_rows([k for k in kinds.all if k.entity != "model"])]
    lines += ["## Values", "", *_table(["value", "in a file"], [[name, text] for name, text in VALUES.items()])]
    old = sorted((each for kind in kinds.all for each in kind.old_types), key=lambda each: each.name)
    lines += ["## Types of older versions", "",
              "Most are converted ([worldfile.md](../worldfile.md)); the others are errors whose message names the replacement.", "",
              *_table(["type", "converted to", "replacement"], [[f"`{each.name}`", _now(each), each.instead] for each in old])]
    return "\n".join(lines).rstrip() + "\n"


def _rows(kinds: list[Kind]) -> list[str]:
    return _table(["name", "description", "interfaces"],
                  [[f"[{k.name}]({k.name}.md)", k.doc, ", ".join(f"`{s.name}`" for s in k.interfaces)] for k in kinds])


def _page(kinds: Kinds, kind: Kind) -> str:
    lines = [_banner(kind.source), f"# {kind.name}", "", kind.doc, "", *_place(kinds, kind)]
    read = [w for w in kind.words if w.use == "read"]
    if read:
        lines += ["## Words", "", *_words(read)]
    if kind.entity == "model" and kind.name != BASE:
        lines += [f"It also has the [words and devices of every model]({BASE}.md).", ""]
    for part in kinds.parts_of(kind):
        lines += [f"Its part `{part.name}( ... )` has [its own page]({part.name}.md).", ""]
    lines += _devices(kind) + _idle(kind) + _state(kind)
    return "\n".join(lines).rstrip() + "\n"


def _place(kinds: Kinds, kind: Kind) -> list[str]:
    if kind.entity == "part":
        return [f"`{kind.name}( ... )` is written inside a [{kind.inside}]({kind.inside}.md)"
                f"{' of any kind' if kind.inside == BASE else ''}.", ""]
    if kind.entity == "trait":
        words = ", ".join(f"`{name}`" for name in kind.given_by)
        return [f"A [model]({BASE}.md) of any kind has one if it has one of the words {words}.", ""]
    if kind.entity == "window":
        return [f"`{kind.name}( ... )` is written at the top level.", ""]
    if kind.body is None:
        return []
    size = " ".join(f"{v:g}" for v in kind.body.size)
    color = " ".join(f"{v:g}" for v in kind.body.color)
    form = kind.body.form or "a box of its size"
    others = "blocks or a bitmap" if kind.body.form else "blocks, a bitmap or a mesh"
    body = f"{form}, unless {others} replace it" if kind.body.solid else f"none, unless {others} define one"
    lines = [f"`{kind.name}( ... )` is written at the top level or inside another model. Defaults: size [{size}] m, "
             f"color [{color}]; body: {body}.", ""]
    draws = [("", kind)] + [(f" for each `{p.name}`", p) for p in kinds.parts_of(kind) if kind.name != BASE]
    told = [f"{each.watts:g} W{of}" for of, each in draws if each.watts is not None]
    if told:
        lines += [f"While it is subscribed it draws {' and '.join(told)} from its battery, independent of `watts`.", ""]
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
        return [*lines, f"Player interfaces: {names}.", ""]
    lines += ["`playhouse run` creates the devices of every model; a configuration file selects its own.", ""]
    rows = [[f"[{s.name}](../interfaces/{s.code:03d}_{s.name}.md)", INDICES[s.index], _needs(s), _voltages(kind, s)] for s in kind.interfaces]
    return [*lines, *_table(["interface", "index", "needs", "voltages"], rows)]


def _voltages(kind: Kind, served: Served) -> str:
    units = {c.name: c.unit for c in kind.state.columns}
    return "; ".join(f"{v.volts:g} V per {units[v.column]} of `{v.column}`" for v in served.voltages)


def _needs(served: Served) -> str:
    if served.listed_when == "never":
        return "; ".join(NEEDS[need] for need in (served.when, "never") if need)
    if served.when:
        return NEEDS[served.when]
    return f"{NEEDS[served.listed_when]}; nothing in a configuration file" if served.listed_when else ""


def _idle(kind: Kind) -> list[str]:
    """Words without effect."""
    lines = []
    later = [w for w in kind.words if w.use == "later"]
    if later:
        lines += ["## Not simulated yet", "", "These have no effect, with one warning each.", "", *_words(later)]
    if kind.silent:
        lines += ["## Without effect", "", "Words of Stage 4 for its window or its scheduling, accepted and ignored:",
                  ", ".join(f"`{name}`" for name in kind.silent) + ".", ""]
    if kind.old:
        rows = [[f"`{old.name}`", "no" if old.how == "none" else "yes", old.instead] for old in kind.old]
        lines += ["## Words of older versions", "", "Supported ones are converted to their replacement, with one warning each ([worldfile.md](../worldfile.md)).", "",
                  *_table(["word", "supported", "replacement"], rows)]
    return lines


def _state(kind: Kind) -> list[str]:
    lines = []
    if kind.state.columns:
        rows = [[f"`{c.name}`", _type(c), c.unit, f"`{c.frame}`" if c.frame else "", c.role, c.writer, f"`{c.word}`" if c.word else "", c.doc]
                for c in kind.state.columns]
        lines += ["## State", "", f"Table `{kind.table}` of the world, for developers.", "",
                  *_table(["column", "type", "unit", "frame", "role", "written by", "word", ""], rows)]
    for record in kind.state.records:
        rows = [[f"`{f.name}`", f.type, f.unit, f.doc] for f in record.fields]
        lines += [f"### {record.name}", "", record.doc, "", *_table(["field", "type", "unit", ""], rows)]
    if kind.state.viewer:
        rows = [[f"`{s.field}`", f"`{s.source}`", s.unit or s.quantum, CODES[s.code], TIMES[s.when]] for s in kind.state.viewer]
        lines += ["## Fields for the page", "", *_table(["field", "column", "unit or quantum", "encoding", "sent"], rows)]
    return lines


def _type(column) -> str:
    return column.type + (" list" if column.list else "") + (f", one per {column.per}" if column.per else "")
