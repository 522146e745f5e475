/** Who is to blame when nothing new is shown: the silent program, or this page, too slow to draw. */
export type Verdict = 'live' | 'silent' | 'slow';

const kPatienceMs = 4000; // the program sends a message a second at least, unless it waits for this page
const kStandstillMs = 2000; // between two looks: this page stood still and could hear nothing

/**
 * Watches the connection and this page's own drawing. The program waits for the acknowledgement of what
 * it has sent, which follows when that is drawn: only while the page owes none is silence the program's.
 * Times in ms.
 */
export class Watchdog {
  private heardAt: number;
  private owedSince: number | null = null; // oldest packet that is not drawn yet
  private slowUntil = -Infinity;
  private looked: number;

  constructor(now: number) {
    this.heardAt = this.looked = now;
  }

  /** Something came from the program. */
  heard(now: number): void {
    this.heardAt = now;
  }

  /** It was a packet, which is to be drawn. */
  owes(now: number): void {
    this.owedSince ??= now;
  }

  /** All packets so far are drawn and acknowledged: now it is the program's turn. */
  drew(now: number): void {
    if (this.owedSince !== null && now - this.owedSince > kPatienceMs) this.slowUntil = now + kPatienceMs;
    this.owedSince = null;
    this.heardAt = now;
  }

  /** Starts anew: after another connection, or as a hidden page is shown again, which drew nothing meanwhile. */
  rest(now: number): void {
    this.heardAt = this.looked = now;
    this.owedSince = null;
    this.slowUntil = -Infinity;
  }

  /** To be called more often than every two seconds. */
  look(now: number): void {
    if (now - this.looked > kStandstillMs) this.heardAt = now;
    this.looked = now;
  }

  verdict(now: number): Verdict {
    if (now < this.slowUntil || (this.owedSince !== null && now - this.owedSince > kPatienceMs)) return 'slow';
    return this.owedSince === null && now - this.heardAt > kPatienceMs ? 'silent' : 'live';
  }
}
