"""Detectors from outside: what docs/detectors.md says of them, by the Python client."""

import re
import sys
import unittest

from house import ROOT, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import connect  # noqa: E402

SEES_BEHIND = """
interval_sim 100
{radar}
position( name "r0" size [0.3 0.3 0.2] radar( pose [0 0 0.2 0] ) )
model( name "wall" pose [3 0 0 0] size [0.2 4 2] )
position( name "person" pose [5 0 0 0] size [0.4 0.4 1.8] color "red" fiducial_return 7 )
"""


class Detectors(HouseTest):
    def page(self) -> str:
        return (ROOT / "docs" / "detectors.md").read_text()

    def test_the_radar_of_the_page_sees_the_person_behind_the_wall(self) -> None:
        radar = re.search(r"```\n(define radar.*?)```", self.page(), re.DOTALL)[1]
        self.assertLessEqual(len(radar.splitlines()), 10, "ten lines, says the README")
        with self.run_house("--speed", 10, world=self.world(SEES_BEHIND.format(radar=radar))) as house, \
                connect(f":{house.port()}") as client:
            found = next(client.fiducial(0).updates(10))
            self.assertEqual([marker.id for marker in found], [7])
            self.assertAlmostEqual(found[0].pose.x, 4.8, delta=0.3)
            beams = client.ranger(0)
            scan = next(beams.updates(10))
            self.assertEqual(len(scan.ranges), 9)
            self.assertLess(scan.ranges[4], 5.2)
            self.assertEqual(scan.ranges[0], 12)

    def test_every_detector_of_the_page_runs(self) -> None:
        examples = "".join(block for block in self.page().split("```")[1::2] if block.startswith("\n"))
        names = re.findall(r"define (\w+) detector", examples)
        self.assertEqual(len(names), 5)
        world = examples + "model( pose [2 0 0 0] )\n" + \
            "position(" + " ".join(f"{name}( )" for name in names) + ")\n"
        with self.run_house("--speed", 10, world=self.world(world)) as house, connect(f":{house.port()}") as client:
            for index, _ in enumerate(names):
                next(client.fiducial(index).updates(10))

    def test_the_world_that_comes_with_it_shows_what_it_says(self) -> None:
        with self.run_house("--speed", 20, world=ROOT / "worlds" / "detectors.world") as house, \
                connect(f":{house.port()}") as client:
            radar, _, lamps = client.robot("r0").fiducials
            self.assertTrue(any(marker.pose.x > 7 for _, marker in zip(range(40), self.markers(radar))))
            dark = lit = 0
            for _, seen in zip(range(200), lamps.updates(10)):
                dark, lit = dark + (not seen), lit + bool(seen)
                if dark and lit:
                    return
            self.fail(f"the lamp was lit {lit} times and dark {dark} times")

    @staticmethod
    def markers(radar):
        for seen in radar.updates(10):
            yield from seen


if __name__ == "__main__":
    unittest.main()
