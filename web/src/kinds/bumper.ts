import { Color, Group } from 'three';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees } from '../ui/texts';
import { frameOf } from '../view/frames';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'bumper', panel, drawings: (stage) => [new Faces(stage)] } satisfies KindPage;

const kListed = 12; // in the panel
const kThick = 0.03; // m, of the bar that shows a face
const kFree = new Color(0x2f9e44);
const kPressed = new Color(0xe03131);

const isPressed = ({ hit }: { hit: number }) => hit >= 0;

/** Faces of bumper switches: a line each, and a bar if pressed; drawn over the bodies that press them. */
class Faces implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly bars = new Painted('triangles', 5, { depthTest: false });
  private readonly lines = new Painted('lines', 6, { depthTest: false });

  constructor(private readonly stage: Stage) {
    this.object.add(this.bars.object, this.lines.object);
  }

  draw(): void {
    const { scene, replica } = this.stage;
    this.bars.begin();
    this.lines.begin();
    for (const [row, switches] of replica.views('bumper')) {
      switches.forEach((one, k) => this.face(row, scene.models[row], k, isPressed(one)));
    }
    this.bars.end();
    this.lines.end();
  }

  dispose(): void {
    this.bars.dispose();
    this.lines.dispose();
  }

  private face(row: number, { origin, bpose = [], blength = [] }: Model, k: number, pressed: boolean): void {
    if (!bpose[k]) return;
    const { x, y, z, a } = frameOf(this.stage.motion, row, origin, bpose[k]);
    const [c, s] = [Math.cos(a), Math.sin(a)];
    const half = blength[k] / 2;
    const { r, g, b } = pressed ? kPressed : kFree;
    const at = (ahead: number, left: number, to: Painted) =>
      to.corner(x + c * ahead - s * left, y + s * ahead + c * left, z, [r, g, b], 1);
    at(0, -half, this.lines);
    at(0, half, this.lines);
    if (!pressed) return;
    for (const [ahead, left] of [[0, -half], [0, half], [kThick, half], [0, -half], [kThick, half], [kThick, -half]]) at(ahead, left, this.bars);
  }
}

function panel(model: Model, { replica, row, line, detail, codes }: PanelTools): Node[] {
  const { bpose = [] } = model;
  const view = () => replica().views('bumper').get(row(model.id));
  const who = (hit: number) => replica().scene.models[replica().rows.get(hit) ?? -1]?.name ?? 'one that went';
  const state = (k: number) => {
    const one = view()?.[k];
    return !one ? 'no data yet' : isPressed(one) ? `pressed by ${who(one.hit)}` : 'free';
  };
  const count = () => `${view()?.filter(isPressed).length ?? 0} of ${bpose.length} pressed`;
  const lines = bpose.slice(0, kListed).map((pose, k) => line(`switch ${k}, ${degrees(pose[3])}`, () => state(k), `switch-${k}`));
  return [el('h3', {}, 'Bumper', ...codes(model), detail(count, 'bumper')), el('table', {}, ...lines)];
}
