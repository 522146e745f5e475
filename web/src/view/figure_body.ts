import { BufferAttribute, BufferGeometry, Color, Matrix4, SphereGeometry, Vector3 } from 'three';
import { kBoneIndex, kSides, type BoneName } from './skeleton';

/** Material of a part of the figure; the shirt has the model's colour. */
export type Cloth = 'shirt' | 'collar' | 'skin' | 'trousers' | 'belt' | 'shoes' | 'soles' | 'hair' | 'white' | 'dark' | 'lips';

const kColors: Record<Cloth, number> = {
  shirt: 0xffffff, collar: 0xd0d0d0, skin: 0xdba684, trousers: 0x39465a, belt: 0x2a2420, shoes: 0x2b2e35, soles: 0xa9a49b,
  hair: 0x3d2a1f, white: 0xf6f4f0, dark: 0x23201e, lips: 0xb06a5c,
};

type Weights = [BoneName, number][];

/** Cross-section of a limb: an ellipse with half axes ahead and aside, at a height. */
interface Ring {
  z: number;
  ahead: number;
  aside: number;
  x?: number; // of its middle
  y?: number;
}

/** Level of detail: vertices per ring, and whether all rings and the face are included. */
export interface Detail {
  corners: number;
  full: boolean;
}

/** Skinned triangles; those in the model's own colour are a separate group. */
class Mesh {
  readonly positions: number[] = [];
  readonly colors: number[] = [];
  readonly bones: number[] = [];
  readonly weights: number[] = [];
  readonly own: number[] = []; // triangle indices
  readonly rest: number[] = [];
  private readonly color = new Color();

  vertex(x: number, y: number, z: number, cloth: Cloth, weights: Weights): number {
    const sum = weights.reduce((all, [, weight]) => all + weight, 0);
    const four = [...weights].sort((a, b) => b[1] - a[1]).slice(0, 4);
    this.positions.push(x, y, z);
    this.color.setHex(kColors[cloth]).toArray(this.colors, this.colors.length);
    for (let k = 0; k < 4; ++k) {
      this.bones.push(four[k] ? kBoneIndex.get(four[k][0])! : 0);
      this.weights.push(four[k] ? four[k][1] / sum : 0);
    }
    return this.positions.length / 3 - 1;
  }

  triangle(cloth: Cloth, a: number, b: number, c: number): void {
    (cloth === 'shirt' || cloth === 'collar' ? this.own : this.rest).push(a, b, c);
  }

  geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(this.colors), 3));
    geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(this.bones), 4));
    geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array(this.weights), 4));
    geometry.setIndex([...this.own, ...this.rest]);
    geometry.addGroup(0, this.own.length, 0);
    geometry.addGroup(this.own.length, this.rest.length, 1);
    geometry.computeVertexNormals();
    return geometry;
  }
}

/** Skin weights by height along a chain of bones: each pair is the blend range [from, to] to the next bone. */
function chain(first: BoneName, ...next: [BoneName, from: number, to: number][]): (z: number) => Weights {
  return (z) => {
    let weights: Weights = [[first, 1]];
    for (const [bone, from, to] of next) {
      const t = Math.min(Math.max((z - from) / (to - from), 0), 1);
      const share = t * t * (3 - 2 * t);
      weights = [...weights.map(([name, weight]): [BoneName, number] => [name, weight * (1 - share)]), [bone, share]];
    }
    return weights.filter(([, weight]) => weight > 1e-3);
  };
}

/** Lofted tube over rings, capped at both ends. */
function tube(mesh: Mesh, { corners, full }: Detail, rings: Ring[], cloth: Cloth, weightsAt: (z: number) => Weights): void {
  const kept = full ? rings : rings.filter((_, k) => k % 2 === 0 || k === rings.length - 1);
  const rows = kept.map(({ z, ahead, aside, x = 0, y = 0 }) =>
    Array.from({ length: corners }, (_, k) => {
      const angle = (2 * Math.PI * k) / corners;
      return mesh.vertex(x + ahead * Math.cos(angle), y + aside * Math.sin(angle), z, cloth, weightsAt(z));
    }),
  );
  const upwards = kept[kept.length - 1].z > kept[0].z;
  const face = (a: number, b: number, c: number) => (upwards ? mesh.triangle(cloth, a, b, c) : mesh.triangle(cloth, a, c, b));
  for (let row = 0; row + 1 < rows.length; ++row) {
    for (let k = 0; k < corners; ++k) {
      const [a, b] = [rows[row][k], rows[row][(k + 1) % corners]];
      const [c, d] = [rows[row + 1][k], rows[row + 1][(k + 1) % corners]];
      face(a, b, d);
      face(a, d, c);
    }
  }
  for (const [row, ring, turned] of [[rows[0], kept[0], true], [rows[rows.length - 1], kept[kept.length - 1], false]] as const) {
    const middle = mesh.vertex(ring.x ?? 0, ring.y ?? 0, ring.z, cloth, weightsAt(ring.z));
    for (let k = 0; k < corners; ++k) {
      const [a, b] = [row[k], row[(k + 1) % corners]];
      if (turned) face(middle, b, a);
      else face(middle, a, b);
    }
  }
}

/** A sphere or a part of one, rigidly bound to one bone. */
function ball(mesh: Mesh, cloth: Cloth, bone: BoneName, geometry: SphereGeometry, place: Matrix4): void {
  geometry.applyMatrix4(place);
  const { position } = geometry.attributes;
  const first = mesh.positions.length / 3;
  for (let k = 0; k < position.count; ++k) mesh.vertex(position.getX(k), position.getY(k), position.getZ(k), cloth, [[bone, 1]]);
  const index = geometry.index!;
  for (let k = 0; k < index.count; k += 3) mesh.triangle(cloth, first + index.getX(k), first + index.getX(k + 1), first + index.getX(k + 2));
}

function placed(x: number, y: number, z: number, ahead: number, aside: number, up: number, back = 0): Matrix4 {
  // A three.js sphere has its poles along y; here they point up, tilted back by an angle.
  return new Matrix4().makeTranslation(new Vector3(x, y, z))
    .multiply(new Matrix4().makeScale(ahead, aside, up))
    .multiply(new Matrix4().makeRotationY(-back))
    .multiply(new Matrix4().makeRotationX(Math.PI / 2));
}

/** A standing person, 1.75 m, arms down. */
export function makeFigure(detail: Detail): BufferGeometry {
  const mesh = new Mesh();
  torso(mesh, detail);
  for (const [side, y] of kSides) {
    arm(mesh, detail, side, y);
    leg(mesh, detail, side, y);
  }
  head(mesh, detail);
  return mesh.geometry();
}

function torso(mesh: Mesh, detail: Detail): void {
  const weights = chain('pelvis', ['spine', 1.0, 1.12], ['chest', 1.15, 1.28], ['neck', 1.46, 1.5], ['head', 1.54, 1.57]);
  tube(mesh, detail, [
    { z: 0.82, ahead: 0.03, aside: 0.05 }, { z: 0.845, ahead: 0.08, aside: 0.13, x: -0.005 }, { z: 0.88, ahead: 0.105, aside: 0.163, x: -0.008 },
    { z: 0.93, ahead: 0.116, aside: 0.17, x: -0.008 }, { z: 0.98, ahead: 0.107, aside: 0.158 }, { z: 1.02, ahead: 0.1, aside: 0.15 },
  ], 'trousers', weights);
  tube(mesh, detail, [
    { z: 0.95, ahead: 0.121, aside: 0.174, x: -0.004 }, { z: 0.97, ahead: 0.119, aside: 0.17, x: -0.002 }, { z: 1.04, ahead: 0.111, aside: 0.158 }, { z: 1.12, ahead: 0.108, aside: 0.155 },
    { z: 1.2, ahead: 0.116, aside: 0.167 }, { z: 1.28, ahead: 0.124, aside: 0.181, x: 0.004 }, { z: 1.34, ahead: 0.123, aside: 0.188, x: 0.004 },
    { z: 1.395, ahead: 0.108, aside: 0.19, x: -0.002 }, { z: 1.43, ahead: 0.089, aside: 0.172, x: -0.008 }, { z: 1.457, ahead: 0.072, aside: 0.125, x: -0.01 },
    { z: 1.482, ahead: 0.06, aside: 0.075, x: -0.01 },
  ], 'shirt', weights);
  tube(mesh, detail, [
    { z: 1.468, ahead: 0.064, aside: 0.08, x: -0.01 }, { z: 1.497, ahead: 0.058, aside: 0.064, x: -0.008 }, { z: 1.498, ahead: 0.052, aside: 0.057, x: -0.008 },
  ], 'collar', weights);
  tube(mesh, detail, [
    { z: 1.45, ahead: 0.055, aside: 0.062, x: -0.01 }, { z: 1.5, ahead: 0.05, aside: 0.053, x: -0.005 }, { z: 1.54, ahead: 0.047, aside: 0.049 },
    { z: 1.6, ahead: 0.05, aside: 0.05 },
  ], 'skin', weights);
}

function arm(mesh: Mesh, detail: Detail, side: 'Left' | 'Right', y: number): void {
  const [upper, lower, hand] = [`arm${side}`, `forearm${side}`, `hand${side}`] as const;
  const weights = chain(hand, [lower, 0.87, 0.92], [upper, 1.09, 1.19], ['chest', 1.425, 1.5]);
  const ring = (z: number, aside: number, ahead: number, thick: number, x = -0.004): Ring => ({ z, ahead, aside: thick, x, y: y * aside });
  tube(mesh, detail, [
    ring(1.452, 0.135, 0.02, 0.02), ring(1.445, 0.146, 0.042, 0.034), ring(1.425, 0.16, 0.055, 0.044), ring(1.385, 0.174, 0.062, 0.05), ring(1.34, 0.182, 0.061, 0.049),
    ring(1.27, 0.19, 0.056, 0.046), ring(1.215, 0.194, 0.056, 0.048), ring(1.214, 0.194, 0.046, 0.039),
  ], 'shirt', weights);
  tube(mesh, detail, [
    ring(1.3, 0.188, 0.04, 0.036), ring(1.22, 0.193, 0.043, 0.037), ring(1.16, 0.198, 0.041, 0.036), ring(1.13, 0.2, 0.041, 0.036), ring(1.08, 0.202, 0.044, 0.037),
    ring(1.0, 0.207, 0.038, 0.033), ring(0.93, 0.212, 0.03, 0.026), ring(0.895, 0.214, 0.028, 0.021),
  ], 'skin', weights);
  tube(mesh, detail, [
    ring(0.905, 0.214, 0.026, 0.02, 0), ring(0.875, 0.215, 0.036, 0.019, 0.003), ring(0.835, 0.216, 0.043, 0.02, 0.005), ring(0.8, 0.216, 0.042, 0.018, 0.004),
    ring(0.76, 0.213, 0.037, 0.015, 0), ring(0.725, 0.21, 0.03, 0.012, -0.003), ring(0.712, 0.208, 0.014, 0.007, -0.004),
  ], 'skin', weights);
  tube(mesh, { ...detail, corners: Math.min(detail.corners, 8) }, [
    ring(0.875, 0.213, 0.014, 0.014, 0.025), ring(0.84, 0.21, 0.014, 0.013, 0.044), ring(0.805, 0.207, 0.012, 0.011, 0.054), ring(0.788, 0.206, 0.005, 0.005, 0.056),
  ], 'skin', weights);
}

function leg(mesh: Mesh, detail: Detail, side: 'Left' | 'Right', y: number): void {
  const [thigh, shin, foot] = [`thigh${side}`, `shin${side}`, `foot${side}`] as const;
  const weights = chain(foot, [shin, 0.07, 0.13], [thigh, 0.43, 0.53], ['pelvis', 0.88, 0.97]);
  const ring = (z: number, ahead: number, aside: number, x = 0, out = 0.09): Ring => ({ z, ahead, aside, x, y: y * out });
  tube(mesh, detail, [
    ring(0.085, 0.048, 0.046, -0.012), ring(0.09, 0.058, 0.054, -0.012), ring(0.16, 0.056, 0.052, -0.012), ring(0.25, 0.06, 0.055, -0.012), ring(0.33, 0.064, 0.058, -0.01),
    ring(0.4, 0.063, 0.058, -0.002), ring(0.455, 0.064, 0.059, 0.006), ring(0.5, 0.067, 0.062, 0.006), ring(0.56, 0.071, 0.067, 0.002), ring(0.65, 0.079, 0.074, 0),
    ring(0.74, 0.087, 0.081, 0, 0.091), ring(0.82, 0.094, 0.086, -0.004, 0.091), ring(0.89, 0.1, 0.084, -0.006, 0.088), ring(0.94, 0.085, 0.07, -0.006, 0.085),
  ], 'trousers', weights);
  shoe(mesh, detail, foot, y);
}

/** Cross-sections from heel to toes: a flat sole and a round top. */
function shoe(mesh: Mesh, { corners, full }: Detail, foot: BoneName, y: number): void {
  const slices = [
    [-0.085, 0.014, 0.035], [-0.08, 0.03, 0.075], [-0.05, 0.04, 0.125], [-0.01, 0.043, 0.13], [0.025, 0.044, 0.105], [0.06, 0.046, 0.08], [0.1, 0.049, 0.064], [0.135, 0.046, 0.054],
    [0.16, 0.036, 0.044], [0.175, 0.014, 0.03],
  ].filter((_, k) => full || k % 2 === 0 || k === 9);
  for (const [cloth, low, high, wide] of [['shoes', 0.018, 1, 1], ['soles', 0, 0, 1.08]] as const) {
    const rows = slices.map(([x, half, top]) => Array.from({ length: corners }, (_, k) => {
      const angle = (2 * Math.PI * k) / corners;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const z = cloth === 'soles' ? (s > 0 ? 0.02 : 0) : s > 0 ? low + s * (top - low) * high : low;
      return mesh.vertex(x * (cloth === 'soles' ? 1.03 : 1), y * 0.09 + half * wide * Math.sign(c) * Math.abs(c) ** 0.6, z, cloth, [[foot, 1]]);
    }));
    for (let row = 0; row + 1 < rows.length; ++row) {
      for (let k = 0; k < corners; ++k) {
        const [a, b] = [rows[row][k], rows[row][(k + 1) % corners]];
        const [c, d] = [rows[row + 1][k], rows[row + 1][(k + 1) % corners]];
        mesh.triangle(cloth, a, b, d);
        mesh.triangle(cloth, a, d, c);
      }
    }
    const [heel, toes] = [rows[0], rows[rows.length - 1]];
    for (let k = 1; k + 1 < corners; ++k) {
      mesh.triangle(cloth, heel[0], heel[k + 1], heel[k]);
      mesh.triangle(cloth, toes[0], toes[k], toes[k + 1]);
    }
  }
}

function head(mesh: Mesh, detail: Detail): void {
  const weights = (): Weights => [['head', 1]];
  tube(mesh, detail, [
    { z: 1.528, ahead: 0.028, aside: 0.026, x: 0.045 }, { z: 1.534, ahead: 0.052, aside: 0.04, x: 0.03 }, { z: 1.555, ahead: 0.074, aside: 0.055, x: 0.02 },
    { z: 1.585, ahead: 0.086, aside: 0.064, x: 0.012 }, { z: 1.62, ahead: 0.094, aside: 0.07, x: 0.006 }, { z: 1.66, ahead: 0.098, aside: 0.074, x: 0 },
    { z: 1.695, ahead: 0.096, aside: 0.073, x: -0.004 }, { z: 1.725, ahead: 0.08, aside: 0.062, x: -0.008 }, { z: 1.745, ahead: 0.05, aside: 0.04, x: -0.01 },
    { z: 1.75, ahead: 0.015, aside: 0.012, x: -0.01 },
  ], 'skin', weights);
  const [around, up] = detail.full ? [20, 10] : [8, 4];
  const round = (share = Math.PI) => new SphereGeometry(1, around, up, 0, 2 * Math.PI, 0, share);
  ball(mesh, 'hair', 'head', round(1.75), placed(-0.012, 0, 1.657, 0.111, 0.087, 0.11, 0.66));
  ball(mesh, 'skin', 'head', new SphereGeometry(1, 8, 6), placed(0.097, 0, 1.62, 0.017, 0.0115, 0.02));
  if (!detail.full) return;
  ball(mesh, 'lips', 'head', new SphereGeometry(1, 8, 6), placed(0.092, 0, 1.577, 0.008, 0.024, 0.006));
  for (const [, y] of kSides) {
    ball(mesh, 'white', 'head', new SphereGeometry(1, 10, 8), placed(0.083, 0.028 * y, 1.65, 0.01, 0.0125, 0.0085));
    ball(mesh, 'dark', 'head', new SphereGeometry(1, 8, 6), placed(0.0912, 0.0275 * y, 1.65, 0.003, 0.006, 0.006));
    ball(mesh, 'hair', 'head', new SphereGeometry(1, 8, 6), placed(0.0885, 0.029 * y, 1.6695, 0.006, 0.017, 0.0034));
    ball(mesh, 'skin', 'head', new SphereGeometry(1, 8, 6), placed(-0.004, 0.074 * y, 1.632, 0.02, 0.009, 0.03));
  }
}
