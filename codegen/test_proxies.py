"""What the definitions of proxies may not say, and what follows from units."""

import ast
import re
import unittest
from pathlib import Path

from codegen import emit_c
from codegen.checks import SchemaError
from codegen.model import build, load
from codegen.proxies import Expr, Type, build_proxies, c, cpp, java, lisp, python, spelled, tcl, typescript
from codegen.proxies.spelling import Spelling

ROOT = Path(__file__).resolve().parent.parent
COMMON = {"name": "common", "doc": "Shared.", "struct": [
    {"name": "Pose2d", "c_name": "player_pose2d_t", "doc": "A pose.", "fields": [
        {"name": "px", "type": "float64", "unit": "m"}, {"name": "py", "type": "float64", "unit": "m"},
        {"name": "pa", "type": "float64", "unit": "rad"}]}]}
FIELDS = [{"name": "height", "type": "int32", "unit": "mm", "doc": "Above the ground."}, {"name": "angle", "type": "float32", "unit": "rad"},
          {"name": "state", "type": "uint8", "doc": "Up or down."}, {"name": "pose", "type": "Pose2d", "unit": "m, m, rad", "frame": "X_OR"},
          {"name": "vel", "type": "Pose2d", "unit": "m/s, m/s, rad/s", "frame": "v_OR_R"},
          {"name": "heights", "type": "int32[]", "max": 4, "unit": "mm"}]
VALUE = {"name": "Lift", "doc": "A lift.", "fields": ["height", "time"]}
READ = {"name": "lift", "message": "STATE", "value": "Lift"}


def proxies(value=VALUE, values=None, **changes):
    """Of one interface; the changes replace entries of its proxy."""
    interface = {
        "name": "arm", "code": 54, "doc": "An arm.",
        "constants": [{"doc": "Values of Data.state.", "values": {"UP": 1, "DOWN": 2}}],
        "message": [{"kind": "DATA", "subtype": 1, "name": "STATE", "payload": "Data", "policy": "latest", "doc": "State."},
                    {"kind": "CMD", "subtype": 1, "name": "MOVE", "payload": "Cmd", "policy": "latest", "doc": "Moves."},
                    {"kind": "REQ", "subtype": 1, "name": "STOP", "doc": "Stops."}],
        "struct": [{"name": "Data", "c_name": "player_arm_data_t", "doc": "State.", "fields": FIELDS},
                   {"name": "Cmd", "c_name": "player_arm_cmd_t", "doc": "Moves.", "fields": FIELDS[:4]}],
        "value": values or [value],
        "proxy": {"class": "Arm", "doc": "An arm.", "read": [READ]} | changes,
    }
    return build_proxies(build([("interfaces/000_common.toml", COMMON), ("interfaces/054_arm.toml", interface)]))


def field(**entry):
    return {"value": VALUE | {"fields": [entry]}}


class Refused(unittest.TestCase):
    def refuse(self, text, **changes):
        with self.assertRaises(SchemaError) as caught:
            proxies(**changes)
        self.assertIn(text, str(caught.exception))
        self.assertIn("interfaces/054_arm.toml: ", str(caught.exception))

    def test_a_field_that_the_message_lacks(self):
        self.refuse("read lift: Lift.hight: struct Data: unknown field 'hight' (did you mean 'height'?)", **field(name="hight"))

    def test_a_message_that_the_interface_lacks(self):
        self.refuse("read lift: unknown message of kind DATA 'STAT' (did you mean 'STATE'?)", read=[READ | {"message": "STAT"}])
        self.refuse("call go: unknown message of kind CMD 'STOP'", call=[{"name": "go", "command": "STOP"}])

    def test_a_constant_that_the_interface_lacks(self):
        self.refuse("unknown constant of arm 'UPP' (did you mean 'UP'?)", **field(name="up", **{"from": "state", "is": "UPP"}))

    def test_a_value_that_nobody_defines(self):
        self.refuse("unknown value 'Left' (did you mean 'Lift'?)", read=[READ | {"value": "Left"}])

    def test_a_value_that_no_proxy_has(self):
        self.refuse("value Other: no proxy has such a value", values=[VALUE, VALUE | {"name": "Other"}])

    def test_a_value_of_the_name_of_one_that_all_have(self):
        self.refuse("value Pose: is there twice", values=[VALUE, VALUE | {"name": "Pose"}])

    def test_a_value_with_a_field_of_two_types(self):
        whole = {"name": "whole", "message": "STATE", "value": "Lift", "fields": {"height": "state"}}
        self.refuse("Lift.height: is a float elsewhere, and a int here", read=[READ, whole])

    def test_an_unknown_key(self):
        self.refuse("read lift: unknown key 'massage' (did you mean 'message'?)", read=[READ | {"massage": "STATE"}])

    def test_a_base_that_no_library_has(self):
        self.refuse("unknown base 'Mobil' (did you mean 'Mobile'?)", base="Mobil")

    def test_a_queue_without_its_base(self):
        self.refuse("base Keeping and [[proxy.take]] go together", base="Keeping")

    def test_a_member_twice(self):
        self.refuse("member 'lift' is there twice", read=[READ, READ])

    def test_a_list_in_a_unit_that_would_be_changed(self):
        self.refuse("heights: a list of numbers in mm is not supported", read=[READ, {"name": "heights", "message": "STATE", "from": "heights"}])

    def test_an_argument_in_a_unit_that_would_be_changed(self):
        self.refuse("argument height: height in mm cannot be an argument yet",
                    call=[{"name": "go", "command": "MOVE", "arguments": [{"name": "height"}]}])

    def test_two_arguments_for_one_field(self):
        self.refuse("two arguments for angle", call=[{"name": "go", "command": "MOVE", "arguments": [
            {"name": "one", "to": "angle"}, {"name": "two", "to": "angle"}]}])

    def test_a_field_that_is_set_twice(self):
        self.refuse("set angle: angle is set twice", call=[{"name": "go", "command": "MOVE", "arguments": [{"name": "angle"}], "set": {"angle": 1}}])

    def test_an_argument_of_a_message_without_a_payload(self):
        self.refuse("req.stop has no payload", call=[{"name": "stop", "request": "STOP", "arguments": [{"name": "angle"}]}])

    def test_a_call_that_is_both(self):
        self.refuse("is either a command or a request", call=[{"name": "go", "command": "MOVE", "request": "STOP"}])

    def test_a_class_by_hand_with_members(self):
        self.refuse("one that is written by hand has nothing but its class", by_hand=True)

    def test_a_shortcut_to_a_list_that_does_not_say_what_is_lacking(self):
        self.refuse("none says what is lacking", shortcut=[{"name": "height", "of": "lift.height", "none": "lift"}])


class Made(unittest.TestCase):
    def part(self, **entry):
        made = proxies(**field(**entry))
        (_, expr), = made.proxies[0].members[0].expr.parts
        return expr, made.values["Lift"].fields[0]

    def test_the_scale_and_the_unit_of_a_number_are_those_of_its_field(self):
        expr, part = self.part(name="height")
        self.assertEqual((expr.factor, expr.type.name, part.doc), ("1e-3", "float", "Above the ground (in m)."))
        expr, part = self.part(name="angle")
        self.assertEqual((expr.factor, expr.type.name, part.doc), ("", "float", "In rad."))
        self.assertEqual(self.part(name="state")[0].type.name, "int")

    def test_a_pose_in_metres_per_second_is_a_velocity(self):
        self.assertEqual(self.part(name="pose")[0].type.name, "Pose")
        self.assertEqual(self.part(name="v", **{"from": "vel"})[0].type.name, "Velocity")

    def test_the_time_is_that_of_the_message(self):
        self.assertEqual(self.part(name="time")[0].how, "time")

    def test_names_in_texts_are_those_of_the_language(self):
        text = "As {go_to()} with {set_power(true)}, {State.pose}; {raises NoData}."
        self.assertEqual(spelled(text, lambda name, call: name.upper() + call, lambda what: f"throws {what}"),
                         "As GO_TO() with SET_POWER(true), STATE.POSE; throws NoData.")


class Ways(unittest.TestCase):
    def test_a_language_that_lacks_one_is_refused(self):
        with self.assertRaisesRegex(TypeError, "does not spell convert, .*, each$"):
            type("Short", (Spelling,), {"TEXTS": dict.fromkeys(("truth", "equals", "bit", "text", "call", "time", "whole"), "")})

    def test_one_that_nobody_knows_is_refused_by_every_language(self):
        for emitter in (c._Class, cpp._Class, java._Class, lisp._Class, python._Module, tcl._Class, typescript._Module):
            with self.assertRaisesRegex(ValueError, "a value is made by 'guess', which is none of is, "):
                emitter._plain(emitter.__new__(emitter), Expr("guess", Type("int")), "data")


class Tree(unittest.TestCase):
    """The definitions of the tree."""

    @classmethod
    def setUpClass(cls):
        cls.proxies = build_proxies(load(ROOT / "interfaces"))

    def test_scales_of_a_fix_follow_from_its_units(self):
        gps = next(p for p in self.proxies.proxies if p.name == "Gps")
        factors = {name: e.factor for name, e in gps.members[0].expr.parts if e.factor}
        self.assertEqual(factors, {"latitude": "1e-7", "longitude": "1e-7", "altitude": "1e-3"})

    def test_python_of_every_proxy_can_be_read(self):
        for path, text in python.emit(self.proxies).items():
            ast.parse(text, path)
            self.assertLessEqual(max(map(len, text.splitlines())), 120, path)

    def test_names_of_c_are_there_once(self):
        headers = "".join(text for path, text in c.emit(self.proxies).items() if path.endswith(".h"))
        headers += "".join(text for path, text in emit_c.emit(self.proxies.schema).items() if path.endswith(".h"))
        names = re.findall(r"^} (ph_\w+);|^(?:ph_status|const \w+|bool|ph_geometry) \*?(ph_\w+)\(", headers, re.M)
        names = [one or other for one, other in names]
        self.assertEqual([name for name in names if names.count(name) > 1], [])
        self.assertIn("ph_laser_get_config", names)  # ph_laser_config is the struct

    def test_parentheses_of_lisp_match(self):
        for path, text in lisp.emit(self.proxies).items():
            code = re.sub(r'"(?:\\\\.|[^"\\\\])*"|;.*', "", text)
            for form in filter(None, re.split(r"\n(?=\()", code)):
                self.assertEqual(form.count("("), form.count(")"), f"{path}: {form}")

    def test_a_function_of_lisp_that_classes_share_takes_the_same_arguments(self):
        drive = [line for text in lisp.emit(self.proxies).values() for line in text.splitlines() if re.match(r"\((define-operation|defmethod) drive ", line)]
        self.assertEqual(sorted(drive), ["(define-operation drive (device vx &key)", "(defmethod drive ((device position2d) vx &key (va 0) (vy 0))",
                                         "(defmethod drive ((device position3d) vx &key (va 0) (vy 0) (vz 0))"])

    def test_lines_of_typescript_fit(self):
        for path, text in typescript.emit(self.proxies).items():
            self.assertLessEqual(max(map(len, text.splitlines())), 125, path)


if __name__ == "__main__":
    unittest.main()
