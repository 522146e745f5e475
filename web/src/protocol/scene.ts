/** The scene as the program describes it once (docs/viewer-protocol.md). Metres and radians. */

export type Pose = [x: number, y: number, z: number, a: number];
export type Rgba = [r: number, g: number, b: number, a: number];

/** A prism: loops of x, y, x, y, ...; solid where an odd number of loops holds a point. */
export interface Solid {
  z: [min: number, max: number];
  loops: number[][];
}

export interface Sensor {
  pose: Pose;
  size: [number, number, number];
  range: [min: number, max: number];
  fov: number;
  samples: number;
  color: Rgba;
}

export interface Model {
  name: string;
  alias?: string;
  type: string;
  kind: 'plain' | 'position' | 'ranger' | 'fiducial';
  parent: number; // row, or -1
  controllers?: string[];
  devices?: string[]; // as Player clients address them
  start: [x_mm: number, y_mm: number, z_mm: number, turn: number, state: number, color: number];
  origin?: Pose;
  size: [number, number, number];
  shape?: number; // row of shapes
  movable?: boolean;
  fiducial?: number;
  position?: number; // row of positions
  trail?: number;
  first_sensor?: number;
  sensors?: number; // row of sensor sets
  finder?: number; // row of finders
  range?: number;
  fov?: number;
}

export interface Scene {
  protocol: 1;
  name: string;
  interval: number; // s, one tick
  window: {
    center: [number, number];
    scale: number; // pixels per metre; 0: fit
    pitch: number;
    yaw: number;
    sensors: boolean;
    follow: string;
  };
  shapes: Solid[][];
  sensors: Sensor[][];
  models: Model[];
}

/** A text message: the scene, or a line for the person who watches. */
export function parseText(text: string): { scene: Scene } | { notice: string } {
  const message: unknown = JSON.parse(text);
  if (typeof message !== 'object' || message === null) throw new Error('not a message of this program');
  if ('notice' in message && typeof message.notice === 'string') return { notice: message.notice };
  if ('protocol' in message && message.protocol === 1) return { scene: message as Scene };
  throw new Error('this page is older or newer than the program: reload it');
}

/** The row of the wheels of a top-level model; null when it has none. */
export function wheelsOf(scene: Scene, roots: Int32Array, row: number): number | null {
  const wheels = scene.models.findIndex((model, part) => roots[part] === row && model.kind === 'position');
  return wheels < 0 ? null : wheels;
}

/** The devices of a top-level model and its parts. */
export function devicesOf(scene: Scene, roots: Int32Array, row: number): string[] {
  return scene.models.flatMap((model, part) => (roots[part] === row ? (model.devices ?? []) : []));
}

/** "guest", or "guest (marker 13)" for somebody whose finder reads it. */
export function nameWithMarker(model: Model): string {
  return model.fiducial ? `${model.name} (marker ${model.fiducial})` : model.name;
}

/** Row of the top-level model above each model. */
export function rootsOf(scene: Scene): Int32Array {
  const roots = new Int32Array(scene.models.length);
  scene.models.forEach((model, row) => {
    roots[row] = model.parent < 0 ? row : roots[model.parent];
  });
  return roots;
}
