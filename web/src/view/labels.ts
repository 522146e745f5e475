import type { Motion } from '../motion';
import { nameWithMarker, type Scene } from '../protocol/scene';
import type { CameraRig } from './camera_rig';
import { Places } from './places';
import type { Theme } from './theme';

export const kLine = 14; // px
const kBodyLeast = 9; // px: smaller robots would be hidden by their names
const kLabelsMost = 250;

interface Label {
  id: number;
  row: number;
  height: number;
  size: number; // m, of the body
  robot: boolean;
  name: string;
  long: string; // with its marker's number
}

/** Offset of a name above the centre of a body of this size, in pixels. */
export function nameHeight(size: number, scale: number): number {
  return Math.min(Math.max(size * scale * 0.62, 10), 46);
}

/** Names of robots and of models with fiducial markers, drawn on the overlay where there is room. */
export class Labels {
  names = true;
  markers = true;
  /** Rows named in the last frame; they have priority, to avoid flicker where space is short. */
  written = new Set<number>();
  private readonly labels: Label[] = [];
  private readonly places = new Places();
  private readonly pen: CanvasRenderingContext2D;

  constructor(
    scene: Scene,
    private readonly motion: Motion,
    private readonly rig: CameraRig,
    private readonly canvas: HTMLCanvasElement,
    private readonly theme: Theme,
    before: Labels | null = null,
  ) {
    const written = new Set(before?.labels.filter(({ row }) => before.written.has(row)).map(({ id }) => id));
    this.pen = canvas.getContext('2d')!;
    scene.models.forEach((model, row) => {
      const robot = model.kind === 'position';
      if (model.parent >= 0 || !(robot || model.fiducial || model.movable)) return;
      this.labels.push({ id: model.id, row, robot, height: model.size[2], size: Math.max(model.size[0], model.size[1]), name: model.name, long: nameWithMarker(model) });
      if (written.has(model.id)) this.written.add(row);
    });
  }

  /** Emphasised rows are always named, in full. */
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
    this.places.clear();
    const before = this.written;
    this.written = new Set();
    for (const label of this.labels) if (emphasized.includes(label.row)) this.write(label, true);
    const others = this.labels.filter((label) => !emphasized.includes(label.row) && this.isWanted(label));
    for (const label of others) if (before.has(label.row)) this.write(label, false);
    for (const label of others) if (!before.has(label.row)) this.write(label, false);
  }

  private isWanted({ robot, size, long, name }: Label): boolean {
    return this.names && (robot || (this.markers && long !== name)) && size * this.rig.scale >= kBodyLeast;
  }

  private write(label: Label, strong: boolean): void {
    const { pen, rig, motion, theme } = this;
    if (!strong && this.written.size >= kLabelsMost) return;
    const at = rig.pixelOf(motion.x[label.row], motion.y[label.row], motion.z[label.row] + label.height);
    if (!at || at.x < -50 || at.y < -20 || at.x > rig.width + 50 || at.y > rig.height + 40) return;
    const text = strong ? label.long : label.name;
    pen.font = `${strong ? 600 : 500} ${strong ? 13 : 12}px system-ui, sans-serif`;
    const above = at.y - nameHeight(label.size, rig.scale);
    const width = pen.measureText(text).width;
    if (!this.places.take(at.x, above, width, kLine) && !strong) return;
    this.written.add(label.row);
    pen.strokeStyle = theme.halo;
    pen.lineWidth = 3.5;
    pen.strokeText(text, at.x, above);
    pen.fillStyle = theme.text;
    pen.fillText(text, at.x, above);
  }
}
