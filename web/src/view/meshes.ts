import { DynamicDrawUsage, Group, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial, type BufferGeometry, type Material } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { Shine } from './surfaces';

/** One surface of a file, in the body's frame. */
interface Surface {
  geometry: BufferGeometry;
  material: Material;
}

/**
 * The material of a file in this light; null: on the map, where there is nothing that metals could mirror, so that they would be
 * black: they have their color there.
 */
export function materialIn(shine: Shine | null, of: Material): Material {
  const material = of.clone();
  if (!(material instanceof MeshStandardMaterial)) return material;
  if (!shine) material.metalness = 0;
  if (material.metalness > 0) material.envMap = shine!.around;
  return material;
}

/** By address: a file is loaded once, however often who is in the world changes. */
const kLoaded = new Map<string, Promise<Surface[]>>();

function surfacesAt(address: string): Promise<Surface[]> {
  const known = kLoaded.get(address);
  if (known) return known;
  const loading = new GLTFLoader().loadAsync(address).then(({ scene }) => {
    // The file has y up, as glTF has it; bodies have z up.
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
  loading.catch(() => kLoaded.delete(address)); // to be tried again
  return loading;
}

/** Models that look as one file does, once that is there. */
export class MeshBatch {
  readonly group = new Group();
  /** When the file is there, or is known not to come. */
  readonly ready: Promise<void>;
  private parts: InstancedMesh<BufferGeometry, Material>[] = [];
  private surfaces: Surface[] = [];
  private isGone = false;

  /** `shown` is called when the file is there. */
  constructor(
    address: string,
    private readonly count: number,
    private shine: Shine | null,
    shown: () => void,
  ) {
    this.ready = surfacesAt(address).then(
      (surfaces) => {
        if (this.isGone) return;
        this.add(surfaces);
        shown();
      },
      (fault) => console.warn(`mesh ${address}: ${fault}`), // bodies stay as they are drawn without
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
  }

  /** Shows them in this light; null: as on a map. */
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
      part.dispose(); // what was loaded stays, for the next population
      part.material.dispose();
    }
  }
}
