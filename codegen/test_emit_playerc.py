"""Old names of the messages, as old programs spell them."""

import unittest
from pathlib import Path

from codegen import emit_playerc
from codegen.model import load


class OldNames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        schema = load(Path(__file__).resolve().parent.parent / "interfaces")
        cls.files = emit_playerc.emit(schema)
        cls.header = cls.files[emit_playerc.HEADER]

    def struct(self, name):
        body = self.header.partition(f"typedef struct {name} {{\n")[2].partition("}")[0]
        return [line.strip() for line in body.splitlines() if not line.strip().startswith(("/**", "*"))]

    def test_constants_and_messages_are_macros(self):
        for line in ("#define PLAYER_LASER_CODE 6", "#define PLAYER_POSITION2D_CMD_VEL 1", "#define PLAYER_CAPABILITIES_REQ 255", "#define PLAYER_OPEN_MODE 1",
                     "#define PLAYER_COOPOBJECT_MSG_NONE -1"):
            self.assertIn(line + "\n", self.header)

    def test_members_are_in_the_order_of_the_wire_with_counts_before_their_lists(self):
        self.assertEqual(self.struct("player_laser_data")[4:], ["uint32_t ranges_count;", "float *ranges;", "uint32_t intensity_count;", "uint8_t *intensity;", "uint32_t id;"])
        self.assertEqual(self.struct("player_map_data")[4:], ["uint32_t data_count;", "int8_t data_range;", "int8_t *data;"])

    def test_bounded_lists_are_within_the_struct(self):
        self.assertEqual(self.struct("player_log_set_filename"), ["uint32_t filename_count;", "char filename[256];"])
        self.assertIn('{"filename", PH_TYPE_CHAR, PH_SHAPE_INLINE, 0, 0, 256,', self.files[emit_playerc.SOURCE])

    def test_structs_follow_those_that_they_contain(self):
        defined = self.header.index
        self.assertLess(defined("} player_camera_data_t;"), defined("} player_stereo_data_t;"))

    def test_rows_are_in_the_order_in_which_they_are_searched(self):
        rows = [line.split(",")[:3] for line in self.files[emit_playerc.SOURCE].partition("player_messages[")[2].splitlines()[1:-1]]
        kinds = {"DATA": 1, "CMD": 2, "REQ": 3, "SYNCH": 5}
        order = [(int(code.strip(" {")), kinds[kind.removeprefix(" PH_KIND_")], int(subtype)) for code, kind, subtype in rows]
        self.assertEqual(len(order), 258)
        self.assertEqual(order, sorted(set(order)))


if __name__ == "__main__":
    unittest.main()
