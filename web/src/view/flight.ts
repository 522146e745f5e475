import type { Hands } from '../drive/hands';
import type { Eye } from './camera_rig';

const kPerPixel = 0.0025; // rad
const kUpMost = 1.5; // rad, up or down
const kSpeed = { usual: 4, least: 0.2, most: 200 }; // m/s at full deflection
const kLowest = 0.05; // m above the ground

/** Free camera: no body in the world, no collision, invisible to others. */
export class Flight {
  speed = kSpeed.usual;

  constructor(readonly eye: Eye) {}

  /** Mouse movement in pixels. */
  look(dx: number, dy: number): void {
    const { eye } = this;
    eye.yaw -= dx * kPerPixel;
    eye.pitch = Math.min(Math.max(eye.pitch - dy * kPerPixel, -kUpMost), kUpMost);
  }

  faster(factor: number): void {
    this.speed = Math.min(Math.max(this.speed * factor, kSpeed.least), kSpeed.most);
  }

  /** Moves by the command for this time: A and D sideways, Q and E vertically. False if at rest. */
  move(hands: Hands, seconds: number): boolean {
    const { eye } = this;
    const way = this.speed * seconds;
    const [c, s] = [Math.cos(eye.yaw), Math.sin(eye.yaw)];
    const [ahead, left, up] = [way * hands.forward, way * hands.turn, way * hands.sideways];
    eye.x += c * Math.cos(eye.pitch) * ahead - s * left;
    eye.y += s * Math.cos(eye.pitch) * ahead + c * left;
    eye.z = Math.max(eye.z + Math.sin(eye.pitch) * ahead + up, kLowest);
    return hands.forward !== 0 || hands.turn !== 0 || hands.sideways !== 0;
  }
}
