"""What the definition of viewers' commands may not say, and what the checked-in one does say."""

import tempfile
import unittest
from pathlib import Path

from codegen import emit_commands
from codegen.checks import SchemaError
from codegen.commands import load_commands

ROOT = Path(__file__).resolve().parent.parent


def load(text):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "commands.toml"
        path.write_text(text)
        return load_commands(path)


WAVE = '[[command]]\nname = "Wave"\nmay = "joins"\ndoc = "The body waves."\n'


class Refused(unittest.TestCase):
    def refused(self, text, why):
        with self.assertRaisesRegex(SchemaError, why):
            load(text)

    def test_what_is_missing_or_unknown(self):
        self.refused(WAVE.replace('may = "joins"\n', ""), "Wave: may is missing")
        self.refused(WAVE + "hand = 1\n", "unknown key 'hand'")
        self.refused(WAVE.replace("joins", "join"), "unknown may 'join' .did you mean 'joins'")
        self.refused(WAVE + 'fields = {hand = "metre"}\n', "hand: unknown type 'metre' .did you mean 'metres'")
        self.refused(WAVE + "example = {hand = 1}\n", "unknown example of 'hand'")
        self.refused(WAVE.replace("Wave", "wave"), "name is that of a struct")

    def test_what_is_there_twice(self):
        self.refused(WAVE + WAVE, "name 'Wave' is there twice")
        self.refused(WAVE + WAVE.replace('"Wave"', '"Greet"\ndo = "wave"'), "do 'wave' is there twice")


class Emitted(unittest.TestCase):
    def test_a_command_is_the_same_at_both_ends_and_in_the_docs(self):
        files = emit_commands.emit(load(WAVE + 'fields = {hand = "count", high = "flag", at = "count or nothing"}\n'))
        self.assertIn("struct Wave {\n  std::uint32_t hand = 0;\n  bool high = false;", files["playhouse/replicate/generated/commands.h"])
        self.assertIn("May::kJoins,  // Wave", files["playhouse/replicate/generated/commands.h"])
        self.assertIn('out.high = in.truth("high");', files["playhouse/replicate/generated/read_commands.cc"])
        self.assertIn("| { do: 'wave'; hand: number; high: boolean; at?: number };", files["web/src/protocol/generated/commands.ts"])
        self.assertIn('`{"do": "wave", "hand": 0, "high": true}` | The body waves.', files["docs/viewer-commands.md"])

    def test_the_checked_in_definition_is_accepted(self):
        self.assertIn("drag", [c.word for c in load_commands(ROOT / "viewer" / "commands.toml")])


if __name__ == "__main__":
    unittest.main()
