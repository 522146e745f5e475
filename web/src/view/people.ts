import { Group } from 'three';
import type { Motion } from '../motion';
import { kWave } from '../protocol/generated/commands';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import type { CameraRig } from './camera_rig';
import { Figure } from './figure';
import { gaitOf, smooth, type Gait } from './gait';
import { kHeight } from './skeleton';

const kRaise = 0.3; // s, time to raise the arm

/** Animation state of a walker, kept across population changes. */
interface Life {
  gait: Gait;
  wave: number; // 0 to 1
}

/** People as animated figures: gait by the drawn motion, breathing, turning, waving. */
export class People {
  readonly group = new Group();
  /** Row of the person not drawn: the origin of the first-person view. */
  hidden: number | null = null;

  private readonly rows: number[];
  private readonly lives: Life[];
  private readonly figures: Figure[];

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
    before: People | null = null,
  ) {
    this.rows = [...scene.models.keys()].filter((row) => isPerson(scene, row));
    this.lives = this.rows.map((row) => {
      const was = before?.replica.rows.get(scene.models[row].id);
      const known = was === undefined ? undefined : before?.lives[before.rows.indexOf(was)];
      return known ?? { gait: gaitOf(motion.x[row], motion.y[row], motion.a[row]), wave: 0 };
    });
    this.figures = this.rows.map((row) => {
      const figure = new Figure();
      figure.object.scale.setScalar(scene.models[row].size[2] / kHeight);
      return figure;
    });
    for (const { object } of this.figures) this.group.add(object);
    this.paint();
    this.move(0);
  }

  /** Advances all figures by `seconds`; false if nothing but breathing moves. */
  move(seconds: number): boolean {
    const { motion, replica } = this;
    const passed = replica.paused ? 0 : seconds;
    let moves = false;
    this.rows.forEach((row, k) => {
      const life = this.lives[k];
      const waves = replica.says.get(row) === kWave;
      moves = life.gait.walk(motion.x[row], motion.y[row], motion.a[row], passed) || moves;
      moves = moves || waves || life.wave > 0;
      life.wave = Math.min(Math.max(life.wave + (waves ? passed : -passed) / kRaise, 0), 1);
      const { object } = this.figures[k];
      object.visible = row !== this.hidden;
      object.position.set(motion.x[row], motion.y[row], motion.z[row]);
      object.rotation.z = motion.a[row];
      this.figures[k].pose(life.gait, smooth(life.wave));
    });
    return moves;
  }

  /** Selects the levels of detail by the size on screen. */
  adapt(rig: CameraRig): void {
    const { motion, scene } = this;
    this.rows.forEach((row, k) => this.figures[k].adapt(rig.scaleAt(motion.x[row], motion.y[row], motion.z[row]) * scene.models[row].size[2]));
  }

  /** Applies changed colours. */
  paint(): void {
    this.rows.forEach((row, k) => (this.figures[k].color = this.replica.color[row] >>> 8));
  }

  dispose(): void {
    for (const figure of this.figures) figure.dispose();
  }
}

export function isPerson(scene: Scene, row: number): boolean {
  return scene.models[row].drive === 'walk';
}
