/**
 * Follows a marker and keeps a metre away from it.
 *
 *     follow.js [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]
 *
 * Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any number), seen by
 * the fiducial finder FINDER (INDEX).
 */

import type { Client, Marker } from '../src/index.js';
import { run, type Clock } from './program.js';

const kDistance = 1.0; // m
const kSpeed = 0.5; // m/s
const kTurn = 1.0; // rad/s

async function follow(client: Client, index: number, clock: Clock, [wanted, number = index]: number[]): Promise<void> {
  const robot = await client.position2d(index);
  const finder = await client.fiducial(number);
  let lostToTheLeft = true;
  for await (const markers of finder.updates()) {
    if (clock.up()) break;
    const marker = choose(markers, wanted);
    if (!marker) {
      // Marker lost: search, turning first to the side where it was last seen.
      await robot.drive(0, lostToTheLeft ? kTurn / 2 : -kTurn / 2);
      continue;
    }
    lostToTheLeft = marker.bearing > 0;
    const speed = Math.max(-kSpeed, Math.min(kSpeed, marker.distance - kDistance));
    const turn = Math.max(-kTurn, Math.min(kTurn, 2 * marker.bearing));
    await robot.drive(Math.abs(marker.bearing) < 1 ? speed : 0, turn);
  }
}

/** The nearest marker of the wanted number. */
function choose(markers: Marker[], wanted: number | undefined): Marker | undefined {
  const fitting = markers.filter(({ id }) => wanted === undefined || id === wanted);
  return fitting.sort((a, b) => a.distance - b.distance)[0];
}

await run(follow, 'follow.js [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]');
