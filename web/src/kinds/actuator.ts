import { Color, Group } from 'three';
import { kBits } from '../protocol/generated/views';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees, metres } from '../ui/texts';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'actuator', panel, drawings: (stage) => [new Ways(stage)] } satisfies KindPage;

const kWay = new Color(0xe8590c);
const kTurn = Math.PI / 32; // step of an arc

const turns = ({ joint }: Model) => joint === 'rotational';

/** The path or the arc of each actuator of the selected robot, between its limits. */
class Ways implements Drawing {
  readonly object = new Group();
  private readonly lines = new Painted('lines', 6, { depthTest: false });

  constructor(private readonly stage: Stage) {
    this.object.add(this.lines.object);
  }

  draw(): void {
    const { scene, replica } = this.stage;
    this.lines.begin();
    for (const [row, { position }] of replica.views('actuator')) {
      const model = scene.models[row];
      if (turns(model)) this.arc(row, model, position);
      else this.way(row, model, position);
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }

  private way(row: number, { axis = [1, 0, 0], lowest = 0, highest = 0 }: Model, position: number): void {
    const length = Math.hypot(...axis);
    const [x, y, z] = length > 0 ? axis.map((part) => part / length) : [1, 0, 0];
    for (const end of [lowest, highest]) {
      const along = end - position;
      this.corner(row, x * along, y * along, z * along);
    }
  }

  private arc(row: number, { axis = [0, 0, 0], lowest = 0, highest = 0, size }: Model, position: number): void {
    const sense = axis[2] < 0 ? -1 : 1;
    const radius = 0.75 * Math.max(size[0], size[1]);
    const from = Math.max(lowest, position - Math.PI);
    const to = Math.min(highest, position + Math.PI);
    const corner = (at: number) => {
      const bearing = sense * (at - position);
      this.corner(row, radius * Math.cos(bearing), radius * Math.sin(bearing), 0);
    };
    for (let at = from; at < to; at += kTurn) {
      corner(at);
      corner(Math.min(at + kTurn, to));
    }
  }

  /** Adds a vertex at a point of the model's frame. */
  private corner(row: number, x: number, y: number, z: number): void {
    const { motion } = this.stage;
    const [c, s] = [Math.cos(motion.a[row]), Math.sin(motion.a[row])];
    const at = [motion.x[row] + c * x - s * y, motion.y[row] + s * x + c * y, motion.z[row] + z] as const;
    this.lines.corner(...at, [kWay.r, kWay.g, kWay.b], 1);
  }
}

function stateText(state: number): string {
  const { stalled, motor_on, braked } = kBits.actuator;
  if (!(state & motor_on)) return 'motor off';
  if (state & braked) return 'braked';
  return state & stalled ? 'stalled' : '';
}

function panel(model: Model, { replica, row, line, detail, codes }: PanelTools): Node[] {
  const { lowest = 0, highest = 0 } = model;
  const place = turns(model) ? degrees : metres;
  const rate = (velocity: number) => (turns(model) ? `${degrees(velocity)}/s` : `${velocity.toFixed(3)} m/s`);
  const view = () => replica().views('actuator').get(row(model.id));
  const state = () => replica().state[row(model.id)];
  return [
    el('h3', {}, turns(model) ? 'Joint' : 'Slide', ...codes(model), detail(() => stateText(state()), 'actuator-state')),
    el('table', {},
      line('position', () => (view() ? place(view()!.position) : '–'), 'actuator-position'),
      line('velocity', () => (view() ? rate(view()!.velocity) : '–'), 'actuator-velocity'),
      line('ends', () => `${place(lowest)} to ${place(highest)}`, 'actuator-ends'),
    ),
  ];
}
