/** The scene, sent once, and changes of its population (docs/viewer-protocol.md). Metres and radians. */

import type { Walk } from '../drive/walker';
import type { Kind, KindStart } from './generated/views';

export type { Sensor } from './generated/views';
export type Pose = [x: number, y: number, z: number, a: number];
export type Rgba = [r: number, g: number, b: number, a: number];

/** A prism: loops of x, y, x, y, ... filled by the even-odd rule. */
export interface Solid {
  z: [min: number, max: number];
  loops: number[][];
}

/** A light of a mesh, in the frame of the body; a spot light has a direction. */
export interface MeshLight {
  p: [x: number, y: number, z: number];
  candela: [r: number, g: number, b: number];
  way?: [x: number, y: number, z: number]; // unit
  inner?: number; // rad from the direction: full intensity up to here
  outer?: number; // rad: zero intensity from here
}

/** Properties shared by models of the same appearance. */
export interface Prototype extends KindStart {
  type: string;
  kind: Kind;
  controllers?: string[];
  origin?: Pose;
  size: [number, number, number];
  shape?: number; // row of shapes
  mesh?: string; // address of a binary glTF file, relative to the page
  painted?: boolean; // white surfaces of the mesh have the colour of the model
  lights?: MeshLight[]; // lights of the mesh
  lamp?: number; // cd, isotropic, in the model's colour
  shine?: [metallic: number, roughness: number]; // material
  smoke?: boolean; // smoke cloud instead of a body
  moving?: number; // number of trailing solids that are drawn by the kind
  movable?: boolean;
  nose?: boolean; // draws a heading mark
  outline?: boolean;
  grid?: boolean;
}

/** Properties of an individual model. */
interface Words {
  id: number;
  name: string;
  alias?: string;
  devices?: string[]; // as Player clients address them
  start: [x_mm: number, y_mm: number, z_mm: number, turn: number, state: number, color: number, flags: number];
  tilt?: [x_turn: number, y_turn: number]; // initial tilt; none: upright
  fiducial?: number;
}

interface ModelText extends Words {
  prototype: number;
  parent?: number; // id
}

export interface Model extends Prototype, Words {
  parentId: number | null;
  parent: number; // row, or -1; children may precede parents
}

/** Lighting of a scene. Colours are in display units, 0 to 1. */
export interface Light {
  to_sun: [x: number, y: number, z: number]; // unit
  sun: number; // brightness of a white face perpendicular to the sun
  ambient: number; // brightness by ambient light
  day: number; // factor on the colours of sky and fog
  white_lux: number; // illuminance at which a white face is drawn with brightness 1
  sky: [r: number, g: number, b: number];
  fog: [r: number, g: number, b: number];
  visibility: number; // m, distance at which fog leaves 5 % contrast; 0: no fog
  floor: number; // 0xRRGGBB
}

export interface Scene {
  protocol: 4; // formats::kPage
  build: string; // version and commit of the program
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
  light: Light | null; // null: the engine has none
  shapes: Solid[][];
  prototypes: Prototype[];
  addable: string[]; // names of the models that can be spawned
  models: Model[]; // by id
}

/** Removed models, and models spawned or reparented. */
export interface Changes {
  gone: number[]; // ids
  models: ModelText[];
}

type SceneText = Omit<Scene, 'models'> & { models: ModelText[] };

/** Ticks of the keyframes that the run can be rewound to, ascending; or why there are none. */
export type History = { ticks: number[] } | { none: string };

type HistoryText = { first: number; steps: [gap: number, times: number][] } | { none: string };

/** The current world as a world file, with its file name. */
export interface WorldFile {
  file: string;
  text: string;
}

/** A text that a model said at a tick; the model may be gone. */
export interface SaidLine {
  tick: number;
  model: number; // id
  name: string;
  text: string;
}

/** A connected viewer; `body`: id of the model it has joined as. */
export interface Person {
  viewer: number;
  role: string;
  name?: string;
  body?: number;
  muted?: boolean;
}

/**
 * Connected viewers, and the rights of this one: drive robots, join, control the run, change and save the population.
 */
export interface People {
  people: Person[];
  you: number;
  drives: boolean;
  joins: boolean;
  manages: boolean;
  edits: boolean;
}

/** Whether a model is the body of another viewer, which nobody else drives. */
export function isOfAnother({ people, you }: Pick<People, 'people' | 'you'>, model: number): boolean {
  return people.some(({ viewer, body }) => body === model && viewer !== you);
}

/** Collision shape: an upright prism, or the vertices of a convex hull. [m] */
export type PhysicsSolid = { z: [min: number, max: number]; loop: number[] } | { corners: number[] };

export interface PhysicsShapes {
  fixed: PhysicsSolid[]; // in the world frame
  bodies: { model: number; solids: PhysicsSolid[] }[]; // by model id, in the model's frame
}

/** The viewer's own body, and its walking limits. */
export interface Joined {
  joined: number; // id
  walk: Walk;
}

/** Acknowledges a drive command by number: it takes effect in the ticks after this one. */
export interface Driven {
  input: number;
  tick: number;
}

type Message = { scene: Scene } | { people: People } | { changes: Changes } | { history: History } | { said: SaidLine[] } | { world: WorldFile } | Joined | { driven: Driven } | { physics: PhysicsShapes } | { notice: string };

/** Parses a text message: the scene, population changes, keyframes, a file, or a notice for the user. */
export function parseText(text: string): Message {
  const message: unknown = JSON.parse(text);
  if (typeof message !== 'object' || message === null) throw new Error('not a message of this program');
  if ('notice' in message && typeof message.notice === 'string') return { notice: message.notice };
  if ('history' in message) return { history: historyOf(message.history as HistoryText) };
  if ('said' in message) return { said: message.said as SaidLine[] };
  if ('world' in message) return { world: message.world as WorldFile };
  if ('joined' in message) return message as Joined;
  if ('driven' in message) return { driven: message.driven as Driven };
  if ('physics' in message) return { physics: message.physics as PhysicsShapes };
  if ('people' in message) return { people: message as People };
  if ('gone' in message) return { changes: message as Changes };
  if ('protocol' in message && message.protocol === 4) return { scene: sceneOf(message as SceneText) };
  throw new Error('this page is older or newer than the program: reload it');
}

function historyOf(text: HistoryText): History {
  if ('none' in text) return text;
  const ticks = [text.first];
  for (const [gap, times] of text.steps) for (let k = 0; k < times; ++k) ticks.push(ticks[ticks.length - 1] + gap);
  return { ticks };
}

export function sceneOf(text: SceneText): Scene {
  return { ...text, models: inRows(text.models.map((model) => modelOf(model, text.prototypes))) };
}

/** The scene with another population: rows change, ids do not. */
export function withChanges(scene: Scene, changes: Changes): Scene {
  const gone = new Set(changes.gone);
  const came = changes.models.map((model) => modelOf(model, scene.prototypes));
  // Models that stay are copied: the previous scene keeps its rows.
  const stay = scene.models.filter((model) => !gone.has(model.id)).map((model) => ({ ...model }));
  return { ...scene, models: inRows([...stay, ...came].sort((a, b) => a.id - b.id)) };
}

function modelOf({ prototype, parent, ...words }: ModelText, prototypes: Prototype[]): Model {
  return { ...prototypes[prototype], ...words, parentId: parent ?? null, parent: -1 };
}

function inRows(models: Model[]): Model[] {
  const rows = rowsOf(models);
  for (const model of models) model.parent = model.parentId === null ? -1 : (rows.get(model.parentId) ?? -1);
  return models;
}

/** Rows by id. */
export function rowsOf(models: Model[]): Map<number, number> {
  return new Map(models.map((model, row) => [model.id, row]));
}

/** Row of the base of a top-level model; null if it has none. */
export function wheelsOf(scene: Scene, roots: Int32Array, row: number): number | null {
  const wheels = scene.models.findIndex((model, part) => roots[part] === row && model.kind === 'position');
  return wheels < 0 ? null : wheels;
}

/** The devices of a top-level model and its parts. */
export function devicesOf(scene: Scene, roots: Int32Array, row: number): string[] {
  return scene.models.flatMap((model, part) => (roots[part] === row ? (model.devices ?? []) : []));
}

/** "guest", or "guest (marker 13)" if it has a fiducial marker. */
export function nameWithMarker(model: Model): string {
  return model.fiducial ? `${model.name} (marker ${model.fiducial})` : model.name;
}

/** Row of the top-level ancestor of each model. */
export function rootsOf(scene: Scene): Int32Array {
  return Int32Array.from(scene.models, (_, row) => {
    let top = row;
    while (scene.models[top].parent >= 0) top = scene.models[top].parent;
    return top;
  });
}

/** All rows, parents before children. */
export function parentsFirst(scene: Scene): Int32Array {
  const depths = scene.models.map((_, row) => {
    let depth = 0;
    for (let at = scene.models[row].parent; at >= 0; at = scene.models[at].parent) ++depth;
    return depth;
  });
  return Int32Array.from(scene.models.keys()).sort((a, b) => depths[a] - depths[b] || a - b);
}
