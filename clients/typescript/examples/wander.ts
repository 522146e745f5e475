/**
 * Wanders about by laser and runs into nothing.
 *
 *     wander.js [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)
 */

import type { Client } from '../src/index.js';
import { run, type Clock } from './program.js';

const kSpeed = 0.4; // m/s
const kTurn = 0.8; // rad/s
const kFront = 0.5; // rad to either side that the robot needs to pass
const kNear = 0.6; // m

async function wander(client: Client, index: number, clock: Clock): Promise<void> {
  const robot = await client.position2d(index);
  const laser = await client.laser(index);
  let turning = 0;
  for await (const scan of laser.updates()) {
    if (clock.up()) break;
    const ahead = scan.nearest(-kFront, kFront);
    const [left, right] = [scan.nearest(kFront, 1.5), scan.nearest(-1.5, -kFront)];
    if (ahead < kNear) {
      turning ||= left > right ? kTurn : -kTurn; // latched until the way ahead is clear
      await robot.drive(0, turning);
    } else {
      turning = 0;
      const sway = Math.min(left, right) < kNear ? 0.5 * (left - right) : 0;
      await robot.drive(Math.min(kSpeed, ahead - kNear + 0.1), Math.max(-kTurn, Math.min(kTurn, sway)));
    }
  }
}

await run(wander, 'wander.js [HOST:PORT [INDEX [SECONDS]]]');
