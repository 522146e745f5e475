"""Tests of what only the Tcl emitter decides."""

import unittest

from codegen import emit_tcl
from codegen.checks import SchemaError
from codegen.model import build


def files(field: str, doc: str = "A thing.") -> dict[str, str]:
    """What is written for a struct with one field of this name and documentation."""
    struct = {"name": "Thing", "c_name": "thing_t", "doc": doc, "fields": [{"name": field, "type": "uint8"}]}
    common = {"name": "common", "doc": "Shared.", "struct": [struct]}
    return emit_tcl.emit(build([("interfaces/000_common.toml", common)]))


class EmitTcl(unittest.TestCase):
    def test_a_narrow_number_keeps_its_low_bits(self) -> None:
        text = files("state")["clients/tcl/generated/common.tcl"]
        self.assertIn("        binary scan $body @${at}Iu state\n        incr at 4\n        set state [low 0xff $state]\n", text)

    def test_a_field_with_the_name_of_a_variable_of_the_reader_is_an_error(self) -> None:
        with self.assertRaisesRegex(SchemaError, "Thing.body cannot be a field in Tcl"):
            files("body")

    def test_a_comment_that_would_end_its_script_is_an_error(self) -> None:
        with self.assertRaisesRegex(SchemaError, "cannot be a comment in Tcl"):
            files("state", "Ends here }.")


if __name__ == "__main__":
    unittest.main()
