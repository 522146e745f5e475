"""Names in C, where all interfaces share one space of names."""

import unittest

from codegen import emit_c
from codegen.checks import SchemaError
from codegen.model import build
from codegen.test_model import message, struct, tables


class Names(unittest.TestCase):
    def test_structs_messages_and_constants_carry_their_interface(self):
        constants = [{"doc": "States.", "values": {"8BIT": 1}}]
        files = emit_c.emit(build(tables(constants=constants, message=[message(payload="TurnRate")], struct=[
            struct({"name": "angle", "type": "float32", "unit": "rad"}, name="TurnRate")])))
        header = files[f"{emit_c.FOLDER}/arm.h"]
        for line in ("#define PH_ARM_CODE 54", "typedef struct ph_arm_turn_rate {", "  float angle;",
                     "PH_CODEC(ph_arm_turn_rate)", "  PH_ARM_8BIT = 1,",
                     "#define PH_ARM_DATA_STATE (&ph_arm_messages[0])"):
            self.assertIn(line + "\n", header)

    def refuse(self, text, **changes):
        schema = build(tables(**changes))
        with self.assertRaises(SchemaError) as caught:
            emit_c.emit(schema)
        self.assertIn(text, str(caught.exception))

    def test_a_name_that_would_stand_for_two_things(self):
        constants = [{"doc": "States.", "values": {"DATA_STATE": 1}}]
        self.refuse("PH_ARM_DATA_STATE would stand for two things", constants=constants, message=[message()])

    def test_a_field_that_is_a_word_of_the_language(self):
        field = {"name": "default", "type": "uint8"}
        self.refuse("default cannot be a field in C", message=[message()], struct=[struct(field)])


if __name__ == "__main__":
    unittest.main()
