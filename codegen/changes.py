"""Loads and validates the changes of a world between two ticks: [[change]] of kinds/*.toml.

A change of a kind is for a model of that kind, one of the base or of a trait for any model that has it; one of the world is for no
model in particular. The list is closed: what is not in it, nobody can do to a running world.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from codegen.checks import SchemaError, documented, keys, one_of, typed, unique


@dataclass(frozen=True)
class FieldType:
    cpp: str            # the member, with its default value
    unit: str = ""      # of its numbers, if that is always the same


TYPES = {
    "count": FieldType("std::uint32_t {} = 0"),
    "integer": FieldType("std::int32_t {} = 0"),
    "seed": FieldType("std::uint64_t {} = 0"),
    "number": FieldType("double {} = 0"),
    "flag": FieldType("bool {} = false"),
    "text": FieldType("std::string {}"),
    "model": FieldType("ModelId {}"),
    "models": FieldType("std::vector<ModelId> {}"),
    "pose": FieldType("geom::Pose {}", "m, m, m, rad"),
    "poses": FieldType("std::vector<geom::Pose> {}", "m, m, m, rad"),
    "pose in 3D": FieldType("geom::SpatialPose {}", "m, m, m, rad; tilt rad, rad"),
    "points": FieldType("std::vector<geom::Vec3> {}", "m, m, m"),
    "tilt": FieldType("geom::Tilt {}", "rad, rad"),
    "twist": FieldType("geom::Twist {}", "m/s, m/s, m/s, rad/s"),
    "color": FieldType("scene::Color {}", "0 to 1"),
    "grip": FieldType("GripperCommand {} = GripperCommand::kOpen"),
    "bytes": FieldType("std::vector<std::uint8_t> {}"),
    "state": FieldType("std::shared_ptr<const std::vector<std::byte>> {}"),
}
# What applying one gives.
GIVES = {"": "bool", "reason": "Result<void>", "model": "Result<ModelId>"}


@dataclass(frozen=True)
class Field:
    name: str
    type: str
    unit: str

    def member(self) -> str:
        return TYPES[self.type].cpp.format(self.name)


@dataclass
class Change:
    name: str
    doc: str
    gives: str
    fields: list[Field] = field(default_factory=list)  # without the model

    @property
    def struct(self) -> str:
        return "".join(part.title() for part in self.name.split("_"))


def changes(source: str, rows: list[dict]) -> list[Change]:
    """Those of one file."""
    out = [_change(f"{source}: change {row.get('name', '?')}", row) for row in rows]
    unique(source, "change", [c.name for c in out])
    return out


def _change(where: str, row: dict) -> Change:
    keys(where, row, {"name", "doc"}, {"fields", "gives"})
    typed(where, row, {"name": str, "doc": str, "fields": dict, "gives": str})
    if not re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", row["name"]):
        raise SchemaError(f"{where}: name is words in lower case with _ between them")
    documented(where, row["doc"])
    gives = row.get("gives", "")
    one_of(where, "gives", gives, GIVES)
    return Change(row["name"], row["doc"], gives, [_field(where, name, kind) for name, kind in row.get("fields", {}).items()])


def _field(where: str, name: str, kind: str) -> Field:
    found = re.fullmatch(r"([^\[]*?)(?: \[(.+)\])?", kind)
    assert found
    one_of(f"{where}: {name}", "type", found[1], TYPES)
    if (found[1] == "number") != bool(found[2]):
        raise SchemaError(f"{where}: {name}: a number, and only a number, has its unit in [ ]")
    return Field(name, found[1], found[2] or TYPES[found[1]].unit)
