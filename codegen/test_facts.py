"""The definitions against the catalogue of facts about the original."""

import json
import unittest
from pathlib import Path

from codegen.model import load

ROOT = Path(__file__).resolve().parent.parent
FACTS = ROOT / "tests/reference/player/interfaces.json"


class Facts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.facts = json.loads(FACTS.read_text(encoding="utf-8"))
        cls.schema = load(ROOT / "interfaces")

    def test_every_message_has_its_number_and_payload(self):
        for fact in self.facts["interfaces"]:
            ours = self.schema.interface(fact["name"])
            self.assertEqual(ours.code, fact["code"])
            wanted = {(m["type"], m["subtype"], m["name"], m.get("payload")) for m in fact["messages"]}
            found = {(m.kind, m.subtype, f"PLAYER_{ours.name.upper()}_{m.kind}_{m.name}", self.c_name(m))
                     for m in ours.messages}
            self.assertEqual(found, wanted)

    def c_name(self, message):
        return self.schema.interface(message.owner).struct(message.payload).c_name if message.payload else None

    def test_every_struct_has_its_fields_in_order_and_its_size(self):
        wanted = {s["name"]: s for i in [{"structs": self.facts["common_structs"]}, *self.facts["interfaces"]]
                  for s in i["structs"]}
        del wanted["player_msghdr_t"]  # playhouse/wire/header.h
        for interface in self.schema.all():
            for struct in interface.structs:
                fact = wanted.pop(struct.c_name)
                names = [f.count_name if step == "count" else f.name for step, f in struct.steps()]
                self.assertEqual(names, [f["name"] for f in fact["fields"]], struct.c_name)
                self.assertEqual(struct.min_bytes, fact["wire_min_bytes"], struct.c_name)
        self.assertEqual(list(wanted), [])

    def test_every_field_has_its_type_and_bound(self):
        facts = {s["name"]: {f["name"]: f for f in s["fields"]}
                 for i in [{"structs": self.facts["common_structs"]}, *self.facts["interfaces"]]
                 for s in i["structs"]}
        for interface in self.schema.all():
            for struct in interface.structs:
                for f in struct.fields:
                    fact = facts[struct.c_name][f.name]
                    array = fact["array"] or {}
                    ctype = f.original_type if f.is_scalar else self.schema.struct_of(f).c_name
                    self.assertEqual(ctype, fact["type"])
                    self.assertEqual(f.length, array.get("n"))
                    self.assertEqual(None if f.dynamic else f.max, array.get("max"))

    def test_every_field_has_the_unit_of_the_original(self):
        # Where the catalogue says something else, or less.
        ours_alone = {"player_simulation_pose3d_req_t.simtime": "us",  # what Stage sends
                      "player_localize_get_particles_t.mean": "m, m, rad",  # what drivers send
                      "player_position3d_cmd_pos_t.vel": "m/s, m/s, m/s, rad/s, rad/s, rad/s",
                      "player_localize_get_particles_t.variance": "m^2",
                      "player_localize_hypoth_t.cov": "m^2, m^2, rad^2, m^2, m rad, m rad",
                      "player_localize_set_pose_t.cov": "m^2, m^2, rad^2, m^2, m rad, m rad"}
        words = {"0..1": "1", "ratio": "1", "m/s x3,rad/s x3": "m/s,m/s,m/s,rad/s,rad/s,rad/s"}
        facts = {(s["name"], f["name"]): f.get("unit") for i in self.facts["interfaces"] for s in i["structs"]
                 for f in s["fields"]}
        for interface in self.schema.interfaces:
            for struct in interface.structs:
                for f in struct.fields:
                    fact, key = facts[struct.c_name, f.name], f"{struct.c_name}.{f.name}"
                    if key in ours_alone:
                        self.assertEqual(f.unit, ours_alone[key], key)
                    elif fact is not None:
                        self.assertEqual(f.unit.replace(", ", ",").replace(" or ", "|"), words.get(fact, fact), key)

    def test_every_constant_has_its_value(self):
        for fact in self.facts["interfaces"]:
            ours = self.schema.interface(fact["name"])
            found = {g.c_prefix + name: value for g in ours.constants for name, value in g.values.items()}
            wanted = dict(fact["constants"])
            for values in fact["enums"].values():
                wanted |= values
            messages = {m["name"] for m in fact["messages"]}
            self.assertEqual(found, {k: v for k, v in wanted.items() if k not in messages})


if __name__ == "__main__":
    unittest.main()
