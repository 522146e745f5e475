import type { Motion } from '../motion';
import type { Scene } from '../protocol/scene';
import type { CameraRig } from './camera_rig';
import type { Theme } from './theme';

const kLabelsMost = 250;
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
    let left = kLabelsMost;
    for (const label of this.labels) {
      const strong = emphasized.includes(label.row);
      if (!strong && (left <= 0 || rig.scale < kScaleLeast)) continue;
      const text = this.textOf(label, strong);
      if (text && this.write(label, text, strong)) --left;
    }
  }

  private textOf(label: Label, strong: boolean): string {
    const name = strong || this.names ? label.name : '';
    const id = this.ids ? label.id : '';
    return name && id ? `${name} ${id}` : name || id;
  }

  private write(label: Label, text: string, strong: boolean): boolean {
    const { pen, rig, motion, theme } = this;
    const at = rig.pixelOf(motion.x[label.row], motion.y[label.row], motion.z[label.row] + label.height);
    if (!at || at.x < -50 || at.y < -20 || at.x > rig.width + 50 || at.y > rig.height + 40) return false;
    const y = at.y - Math.min(Math.max(rig.scale * 0.3, 12), 46);
    pen.font = `${strong ? 600 : 500} ${strong ? 13 : 12}px system-ui, sans-serif`;
    pen.strokeStyle = theme.halo;
    pen.lineWidth = 3.5;
    pen.strokeText(text, at.x, y);
    pen.fillStyle = theme.text;
    pen.fillText(text, at.x, y);
    return true;
  }
}
