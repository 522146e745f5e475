import { Color } from 'three';
import type { Rgba } from '../protocol/scene';
import { Painted } from './painted';

/** Visible region of a plane at a height, in one colour: a polygon x, y, ... star-shaped about its first corner. */
export type Area = [color: Rgba, z: number, outline: number[]];

const kLift = 0.001; // m, offset above coplanar surfaces

/** Translucent areas. */
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
