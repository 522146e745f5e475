/** For test programs: what they insist on, and how they end. */

import { RequestRefused } from '../src/index.js';

export function mustBe(fact: boolean, what: string): asserts fact {
  if (!fact) throw new Error(`it is not true that ${what}`);
}

export async function mustRefuse(asked: Promise<unknown>, what: string): Promise<void> {
  const fault = await asked.then(() => undefined, (error: unknown) => error);
  if (!(fault instanceof RequestRefused)) throw new Error(`the server should have refused ${what}, but: ${String(fault)}`);
}

/** Runs the use of this name: PROGRAM NAME HOST:PORT. Prints what fails, and exits with 1 then. */
export async function main(uses: Record<string, (address: string) => Promise<void>>, usage: string): Promise<void> {
  const [name = '', address] = process.argv.slice(2);
  try {
    const use = uses[name];
    if (!use || address === undefined) throw new Error(`usage: ${usage}`);
    await use(address);
  } catch (error) {
    console.error((error as Error).message);
    process.exit(1); // with connections that are still open
  }
}
