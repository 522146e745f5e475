/** Longest time of a timer of Node.js, in s. */
const kLongestTimer = 2 ** 31 / 1000 - 1;

/** The present, in s, of a clock that is never set. */
export function now(): number {
  return performance.now() / 1000;
}

/** Lets any number of tasks wait until another one calls ring(). */
export class Bell {
  private readonly waiting = new Set<(rung: boolean) => void>();

  /** Ends all waits that have begun. */
  ring(): void {
    if (this.waiting.size === 0) return;
    const rung = [...this.waiting];
    this.waiting.clear();
    for (const end of rung) end(true);
  }

  /** Whether it rings before the deadline, a time of now(). What has arrived by then may still ring. */
  wait(deadline: number): Promise<boolean> {
    return new Promise((resolve) => {
      const end = (rung: boolean): void => {
        cancel();
        this.waiting.delete(end);
        resolve(rung);
      };
      const cancel = after(deadline - now(), () => end(false));
      this.waiting.add(end);
    });
  }
}

/** Calls `act` after this time in s, never if that is longer than a timer can be; returns what cancels it. */
export function after(seconds: number, act: () => void): () => void {
  if (seconds > kLongestTimer) return () => {};
  const timer = setTimeout(act, Math.max(1, 1000 * seconds));
  return () => clearTimeout(timer);
}
