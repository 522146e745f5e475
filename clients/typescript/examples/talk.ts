/**
 * Tells the other robots by radio where it is, twice a second, and prints what it hears of them.
 *
 *     talk.js [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C)
 *
 * Start it once for each robot that is to talk: it only looks at the robot, and whoever drives it goes on.
 */

import { Access, type Client } from '../src/index.js';
import { run, type Clock } from './program.js';

const kPeriod = 0.5; // s, simulated

async function talk(client: Client, index: number, clock: Clock): Promise<void> {
  const robot = await client.position2d(index, Access.READ);
  const radio = await client.opaque(index);
  let nextTime = 0;
  for await (const { pose, time } of robot.updates()) {
    if (clock.up()) break;
    for (const message of radio.takeMessages()) {
      console.log(`${time.toFixed(1)} s: ${new TextDecoder().decode(message)}`);
    }
    if (time >= nextTime) {
      await radio.send(`robot ${index} is at ${pose.x.toFixed(2)} ${pose.y.toFixed(2)}`);
      nextTime = time + kPeriod;
    }
  }
}

await run(talk, 'talk.js [HOST:PORT [INDEX [SECONDS]]]');
