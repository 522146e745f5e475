const kFaster = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50];
const kWaitMs = 2000; // timeout: an answer takes one or two packets; later the request was refused or overridden

/**
 * Optimistic display of the requested speed: until the server confirms it, further
 * key presses count from the request, as packets lag behind fast key presses.
 */
export class SpeedWish {
  private wish: { speed: number; until: number } | null = null;

  ask(speed: number, now: number): void {
    this.wish = { speed, until: now + kWaitMs };
  }

  /** Speed to show and to step from, given the server's current speed. */
  over(said: number, now: number): number {
    const { wish } = this;
    if (wish && (now > wish.until || Math.fround(wish.speed) === Math.fround(said))) this.wish = null;
    return this.wish?.speed ?? said;
  }
}

/** The speed `steps` away from this one; 0 (as fast as possible) counts as the fastest. */
export function fasterBy(steps: number, speed: number): number {
  const now = speed || kFaster[kFaster.length - 1];
  const nearest = kFaster.reduce((best, other, k) => (Math.abs(Math.log(other / now)) < Math.abs(Math.log(kFaster[best] / now)) ? k : best), 0);
  return kFaster[Math.min(Math.max(nearest + steps, 0), kFaster.length - 1)];
}
