import type { Motion } from '../motion';
import type { Scene } from '../protocol/scene';
import type { CameraRig } from './camera_rig';
import type { Theme } from './theme';

const kLabelsMost = 250;
const kLine = 14; // px
const kScaleLeast = 14; // pixels per metre: below, names would cover the robots

interface Label {
  row: number;
  height: number;
  name: string; // empty: only the marker's id
  id: string;
}

/** Names of robots and ids of markers, written over the picture. */
export class Labels {
  names = true;
  ids = true;
  private readonly labels: Label[] = [];
  private readonly written: { x: number; y: number; width: number }[] = [];
  private readonly pen: CanvasRenderingContext2D;

  constructor(
    scene: Scene,
    private readonly motion: Motion,
    private readonly rig: CameraRig,
    private readonly canvas: HTMLCanvasElement,
    private readonly theme: Theme,
  ) {
    this.pen = canvas.getContext('2d')!;
    scene.models.forEach((model, row) => {
      const robot = model.kind === 'position' && model.parent < 0;
      const id = model.fiducial && model.parent < 0 ? `#${model.fiducial}` : '';
      if (robot || id) this.labels.push({ row, height: model.size[2], name: robot ? model.name : '', id });
    });
  }

  /** The emphasized rows are always named. */
  draw(emphasized: (number | null)[]): void {
    const { pen, canvas, rig } = this;
    const ratio = window.devicePixelRatio;
    if (canvas.width !== Math.round(rig.width * ratio) || canvas.height !== Math.round(rig.height * ratio)) {
      canvas.width = Math.round(rig.width * ratio);
      canvas.height = Math.round(rig.height * ratio);
    }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, rig.width, rig.height);
    pen.textAlign = 'center';
    pen.lineJoin = 'round';
    this.written.length = 0;
    for (const label of this.labels) {
      if (emphasized.includes(label.row)) this.write(label, this.textOf(label, true), true);
    }
    if (rig.scale < kScaleLeast) return;
    for (const label of this.labels) {
      if (this.written.length >= kLabelsMost) break;
      if (!emphasized.includes(label.row)) this.write(label, this.textOf(label, false), false);
    }
  }

  private textOf(label: Label, strong: boolean): string {
    const name = strong || this.names ? label.name : '';
    const id = this.ids ? label.id : '';
    return name && id ? `${name} ${id}` : name || id;
  }

  private write(label: Label, text: string, strong: boolean): void {
    const { pen, rig, motion, theme } = this;
    const at = rig.pixelOf(motion.x[label.row], motion.y[label.row], motion.z[label.row] + label.height);
    if (!text || !at || at.x < -50 || at.y < -20 || at.x > rig.width + 50 || at.y > rig.height + 40) return;
    pen.font = `${strong ? 600 : 500} ${strong ? 13 : 12}px system-ui, sans-serif`;
    const above = at.y - Math.min(Math.max(rig.scale * 0.3, 12), 46);
    const free = this.freeLine(at.x, above, pen.measureText(text).width);
    if (free === null && !strong) return;
    const y = free ?? above;
    pen.strokeStyle = theme.halo;
    pen.lineWidth = 3.5;
    pen.strokeText(text, at.x, y);
    pen.fillStyle = theme.text;
    pen.fillText(text, at.x, y);
  }

  /** A height near y where a text this wide covers no other; null when there is none. */
  private freeLine(x: number, y: number, width: number): number | null {
    const covers = (line: number) =>
      this.written.some((other) => Math.abs(other.x - x) < (other.width + width) / 2 + 4 && Math.abs(other.y - line) < kLine);
    for (const line of [y, y - kLine, y - 2 * kLine]) {
      if (covers(line)) continue;
      this.written.push({ x, y: line, width });
      return line;
    }
    return null;
  }
}
