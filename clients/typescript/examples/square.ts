/**
 * Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
 *
 *     square.js [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)
 */

import type { Client, Pose, Position2d } from '../src/index.js';
import { run, type Clock } from './program.js';

const kSide = 1.5; // m
const kReached = 0.03; // m
const kAligned = 0.02; // rad
const kSpeed = 0.4; // m/s
const kTurn = 1.0; // rad/s

async function square(client: Client, index: number, clock: Clock): Promise<void> {
  const robot = await client.position2d(index);
  await robot.nextData();
  const start = robot.pose;
  await visitCorners(robot, start, clock);
  for await (const state of robot.updates()) {
    const aside = normalized(start.a - state.pose.a);
    if (clock.up() || Math.abs(aside) < kAligned) break;
    await robot.drive(0, limited(2 * aside));
  }
  await robot.close();
}

async function visitCorners(robot: Position2d, start: Pose, clock: Clock): Promise<void> {
  const corners = [[kSide, 0], [kSide, kSide], [0, kSide], [0, 0]] as const;
  let reached = 0;
  for await (const state of robot.updates()) {
    const corner = corners[reached];
    if (clock.up() || !corner) return;
    const here = seenFrom(start, state.pose);
    const [ahead, left] = [corner[0] - here.x, corner[1] - here.y];
    if (Math.hypot(ahead, left) < kReached) {
      reached += 1;
      console.log(`corner ${reached} at (${here.x.toFixed(2)}, ${here.y.toFixed(2)}) m`);
      await robot.stop();
      continue;
    }
    const aside = normalized(Math.atan2(left, ahead) - here.a);
    const speed = Math.abs(aside) > 0.15 ? 0 : Math.min(kSpeed, Math.max(0.05, Math.hypot(ahead, left)));
    await robot.drive(speed, limited(2 * aside));
  }
}

/** The same place in the frame of `origin`. */
function seenFrom(origin: Pose, pose: Pose): Pose {
  const [dx, dy] = [pose.x - origin.x, pose.y - origin.y];
  const [c, s] = [Math.cos(origin.a), Math.sin(origin.a)];
  return { x: c * dx + s * dy, y: c * dy - s * dx, a: normalized(pose.a - origin.a) };
}

function normalized(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

function limited(turn: number): number {
  return Math.max(-kTurn, Math.min(kTurn, turn));
}

await run(square, 'square.js [HOST:PORT [INDEX [SECONDS]]]');
