import type { Hands, Velocity } from './hands';

const kPerPixel = 0.0025; // rad per pixel of mouse movement
const kUpMost = 1.4; // pitch limit [rad]
const kTurnGain = 6; // 1/s
const kTurnMost = 3; // rad/s
const kTurnLeast = 0.01; // rad: deadband of the heading controller
const kWalk: Velocity = { forward: 2, sideways: 0.8, turn: 1.8 }; // at full deflection

/** View direction of a first-person view: the mouse turns it at once, the body's heading follows. */
export class Eyes {
  yaw: number; // rad, in the world
  pitch = 0; // rad, up

  constructor(heading: number) {
    this.yaw = heading;
  }

  /** Mouse movement in pixels. */
  look(dx: number, dy: number): void {
    this.yaw -= dx * kPerPixel;
    this.pitch = Math.min(Math.max(this.pitch - dy * kPerPixel, -kUpMost), kUpMost);
  }

  /** Adopts the body's heading while something other than the mouse turns it. */
  follow(heading: number): void {
    this.yaw = heading;
  }

  /** Velocity command for a body of this heading: keys walk (A and D strafe), and the body turns to the view direction. */
  walk(hands: Hands, heading: number): Velocity {
    const off = Math.atan2(Math.sin(this.yaw - heading), Math.cos(this.yaw - heading));
    const turn = hands.sideways !== 0 ? hands.sideways * kWalk.turn : Math.abs(off) < kTurnLeast ? 0 : Math.min(Math.max(kTurnGain * off, -kTurnMost), kTurnMost);
    const round = (value: number) => Math.round(value * 1000) / 1000 + 0;
    return { forward: round(hands.forward * kWalk.forward), sideways: round(hands.turn * kWalk.sideways), turn: round(turn) };
  }
}
