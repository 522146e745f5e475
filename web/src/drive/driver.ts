import { isStill, kStill, type Velocity } from './hands';

const kRenewMs = 150; // the program stops a robot whose velocity is not renewed for half a second
const kLeastMs = 40; // between two velocities of a stick on its way

export interface Order extends Velocity {
  model: number;
}

/** What to tell the program of one robot that is driven: changes at once, the same again before it ends, and one stop. */
export class Driver {
  private last: Order | null = null; // null: nothing is driven
  private lastTime = 0;

  get driven(): number | null {
    return this.last?.model ?? null;
  }

  /** Orders to send now, for what the hands want of this model; null: of none. */
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

  /** The connection is gone: nobody is there to be told. */
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
