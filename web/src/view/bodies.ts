import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, Group, InstancedMesh, LineBasicMaterial,
  LineSegments, Matrix4, MeshLambertMaterial, type Material,
} from 'three';
import { kKindPages, type KindPage } from '../kinds/kind_page';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import { rootsOf, type Model, type Pose, type Scene, type Solid } from '../protocol/scene';
import { bodyMatrix } from './frames';
import { MeshBatch } from './meshes';
import { isPerson } from './people';
import { edgesOf, geometryOf, heightOf } from './shapes';
import { darkOf, disposeAll, isLamp, isLit, surfaceOf, type Shine } from './surfaces';
import type { Theme } from './theme';

/** Instanced models of the same appearance, one draw call. */
interface Batch {
  mesh: InstancedMesh;
  edges: LineSegments | null; // outlines
  rows: number[];
  origins: Pose[];
  file?: MeshBatch; // the glTF mesh, if there is one
  awaits?: boolean; // the mesh is not loaded yet: of the body only outlines are drawn
  hidden?: boolean; // hidden: the mesh is drawn instead
  shade?: KindPage['shade'];
}

const kOutlineScale = 10; // pixels per metre
const kNothing = new Matrix4().makeScale(0, 0, 0);

/** Extruded bodies, except of people, smoke and solids drawn by kinds; heading marks of models that move or request one. */
export class Bodies {
  readonly group = new Group();
  private readonly batches: Batch[] = [];
  private readonly noses: Batch | null;
  private readonly shown: Uint32Array; // colours currently uploaded
  private readonly roots: Int32Array;
  private readonly matrix = new Matrix4();
  private readonly color = new Color();
  private shine: Shine | null = null;
  private unseen: number | null = null; // root of the models that are not drawn

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
    theme: Theme,
    /** Called when the appearance changes asynchronously: a mesh was loaded. */
    private readonly changed: () => void,
  ) {
    this.shown = new Uint32Array(scene.models.length);
    this.roots = rootsOf(scene);
    const alike = new Map<string, number[]>();
    scene.models.forEach((model, row) => {
      if ((model.shape === undefined && !model.painted) || model.smoke || isPerson(scene, row)) return;
      const shaded = shadeOf(model) ? model.kind : '';
      const look = `${model.shine ?? ''}/${isLamp(model)}/${shaded}`;
      const key = `${model.mesh ?? ''}/${model.shape}/${model.moving ?? 0}/${replica.color[row] & 0xff}/${look}`;
      const rows = alike.get(key);
      if (rows) rows.push(row);
      else alike.set(key, [row]);
    });
    for (const rows of alike.values()) this.addBatch(rows, theme);
    this.noses = this.makeNoses();
    this.paint();
    this.move();
  }

  /** Number of meshes loaded and drawn. */
  get files(): number {
    return this.batches.filter(({ hidden }) => hidden).length;
  }

  /** Resolves when all meshes are loaded. */
  async filesThere(): Promise<void> {
    await Promise.all(this.batches.map(({ file }) => file?.ready));
  }

  /** Hides a top-level model with all its parts; null: none. */
  hide(root: number | null): void {
    if (root === this.unseen) return;
    this.unseen = root;
    this.move();
  }

  /** Updates the transforms of all bodies from the interpolated motion. */
  move(): void {
    for (const batch of this.batches) {
      batch.rows.forEach((row, k) => {
        const matrix = this.isUnseen(row) ? kNothing : bodyMatrix(this.motion, row, batch.origins[k], this.matrix);
        batch.mesh.setMatrixAt(k, matrix);
        batch.file?.place(k, matrix);
      });
      batch.mesh.instanceMatrix.needsUpdate = true;
      batch.file?.placed();
    }
    if (!this.noses) return;
    const { mesh, rows } = this.noses;
    rows.forEach((row, k) => mesh.setMatrixAt(k, this.isUnseen(row) ? kNothing : this.noseMatrix(row)));
    mesh.instanceMatrix.needsUpdate = true;
  }

  private isUnseen(row: number): boolean {
    return this.unseen !== null && this.roots[row] === this.unseen;
  }

  /** Hides outlines at scales where they would dominate. */
  adapt(pixelsPerMetre: number): void {
    const outlined = !this.shine && pixelsPerMetre >= kOutlineScale;
    for (const { edges, hidden, awaits } of this.batches) {
      if (edges) edges.visible = awaits || (!hidden && outlined);
    }
  }

  /** Sets the lighting; null: flat shading with outlines, as on a map. */
  shineBy(shine: Shine | null): void {
    if (shine === this.shine) return;
    this.shine = shine;
    for (const { mesh, rows, file } of this.batches) {
      disposeAll(mesh.material);
      mesh.material = this.surfaceFor(rows[0]);
      file?.shineBy(shine);
    }
    if (this.noses) this.noses.mesh.visible = !shine; // not part of the body
    this.shown.fill(0);
    this.paint();
  }

  private surfaceFor(row: number): Material {
    return surfaceOf(this.scene.models[row], (this.replica.color[row] & 0xff) / 255, this.shine);
  }

  /** Uploads changed colours. */
  paint(): void {
    const { color } = this.replica;
    for (const batch of this.batches) {
      batch.rows.forEach((row, k) => {
        const now = this.colorOf(row, batch);
        if (this.shown[row] === now) return;
        batch.mesh.setColorAt(k, this.color.setHex(now >>> 8));
        batch.mesh.instanceColor!.needsUpdate = true;
        batch.file?.paint(k);
      });
    }
    this.noses?.rows.forEach((row, k) => {
      if (this.shown[row] === color[row]) return;
      this.noses!.mesh.setColorAt(k, this.color.setHex(color[row] >>> 8).multiplyScalar(0.55));
      this.noses!.mesh.instanceColor!.needsUpdate = true;
    });
    this.shown.set(color);
    for (const batch of this.batches) if (batch.shade || this.shine) for (const row of batch.rows) this.shown[row] = this.colorOf(row, batch);
  }

  private colorOf(row: number, { shade }: Batch): number {
    const { color, state } = this.replica;
    const model = this.scene.models[row];
    const dark = this.shine && isLamp(model) && !isLit(model, state[row]) ? darkOf(this.shine.light) : 1;
    const brightness = dark * (shade?.(state[row]) ?? 1);
    return brightness < 1 ? darkened(color[row], brightness) : color[row];
  }

  dispose(): void {
    for (const { mesh, edges, file } of [...this.batches, ...(this.noses ? [this.noses] : [])]) {
      file?.dispose();
      mesh.geometry.dispose(); // frees GPU memory; a cached geometry is uploaded again
      mesh.dispose();
      disposeAll(mesh.material);
      edges?.geometry.dispose();
      (edges?.material as LineBasicMaterial | undefined)?.dispose();
    }
  }

  private addBatch(rows: number[], theme: Theme): void {
    const { shape, moving, mesh: address, painted } = this.scene.models[rows[0]];
    const { geometry, edges: outline } = shape === undefined ? kBodiless : drawnOf(this.scene.shapes[shape], moving ?? 0);
    if (!geometry) return;
    const alpha = (this.replica.color[rows[0]] & 0xff) / 255;
    const mesh = new InstancedMesh(geometry, this.surfaceFor(rows[0]), rows.length);
    mesh.castShadow = mesh.receiveShadow = alpha >= 1;
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    const edges = followers(outline, mesh, alpha, theme);
    this.group.add(mesh, edges);
    const origins = rows.map((row): Pose => this.scene.models[row].origin ?? [0, 0, 0, 0]);
    const batch: Batch = { mesh, edges, rows, origins, shade: shadeOf(this.scene.models[rows[0]]) };
    this.batches.push(batch);
    if (address !== undefined) this.addFile(batch, address, painted ?? false);
  }

  /** Draws the mesh once it is loaded; until then the outlines of the extruded shape, if it fails all of it. */
  private addFile(batch: Batch, address: string, painted: boolean): void {
    batch.awaits = !painted; // a look is drawn as its body until it is there
    batch.mesh.visible = painted;
    const done = (loaded: boolean) => {
      batch.awaits = false;
      batch.hidden = loaded;
      batch.mesh.visible = !loaded;
      batch.edges!.visible = false; // until adapt()
      this.move();
      this.changed();
    };
    const colorOf = (k: number) => this.color.setHex(this.colorOf(batch.rows[k], batch) >>> 8);
    batch.file = new MeshBatch(address, batch.rows.length, this.shine, done, painted ? colorOf : null);
    this.group.add(batch.file.group);
  }

  private makeNoses(): Batch | null {
    const rows: number[] = [];
    this.scene.models.forEach((model, row) => {
      if ((model.kind === 'position' || model.nose) && model.shape !== undefined && !model.smoke && !isPerson(this.scene, row)) rows.push(row);
    });
    if (rows.length === 0) return null;
    const geometry = new BufferGeometry();
    // Heading mark ahead of a body of size 1.
    const points = new Float32Array([0.74, 0, 0, 0.54, 0.26, 0, 0.54, -0.26, 0]);
    geometry.setAttribute('position', new BufferAttribute(points, 3));
    geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(points, (_, i) => (i % 3 === 2 ? 1 : 0)), 3));
    const mesh = new InstancedMesh(geometry, new MeshLambertMaterial({ side: DoubleSide }), rows.length);
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return { mesh, edges: null, rows, origins: [] };
  }

  private noseMatrix(row: number): Matrix4 {
    const model = this.scene.models[row];
    const [length, width] = model.size;
    const middle = heightOf(this.scene.shapes[model.shape!]) / 2;
    const matrix = bodyMatrix(this.motion, row, model.origin ?? [0, 0, 0, 0], this.matrix);
    const e = matrix.elements;
    for (let k = 0; k < 3; ++k) {
      e[k] *= length;
      e[4 + k] *= width;
    }
    for (let k = 0; k < 3; ++k) e[12 + k] += middle * e[8 + k];
    return matrix;
  }
}

/** Brightness function of a model's kind. */
function shadeOf({ kind }: Model): KindPage['shade'] {
  return kKindPages.find((page) => page.kind === kind)?.shade;
}

/** Scales the brightness of a colour 0xRRGGBBAA. */
function darkened(color: number, brightness: number): number {
  const part = (shift: number) => Math.round(((color >>> shift) & 0xff) * brightness) << shift;
  return (part(24) | part(16) | part(8) | (color & 0xff)) >>> 0;
}

interface Drawn {
  geometry: BufferGeometry | null;
  edges: BufferGeometry;
}

/** Of what has a look and no body. */
const kBodiless: Drawn = { geometry: empty(), edges: empty() };

function empty(): BufferGeometry {
  return new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(0), 3));
}

/** Cache by shape and number of omitted solids: bitmap walls are slow to extrude, and survive population changes. */
const kDrawn = new WeakMap<Solid[], Map<number, Drawn>>();

function drawnOf(solids: Solid[], leftOut: number): Drawn {
  const ofShape = kDrawn.get(solids) ?? new Map<number, Drawn>();
  kDrawn.set(solids, ofShape);
  const drawn = solids.slice(0, solids.length - leftOut);
  const known = ofShape.get(leftOut) ?? { geometry: geometryOf(drawn), edges: edgesOf(drawn) };
  ofShape.set(leftOut, known);
  return known;
}

/** Instanced outlines that share a mesh's matrices. */
export function followers(geometry: BufferGeometry, mesh: InstancedMesh, alpha: number, theme: Theme): LineSegments {
  const material = new LineBasicMaterial({ color: theme.edge, transparent: true, opacity: alpha < 1 ? 0.25 : 0.55 });
  // three.js instances any object with these members, but offers a class only for meshes.
  const lines = Object.assign(new LineSegments(geometry, material), {
    isInstancedMesh: true,
    instanceMatrix: mesh.instanceMatrix,
    instanceColor: null,
    morphTexture: null,
    count: mesh.count,
  });
  lines.frustumCulled = false;
  return lines;
}
