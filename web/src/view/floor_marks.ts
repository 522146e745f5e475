import { Color } from 'three';
import type { Drawing, Stage } from '../kinds/kind_page';
import type { Model } from '../protocol/scene';
import { frameOf } from './frames';
import { Painted } from './painted';

type Line = [x0: number, y0: number, x1: number, y1: number];

const kLinesMost = 200; // per side of a box; coarser spacing above
const kFlat = 0.05; // m: bodies up to this height count as floor
const kAbove = 0.002; // m

/** Rectangle of a model's size, in its own frame. [m] */
export function outlineOf({ size: [length, width] }: Pick<Model, 'size'>): Line[] {
  const [x, y] = [length / 2, width / 2];
  return [[-x, -y, x, -y], [x, -y, x, y], [x, y, -x, y], [-x, y, -x, -y]];
}

/** Grid over a model's size, centred, with 1 m spacing; 10, 100, ... m for large models. [m] */
export function gridOf({ size: [length, width] }: Pick<Model, 'size'>): Line[] {
  let spacing = 1;
  while (Math.max(length, width) / spacing > kLinesMost) spacing *= 10;
  const [x, y] = [length / 2, width / 2];
  const steps = (half: number) => {
    const most = Math.floor(half / spacing);
    return Array.from({ length: 2 * most + 1 }, (_, k) => (k - most) * spacing);
  };
  return [...steps(x).map((at): Line => [at, -y, at, y]), ...steps(y).map((at): Line => [-x, at, x, at])];
}

/** Height of a model's marks above its base: on top of it if it is flat. [m] */
export function markHeight({ size: [, , height] }: Pick<Model, 'size'>): number {
  return (height <= kFlat ? height : 0) + kAbove;
}

/** Outlines and grids of models with `gui_outline` or `gui_grid`. */
export class FloorMarks implements Drawing {
  private readonly lines = new Painted('lines', 1);
  readonly object = this.lines.object;
  private readonly marks: { row: number; lines: Line[]; color: Color }[] = [];

  constructor(private readonly stage: Stage) {
    const { scene, theme } = stage;
    scene.models.forEach((model, row) => {
      if (model.grid) this.marks.push({ row, lines: gridOf(model), color: new Color(theme.axis) });
      if (model.outline) this.marks.push({ row, lines: outlineOf(model), color: new Color(theme.edge) });
    });
  }

  draw(): void {
    this.lines.begin();
    for (const { row, lines, color } of this.marks) {
      const model = this.stage.scene.models[row];
      const { x, y, z, a } = frameOf(this.stage.motion, row, model.origin);
      const height = z + markHeight(model);
      const [c, s] = [Math.cos(a), Math.sin(a)];
      const corner = (ahead: number, left: number) =>
        this.lines.corner(x + c * ahead - s * left, y + s * ahead + c * left, height, [color.r, color.g, color.b], 1);
      for (const [x0, y0, x1, y1] of lines) {
        corner(x0, y0);
        corner(x1, y1);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }
}
