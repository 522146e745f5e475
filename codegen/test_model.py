"""What the definitions may not say, and what those of the tree do say."""

import tempfile
import unittest
from pathlib import Path

from codegen.checks import SchemaError
from codegen.model import BODY_BYTES, build, load

ROOT = Path(__file__).resolve().parent.parent
POSE = {"name": "Pose2d", "c_name": "player_pose2d_t", "doc": "A pose.",
        "fields": [{"name": "px", "type": "float64", "unit": "m"}]}


def tables(**changes):
    """A common file and one interface; the changes replace entries of the interface."""
    common = {"name": "common", "doc": "Shared.", "struct": [POSE]}
    interface = {
        "name": "arm", "code": 54, "doc": "An arm.",
        "message": [{"kind": "DATA", "subtype": 1, "name": "STATE", "payload": "State", "policy": "latest",
                     "doc": "State."}],
        "struct": [{"name": "State", "c_name": "player_arm_state_t", "doc": "State.",
                    "fields": [{"name": "angle", "type": "float32", "unit": "rad"}]}],
    } | changes
    return [("interfaces/000_common.toml", common), ("interfaces/054_arm.toml", interface)]


def struct(*fields, name="State"):
    return {"name": name, "c_name": f"player_arm_{name.lower()}_t", "doc": "State.", "fields": list(fields)}


def message(**changes):
    return {"kind": "DATA", "subtype": 1, "name": "STATE", "policy": "latest", "doc": "State."} | changes


class Refused(unittest.TestCase):
    def refuse(self, text, **changes):
        with self.assertRaises(SchemaError) as caught:
            build(tables(**changes))
        self.assertIn(text, str(caught.exception))
        self.assertIn("interfaces/", str(caught.exception))

    def test_a_float_without_a_unit(self):
        self.refuse("field angle: a float needs a unit", struct=[struct({"name": "angle", "type": "float32"})])

    def test_a_list_of_floats_without_a_unit(self):
        self.refuse("a float needs a unit", struct=[struct({"name": "a", "type": "float32[]", "max": "message"})])

    def test_a_pose_without_a_frame(self):
        self.refuse("field pose: a Pose2d needs a frame", struct=[struct({"name": "pose", "type": "Pose2d"})])

    def test_a_frame_that_is_no_monogram(self):
        self.refuse("'robot' is not a monogram",
                    struct=[struct({"name": "pose", "type": "Pose2d", "frame": "robot"})])

    def test_a_unit_that_nobody_knows(self):
        self.refuse("field angle: unknown unit 'bananas'",
                    struct=[struct({"name": "angle", "type": "float32", "unit": "bananas"})])
        self.refuse("field n: unknown unit 'meters' (did you mean 'm'?",
                    struct=[struct({"name": "n", "type": "uint8", "unit": "meters"})])

    def test_a_unit_that_nobody_knows_of_a_pose_or_one_of_its_parts(self):
        pose = {"name": "pose", "type": "Pose2d", "frame": "X_OR"}
        self.refuse("unknown unit 'bananas'", struct=[struct(pose | {"unit": "bananas"})])
        self.refuse("unknown unit 'Rad' (did you mean 'rad'?", struct=[struct(pose | {"unit": "m, m, Rad"})])
        self.refuse("unknown unit 'rads'", struct=[struct(pose | {"unit": "m or rads"})])
        self.refuse("unknown unit ''", struct=[struct(pose | {"unit": "m, m,"})])

    def test_a_pose_without_a_unit(self):
        self.refuse("a Pose2d needs a unit", struct=[struct({"name": "pose", "type": "Pose2d", "frame": "X_OR"})])

    def test_a_unit_with_more_or_fewer_parts_than_the_value(self):
        self.refuse("2 units for a value of 1 part", struct=[struct({"name": "angle", "type": "float32", "unit": "m, rad"})])
        self.refuse("2 units for a value of 3 parts",
                    struct=[struct({"name": "to", "type": "float32[3]", "unit": "m, m"})])
        self.refuse("3 units for a value of 1 part",
                    struct=[struct({"name": "pose", "type": "Pose2d", "unit": "m, m, rad", "frame": "X_OR"})])

    def test_a_sign_for_what_has_one_or_is_no_number(self):
        for kind in ("int32", "uint8", "uint16", "float64", "uint32[]", "Pose2d"):
            field = {"name": "level", "type": kind, "signed": True, "unit": "m", "frame": "X_OR"}
            self.refuse("field level: signed is for single numbers of type uint32", struct=[struct(field | ({"max": 4} if "[" in kind else {}))])
        self.refuse("field level: signed = 1, valid: true", struct=[struct({"name": "level", "type": "uint32", "signed": 1})])

    def test_an_unbounded_array(self):
        self.refuse("unbounded array", struct=[struct({"name": "n", "type": "uint8[]"})])

    def test_an_unknown_type(self):
        self.refuse("unknown type 'uint9'", struct=[struct({"name": "n", "type": "uint9"})])

    def test_an_unknown_payload(self):
        self.refuse("unknown type 'Other'", message=[message(payload="Other")])

    def test_an_unknown_key(self):
        self.refuse("unknown key 'units'", struct=[struct({"name": "n", "type": "uint8", "units": "m"})])

    def test_a_subtype_twice(self):
        self.refuse("message number 'DATA 1' is there twice", message=[message(), message(name="OTHER")])

    def test_a_name_twice(self):
        self.refuse("message 'data.state' is there twice", message=[message(), message(subtype=2)])

    def test_a_field_that_takes_the_name_of_a_count(self):
        self.refuse("field 'n_count' is there twice",
                    struct=[struct({"name": "n_count", "type": "uint8"},
                                   {"name": "n", "type": "uint8[]", "max": 4})])

    def test_a_reserved_subtype(self):
        self.refuse("uses the reserved subtype 2", reserved=[2],
                    message=[{"kind": "REQ", "subtype": 2, "name": "X", "doc": "X."}])

    def test_a_subtype_of_the_shared_requests(self):
        self.refuse("247..255 belong to the shared requests",
                    message=[{"kind": "REQ", "subtype": 250, "name": "X", "doc": "X."}])

    def test_data_without_a_policy_and_a_request_with_one(self):
        self.refuse("policy", message=[message(policy="")])
        self.refuse("policy", message=[message(kind="REQ")])

    def test_a_message_without_a_sentence(self):
        self.refuse("doc must be a sentence", message=[message(doc="")])

    def test_a_struct_inside_itself(self):
        self.refuse_struct_cycle(struct({"name": "inner", "type": "State"}))
        self.refuse_struct_cycle(struct({"name": "inner", "type": "State[]", "max": 3}))

    def refuse_struct_cycle(self, entry):
        with self.assertRaises(SchemaError) as caught:
            build(tables(struct=[entry]))
        self.assertIn("contains itself", str(caught.exception))

    def test_a_code_twice(self):
        common, arm = tables()
        other = ("interfaces/054_leg.toml", arm[1] | {"name": "leg", "struct": [], "message": []})
        with self.assertRaises(SchemaError) as caught:
            build([common, arm, other])
        self.assertIn("interface code 54 is there twice", str(caught.exception))


class Places(unittest.TestCase):
    def test_a_fault_of_a_field_is_told_with_its_line(self):
        text = """name = "common"
doc = "Shared."
# fields = [{name = "x", type = "uint8"}]

[[struct]]
name = "Point"
c_name = "point_t"
doc = "A { in a text."
fields = [
  {name = "x", type = "float32", unit = "m"},  # a remark {
  {name = "y", type = "float32", unit = "bananas"},
]
"""
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "000_common.toml").write_text(text, encoding="utf-8")
            with self.assertRaises(SchemaError) as caught:
                load(Path(folder))
        self.assertIn("interfaces/000_common.toml:11: struct Point: field y: unknown unit 'bananas'",
                      str(caught.exception))


class Accepted(unittest.TestCase):
    def test_wire_order_has_the_count_where_the_definition_says(self):
        schema = build(tables(struct=[struct({"name": "range", "type": "int8"},
                                             {"name": "data", "type": "int8[]", "max": "message",
                                              "count_before": "range"})]))
        steps = schema.interface("arm").struct("State").steps()
        self.assertEqual([(step, f.name) for step, f in steps],
                         [("count", "data"), ("value", "range"), ("value", "data")])

    def test_smallest_sizes_and_bounds_follow_from_the_fields(self):
        schema = build(tables(struct=[struct({"name": "raw", "type": "char[5]"},
                                             {"name": "poses", "type": "Pose2d[]", "max": "message",
                                              "frame": "X_RS", "unit": "m"},
                                             {"name": "words", "type": "uint16[3]"})]))
        state = schema.interface("arm").struct("State")
        self.assertEqual(state.min_bytes, 8 + 8 + 12)
        self.assertEqual(state.fields[1].max, BODY_BYTES // 8)
        self.assertEqual(state.fields[1].owner, "common")


class Checked(unittest.TestCase):
    def test_the_interfaces_of_the_tree_load(self):
        schema = load(ROOT / "interfaces")
        self.assertEqual(len(schema.interfaces), 43)
        self.assertEqual(sum(len(i.messages) for i in schema.interfaces), 249)
        self.assertEqual(sum(len(i.structs) for i in schema.all()), 223)

    def test_simulated_devices_are_described_as_they_answer(self):
        # What playhouse/bridge/simulated/devices_test.cc finds in their messages.
        said = {("simulation", "Pose2dReq", "pose"): ("m, m, rad", "X_PT"),
                ("simulation", "Pose3dReq", "pose"): ("m, m, m, rad, rad, rad", "X_PT"),
                ("simulation", "Pose3dReq", "simtime"): ("us", ""),
                ("fiducial", "Geom", "size"): ("m, m, m", "")}
        schema = load(ROOT / "interfaces")
        for (interface, struct, name), quantity in said.items():
            fields = {f.name: f for f in schema.interface(interface).struct(struct).fields}
            self.assertEqual((fields[name].unit, fields[name].frame), quantity, f"{interface}.{struct}.{name}")

    def test_unsigned_numbers_that_may_be_below_zero_say_so(self):
        schema = load(ROOT / "interfaces")
        found = {f"{i.name}.{s.name}.{f.name}" for i in schema.all() for s in i.structs for f in s.fields if f.signed}
        self.assertEqual(found, {"wifi.Link.level", "wifi.Link.noise", "wifi.Data.maxlevel", "wifi.Data.maxnoise",
                                 "blobfinder.ColorConfig.channel"})
        level = next(f for f in schema.interface("wifi").struct("Link").fields if f.name == "level")
        self.assertEqual(level.described(), "Signal, up to Data.maxlevel (signed).")
        self.assertEqual((level.type, level.original_type), ("int32", "uint32"))

    def test_file_names_are_code_and_name(self):
        for interface in load(ROOT / "interfaces").all():
            self.assertEqual(interface.source, f"interfaces/{interface.code or 0:03d}_{interface.name}.toml")


if __name__ == "__main__":
    unittest.main()
