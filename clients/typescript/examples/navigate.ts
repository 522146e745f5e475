/**
 * Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
 *
 *     navigate.js [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is done)
 */

import type { Client } from '../src/index.js';
import { run, type Clock } from './program.js';

const kPlaces = [{ x: 6, y: 4, a: 1.5 }, { x: -5.8, y: 5, a: 3 }]; // m, m, rad

async function navigate(client: Client, index: number, clock: Clock): Promise<void> {
  const planner = await client.planner(index);
  for (const place of kPlaces) {
    await planner.goTo(place);
    for await (const { pose } of planner.updates()) {
      if (clock.up()) return;
      if (!planner.arrived) continue;
      console.log(`arrived at (${pose.x.toFixed(2)}, ${pose.y.toFixed(2)}) m`);
      break;
    }
  }
}

await run(navigate, 'navigate.js [HOST:PORT [INDEX [SECONDS]]]');
