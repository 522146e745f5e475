import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from 'three';
import type { Box } from './camera_rig';
import type { Theme } from './theme';

const kLinesMost = 400;
const kPixelsLeast = 8;

/** Floor grid: a line per metre, every fifth emphasised; coarser in large worlds. */
export class Ground {
  readonly group = new Group();
  private readonly lines: LineSegments[] = [];
  private spacing = 1; // m

  constructor(extent: Box, theme: Theme) {
    const size = Math.max(extent.x_max - extent.x_min, extent.y_max - extent.y_min, 10);
    while ((size * 2) / this.spacing > kLinesMost) this.spacing *= 10;
    const { spacing } = this;
    const snap = (value: number, round: (v: number) => number) => round(value / (5 * spacing)) * 5 * spacing;
    const box = {
      x_min: snap(extent.x_min - size / 4, Math.floor),
      y_min: snap(extent.y_min - size / 4, Math.floor),
      x_max: snap(extent.x_max + size / 4, Math.ceil),
      y_max: snap(extent.y_max + size / 4, Math.ceil),
    };
    this.add(box, spacing, theme.grid, (k) => k % 5 !== 0);
    this.add(box, spacing, theme.axis, (k) => k % 5 === 0);
  }

  /** Hides lines that would be closer than a few pixels. */
  adapt(pixelsPerMetre: number): void {
    this.lines[0].visible = pixelsPerMetre * this.spacing >= kPixelsLeast;
  }

  dispose(): void {
    for (const line of this.lines) line.geometry.dispose();
  }

  private add(box: Box, spacing: number, color: number, wanted: (k: number) => boolean): void {
    const points: number[] = [];
    for (let x = box.x_min; x <= box.x_max + 1e-6; x += spacing) {
      if (wanted(Math.round(x / spacing))) points.push(x, box.y_min, 0, x, box.y_max, 0);
    }
    for (let y = box.y_min; y <= box.y_max + 1e-6; y += spacing) {
      if (wanted(Math.round(y / spacing))) points.push(box.x_min, y, 0, box.x_max, y, 0);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    const lines = new LineSegments(geometry, new LineBasicMaterial({ color }));
    lines.renderOrder = -1;
    this.lines.push(lines);
    this.group.add(lines);
  }
}
