/** The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]]. */

import { constants } from 'node:os';
import { connect, PlayerError, type Client } from '../src/index.js';

/** How long the program may still run; 0 seconds means until Ctrl-C. */
export class Clock {
  private readonly end: number;

  constructor(seconds: number) {
    this.end = seconds > 0 ? performance.now() + 1000 * seconds : Infinity;
  }

  up(): boolean {
    return performance.now() >= this.end;
  }
}

type Behaviour = (client: Client, index: number, clock: Clock, more: number[]) => Promise<void>;

/** A whole number up to 65535, else undefined. */
function whole(word: string): number | undefined {
  return /^\d+$/.test(word) && Number(word) <= 65535 ? Number(word) : undefined;
}

/** A number of seconds, 0 or more, else undefined. */
function secondsOf(word: string): number | undefined {
  return /^(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word) && Number.isFinite(Number(word)) ? Number(word) : undefined;
}

/** The exit code that is due at the first of Ctrl-C, SIGTERM and SIGHUP (the terminal was closed); later ones are ignored. */
function signalled(): Promise<number> {
  return new Promise((resolve) => {
    for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) {
      process.on(signal, () => resolve(128 + constants.signals[signal]));
    }
  });
}

/**
 * Connects, behaves, and ends with 0 when done, 1 on an error, 2 on wrong arguments, and 128 and its number on a signal
 * (130 on Ctrl-C). Closing the client stops the robot.
 */
export async function run(behave: Behaviour, usage: string): Promise<void> {
  const [address = '127.0.0.1:6665', first = '0', second = '0', ...rest] = process.argv.slice(2);
  const [index, seconds, more] = [whole(first), secondsOf(second), rest.map(whole)];
  if (index === undefined || seconds === undefined || more.includes(undefined)) {
    console.error(`usage: ${usage}`);
    process.exit(2);
  }
  let client: Client | undefined;
  const work = async (): Promise<number> => {
    client = await connect(address);
    await behave(client, index, new Clock(seconds), more as number[]);
    return 0;
  };
  let code = 1;
  try {
    code = await Promise.race([signalled(), work()]);
  } catch (error) {
    if (!(error instanceof PlayerError)) throw error;
    console.error(error.message);
  } finally {
    await client?.close();
  }
  process.exit(code); // a signal may have come while it was connecting
}
