import { isStill, kStill, type Velocity } from './hands';

const kRenewMs = 150; // the server stops a robot whose velocity command is not renewed within 0.5 s
const kLeastMs = 40; // minimum interval between commands of a moving stick

export interface Order extends Velocity {
  model: number;
}

/** Commands for the driven robot: changes at once, renewal before the server's timeout, and one stop. */
export class Driver {
  private last: Order | null = null; // null: nothing is driven
  private lastTime = 0;

  get driven(): number | null {
    return this.last?.model ?? null;
  }

  /** Commands to send now for the wanted velocity of this model; null: no model is driven. */
  next(model: number | null, velocity: Velocity, now: number): Order[] {
    const orders: Order[] = [];
    if (this.last && this.last.model !== model) orders.push(...this.stop());
    if (model === null) return orders;
    if (isStill(velocity)) return this.stop();
    if (this.last && !this.isDue(velocity, now)) return orders;
    this.last = { model, ...velocity };
    this.lastTime = now;
    orders.push(this.last);
    return orders;
  }

  /** The connection is lost: drop the state, there is no server to send a stop to. */
  forget(): void {
    this.last = null;
  }

  private stop(): Order[] {
    const { last } = this;
    this.last = null;
    return last ? [{ model: last.model, ...kStill }] : [];
  }

  private isDue({ forward, sideways, turn }: Velocity, now: number): boolean {
    const same = this.last?.forward === forward && this.last.sideways === sideways && this.last.turn === turn;
    return now - this.lastTime >= (same ? kRenewMs : kLeastMs);
  }
}
