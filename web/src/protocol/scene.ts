/** The scene as the program describes it once, and who comes and goes later (docs/viewer-protocol.md). Metres and radians. */

import type { Walk } from '../drive/walker';
import type { Kind, KindStart } from './generated/views';

export type { Sensor } from './generated/views';
export type Pose = [x: number, y: number, z: number, a: number];
export type Rgba = [r: number, g: number, b: number, a: number];

/** A prism: loops of x, y, x, y, ...; solid where an odd number of loops holds a point. */
export interface Solid {
  z: [min: number, max: number];
  loops: number[][];
}

/** A light of a mesh, in the frame of the body; a spot has a way. */
export interface MeshLight {
  p: [x: number, y: number, z: number];
  candela: [r: number, g: number, b: number];
  way?: [x: number, y: number, z: number]; // unit
  inner?: number; // rad from the way: full light
  outer?: number; // and none
}

/** What models that look alike have in common. */
export interface Prototype extends KindStart {
  type: string;
  kind: Kind;
  controllers?: string[];
  origin?: Pose;
  size: [number, number, number];
  shape?: number; // row of shapes
  mesh?: string; // address of a binary glTF of the body, from that of the page
  lights?: MeshLight[]; // that the mesh has
  lamp?: number; // cd, in its color, every way alike
  shine?: [metallic: number, roughness: number]; // of what it is made of
  smoke?: boolean; // a cloud in place of a body
  moving?: number; // how many of its solids, the last, its kind draws
  movable?: boolean;
  nose?: boolean; // what it wants drawn beside its body
  outline?: boolean;
  grid?: boolean;
}

/** What is a model's own. */
interface Words {
  id: number;
  name: string;
  alias?: string;
  devices?: string[]; // as Player clients address them
  start: [x_mm: number, y_mm: number, z_mm: number, turn: number, state: number, color: number, flags: number];
  tilt?: [x_turn: number, y_turn: number]; // at the start; none: upright
  fiducial?: number;
}

interface ModelText extends Words {
  prototype: number;
  parent?: number; // id
}

export interface Model extends Prototype, Words {
  parentId: number | null;
  parent: number; // row, or -1; what is carried may come before who carries it
}

/** What shines on a scene. Colors are shares of what a screen shows, from 0 to 1. */
export interface Light {
  to_sun: [x: number, y: number, z: number]; // unit
  sun: number; // how bright it makes a white face that is square to it
  ambient: number; // and the light from everywhere
  day: number; // share of the colors of sky and fog
  white_lux: number; // of lamps that make a white face as bright as 1
  sky: [r: number, g: number, b: number];
  fog: [r: number, g: number, b: number];
  visibility: number; // m, at which fog leaves 5 % of a contrast; 0: there is no fog
  floor: number; // 0xRRGGBB
}

export interface Scene {
  protocol: 3;
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
  addable: string[]; // names of what a person may add
  models: Model[]; // by id
}

/** Who has gone, and who came or has another parent. */
export interface Changes {
  gone: number[]; // ids
  models: ModelText[];
}

type SceneText = Omit<Scene, 'models'> & { models: ModelText[] };

/** The ticks of the instants that the run can go back to, ascending; or why there are none. */
export type History = { ticks: number[] } | { none: string };

type HistoryText = { first: number; steps: [gap: number, times: number][] } | { none: string };

/** The world as it stands, to be kept under this name. */
export interface WorldFile {
  file: string;
  text: string;
}

/** Somebody who watches; `body` is the id of the model that they have joined as. */
export interface Person {
  viewer: number;
  role: string;
  name?: string;
  body?: number;
  muted?: boolean;
}

/**
 * Who watches, and what this viewer may do: drive robots, join, change how the world runs, change who is in it and save it.
 */
export interface People {
  people: Person[];
  you: number;
  drives: boolean;
  joins: boolean;
  manages: boolean;
  edits: boolean;
}

/** What physics takes something for: an upright prism, or the corners of what is convex. [m] */
export type PhysicsSolid = { z: [min: number, max: number]; loop: number[] } | { corners: number[] };

export interface PhysicsShapes {
  fixed: PhysicsSolid[]; // in the world
  bodies: { model: number; solids: PhysicsSolid[] }[]; // by id, in the frame of the model
}

/** The viewer's own body, and how it walks. */
export interface Joined {
  joined: number; // id
  walk: Walk;
}

/** A command of the viewer's, by its number, counts in the ticks after this one. */
export interface Driven {
  input: number;
  tick: number;
}

type Message = { scene: Scene } | { people: People } | { changes: Changes } | { history: History } | { world: WorldFile } | Joined | { driven: Driven } | { physics: PhysicsShapes } | { notice: string };

/** A text message: the scene, changes of its population, instants to go back to, a file, or a line for the person who watches. */
export function parseText(text: string): Message {
  const message: unknown = JSON.parse(text);
  if (typeof message !== 'object' || message === null) throw new Error('not a message of this program');
  if ('notice' in message && typeof message.notice === 'string') return { notice: message.notice };
  if ('history' in message) return { history: historyOf(message.history as HistoryText) };
  if ('world' in message) return { world: message.world as WorldFile };
  if ('joined' in message) return message as Joined;
  if ('driven' in message) return { driven: message.driven as Driven };
  if ('physics' in message) return { physics: message.physics as PhysicsShapes };
  if ('people' in message) return { people: message as People };
  if ('gone' in message) return { changes: message as Changes };
  if ('protocol' in message && message.protocol === 3) return { scene: sceneOf(message as SceneText) };
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

/** The scene with another population; rows move, ids do not. */
export function withChanges(scene: Scene, changes: Changes): Scene {
  const gone = new Set(changes.gone);
  const came = changes.models.map((model) => modelOf(model, scene.prototypes));
  // Models that stay are copied: their rows belong to the scene that was.
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
  return Int32Array.from(scene.models, (_, row) => {
    let top = row;
    while (scene.models[top].parent >= 0) top = scene.models[top].parent;
    return top;
  });
}

/** All rows, parents before what they carry. */
export function parentsFirst(scene: Scene): Int32Array {
  const depths = scene.models.map((_, row) => {
    let depth = 0;
    for (let at = scene.models[row].parent; at >= 0; at = scene.models[at].parent) ++depth;
    return depth;
  });
  return Int32Array.from(scene.models.keys()).sort((a, b) => depths[a] - depths[b] || a - b);
}
