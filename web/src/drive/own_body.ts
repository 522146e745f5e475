import { radiansOf, type Replica } from '../protocol/replica';
import type { Joined, PhysicsShapes } from '../protocol/scene';
import type { Order } from './driver';
import { Obstacles } from './obstacles';
import { Prediction, type Place } from './prediction';
import { Walker } from './walker';

/** The viewer's own body, drawn at its predicted pose, ahead of the server's updates. */
export class OwnBody {
  readonly id: number;
  private readonly walker: Walker;
  private readonly prediction: Prediction;

  constructor({ joined, walk }: Joined, private readonly interval: number) {
    this.id = joined;
    this.walker = new Walker(walk);
    this.prediction = new Prediction(this.walker, interval);
  }

  /** The command to send, with an input number if it is for this body. */
  number(order: Order, now: number): Order & { input?: number } {
    return order.model === this.id ? { ...order, input: this.prediction.command(order, now / 1000) } : order;
  }

  counts(input: number, tick: number): void {
    this.prediction.counts(input, tick);
  }

  /** Sets the collision shapes of the body and of static obstacles. */
  meet({ fixed, bodies }: PhysicsShapes): void {
    const own = bodies.find(({ model }) => model === this.id);
    if (own) this.walker.meet(own.solids, new Obstacles(fixed));
  }

  /** A packet was applied. */
  correct(replica: Replica, now: number): void {
    const row = replica.rows.get(this.id);
    if (row === undefined) return;
    const { tick } = replica;
    const [x, y, z] = [replica.x[row] / 1000, replica.y[row] / 1000, replica.z[row] / 1000];
    this.prediction.correct({ tick, x, y, z, a: radiansOf(replica.a[row]), tickSeconds: tickSecondsOf(replica, this.interval) }, now / 1000);
  }

  /** Pose to draw. */
  at(now: number): Place | null {
    return this.prediction.at(now / 1000);
  }
}

/** Wall-clock seconds per tick; 0: time stands still. */
function tickSecondsOf({ paused, speed, realTimeFactor }: Replica, interval: number): number {
  const behind = realTimeFactor > 0 && realTimeFactor < 0.9 * speed;
  const rate = speed === 0 || behind ? realTimeFactor : speed;
  return paused || rate <= 0 ? 0 : interval / rate;
}
