import { Color, Group, MeshLambertMaterial, Skeleton, SkinnedMesh, type Bone } from 'three';
import { makeFigure } from './figure_body';
import { pose } from './figure_pose';
import type { Gait } from './gait';
import { makeBones } from './skeleton';

const kNear = 110; // height in pixels above which the fine mesh is used
const kFine = makeFigure({ corners: 18, full: true });
const kCoarse = makeFigure({ corners: 7, full: false });

/** A person: skinned mesh at two levels of detail, its shirt in the model's colour. */
export class Figure {
  readonly object = new Group();
  private readonly bones: Bone[] = makeBones();
  private readonly skeleton = new Skeleton(this.bones);
  private readonly shirt = new MeshLambertMaterial({ vertexColors: true });
  private readonly rest = new MeshLambertMaterial({ vertexColors: true });
  private readonly meshes: SkinnedMesh[];

  constructor() {
    this.object.add(this.bones[0]);
    this.object.updateMatrixWorld(true);
    this.skeleton.calculateInverses();
    this.meshes = [kFine, kCoarse].map((geometry) => {
      const mesh = new SkinnedMesh(geometry, [this.shirt, this.rest]);
      mesh.bind(this.skeleton, this.object.matrixWorld);
      mesh.frustumCulled = false;
      mesh.castShadow = mesh.receiveShadow = true;
      this.object.add(mesh);
      return mesh;
    });
    this.adapt(0);
  }

  set color(hex: number) {
    this.shirt.color = new Color(hex);
  }

  pose(gait: Gait, wave: number): void {
    pose(this.bones, gait, wave);
  }

  /** Selects the level of detail by the height in pixels. */
  adapt(pixels: number): void {
    this.meshes[0].visible = pixels >= kNear;
    this.meshes[1].visible = pixels < kNear;
  }

  /** The geometry is shared and not disposed of. */
  dispose(): void {
    this.skeleton.dispose();
    this.shirt.dispose();
    this.rest.dispose();
  }
}
