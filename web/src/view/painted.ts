import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, LineBasicMaterial, LineSegments, Mesh,
  type MaterialParameters, MeshBasicMaterial, type Object3D,
} from 'three';

/** Dynamic triangles or lines, rebuilt per frame, in world coordinates, with RGBA per vertex. */
export class Painted {
  readonly object: Object3D;
  private positions = new Float32Array(3 * 1024);
  private colors = new Float32Array(4 * 1024);
  private count = 0;
  private readonly geometry = new BufferGeometry();

  constructor(what: 'triangles' | 'lines', order: number, own: MaterialParameters = {}) {
    const look = { vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide, ...own };
    const object =
      what === 'triangles'
        ? new Mesh(this.geometry, new MeshBasicMaterial(look))
        : new LineSegments(this.geometry, new LineBasicMaterial(look));
    object.frustumCulled = false;
    object.renderOrder = order;
    this.object = object;
    this.attach();
  }

  begin(): void {
    this.count = 0;
  }

  corner(x: number, y: number, z: number, color: ArrayLike<number>, alpha: number): void {
    if ((this.count + 1) * 3 > this.positions.length) this.grow();
    const to = this.count * 3;
    this.positions[to] = x;
    this.positions[to + 1] = y;
    this.positions[to + 2] = z;
    const at = this.count * 4;
    this.colors[at] = color[0];
    this.colors[at + 1] = color[1];
    this.colors[at + 2] = color[2];
    this.colors[at + 3] = alpha;
    ++this.count;
  }

  end(): void {
    this.geometry.setDrawRange(0, this.count);
    for (const name of ['position', 'color']) {
      const attribute = this.geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private grow(): void {
    const positions = new Float32Array(this.positions.length * 2);
    const colors = new Float32Array(this.colors.length * 2);
    positions.set(this.positions);
    colors.set(this.colors);
    this.positions = positions;
    this.colors = colors;
    this.geometry.dispose();
    this.attach();
  }

  private attach(): void {
    this.geometry.setAttribute('position', new BufferAttribute(this.positions, 3).setUsage(DynamicDrawUsage));
    this.geometry.setAttribute('color', new BufferAttribute(this.colors, 4).setUsage(DynamicDrawUsage));
  }
}
