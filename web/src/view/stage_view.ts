import {
  AmbientLight, Color, DirectionalLight, Group, HemisphereLight, LineBasicMaterial, LineLoop, BufferGeometry, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry, Scene as Picture, Vector3, WebGLRenderer, type Texture,
} from 'three';
import { Motion } from '../motion';
import { kKindPages, type Drawing } from '../kinds/kind_page';
import type { Eyes } from '../drive/eyes';
import type { Replica } from '../protocol/replica';
import { rootsOf, type Light, type Scene } from '../protocol/scene';
import { Areas, type Area } from './areas';
import { Bodies } from './bodies';
import { Bubbles } from './bubbles';
import { ClientDrawings } from './client_drawings';
import { CameraRig, type Box, type Eye, type Margins } from './camera_rig';
import { Daylight } from './daylight';
import { Flight } from './flight';
import { FloorMarks } from './floor_marks';
import { frameOf } from './frames';
import { Ground } from './ground';
import { Labels } from './labels';
import { Lamps } from './lamps';
import { isPerson, People } from './people';
import { PhysicsShapes } from './physics_shapes';
import { heightOf } from './shapes';
import { Smoke } from './smoke';
import { disposeAll, type Shine } from './surfaces';
import { thingAt } from './things';
import { themeNow, type Theme } from './theme';
import { Trails } from './trails';

const kEyeHeight = 0.93; // fraction of a person's height
const kAbove = 0.05; // m above a robot's top
const kFloor = 2000; // m
const kTooLarge = 'the picture is too large for this browser';

export interface Layers {
  sensors: boolean;
  fiducials: boolean;
  trails: boolean;
  names: boolean;
  speech: boolean; // texts of models, and flags they carry
  grid: boolean;
  drawings: boolean; // of clients
  physics: boolean; // wireframes of collision shapes
}

/** All drawings of one population. */
class Drawn {
  readonly group = new Group();
  readonly bodies: Bodies;
  readonly drawings: Drawing[]; // on the floor and of kinds
  readonly trails: Trails;
  readonly labels: Labels;
  readonly bubbles: Bubbles;
  readonly ground: Ground;
  readonly people: People;
  readonly smoke: Smoke;

  constructor(
    readonly scene: Scene,
    readonly replica: Replica,
    readonly motion: Motion,
    rig: CameraRig,
    canvas: HTMLCanvasElement,
    theme: Theme,
    changed: () => void,
    before: Drawn | null = null,
  ) {
    this.bodies = new Bodies(scene, replica, motion, theme, changed);
    this.people = new People(scene, replica, motion, before?.people);
    this.smoke = new Smoke(scene, replica, motion);
    const stage = { scene, replica, motion, theme };
    this.drawings = [new FloorMarks(stage), new ClientDrawings(stage), ...kKindPages.flatMap(({ drawings }) => drawings?.(stage) ?? [])];
    this.trails = new Trails(scene, replica, before?.trails);
    this.labels = new Labels(scene, motion, rig, canvas, theme, before?.labels);
    this.bubbles = new Bubbles(scene, replica, motion, rig, canvas, theme);
    this.ground = new Ground(extentOf(scene, motion), theme);
    this.group.add(this.ground.group, this.trails.object, this.bodies.group, this.people.group, this.smoke.group, ...this.drawings.map(({ object }) => object));
  }

  /** Leaves out the robot or person that this model belongs to, whose view it is; null: nobody. */
  hide(row: number | null, roots: Int32Array): void {
    const root = row === null ? null : roots[row];
    this.bodies.hide(root);
    this.people.hidden = row !== null && isPerson(this.scene, row) ? row : root;
  }

  /** Sets the lighting; null: map view. */
  shineBy(shine: Shine | null): void {
    this.bodies.shineBy(shine);
    this.smoke.light = shine?.light ?? null;
  }

  dispose(): void {
    for (const part of [this.bodies, this.people, this.smoke, ...this.drawings, this.trails, this.ground]) part.dispose();
  }
}

/** The view: redraws the world on change, and picks models under the pointer. */
export class StageView {
  readonly rig = new CameraRig();
  readonly layers: Layers = { sensors: true, fiducials: true, trails: true, names: true, speech: true, grid: true, drawings: true, physics: false };
  selected: number | null = null;
  hovered: number | null = null;
  followed: number | null = null;
  /** First-person view: row of the model, and view direction. */
  seenBy: { row: number; eyes: Eyes } | null = null;
  /** Source of a predicted pose that overrides a model's drawn pose; called before each frame. */
  lead: (now: number) => { row: number; x: number; y: number; a: number } | null = () => null;
  /** The free camera, when in flight. */
  flight: Flight | null = null;
  readonly physics = new PhysicsShapes();
  motion: Motion | null = null;
  roots: Int32Array = new Int32Array();

  private readonly renderer: WebGLRenderer;
  private readonly picture = new Picture();
  private readonly ring: LineLoop;
  private readonly plain = new Group(); // lighting of the map view
  private readonly daylight: Daylight;
  private readonly lamps = new Lamps();
  private readonly areas = new Areas();
  private readonly floor = new Mesh<PlaneGeometry, MeshBasicMaterial | MeshLambertMaterial>(new PlaneGeometry(kFloor, kFloor)); // of who stands on it
  private drawn: Drawn | null = null;
  private seer: number | null = null; // row of the model whose eye the free camera is
  private theme: Theme = themeNow();
  private dirty = true;
  private last = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly overlay: HTMLCanvasElement,
    /** Margins of the view covered by panels. */
    private readonly margins: () => Margins,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'low-power' });
    const side = new DirectionalLight(0xffffff, 1.6);
    side.position.set(-4, -7, 12);
    this.plain.add(new AmbientLight(0xffffff, 0.7), new HemisphereLight(0xffffff, 0xb8bec8, 1.1), side);
    this.daylight = new Daylight(this.renderer, this.picture);
    this.picture.add(this.plain, this.daylight.group, this.lamps.group);
    const circle = Array.from({ length: 48 }, (_, k) => new Vector3(Math.cos((k / 24) * Math.PI), Math.sin((k / 24) * Math.PI), 0));
    this.ring = new LineLoop(new BufferGeometry().setFromPoints(circle), new LineBasicMaterial({ depthTest: false, transparent: true }));
    this.ring.renderOrder = 10;
    this.ring.visible = false;
    this.floor.position.z = -0.01;
    this.floor.receiveShadow = true;
    this.picture.add(this.ring, this.areas.object, this.floor, this.physics.group);
    this.floor.visible = false;
    this.applyTheme();
  }

  /** Number of meshes drawn. */
  get meshes(): number {
    return this.drawn?.bodies.files ?? 0;
  }

  async filesThere(): Promise<void> {
    await this.drawn?.bodies.filesThere();
  }

  /** Shows another scene; keeps the camera if it is the same world. */
  show(scene: Scene, replica: Replica): void {
    const again = this.drawn?.scene.name === scene.name;
    if (!this.flight) this.seeThrough(null);
    this.drop();
    this.draws(scene, replica, new Motion(scene, replica), null);
    if (!again) this.frameAsTheFileWants();
  }

  /** Shows another population of the scene; models in both keep their state. */
  follow(scene: Scene, replica: Replica): void {
    const { drawn, motion } = this;
    const now = (row: number | null) => (row === null || !drawn ? null : (replica.rows.get(drawn.scene.models[row].id) ?? null));
    [this.selected, this.hovered, this.followed] = [now(this.selected), now(this.hovered), now(this.followed)];
    const seer = now(this.seenBy?.row ?? null);
    if (this.seenBy && seer === null) this.seeThrough(null);
    else if (this.seenBy) this.seenBy.row = seer!;
    this.drop();
    this.draws(scene, replica, new Motion(scene, replica, motion), drawn);
  }

  private draws(scene: Scene, replica: Replica, motion: Motion, before: Drawn | null): void {
    this.motion = motion;
    this.roots = rootsOf(scene);
    this.drawn = new Drawn(scene, replica, motion, this.rig, this.overlay, this.theme, () => (this.dirty = true), before);
    this.picture.add(this.drawn.group);
    this.applyTheme();
  }

  /** A packet was applied. */
  changed(now: number): void {
    this.motion?.aim(now);
    this.drawn?.bodies.paint();
    this.drawn?.people.paint();
    this.drawn?.trails.record();
    this.dirty = true;
  }

  setTheme(): void {
    this.theme = themeNow();
    this.applyTheme();
    if (this.drawn) this.show(this.drawn.scene, this.drawn.replica);
  }

  applyLayers(): void {
    const { drawn, layers } = this;
    this.physics.group.visible = layers.physics;
    if (drawn) {
      for (const drawing of drawn.drawings) drawing.object.visible = this.shows(drawing);
      drawn.trails.object.visible = layers.trails;
      drawn.ground.group.visible = layers.grid && !this.light;
      drawn.labels.names = layers.names;
      drawn.bubbles.shown = layers.speech;
      drawn.labels.markers = layers.fiducials;
    }
    this.paintFloor();
    this.dirty = true;
  }

  private shows({ layer }: Drawing): boolean {
    return layer === undefined || this.layers[layer];
  }

  redraw(): void {
    this.dirty = true;
  }

  /** Texts in the visible bubbles, by row. */
  get spoken(): Iterable<[number, string]> {
    return this.drawn?.bubbles.spoken ?? [];
  }

  /** Numbers of visible flags, by row of the carrier. */
  get tokens(): Iterable<[number, number]> {
    return this.drawn?.bubbles.tokens ?? [];
  }

  /** Rows with visible names. */
  get labelled(): Iterable<number> {
    return this.drawn?.labels.written ?? [];
  }

  fitAll(): void {
    const { drawn } = this;
    if (drawn) this.rig.fit(extentOf(drawn.scene, drawn.motion), this.margins(), 'glide');
    this.dirty = true;
  }

  tilt(): void {
    this.rig.tilt();
    this.dirty = true;
  }

  /** Switches to the first-person view of a model; null: from above. */
  seeThrough(seenBy: { row: number; eyes: Eyes } | null): void {
    this.seenBy = seenBy;
    this.flight = null;
    this.rig.eye = null;
    this.floor.visible = seenBy !== null;
    this.applyTheme();
  }

  /** Switches to free flight, from the current view. */
  fly(): void {
    const eye = this.rig.eyeHere();
    this.seeThrough(null);
    this.followed = null;
    this.flight = new Flight(eye);
    this.rig.eye = eye;
    this.floor.visible = true;
    this.applyTheme();
  }

  /** Puts the free camera here; the model with this id, whose eye it is, is not drawn. */
  lookFrom(eye: Eye, hides: number | null): void {
    if (!this.flight) this.fly();
    Object.assign(this.flight!.eye, eye);
    this.seer = hides === null ? null : (this.drawn?.replica.rows.get(hides) ?? null);
    this.dirty = true;
  }

  /** Replaces the collision shapes. */
  showPhysics(shapes: Parameters<PhysicsShapes['show']>[0]): void {
    this.physics.show(shapes);
    this.dirty = true;
  }

  /** Places the camera: at a person's eyes, at a camera's lens, or on top of a robot. */
  private placeEye(): void {
    const { seenBy, motion, drawn } = this;
    drawn?.hide(seenBy?.row ?? this.seer, this.roots);
    if (!seenBy || !motion || !drawn) return;
    const { row, eyes } = seenBy;
    const { size, kind, origin, view } = drawn.scene.models[row];
    if (kind === 'camera') {
      const { x, y, z, a } = frameOf(motion, row, origin);
      this.rig.eye = { x, y, z: z + size[2] / 2, yaw: a, pitch: eyes.pitch, fov: view?.[1] };
      return;
    }
    const height = isPerson(drawn.scene, row) ? kEyeHeight * size[2] : size[2] + kAbove;
    this.rig.eye = { x: motion.x[row], y: motion.y[row], z: motion.z[row] + height, yaw: eyes.yaw, pitch: eyes.pitch };
  }

  /** Replaces the areas drawn over floor and surfaces at their height. */
  showAreas(areas: Area[]): void {
    this.areas.lay(areas);
    this.dirty = true;
  }

  /** Draws if anything has changed since the last call. */
  frame(now: number): void {
    if (this.advance(now)) this.draw();
  }

  /** Updates all state to this time without drawing; false if nothing has changed. */
  advance(now: number): boolean {
    const seconds = Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    const resized = this.fitWindow();
    this.motion?.lead(this.lead(now));
    const moved = this.motion?.update(now) ?? false;
    if (this.followed !== null && this.motion) {
      const centre = this.rig.centreFor(this.motion.x[this.followed], this.motion.y[this.followed], this.rig.scale, this.margins());
      this.rig.lookAt(centre.x, centre.y);
    }
    this.placeEye();
    const glides = this.rig.update(seconds);
    if (moved) this.drawn?.bodies.move();
    const walks = this.drawn?.people.move(seconds) ?? false;
    const changed = moved || walks || glides || resized || this.dirty;
    this.dirty = false;
    return changed;
  }

  /**
   * Picks the top-level model within `reach` pixels: the nearest robot,
   * else the nearest other movable model; null for floor and walls.
   */
  pick(px: number, py: number, reach: number): number | null {
    const { drawn, motion } = this;
    if (!drawn || !motion) return null;
    const ray = this.rig.rayAt(px, py);
    const slack = reach / this.rig.scale;
    let best: number | null = null;
    let nearest = Infinity;
    drawn.scene.models.forEach((model, row) => {
      if (model.parent >= 0 || !(model.movable || model.kind === 'position')) return;
      const p = ray(motion.z[row] + model.size[2] * 0.6);
      if (!p) return;
      const [ox, oy] = model.origin ?? [0, 0];
      const dx = p.x - motion.x[row];
      const dy = p.y - motion.y[row];
      const c = Math.cos(motion.a[row]);
      const s = Math.sin(motion.a[row]);
      const along = Math.abs(c * dx + s * dy - ox) - model.size[0] / 2;
      const across = Math.abs(-s * dx + c * dy - oy) - model.size[1] / 2;
      if (along > slack || across > slack) return;
      const distance = Math.hypot(dx, dy) + (model.kind === 'position' ? 0 : 1e3);
      if (distance >= nearest) return;
      nearest = distance;
      best = row;
    });
    return best;
  }

  /** Name and type of the unselectable object at a pixel; null for the bare floor. */
  describe(px: number, py: number): string | null {
    const { drawn, motion } = this;
    const row = drawn && motion ? thingAt(drawn.scene, motion, this.rig.rayAt(px, py)) : null;
    if (row === null) return null;
    const { name, type } = drawn!.scene.models[row];
    return `${name}, a ${type}`;
  }

  /** Moves the view to a model, centred inside the margins. */
  goTo(row: number, scaleLeast: number): void {
    if (!this.motion) return;
    const scale = Math.max(this.rig.scale, scaleLeast);
    this.rig.glideTo({ ...this.rig.centreFor(this.motion.x[row], this.motion.y[row], scale, this.margins()), scale });
    this.dirty = true;
  }

  /** The same at the current scale, if the model is covered by panels or off screen. */
  reveal(row: number): void {
    const at = this.motion && this.rig.pixelOf(this.motion.x[row], this.motion.y[row], 0);
    const { left, right, top, bottom } = this.margins();
    const free = at && at.x > left && at.x < this.rig.width - right && at.y > top && at.y < this.rig.height - bottom;
    if (!free) this.goTo(row, 0);
  }

  /** The current view with names and bubbles, as a PNG file. */
  picturePng(): Promise<Blob> {
    this.draw(); // the drawing buffer is valid only until the browser composites it: copy at once
    const { domElement } = this.renderer;
    const { drawingBufferWidth, drawingBufferHeight } = this.renderer.getContext();
    if (drawingBufferWidth < domElement.width || drawingBufferHeight < domElement.height) return Promise.reject(new Error(kTooLarge));
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [domElement.width, domElement.height];
    const context = copy.getContext('2d')!;
    for (const layer of [domElement, this.overlay]) context.drawImage(layer, 0, 0, copy.width, copy.height);
    return new Promise((done, fail) => copy.toBlob((png) => (png ? done(png) : fail(new Error(kTooLarge)))));
  }

  private draw(): void {
    const { drawn, layers } = this;
    if (drawn) {
      for (const drawing of drawn.drawings) if (this.shows(drawing)) drawing.draw();
      if (layers.trails) drawn.trails.draw();
      drawn.ground.adapt(this.rig.scale);
      drawn.bodies.adapt(this.rig.scale);
      drawn.people.adapt(this.rig);
      drawn.smoke.draw();
      if (this.light) this.shineOn(drawn);
      if (layers.physics) this.physics.move(drawn.replica, drawn.motion);
      this.placeRing(drawn);
      drawn.labels.draw([this.selected, this.hovered, this.followed]);
      drawn.bubbles.draw([this.selected, this.hovered, this.followed]);
    }
    this.renderer.render(this.picture, this.rig.camera);
  }

  private shineOn({ scene, replica, motion }: Drawn): void {
    const { camera } = this.rig;
    this.daylight.follow(camera);
    this.lamps.place(scene, replica, motion, camera.position);
  }

  private placeRing(drawn: Drawn): void {
    const row = this.selected;
    this.ring.visible = row !== null;
    if (row === null) return;
    const model = drawn.scene.models[row];
    const radius = Math.hypot(model.size[0], model.size[1]) * 0.62 + 3 / this.rig.scale;
    this.ring.position.set(drawn.motion.x[row], drawn.motion.y[row], drawn.motion.z[row] + 0.01);
    this.ring.scale.setScalar(radius);
  }

  private fitWindow(): boolean {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    if (clientWidth === this.rig.width && clientHeight === this.rig.height) return false;
    this.rig.resize(clientWidth, clientHeight);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
    return true;
  }

  private frameAsTheFileWants(): void {
    const { window: wanted } = this.drawn!.scene;
    this.fitWindow();
    this.rig.pitch = Math.min(Math.abs(wanted.pitch), 1.3);
    this.rig.yaw = wanted.yaw;
    this.rig.fit(extentOf(this.drawn!.scene, this.drawn!.motion), this.margins(), 'jump');
    this.rig.update(0);
  }

  /** Scene lighting in first-person and free views, if any; null: map view. */
  private get light(): Light | null {
    return this.seenBy || this.flight ? (this.drawn?.scene.light ?? null) : null;
  }

  private applyTheme(): void {
    const { light, theme } = this;
    this.plain.visible = light === null;
    this.lamps.group.visible = light !== null;
    const shine = light && this.daylight.show(light);
    if (!shine) this.daylight.hide();
    if (shine) this.lamps.prepare(this.drawn!.scene);
    this.drawn?.shineBy(shine);
    this.picture.background = light ? null : new Color(this.seenBy || this.flight ? theme.sky : theme.floor);
    (this.ring.material as LineBasicMaterial).color.setHex(theme.select);
    this.applyLayers();
  }

  /** Material of the ground plane: lit slabs if the scene has lighting and the grid is shown. */
  private paintFloor(): void {
    const { light, theme, floor } = this;
    disposeAll(floor.material);
    floor.material = light
      ? new MeshLambertMaterial({ color: light.floor, map: this.layers.grid ? this.slabs() : null })
      : new MeshBasicMaterial({ color: theme.floor });
  }

  private slabs(): Texture {
    const { slabs } = this.daylight;
    slabs.repeat.set(kFloor, kFloor);
    return slabs;
  }

  private drop(): void {
    if (!this.drawn) return;
    this.picture.remove(this.drawn.group);
    this.drawn.dispose();
    this.drawn = null;
  }
}

/** Current bounding box of the scene's bodies: robots may be outside of the walls. */
function extentOf(scene: Scene, motion: Motion): Box {
  const box = { x_min: Infinity, y_min: Infinity, x_max: -Infinity, y_max: -Infinity };
  scene.models.forEach((model, row) => {
    if (model.parent >= 0 || model.shape === undefined || heightOf(scene.shapes[model.shape]) <= 0) return;
    const [ox, oy, , oa] = model.origin ?? [0, 0, 0, 0];
    const [c, s] = [Math.cos(motion.a[row]), Math.sin(motion.a[row])];
    const [x, y] = [motion.x[row] + c * ox - s * oy, motion.y[row] + s * ox + c * oy];
    const [cb, sb] = [Math.abs(Math.cos(motion.a[row] + oa)) / 2, Math.abs(Math.sin(motion.a[row] + oa)) / 2];
    const [right, up] = [cb * model.size[0] + sb * model.size[1], sb * model.size[0] + cb * model.size[1]];
    box.x_min = Math.min(box.x_min, x - right);
    box.y_min = Math.min(box.y_min, y - up);
    box.x_max = Math.max(box.x_max, x + right);
    box.y_max = Math.max(box.y_max, y + up);
  });
  return box.x_min <= box.x_max ? box : { x_min: -5, y_min: -5, x_max: 5, y_max: 5 };
}
