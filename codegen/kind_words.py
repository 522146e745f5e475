"""The words of an entity of world files: `[[word]]` of kinds/*.toml."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from codegen.checks import SchemaError, documented, keys, one_of, typed, unique

STAGES = ("same", "better", "other", "none")  # comparison with Stage 4
ENGINES = ("arena",)
CHECKS = ("hexadecimal_bytes", "known_material", "not_misspelt_material")  # functions of playhouse/scene/text/read_word.h
USES = ("read", "later")  # words without an entry of their own are `silent` and `old`

# What a value is made of: (the parts of its form, the scale of each). L and A are converted from the file's units of
# length and angle, N is a plain number.
SHAPES = {
    "flag": ("", "N"), "integer": ("", "N"), "count": ("", "N"), "number": ("", "N"), "length": ("", "L"),
    "angle": ("", "A"), "text": ("", ""), "texts": ("", ""), "choice": ("", ""), "color": ("", ""), "colors": ("", ""),
    "pose": ("x y z heading", "LLLA"), "size": ("x y z", "LLL"), "point": ("x y", "NN"), "twist": ("x y z heading", "LLLA"),
    "bounds": ("xmin xmax ymin ymax zmin zmax amin amax", "LLLLLLAA"), "rgba": ("red green blue alpha", "NNNN"),
    "tuple": (None, None), "choices": (None, ""),
}
NUMBERS = {"integer", "count", "number", "length", "angle"}
PART_SCALES = {"number": "N", "length": "L", "angle": "A"}
COUNTED = {"integer", "number", "length", "angle", "pose", "size", "point"}  # element types of counted words

# What units of plain numbers in world files are made of: a quotient of these, of their powers and roots, as m/s^2/sqrt(Hz);
# or several, as m or rad.
UNITS = ("1", "m", "s", "ms", "deg", "rad", "kg", "px", "N", "W", "J", "kJ", "cd", "dB", "dBm", "Hz", "MHz", "bit", "V", "K", "degC")
FACTOR = re.compile(r"(sqrt\()?(?P<unit>[^()^]*)(?(1)\))(\^[2-9])?$")
# Of velocities and accelerations, and what stands behind "[x y z heading]" in an error. "1" is a fraction.
RATES = {"m/s": "per second", "m/s^2": "per second squared", "1": ""}
SCALED_UNITS = {"L": "m", "A": "deg"}

WORD = re.compile(r"[a-z][a-z0-9_]*$")
MEMBER = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")


@dataclass
class Part:
    """A number of a tuple."""

    name: str
    scale: str      # L, A or N
    unit: str       # default unit in the file
    member: str     # of the description


@dataclass
class Value:
    """A value of a choice."""

    word: str
    name: str       # of the enumerator, in lower case
    doc: str


@dataclass
class Word:
    name: str
    type: str
    doc: str
    use: str = "read"
    stage: str = "same"     # same as in Stage 4, better, other, or none: Stage has no such word
    stage_why: str = ""     # difference; "" if it is the same
    engine: str = ""        # the one in which alone it has its full effect; "" both
    check: str = ""         # function of read_word.h that checks the text
    unit: str = ""              # default unit in the file; one per part, or one for all
    default: object = None      # in the file; None: none, or in default_text
    default_text: str = ""
    min: float | None = None
    above: float | None = None
    max: float | None = None
    limit: str = ""             # the name of `max` in base/limits.h
    clamp: str = ""             # interpretation of a value below `min`: a warning instead of an error
    ascending_from: float | None = None
    by_hand: bool = False       # hand-written code reads it, and there is no member
    optional: bool = False      # the member is empty without the word
    indexed: bool = False       # word[0], word[1], ...
    counted_by: str = ""        # the word with the number of elements; without an index a value applies to all others
    member: str = ""
    frame: str = ""
    enum: str = ""
    with_word: str = ""         # read together with that word, into its member
    parts: list[Part] = field(default_factory=list)
    values: list[Value] = field(default_factory=list)
    choices: list[Word] = field(default_factory=list)  # the choices in brackets, each a word

    @property
    def has_member(self) -> bool:
        return self.use == "read" and not self.by_hand and not self.with_word

    @property
    def scales(self) -> str:
        """A letter for each number of the value."""
        if self.type == "tuple":
            return "".join(p.scale for p in self.parts)
        scales = SHAPES[self.type][1]
        return "N" * len(scales) if self.unit == "1" else scales

    @property
    def form(self) -> str:
        """Content of the brackets of a tuple, "" for single values."""
        if self.type in ("tuple", "choices"):
            return " ".join(p.name for p in self.parts or self.choices)
        return SHAPES[self.type][0]

    def members(self) -> list[str]:
        """Of the description."""
        return [p.member for p in self.parts or self.choices] or [self.member]

    def units(self) -> list[str]:
        """Default unit in the file of each number; empty without a quantity."""
        if self.type == "tuple":
            return [p.unit for p in self.parts]
        if self.type == "point":
            return ["m", "m"]
        if self.type in ("twist", "bounds") and self.unit != "1":
            return [SCALED_UNITS[scale] + self.unit[1:] for scale in self.scales]
        if self.unit:
            return [self.unit] * len(self.scales)
        return [SCALED_UNITS[scale] for scale in self.scales if scale in SCALED_UNITS]


def known_unit(where: str, what: str, text) -> None:
    """Refuses what is not made of UNITS."""
    for factor in re.split(r"/| or ", text) if text else [text]:
        found = FACTOR.match(factor or "")
        one_of(where, what, found["unit"] if found and factor else factor, UNITS)


OPTIONAL = {"use", "unit", "default", "default_text", "min", "above", "max", "limit", "clamp", "ascending_from", "by_hand",
            "optional", "indexed", "counted_by", "member", "frame", "enum", "with", "parts", "values", "choices", "stage", "stage_why", "engine", "check"}

KEY_TYPES = {key: str for key in ("name", "type", "doc", "use", "unit", "default_text", "limit", "clamp", "member", "frame",
                                  "enum", "with", "word", "counted_by", "stage", "stage_why", "engine", "check")}
KEY_TYPES |= {"by_hand": bool, "optional": bool, "indexed": bool, "parts": list, "values": list, "choices": list}
KEY_TYPES |= {"min": (int, float), "above": (int, float), "max": (int, float), "ascending_from": (int, float)}


def word(where: str, row: dict, simulated: bool) -> Word:
    """One `[[word]]`. For an entity that is not simulated it is not read, so its default may be unknown."""
    keys(where, row, {"name", "type", "doc"}, OPTIONAL)
    typed(where, row, KEY_TYPES)
    if not WORD.match(row["name"]):
        raise SchemaError(f"{where}: name is not a word in lower case")
    one_of(where, "type", row["type"], SHAPES)
    one_of(where, "use", row.get("use", "read"), USES)
    one_of(where, "stage", row.get("stage", "same"), STAGES)
    if (row.get("stage", "same") == "same") != ("stage_why" not in row):
        raise SchemaError(f"{where}: stage_why is for what is not the same as in Stage, and needed there")
    if "stage_why" in row:
        documented(where, row["stage_why"])
    if "engine" in row:
        one_of(where, "engine", row["engine"], ENGINES)
    documented(where, row["doc"])
    out = Word(row["name"], row["type"], row["doc"], with_word=row.get("with", ""))
    for key in OPTIONAL - {"with", "parts", "values", "choices"}:
        if key in row:
            setattr(out, key, row[key])
    out.member = row.get("member", out.name)
    if not MEMBER.match(out.member):
        raise SchemaError(f"{where}: member {out.member!r} is not a name")
    if out.check:
        _only_of(where, out, "check", {"text"})
        one_of(where, "check", out.check, CHECKS)
    _parts(where, out, row)
    _values(where, out, row)
    _choices(where, out, row)
    _indices(where, out, simulated)
    _unit(where, out, simulated)
    _limits(where, out)
    _default(where, out, simulated)
    return out


def _only_of(where: str, row: Word, key: str, types: set[str]) -> None:
    if row.type not in types:
        raise SchemaError(f"{where}: {key} is for {', '.join(sorted(types))}, not for a {row.type}")


def _parts(where: str, out: Word, row: dict) -> None:
    if (out.type == "tuple") != ("parts" in row):
        raise SchemaError(f"{where}: a tuple, and only a tuple, has parts")
    for entry in row.get("parts", []):
        inner = f"{where}: part {entry.get('name', '?')}"
        keys(inner, entry, {"name", "type"}, {"unit", "member"})
        typed(inner, entry, KEY_TYPES)
        one_of(inner, "type", entry["type"], PART_SCALES)
        if entry["type"] == "number":
            known_unit(inner, "unit", entry.get("unit"))
        elif "unit" in entry:
            raise SchemaError(f"{inner}: a {entry['type']} has the file's unit")
        scale = PART_SCALES[entry["type"]]
        out.parts.append(Part(entry["name"], scale, entry.get("unit") or SCALED_UNITS[scale], entry.get("member", entry["name"])))
    unique(where, "part", [p.name for p in out.parts])
    if out.ascending_from is not None:
        _only_of(where, out, "ascending_from", {"tuple"})


def _values(where: str, out: Word, row: dict) -> None:
    if (out.type == "choice") != ("values" in row):
        raise SchemaError(f"{where}: a choice, and only a choice, has values")
    for entry in row.get("values", []):
        keys(f"{where}: values", entry, {"word"}, {"name", "doc"})
        typed(f"{where}: values", entry, KEY_TYPES)
        out.values.append(Value(entry["word"], entry.get("name", entry["word"]), entry.get("doc", "")))
    unique(where, "value", [v.word for v in out.values])
    if out.enum:
        _only_of(where, out, "enum", {"choice"})


def _indices(where: str, out: Word, simulated: bool) -> None:
    if simulated and out.indexed and out.has_member and not out.counted_by:
        raise SchemaError(f"{where}: an indexed word is read by hand or counted: counted_by is missing")
    if not out.counted_by:
        return
    if not out.indexed or not out.has_member or out.optional or out.default is None:
        raise SchemaError(f"{where}: counted_by is for an indexed word with a member that is always there, and a default")
    _only_of(where, out, "counted_by", COUNTED)


def _choices(where: str, out: Word, row: dict) -> None:
    if (out.type == "choices") != ("choices" in row):
        raise SchemaError(f"{where}: choices, and only choices, have choices")
    for entry in row.get("choices", []):
        inner = f"{where}: choice {entry.get('name', '?')}"
        keys(inner, entry, {"name", "enum", "doc", "values"}, {"member"})
        typed(inner, entry, KEY_TYPES)
        documented(inner, entry["doc"])
        choice = Word(entry["name"], "choice", entry["doc"], member=entry.get("member", entry["name"]), enum=entry["enum"])
        _values(inner, choice, entry)
        out.choices.append(choice)
    unique(where, "choice", [c.name for c in out.choices])


def _unit(where: str, out: Word, simulated: bool) -> None:
    if out.type == "number":
        if not out.unit:
            raise SchemaError(f'{where}: a number needs a unit ("1" for a plain one)')
        known_unit(where, "unit", out.unit)
    elif out.type in ("twist", "bounds"):
        one_of(where, "unit", out.unit, RATES)
    elif out.unit:
        raise SchemaError(f"{where}: a {out.type} has no unit of its own")
    if out.frame:
        _only_of(where, out, "frame", {"pose"})
    if out.type == "pose" and simulated and out.has_member and not out.frame:
        raise SchemaError(f"{where}: a pose needs a frame")


def _default(where: str, out: Word, simulated: bool) -> None:
    value = out.default
    if value is None:
        told = out.default_text or out.optional or out.type in ("texts", "colors")
        if simulated and out.has_member and not told:
            raise SchemaError(f"{where}: default is missing (default_text, where it is not a value)")
        return
    if out.type in ("text", "choice"):
        good = isinstance(value, str)
    elif out.type == "flag":
        good = type(value) is int and value in (0, 1)
    elif out.type in ("integer", "count"):
        good = type(value) is int
    elif out.type in NUMBERS:
        good = _is_number(value)
    elif out.type == "choices":
        good = isinstance(value, list) and len(value) == len(out.choices)
    else:
        length = 4 if out.type == "color" else len(out.scales)
        good = isinstance(value, list) and len(value) == length and all(map(_is_number, value))
    if not good:
        kind = out.type if out.type == "choices" else f"a {out.type}"
        raise SchemaError(f"{where}: default {value!r} is not what {kind} can be")
    if out.type == "choice":
        one_of(where, "default", value, [v.word for v in out.values])
    for choice, word_of_it in zip(out.choices, value if out.choices else []):
        one_of(f"{where}: choice {choice.name}", "default", word_of_it, [v.word for v in choice.values])
        choice.default = word_of_it
    if out.type in NUMBERS and not _within(out, value):
        raise SchemaError(f"{where}: default {value!r} is outside of the limits")


def _is_number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _within(out: Word, value: float) -> bool:
    return ((out.min is None or value >= out.min) and (out.max is None or value <= out.max)
            and (out.above is None or value > out.above))


def _limits(where: str, out: Word) -> None:
    for key in ("min", "above", "max"):
        if getattr(out, key) is not None:
            _only_of(where, out, key, NUMBERS | {"tuple"})
    if out.type == "tuple" and (out.above, out.min is None) != (None, out.max is None):
        raise SchemaError(f"{where}: the numbers of a tuple have both a min and a max")
    if out.type == "tuple":
        return
    if out.above not in (None, 0) or (out.min not in (None, 0) and out.type != "count"):
        raise SchemaError(f"{where}: a limit other than 0 is for a count, which has no unit")
    if out.max is not None and (out.type not in ("count", "number", "angle") or out.min is None or out.clamp):
        raise SchemaError(f"{where}: max is for a count, a number or an angle that has a min")
    if out.type == "count" and (out.min is None or out.min < 0):
        raise SchemaError(f"{where}: a count needs a min of 0 or more")
    if out.limit and out.max is None:
        raise SchemaError(f"{where}: limit names a max, and there is none")
    if out.clamp and (out.min != 0 or out.type not in ("number", "integer")):
        raise SchemaError(f"{where}: clamp is for a number or an integer with min 0")


def check_together(where, words: list[Word]) -> None:
    """Checks references between words; `where(word)` is the place of a word."""
    by_name = {w.name: w for w in words}
    for w in words:
        if w.with_word:
            one_of(where(w), "with", w.with_word, by_name)
            if (by_name[w.with_word].type, w.type) != ("color", "rgba"):
                raise SchemaError(f"{where(w)}: only an rgba is read with another word, a color")
        elif w.type == "rgba":
            raise SchemaError(f"{where(w)}: an rgba is read with a color: with is missing")
        if w.counted_by:
            before = [b.name for b in words[:words.index(w)] if b.type == "count" and b.has_member]
            one_of(where(w), "counted_by", w.counted_by, before)
    members = [m for w in words if w.has_member for m in w.members()]
    unique(where(words[0]).partition(": word")[0] if words else "", "member", members)
