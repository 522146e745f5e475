import { Color } from 'three';
import type { Rgba } from '../protocol/scene';
import { Painted } from './painted';

/** Parts of a plane at a height, in one color: all that can be seen from the first corner of an outline of x, y, x, y, ... */
export type Area = [color: Rgba, z: number, outline: number[]];

const kLift = 0.001; // m, over what is as high

/** Areas that one can see through. */
export class Areas {
  private readonly fill = new Painted('triangles', 5);
  readonly object = this.fill.object;

  lay(areas: Area[]): void {
    this.fill.begin();
    for (const [[red, green, blue, alpha], z, outline] of areas) {
      const { r, g, b } = new Color().setRGB(red, green, blue, 'srgb');
      for (let k = 2; k + 3 < outline.length; k += 2) {
        for (const at of [0, k, k + 2]) this.fill.corner(outline[at], outline[at + 1], z + kLift, [r, g, b], alpha);
      }
    }
    this.fill.end();
  }
}
