"""What drivers that make values of any payload are told of its fields."""

import unittest
from pathlib import Path

from codegen.checks import SchemaError
from codegen.emit_wire_fields import PATH, choices_of, emit
from codegen.model import build, load
from codegen.test_model import struct, tables

ROOT = Path(__file__).resolve().parent.parent


def emitted(*fields, **changes) -> str:
    return emit(build(tables(struct=[struct(*fields)], **changes)))[PATH]


def group(doc: str, **values) -> dict:
    return {"doc": doc, "values": values}


class WireFields(unittest.TestCase):
    MODE = {"name": "mode", "type": "uint8"}

    def test_constants_named_after_a_field_are_its_values(self):
        text = emitted(self.MODE, constants=[group("Values of State.mode: what it does.", IDLE=2, MOVING=5)])
        self.assertIn("[] = {2, 5};", text)

    def test_bits_of_a_field_are_one_value(self):
        for doc, values in (("Bits of State.mode.", {"A": 1, "B": 8}), ("Bits of State.mode, by number.", {"A": 0, "B": 3})):
            self.assertIn("[] = {9};", emitted(self.MODE, constants=[group(doc, **values)]))

    def test_constants_of_a_field_that_is_not_there_are_refused(self):
        with self.assertRaisesRegex(SchemaError, "054_arm.toml: constants: .*there is no field State.mood"):
            emitted(self.MODE, constants=[group("Values of State.mood.", GOOD=1)])

    def test_a_part_of_several_units_is_of_the_first(self):
        text = emitted({"name": "joint", "type": "float32", "unit": "rad or m"})
        self.assertIn('[] = {"rad"};', text)

    def test_questions_are_the_requests_whose_doc_says_so(self):
        rows = [{"kind": "REQ", "subtype": n, "name": f"R{n}", "payload": "State", "doc": doc}
                for n, doc in ((1, "Requests its mode."), (2, "Sets its mode."))]
        text = emitted(self.MODE, message=rows)
        self.assertIn("{54, 1},  // arm.req.r1", text)
        self.assertNotIn("{54, 2},", text)

    def test_every_field_that_has_constants_is_found(self):
        schema = load(ROOT / "interfaces")
        found = {f"{i.name}.{name}" for i in schema.interfaces for name in choices_of(i)}
        self.assertGreater(len(found), 15)
        self.assertLessEqual({"wifi.Data.mode", "wifi.Link.mode", "power.Data.valid", "position1d.Data.status"}, found)


if __name__ == "__main__":
    unittest.main()
