const kFaster = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50];
const kWaitMs = 2000; // the program's answer takes a packet or two; after this it was refused, or somebody else chose

/**
 * The speed that this page asked for last. Until the program has it, the next key counts from here: what packets say is older
 * than the keys of somebody who presses quickly.
 */
export class SpeedWish {
  private wish: { speed: number; until: number } | null = null;

  ask(speed: number, now: number): void {
    this.wish = { speed, until: now + kWaitMs };
  }

  /** The speed to show and to count from, when the program says this one. */
  over(said: number, now: number): number {
    const { wish } = this;
    if (wish && (now > wish.until || Math.fround(wish.speed) === Math.fround(said))) this.wish = null;
    return this.wish?.speed ?? said;
  }
}

/** The speed so many steps from this one; 0 (as fast as possible) counts as the fastest. */
export function fasterBy(steps: number, speed: number): number {
  const now = speed || kFaster[kFaster.length - 1];
  const nearest = kFaster.reduce((best, other, k) => (Math.abs(Math.log(other / now)) < Math.abs(Math.log(kFaster[best] / now)) ? k : best), 0);
  return kFaster[Math.min(Math.max(nearest + steps, 0), kFaster.length - 1)];
}
