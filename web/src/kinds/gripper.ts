import {
  BoxGeometry, Color, DynamicDrawUsage, EdgesGeometry, Group, InstancedMesh, Matrix4, MeshLambertMaterial, type LineBasicMaterial,
} from 'three';
import type { GripperView } from '../protocol/generated/views';
import { kSubscribed } from '../protocol/replica';
import type { Model } from '../protocol/scene';
import { followers } from '../view/bodies';
import { frameOf } from '../view/frames';
import { Painted } from '../view/painted';
import { el } from '../ui/dom';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'gripper', panel, drawings: (stage) => [new Paddles(stage), new Beams(stage)] } satisfies KindPage;

const kSides = [1, -1]; // left, right
// How far behind the front a beam is, as a fraction of the length, the inner one first.
const kInsets = [0.75 * 0.66, 0.25 * 0.66];
const kFree = new Color(0x2f9e63);
const kBroken = new Color(0xd5372c);

/** Distance of the inner paddle faces from the centre line. [m] */
export function faceOf({ size, paddle: [, width] = [0, 0, 0] }: Model, closed: number): number {
  return (1 - closed) * Math.max(0, 0.5 - width) * size[1];
}

/** State of the paddles in words. */
export function paddlesText({ paddles, closing, held }: GripperView): string {
  const done = `${Math.round(paddles * 100)} %`;
  if (closing < 0) return `opening, ${done}`;
  if (held >= 0 || paddles >= 1) return `closed${paddles < 1 ? `, ${done}` : ''}`;
  if (closing > 0) return `closing, ${done}`;
  return paddles > 0 ? `stopped, ${done}` : 'open';
}

export function liftText({ lift, rising }: GripperView): string {
  if (rising !== 0) return `${rising > 0 ? 'rising' : 'sinking'}, ${Math.round(lift * 100)} %`;
  return lift >= 1 ? 'up' : lift > 0 ? `stopped, ${Math.round(lift * 100)} %` : 'down';
}

/** Names of the set bits: the first for bit 1, the second for bit 2. */
export function bitsText(bits: number, names: [string, string]): string {
  return bits === 0 ? 'none' : names.filter((_, k) => bits & (1 << k)).join(', ');
}

/** Paddles of grippers with the default body, at their current positions. */
class Paddles implements Drawing {
  readonly object = new Group();
  private readonly rows: number[];
  private readonly mesh: InstancedMesh;
  private readonly edges;
  private readonly matrix = new Matrix4();
  private readonly color = new Color();

  constructor(private readonly stage: Stage) {
    this.rows = [...stage.scene.models.keys()].filter((row) => stage.scene.models[row].kind === 'gripper' && stage.scene.models[row].moving);
    const box = new BoxGeometry(1, 1, 1).translate(0.5, 0.5, 0.5);
    this.mesh = new InstancedMesh(box, new MeshLambertMaterial(), this.rows.length * kSides.length);
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.edges = followers(new EdgesGeometry(box), this.mesh, 1, stage.theme);
    this.object.add(this.mesh, this.edges);
  }

  draw(): void {
    if (this.rows.length === 0) return;
    const { replica } = this.stage;
    const views = replica.views('gripper');
    this.rows.forEach((row, k) => {
      const { paddles, lift } = views.get(row) ?? { paddles: 0, lift: 0 };
      kSides.forEach((side, i) => {
        this.mesh.setMatrixAt(kSides.length * k + i, this.paddleMatrix(row, side, paddles, lift));
        this.mesh.setColorAt(kSides.length * k + i, this.color.setHex(replica.color[row] >>> 8));
      });
    });
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.instanceColor!.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.dispose();
    (this.mesh.material as MeshLambertMaterial).dispose();
    this.edges.geometry.dispose();
    (this.edges.material as LineBasicMaterial).dispose();
  }

  /** Transform of a unit box [0, 1]^3 to a paddle. */
  private paddleMatrix(row: number, side: number, closed: number, lift: number): Matrix4 {
    const model = this.stage.scene.models[row];
    const { size: [sx, sy, sz], paddle: [length, width, height] = [0, 0, 0] } = model;
    const { x, y, z, a } = frameOf(this.stage.motion, row, model.origin);
    const [c, s] = [Math.cos(a), Math.sin(a)];
    const [along, across, up] = [length * sx, Math.min(width, 0.5) * sy, height * sz];
    const face = faceOf(model, closed);
    const px = sx / 2 - along;
    const py = side > 0 ? face : -face - across;
    return this.matrix.set(
      c * along, -s * across, 0, x + c * px - s * py,
      s * along, c * across, 0, y + s * px + c * py,
      0, 0, up, z + lift * (1 - height) * sz,
      0, 0, 0, 1,
    );
  }
}

/** Break beams between the paddles of grippers in use. */
class Beams implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly lines = new Painted('lines', 4);

  constructor(private readonly stage: Stage) {
    this.object.add(this.lines.object);
  }

  draw(): void {
    const { scene, replica } = this.stage;
    this.lines.begin();
    for (const [row, { paddles, beams }] of replica.views('gripper')) {
      if (!(replica.state[row] & kSubscribed)) continue;
      const model = scene.models[row];
      const { x, y, z, a } = frameOf(this.stage.motion, row, model.origin);
      const [c, s] = [Math.cos(a), Math.sin(a)];
      const face = faceOf(model, paddles);
      kInsets.forEach((inset, beam) => {
        const { r, g, b } = beams & (1 << beam) ? kBroken : kFree;
        const px = (0.5 - inset) * model.size[0];
        for (const side of kSides) this.lines.corner(x + c * px - s * side * face, y + s * px + c * side * face, z + 0.02, [r, g, b], 0.9);
      });
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }
}

function panel(model: Model, { replica, row, line, codes }: PanelTools): Node[] {
  const told = (text: (now: GripperView) => string) => () => {
    const now = replica().views('gripper').get(row(model.id));
    return now ? text(now) : '–';
  };
  const measured = (text: (now: GripperView) => string) =>
    told((now) => (replica().state[row(model.id)] & kSubscribed ? text(now) : 'nobody uses it'));
  const nameOf = (id: number) => replica().scene.models[replica().rows.get(id) ?? -1]?.name ?? 'nothing';
  return [
    el('h3', {}, 'Gripper', ...codes(model)),
    el('table', {},
      line('paddles', told(paddlesText), 'paddles'),
      line('lift', told(liftText), 'lift'),
      line('holds', told(({ held }) => nameOf(held)), 'holds'),
      line('beams broken', measured(({ beams }) => bitsText(beams, ['inner', 'outer'])), 'beams'),
      line('touched', measured(({ contacts }) => bitsText(contacts, ['left', 'right'])), 'contacts'),
    ),
  ];
}
