import { DynamicDrawUsage, Group, InstancedMesh, Matrix4, Mesh, type BufferGeometry, type Material } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** One surface of a file, in the body's frame. */
interface Surface {
  geometry: BufferGeometry;
  material: Material | Material[];
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
  private parts: InstancedMesh[] = [];
  private isGone = false;

  /** `shown` is called when the file is there. */
  constructor(
    address: string,
    private readonly count: number,
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
    this.parts = surfaces.map(({ geometry, material }) => {
      const part = new InstancedMesh(geometry, material, this.count);
      part.instanceMatrix.setUsage(DynamicDrawUsage);
      part.frustumCulled = false;
      part.castShadow = part.receiveShadow = true;
      return part;
    });
    if (this.parts.length > 0) this.group.add(...this.parts);
  }

  place(k: number, matrix: Matrix4): void {
    for (const part of this.parts) part.setMatrixAt(k, matrix);
  }

  placed(): void {
    for (const part of this.parts) part.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.isGone = true;
    for (const part of this.parts) part.dispose(); // surfaces stay, for the next population
  }
}
