"""C++ for the entities of world files: playhouse/scene/generated/.

kind_forms.h has properties of kinds as enumerations; kind_descs.h has the descriptions, one struct per kind with members; read_kinds.h/.cc read them from properties and report
errors; write_kinds.h/.cc write them in world-file syntax; kind_tables.cc has the data of playhouse/scene/kinds.h: types, words,
interfaces.
"""

from __future__ import annotations

import textwrap

from codegen.emit_kinds_text import default_text, doc_text, form_text, limits_text, unit_text
from codegen.kind_old import OldType, OldWord
from codegen.kind_words import RATES, Word
from codegen.kinds import BASE, ENTITIES, INDICES, NEEDS, Kind, Kinds, Served

FOLDER = "playhouse/scene/generated"
WIDTH = 110
BANNER = "// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.\n"

TYPES = {
    "flag": "bool", "integer": "int", "count": "std::uint32_t", "number": "double", "length": "double",
    "angle": "double", "text": "std::string", "texts": "std::vector<std::string>", "pose": "geom::Pose",
    "size": "geom::Size", "point": "geom::Vec2", "twist": "geom::Twist", "color": "Color", "colors": "std::vector<Color>",
}
# Properties::NAME(word, what the member has) for these.
READERS = {"flag": "flag", "integer": "integer", "number": "number", "length": "length", "angle": "angle", "text": "text",
           "size": "size"}


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {
        f"{FOLDER}/kind_forms.h": _forms(),
        f"{FOLDER}/kind_descs.h": _descs(kinds),
        f"{FOLDER}/read_kinds.h": _readers_header(kinds),
        f"{FOLDER}/read_kinds.cc": _readers(kinds),
        f"{FOLDER}/write_kinds.h": _writers_header(kinds),
        f"{FOLDER}/write_kinds.cc": _writers(kinds),
        f"{FOLDER}/kind_tables.cc": _tables(kinds),
    }


def described(kinds: Kinds) -> list[Kind]:
    """Kinds with a description."""
    return [k for k in kinds.all if k.members]


def enumerator(name: str) -> str:
    return "k" + "".join(part.title() for part in name.split("_"))


def _comment(text: str, indent: str = "") -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent=f"{indent}/// ", subsequent_indent=f"{indent}/// ")


def _text(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


# --- what tables of kinds tell -------------------------------------------------------------------------------------


FORMS = [
    ("EntityForm", "Place of an entity in a file.", ENTITIES),
    ("Index", "Numbering of the devices of an interface in the automatic map.", INDICES),
    ("Need", "What a model must have for an interface.", NEEDS),
]


def _forms() -> str:
    lines = [BANNER + "#pragma once", "", "/// Properties of kinds, with the names of kinds/*.toml.", "",
             "#include <cstddef>", "#include <cstdint>", "#include <string_view>", "", "namespace playhouse::scene {"]
    for enum, doc, values in FORMS:
        lines += ["", f"/// {doc}", f"enum class {enum} : std::uint8_t {{"]
        for name, meaning in values.items():
            lines += [*_comment(meaning, "  "), f"  {_form(name)},"]
        names = ", ".join(_text(name) for name in values)
        lines += ["};", f"constexpr std::string_view name_of({enum} value) {{",
                  f"  constexpr std::string_view kNames[] = {{{names}}};",
                  "  return kNames[static_cast<std::size_t>(value)];", "}"]
    return "\n".join([*lines, "", "}  // namespace playhouse::scene", ""])


def _form(name: str) -> str:
    return enumerator((name or "nothing").replace(" ", "_"))


# --- descriptions --------------------------------------------------------------------------------------------------


def _descs(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", ""]
    lines += _comment("Descriptions of each kind in world files, in SI units and radians; members have the default values "
                      "of files. Frames: W world, P parent, M model, B its body, S sensor, O odometry.")
    lines += ["", "#include <cstdint>", "#include <optional>", "#include <string>", "#include <vector>", "",
              '#include "playhouse/geom/pose.h"', '#include "playhouse/scene/text/values.h"', "", "namespace playhouse::scene {", ""]
    lines += _comment("The simulated kinds of models; models of any other type are kPlain.")
    lines += ["enum class ModelKind : std::uint8_t {"]
    lines += [f"  {enumerator(k.kind)} = {k.number}," for k in kinds.simulated()]
    lines += ["};", ""]
    for kind in described(kinds):
        for word in kind.members:
            for choice in [word, *word.choices]:
                lines += _enum(choice)
        lines += _struct(kind)
    lines += _comment("Descriptions of models in addition to PlainDesc: only that of the model's kind is set.")
    lines += ["struct KindDescs {"]
    for kind in kinds.simulated():
        if kind.members and kind.name != BASE:
            lines.append(f"  std::optional<{kind.desc}> {kind.name};  // {enumerator(kind.kind)}")
        lines += [f"  std::vector<{part.desc}> {part.table};  // {enumerator(kind.kind)}" for part in kinds.parts_of(kind)
                  if part.members]
    lines += ["", "  friend bool operator==(const KindDescs&, const KindDescs&) = default;", "};", ""]
    for trait in kinds.traits():
        lines += [*_comment(f"Whether a model has a {trait.name}: {trait.doc[0].lower()}{trait.doc[1:]}"),
                  f"inline bool has_{trait.name}(const {kinds.find(BASE).desc}& model) {{",
                  "  return " + " || ".join(f"model.{m}" for m in _givers(kinds, trait)) + ";", "}", ""]
    lines += ["}  // namespace playhouse::scene", ""]
    return "\n".join(lines)


def _givers(kinds: Kinds, trait: Kind) -> list[str]:
    return [next(w.member for w in kinds.find(BASE).words if w.name == name) for name in trait.given_by]


def _enum(word: Word) -> list[str]:
    if not word.enum:
        return []
    names = ", ".join(enumerator(v.name) for v in word.values)
    return [*_comment(word.doc), f"enum class {word.enum} : std::uint8_t {{ {names} }};", ""]


def _struct(kind: Kind) -> list[str]:
    lines = [*_comment(kind.doc), f"struct {kind.desc} {{"]
    for word in kind.members:
        lines += _members(word)
    lines += ["", f"  friend bool operator==(const {kind.desc}&, const {kind.desc}&) = default;", "};", ""]
    return lines


def _members(word: Word) -> list[str]:
    about = _comment(_about(word), "  ")
    if word.type == "tuple":
        values = word.default or [0] * len(word.parts)
        rows = [f"  double {part.member} = {_number(value, part.scale, part.unit)};" for part, value in zip(word.parts, values)]
        return [*about, *rows]
    if word.type == "bounds":
        pairs = [f"{{{_number(a, s, '')}, {_number(b, s, '')}}}" for a, b, s in
                 zip(word.default[::2], word.default[1::2], word.scales[::2])]
        return [*about, f"  Interval {word.member}[4] = {{{', '.join(pairs)}}};"]
    if word.type == "choices":
        return [line for choice in word.choices for line in _members(choice)]
    type_name = word.enum if word.type == "choice" else TYPES[word.type]
    if word.indexed:
        return [*about, f"  std::vector<{type_name}> {word.member};"]
    if word.optional:
        return [*about, f"  std::optional<{type_name}> {word.member};"]
    return [*about, f"  {type_name} {word.member}{_initial(word)};"]


def _about(word: Word) -> str:
    unit = unit_text(word, inside=True)
    quantity = ", ".join(x for x in (f"frame {word.frame}" if word.frame else "", unit) if x)
    default = f" Else {word.default_text}." if word.default_text else ""
    return f"{word.doc}{default}" + (f" [{quantity}]" if quantity else "")


def _initial(word: Word) -> str:
    value = word.default
    if word.type == "choice":
        return f" = {word.enum}::{enumerator(next(v.name for v in word.values if v.word == value))}"
    if word.type == "text":
        return f" = {_text(value)}" if value else ""
    if word.type == "flag":
        return f" = {'true' if value else 'false'}"
    if value is None:
        return ""
    if word.type == "color":
        return "{" + ", ".join(_float(v) for v in value) + "}"
    if isinstance(value, list):
        return "{" + ", ".join(_number(v, s, "") for v, s in zip(value, word.scales)) + "}" if any(value) else ""
    return f" = {_number(value, word.scales, word.unit)}"


def _number(value: float, scale: str, unit: str) -> str:
    """Converts a number of a file to the unit of its member."""
    if scale == "A" or unit == "deg":
        return f"geom::radians({value!r})" if value else "0"
    return f"{value / 1000!r}" if unit == "ms" else f"{value!r}"


def _float(value: float) -> str:
    return f"{value!r}f" if isinstance(value, float) and value != int(value) else str(int(value))


# --- reading -------------------------------------------------------------------------------------------------------


def _readers_header(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", ""]
    lines += _comment("Reads the words of an entity into its description, which has what counts where a word is not there. "
                      "Faults are kept in the state of the load. `row` is the model's: it decides what color \"random\" is.")
    lines += ["", "#include <cstddef>", "", '#include "playhouse/scene/generated/kind_descs.h"',
              '#include "playhouse/scene/properties.h"', "", "namespace playhouse::scene {", ""]
    lines += [f"{_signature(k)};" for k in described(kinds) if not _through_kind(k)]
    lines += ["", *_comment("Reads what models of a kind say beyond PlainDesc.")]
    lines += ["void read_kind(const Properties& properties, ModelKind kind, KindDescs& to);", "",
              "/// False for a model without the description of its kind: impossible from files, possible from code.",
              "bool is_described(ModelKind kind, const KindDescs& by);", "", "}  // namespace playhouse::scene", ""]
    return "\n".join(lines)


def _through_kind(kind: Kind) -> bool:
    """Whether read_kind() reads it."""
    return kind.entity == "model" and kind.name != BASE


def _has_color(kind: Kind) -> bool:
    return any(w.type == "color" for w in kind.members)


def _signature(kind: Kind) -> str:
    row = ", std::size_t row" if _has_color(kind) else ""
    return f"void read(const Properties& properties{row}, {kind.desc}& to)"


def _readers(kinds: Kinds) -> str:
    inner = [k for k in described(kinds) if _through_kind(k)]
    lines = [BANNER.rstrip(), f'#include "{FOLDER}/read_kinds.h"', "", '#include "playhouse/base/limits.h"',
             '#include "playhouse/scene/text/read_word.h"', "", "namespace playhouse::scene {", "namespace {", ""]
    for kind in inner:
        lines += [*_reader(kind), ""]
    lines += ["}  // namespace", ""]
    for kind in described(kinds):
        if not _through_kind(kind):
            lines += [*_reader(kind), ""]
    lines += ["void read_kind(const Properties& properties, ModelKind kind, KindDescs& to) {", "  switch (kind) {"]
    for kind in inner:
        lines += [f"    case ModelKind::{enumerator(kind.kind)}:", f"      read(properties, to.{kind.name}.emplace());",
                  "      break;"]
    for kind in kinds.simulated():
        if kind not in inner:
            lines.append(f"    case ModelKind::{enumerator(kind.kind)}:")
    lines += ["      break;", "  }", "}", "", "bool is_described(ModelKind kind, const KindDescs& by) {", "  switch (kind) {"]
    for kind in inner:
        lines += [f"    case ModelKind::{enumerator(kind.kind)}:", f"      return by.{kind.name}.has_value();"]
    lines += ["    default:", "      return true;", "  }", "}", "", "}  // namespace playhouse::scene", ""]
    return "\n".join(lines)


def _reader(kind: Kind) -> list[str]:
    lines = [f"{_signature(kind)} {{"]
    for word in kind.members:
        key, to = _text(word.name), f"to.{word.member}"
        read = _read_each(kind, word) if word.indexed else [*_read(word, key, to), *_check(word, key, to)]
        lines += [f"  {line}" for line in read]
    return [*lines, "}"]


def _read_each(kind: Kind, word: Word) -> list[str]:
    count = next(w for w in kind.members if w.name == word.counted_by)
    type_name = TYPES[word.type]
    return [f"{type_name} {word.name}{_initial(word)};",
            f"to.{word.member} = read_each(properties, {_text(word.name)}, {_text(count.name)}, to.{count.member}, {word.name}, "
            f"[&](std::string_view key, {type_name}& each) {{",
            *(f"  {line}" for line in [*_read(word, "key", "each"), *_check(word, "key", "each")]), "});"]


def _read(word: Word, key: str, to: str) -> list[str]:
    """Reads the value of `key` into `to`, which holds the default."""
    if word.type == "number" and word.unit == "ms":
        return [f"{to} = read_milliseconds(properties, {key}, {to});"]
    if word.type in READERS and word.optional:
        return [f"if (properties.has({key})) {to} = properties.{READERS[word.type]}({key}, {{}});"]
    if word.type in READERS:
        return [f"{to} = properties.{READERS[word.type]}({key}, {to});"]
    if word.type == "texts":
        return [f"{to} = read_texts(properties, {key});"]
    if word.type == "colors":
        return [f"{to} = read_colors(properties, {key});"]
    if word.type == "color":
        return [f"{to} = properties.color({to}, row);"]
    if word.type == "pose":
        return [f"{to} = properties.pose({key}){'' if word.optional else f'.value_or({to})'};"]
    if word.type == "point":
        return [f"{to} = read_point(properties, {key}, {to});"]
    if word.type == "count":
        most = f"limits::{word.limit}" if word.limit else f"{word.max or 1000000000}"
        check = [f"static_assert(limits::{word.limit} == {word.max});"] if word.limit else []
        return [*check, f"{to} = read_count(properties, {key}, {to}, {word.min}, {most});"]
    if word.type == "choice":
        return [_words_of(word),
                f"{to} = static_cast<{word.enum}>(read_choice(properties, {key}, {_choices(word)}, static_cast<std::size_t>({to})));"]
    if word.type == "choices":
        return _read_choices(word)
    if word.type == "twist":
        form = f"[{word.form}] {RATES[word.unit]}".strip()
        read = f"read_twist(properties, {key}, {_text(word.scales)}, {_text(form)}"
        return [f"if (properties.has({key})) {to} = {read});"]
    if word.type == "bounds":
        return [f"read_bounds(properties, {key}, {_text(word.scales)}, {to});"]
    return _read_tuple(word)


def _choices(word: Word) -> str:
    return "kWordsOf" + enumerator(word.name)[1:]


def _words_of(choice: Word) -> str:
    words = ", ".join(_text(v.word) for v in choice.values)
    return f"static constexpr std::string_view {_choices(choice)}[] = {{{words}}};"


def _read_choices(word: Word) -> list[str]:
    lines = [_words_of(choice) for choice in word.choices]
    held = ", ".join(f"{{{_text(c.name)}, {_choices(c)}, static_cast<std::size_t>(to.{c.member})}}" for c in word.choices)
    lines += [f"Choice {word.name}[{len(word.choices)}] = {{{held}}};",
              f"read_choices(properties, {_text(word.name)}, {word.name}, {_text(f'[{word.form}]')});"]
    return lines + [f"to.{c.member} = static_cast<{c.enum}>({word.name}[{i}].value);" for i, c in enumerate(word.choices)]


def _read_tuple(word: Word) -> list[str]:
    held = [f"geom::degrees(to.{p.member})" if p.unit == "deg" and p.scale == "N" else f"to.{p.member}" for p in word.parts]
    lines = [f"double {word.name}[{len(word.parts)}] = {{{', '.join(held)}}};",
             f"properties.tuple({_text(word.name)}, {_text(word.scales)}, {word.name}, {_text(f'[{word.form}]')});"]
    if word.ascending_from is not None:
        chain = [f"{word.ascending_from}", *(f"{word.name}[{i}]" for i in range(len(word.parts)))]
        good = " && ".join(f"{a} <= {b}" for a, b in zip(chain, chain[1:]))
        lines.append(f"require({good}, properties, {_text(word.name)}, {_text('needs ' + limits_text(word))});")
    if word.max is not None:
        bounds = [[f"geom::radians({v})" if p.scale == "A" else f"{v}" for v in (word.min, word.max)] for p in word.parts]
        good = " && ".join(f"{word.name}[{i}] >= {least} && {word.name}[{i}] <= {most}" for i, (least, most) in enumerate(bounds))
        lines.append(f"require({good}, properties, {_text(word.name)}, {_text('needs numbers ' + limits_text(word))});")
    for i, part in enumerate(word.parts):
        value = f"{word.name}[{i}]"
        value = f"geom::radians({value})" if part.unit == "deg" and part.scale == "N" else value
        lines.append(f"to.{part.member} = {value};")
    return lines


def _check(word: Word, key: str, to: str) -> list[str]:
    """Checks not made by read_count() and tuples."""
    if word.check:
        return [f"{word.check}(properties, {key}, {to});"]
    if word.type in ("count", "tuple") or (word.min is None and word.above is None):
        return []
    if word.optional:
        to += f".value_or({1 if word.above is not None else 0})"  # unsaid is within the limits
    if word.clamp:
        return [f"{to} = at_least_zero(properties, {key}, {to}, {_text(word.clamp)});"]
    if word.above is not None:
        unit = f" {word.unit}" if word.type == "number" and word.unit != "1" else ""
        return [f"require({to} > 0, properties, {key}, {_text('must be above 0' + unit)});"]
    if word.max is not None:
        most = f"geom::radians({word.max})" if word.type == "angle" else f"{word.max}"
        return [f"require({to} >= 0 && {to} <= {most}, properties, {key}, {_text('must be ' + limits_text(word))});"]
    return [f"require({to} >= 0, properties, {key}, \"must not be negative\");"]


# --- writing -------------------------------------------------------------------------------------------------------


def _writers_header(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", ""]
    lines += _comment("Writes the words in which a description differs from `unsaid`, that of an entity that says nothing, so that "
                      "read() of read_kinds.h gives it back.")
    lines += ["", '#include "playhouse/scene/generated/kind_descs.h"', '#include "playhouse/scene/text/write_word.h"', "",
              "namespace playhouse::scene {", ""]
    for kind in described(kinds):
        if kind.name == BASE:
            lines += [*_comment("`z` is the height, in the frame of the pose, from which the file counts: that of a parent on which "
                                "the model stands. [m]"), f"{_write_signature(kind)};"]
        elif not _through_kind(kind) and kind.entity != "part":
            lines.append(f"{_write_signature(kind)};")
    lines += ["", *_comment("Writes what models say beyond PlainDesc, and the entities that are parts of them.")]
    lines += ["void write_kind(const KindDescs& from, const config::Units& units, Entity& to);", "", "}  // namespace playhouse::scene", ""]
    return "\n".join(lines)


def _write_signature(kind: Kind) -> str:
    height = ", double z" if kind.name == BASE else ""
    return f"void write(const {kind.desc}& from, const {kind.desc}& unsaid{height}, Words& to)"


def _writers(kinds: Kinds) -> str:
    inner = [k for k in described(kinds) if _through_kind(k) or k.entity == "part"]
    lines = [BANNER.rstrip(), f'#include "{FOLDER}/write_kinds.h"', "", "#include <algorithm>", "#include <array>", "#include <string>", "",
             "namespace playhouse::scene {", "namespace {", ""]
    for kind in inner:
        lines += [*_writer(kind), ""]
    lines += ["}  // namespace", ""]
    for kind in described(kinds):
        if kind not in inner:
            lines += [*_writer(kind), ""]
    lines += ["void write_kind(const KindDescs& from, const config::Units& units, Entity& to) {", "  Words words(units, to.words);"]
    for kind in inner:
        if kind.entity != "part":
            lines.append(f"  if (from.{kind.name}) write(*from.{kind.name}, {{}}, words);")
    for kind in inner:
        if kind.entity == "part":
            lines += [f"  for (const {kind.desc}& part : from.{kind.table}) {{",
                      f"    Words words_of_part(units, to.parts.emplace_back(Entity{{{_text(kind.name)}, {{}}, {{}}}}).words);",
                      "    write(part, {}, words_of_part);", "  }"]
    lines += ["}", "", "}  // namespace playhouse::scene", ""]
    return "\n".join(lines)


def _writer(kind: Kind) -> list[str]:
    lines = [f"{_write_signature(kind)} {{"]
    for word in kind.members:
        lines += [f"  {line}" for line in _write(word)]
    return [*lines, "}"]


def _write(word: Word) -> list[str]:
    """Writes the value of `from`, unless it is the default."""
    key, has = _text(word.name), f"from.{word.member}"
    if word.counted_by:
        numbered = f'{_text(word.name + "[")} + std::to_string(i) + "]"'
        return [f"for (std::size_t i = 0; i < {has}.size(); ++i) to.{_write_call(word, numbered, f'{has}[i]')};"]
    if word.type == "tuple":
        members = [part.member for part in word.parts]
        scales = "".join("D" if p.unit == "deg" and p.scale == "N" else p.scale for p in word.parts)
        return [f"const double {word.name}[] = {{{', '.join(f'from.{m}' for m in members)}}};",
                f"if ({differs(word)}) to.tuple({key}, {_text(scales)}, {word.name});"]
    if word.type == "bounds":
        return [f"if ({differs(word)}) to.bounds({key}, {_text(word.scales)}, {has});"]
    value = f"*{has}" if word.optional else has
    if word.type == "choice":
        return [_words_of(word), f"if ({differs(word)}) to.text({key}, {_choices(word)}[static_cast<std::size_t>({value})]);"]
    if word.type == "choices":
        chosen = ", ".join(f"std::string({_choices(c)}[static_cast<std::size_t>(from.{c.member})])" for c in word.choices)
        return [*map(_words_of, word.choices), f"if ({differs(word)}) to.texts({key}, std::array{{{chosen}}});"]
    return [f"if ({differs(word)}) to.{_write_call(word, key, value)};"]


def differs(word: Word) -> str:
    """The condition that `from` has another value than `unsaid`."""
    if word.type == "bounds":
        return f"!std::ranges::equal(from.{word.member}, unsaid.{word.member})"
    if word.optional:
        return f"from.{word.member}"
    return " || ".join(f"from.{m} != unsaid.{m}" for m in word.members())


def _write_call(word: Word, key: str, value: str) -> str:
    if word.type == "color":
        return f"color({value})"
    if word.type == "twist":
        return f"twist({key}, {_text(word.scales)}, {value})"
    if word.type == "pose" and word.frame == "X_PM":
        return f"pose({key}, {value}, z)"
    name = "integer" if word.type == "count" else "milliseconds" if word.unit == "ms" else word.type
    return f"{name}({key}, {value})"


# --- tables --------------------------------------------------------------------------------------------------------


def _tables(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), '#include "playhouse/scene/kinds.h"', "", "namespace playhouse::scene {", "namespace {", ""]
    for kind in kinds.all:
        lines += _words(kind) + _interfaces(kind)
    lines += [f"constexpr Kind kKinds[{len(kinds.all)}] = {{"]
    for kind in kinds.all:
        lines += _row(kind)
    old = [each for kind in kinds.all for each in kind.old_types]
    lines += ["};", "", *(line for each in old for line in _said_words(each))]
    lines += [f"constexpr OldType kOldTypes[{len(old)}] = {{", *map(_old_type, old)]
    lines += ["};", "", "}  // namespace", "", "std::span<const Kind> kinds() { return kKinds; }", "",
              "std::span<const OldType> old_types() { return kOldTypes; }", "", "}  // namespace playhouse::scene", ""]
    return "\n".join(lines)



def _table(kind: Kind, what: str) -> str:
    return f"k{what}Of{enumerator(kind.name)[1:]}"


def _words(kind: Kind) -> list[str]:
    count = len(kind.words) + len(kind.silent) + len(kind.old)
    if count == 0:
        return []
    lines = [line for old in kind.old for line in _meaning(kind, old)]
    lines.append(f"constexpr Word {_table(kind, 'Words')}[{count}] = {{")
    for word in kind.words:
        use = "kSilent" if not kind.simulated else enumerator(word.use)
        fields = [("type", word.type), ("form", form_text(word)), ("unit", unit_text(word)), ("otherwise", default_text(word)),
                  ("told", word.default_text), ("limits", limits_text(word)), ("counted_by", word.counted_by), ("doc", doc_text(word))]
        told = "".join(f", .{name} = {_text(text)}" for name, text in fields if text)
        lines.append(f"    {{.name = {_text(word.name)}, .use = Support::{use}{told}}},")
    lines += [f"    {{.name = {_text(name)}, .use = Support::kSilent}}," for name in kind.silent]
    for old in kind.old:
        told = f", .instead = {_text(old.instead)}" if old.instead else ""
        means = f", .meaning = &{_meaning_name(kind, old)}" if old.how not in ("none", "by hand") else ""
        lines.append(f"    {{.name = {_text(old.name)}, .use = Support::kOld{told}{means}}},")
    return [*lines, "};", ""]


def _meaning_name(kind: Kind, old: OldWord) -> str:
    return f"kOld_{kind.name}_{old.name}"


def _meaning(kind: Kind, old: OldWord) -> list[str]:
    if old.how in ("none", "by hand"):
        return []
    name, lines, fields = _meaning_name(kind, old), [], [f".how = Meaning::How::{enumerator(old.how)}"]
    if old.part:
        fields.append(f".part = {_text(old.part)}")
    if old.to:
        lines.append(f"constexpr std::string_view {name}_to[] = {{{', '.join(map(_text, old.to))}}};")
        fields.append(f".to = {name}_to")
    if old.values:
        lines.append(f"constexpr SaidWord {name}_values[] = {{{_said(old.values)}}};")
        fields.append(f".values = {name}_values")
    if old.part_words:
        lines.append(f"constexpr SaidWord {name}_part_words[] = {{{_said(old.part_words)}}};")
        fields.append(f".part_words = {name}_part_words")
    return [*lines, f"constexpr Meaning {name}{{{', '.join(fields)}}};"]


def _said(words: dict[str, str]) -> str:
    return ", ".join(f"{{{_text(word)}, {_text(value)}}}" for word, value in words.items())


def _said_words(old: OldType) -> list[str]:
    return [f"constexpr SaidWord kOldType_{old.name}_{what}[] = {{{_said(words)}}};"
            for what, words in (("words", old.words), ("part_words", old.part_words)) if words]


def _old_type(old: OldType) -> str:
    fields = [f".name = {_text(old.name)}", f".instead = {_text(old.instead)}"]
    if old.type is not None:
        fields += [".is_read = true"] + [f".{key} = {_text(value)}" for key, value in (("type", old.type), ("part", old.part)) if value]
    fields += [f".{what} = kOldType_{old.name}_{what}" for what, words in (("words", old.words), ("part_words", old.part_words)) if words]
    return f"    {{{', '.join(fields)}}},"


def _interface(served: Served) -> str:
    listed = served.listed_when or served.when
    return (f'    {{"{served.name}", {served.code}, Index::{_form(served.index)}, Need::{_form(served.when)}, '
            f"Need::{_form(listed)}, {'true' if served.shared else 'false'}}},")


def _interfaces(kind: Kind) -> list[str]:
    if not kind.interfaces:
        return []
    return [f"constexpr KindInterface {_table(kind, 'Interfaces')}[{len(kind.interfaces)}] = {{",
            *map(_interface, kind.interfaces), "};", ""]


def _row(kind: Kind) -> list[str]:
    fields = [f".name = {_text(kind.name)}", f".doc = {_text(kind.doc)}", f".entity = EntityForm::{_form(kind.entity)}"]
    if kind.inside:
        fields.append(f".inside = {_text(kind.inside)}")
    if kind.table:
        fields.append(f".table = {_text(kind.table)}")
    if kind.number is not None:
        fields.append(f".kind = ModelKind::{enumerator(kind.kind)}")
    fields.append(f".simulated = {'true' if kind.simulated else 'false'}")
    if kind.body:
        size, color = ", ".join(f"{v!r}" for v in kind.body.size), ", ".join(_float(v) for v in kind.body.color)
        fields += [f".solid = {'true' if kind.body.solid else 'false'}", f".size = {{{size}}}", f".color = {{{color}}}"]
    if kind.words or kind.silent or kind.old:
        fields.append(f".words = {_table(kind, 'Words')}")
    if kind.interfaces:
        fields.append(f".interfaces = {_table(kind, 'Interfaces')}")
    if kind.entity == "trait":
        fields.append(f".has = has_{kind.name}")
    return [f"    {{{', '.join(fields)}}},"]
