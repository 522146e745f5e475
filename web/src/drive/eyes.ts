import type { Hands, Velocity } from './hands';

const kPerPixel = 0.0025; // rad
const kUpMost = 1.4; // rad, up or down
const kTurnGain = 6; // 1/s
const kTurnMost = 3; // rad/s
const kTurnLeast = 0.01; // rad; nearer than this is there
const kWalk: Velocity = { forward: 2, sideways: 0.8, turn: 1.8 }; // at full hands

/** Where somebody looks who sees the world through a model's eyes: by the mouse at once, and the body follows. */
export class Eyes {
  yaw: number; // rad, in the world
  pitch = 0; // rad, up

  constructor(heading: number) {
    this.yaw = heading;
  }

  /** The mouse moved by so many pixels. */
  look(dx: number, dy: number): void {
    this.yaw -= dx * kPerPixel;
    this.pitch = Math.min(Math.max(this.pitch - dy * kPerPixel, -kUpMost), kUpMost);
  }

  /** Looks where the body heads: it is turned otherwise than by the mouse. */
  follow(heading: number): void {
    this.yaw = heading;
  }

  /** What a body of this heading is to do: it walks as the hands want, A and D aside, and turns to where one looks. */
  walk(hands: Hands, heading: number): Velocity {
    const off = Math.atan2(Math.sin(this.yaw - heading), Math.cos(this.yaw - heading));
    const turn = hands.sideways !== 0 ? hands.sideways * kWalk.turn : Math.abs(off) < kTurnLeast ? 0 : Math.min(Math.max(kTurnGain * off, -kTurnMost), kTurnMost);
    const round = (value: number) => Math.round(value * 1000) / 1000 + 0;
    return { forward: round(hands.forward * kWalk.forward), sideways: round(hands.turn * kWalk.sideways), turn: round(turn) };
  }
}
