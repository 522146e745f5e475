import { DynamicDrawUsage, Group, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial, type BufferGeometry, type Color, type Material } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { Shine } from './surfaces';

/** One mesh primitive of a glTF file, in the body's frame. */
interface Surface {
  geometry: BufferGeometry;
  material: Material;
}

/**
 * A file's material in this light; null: map view, where metalness
 * is 0, as metals would be black without an environment to reflect.
 */
export function materialIn(shine: Shine | null, of: Material): Material {
  const material = of.clone();
  if (!(material instanceof MeshStandardMaterial)) return material;
  if (!shine) material.metalness = 0;
  if (material.metalness > 0) material.envMap = shine!.around;
  return material;
}

/** Whether surfaces of a look with this material have the colour of their model: white ones without texture. */
export function isPainted(material: Material): boolean {
  if (!(material instanceof MeshStandardMaterial) || material.map) return false;
  const { r, g, b } = material.color;
  return Math.min(r, g, b) >= 0.999;
}

/** Cache by address: a file is loaded once, across population changes. */
const kLoaded = new Map<string, Promise<Surface[]>>();

function surfacesAt(address: string): Promise<Surface[]> {
  const known = kLoaded.get(address);
  if (known) return known;
  const loading = new GLTFLoader().loadAsync(address).then(({ scene }) => {
    // glTF is y-up; bodies are z-up.
    const toBody = new Matrix4().makeRotationX(Math.PI / 2);
    const surfaces: Surface[] = [];
    scene.updateMatrixWorld(true);
    scene.traverse((node) => {
      if (!(node instanceof Mesh)) return;
      const geometry = (node.geometry as BufferGeometry).clone().applyMatrix4(new Matrix4().multiplyMatrices(toBody, node.matrixWorld));
      surfaces.push({ geometry, material: node.material as Material });
    });
    return surfaces;
  });
  kLoaded.set(address, loading);
  loading.catch(() => kLoaded.delete(address)); // so that it is retried
  return loading;
}

/** Instances of a glTF file, once it is loaded. */
export class MeshBatch {
  readonly group = new Group();
  /** Resolves when the file is loaded or has failed. */
  readonly ready: Promise<void>;
  private parts: InstancedMesh<BufferGeometry, Material>[] = [];
  private surfaces: Surface[] = [];
  private isGone = false;

  /** `done` is called when the file is loaded (true) or has failed. */
  constructor(
    address: string,
    private readonly count: number,
    private shine: Shine | null,
    done: (loaded: boolean) => void,
    /** Colours of the instances, for surfaces that are painted; null: the file's own. */
    private readonly colorOf: ((k: number) => Color) | null = null,
  ) {
    this.ready = surfacesAt(address).then(
      (surfaces) => {
        if (this.isGone) return;
        this.add(surfaces);
        done(true);
      },
      (fault) => {
        console.warn(`mesh ${address}: ${fault}`);
        if (!this.isGone) done(false);
      },
    );
  }

  private add(surfaces: Surface[]): void {
    this.surfaces = surfaces;
    this.parts = surfaces.map(({ geometry, material }) => {
      const part = new InstancedMesh(geometry, materialIn(this.shine, material), this.count);
      part.instanceMatrix.setUsage(DynamicDrawUsage);
      part.frustumCulled = false;
      part.castShadow = part.receiveShadow = true;
      return part;
    });
    if (this.parts.length > 0) this.group.add(...this.parts);
    for (let k = 0; k < this.count; ++k) this.paint(k);
  }

  /** Uploads the colour of an instance. */
  paint(k: number): void {
    if (!this.colorOf) return;
    this.parts.forEach((part, i) => {
      if (!isPainted(this.surfaces[i].material)) return;
      part.setColorAt(k, this.colorOf!(k));
      part.instanceColor!.needsUpdate = true;
    });
  }

  /** Sets the lighting; null: map view. */
  shineBy(shine: Shine | null): void {
    this.shine = shine;
    this.parts.forEach((part, k) => {
      part.material.dispose();
      part.material = materialIn(shine, this.surfaces[k].material);
    });
  }

  place(k: number, matrix: Matrix4): void {
    for (const part of this.parts) part.setMatrixAt(k, matrix);
  }

  placed(): void {
    for (const part of this.parts) part.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.isGone = true;
    for (const part of this.parts) {
      part.dispose(); // the cached geometry stays, for the next population
      part.material.dispose();
    }
  }
}
