"""What a Player client has models say, and what it hears others say."""

import struct
import unittest

from house import ACK, CMD, SIMULATION, SPEECH, SPEECH_RECOGNITION, Client, House, HouseTest, text

SAY = 1
SAVE = 3

WORLD = """
model( name "box" pose [2 0 0 0] say "quiet, please" )
position( name "r0" )
position( name "r1" pose [0 2 0 0] )
"""
CFG = """
driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver ( name "stage" provides ["speech:0" "speech:1"] model "box" )
driver ( name "stage" provides ["speech:2"] model "r1" )
"""


class Speech(HouseTest):
    def start(self, *arguments) -> Client:
        self.saved = self.folder / "saved.world"
        self.house = House(*arguments, "--port", 0, "--headless", "--save-world", self.saved)
        self.addCleanup(self.house.__exit__)
        client = Client(self.house.port())
        self.addCleanup(client.close)
        self.assertEqual(client.open(SIMULATION, 0).type, ACK)
        return client

    def say(self, client: Client, index: int, words: str):
        self.assertEqual(client.open(SPEECH, index).type, ACK)
        client.send(SPEECH, index, CMD, SAY, text(words))

    def saved_world(self, client: Client) -> str:
        client.pose("r0")   # answered behind all commands
        client.send(SIMULATION, 0, CMD, SAVE)
        self.house.wait_for_line("saved the world at")
        return self.saved.read_text()

    def test_every_robot_has_a_voice_of_its_number(self):
        client = self.start("run", self.world(WORLD))
        self.assertEqual([d for d in client.devices() if d[0] == SPEECH], [(SPEECH, 0), (SPEECH, 1)])
        self.say(client, 1, "on my way")
        saved = self.saved_world(client)
        self.assertEqual(saved.count("say "), 2, saved)
        self.assertIn('say "on my way"', saved[saved.index('"r1"'):])

    def test_a_configuration_gives_any_model_as_many_voices_as_it_names(self):
        self.world(WORLD)
        client = self.start("serve", self.write("test.cfg", CFG))
        self.say(client, 0, "hush")
        self.say(client, 1, "schön leise")
        self.say(client, 2, "why?")
        saved = self.saved_world(client)
        self.assertEqual(saved.count("say "), 2, saved)
        self.assertIn('say "schön leise"', saved)
        self.assertIn('say "why?"', saved)

    def test_robots_hear_each_other_and_not_themselves(self):
        client = self.start("run", self.world(WORLD))
        for robot in (0, 1):
            self.assertEqual(client.open(SPEECH_RECOGNITION, robot).type, ACK)
        self.say(client, 0, "marco")
        self.assertEqual(client.next_data(SPEECH_RECOGNITION, 1).body, text("marco"))
        self.say(client, 1, "polo, schön")
        self.assertEqual(client.next_data(SPEECH_RECOGNITION, 0).body, text("polo, schön"), "its own voice was no message")

    def test_an_empty_text_ends_what_is_said_and_a_cut_one_changes_nothing(self):
        self.world(WORLD)
        client = self.start("serve", self.write("test.cfg", CFG))
        self.say(client, 2, "x")
        self.say(client, 0, "")
        client.send(SPEECH, 2, CMD, SAY, struct.pack(">II", 9, 9))
        saved = self.saved_world(client)
        self.assertEqual(saved.count("say "), 1, saved)
        self.assertIn('say "x"', saved)


if __name__ == "__main__":
    unittest.main()
