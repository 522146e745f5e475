import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';

const kFov = (35 * Math.PI) / 180;
const kScale = { least: 0.5, most: 2000 }; // pixels per metre
const kEyeFov = 70; // degrees, vertical field of view
const kEyeReach = 20; // m: range of the world sent to a first-person view
const kEyeFar = 5000; // m
const kFitSteps = 8;
const kHighest = 1000; // m: far plane from above, at any zoom
const kPitchMost = (78 * Math.PI) / 180;
export const kTilted = (50 * Math.PI) / 180;

export interface Box {
  x_min: number;
  y_min: number;
  x_max: number;
  y_max: number;
}

/** Pose of a camera: metres and radians, pitch positive up. */
export interface Eye {
  x: number;
  y: number;
  z: number;
  yaw: number;
  pitch: number;
  fov?: number; // rad, vertical; none: that of a person
}

/** Margins of the view covered by panels, in pixels. */
export interface Margins {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/**
 * Camera of the view: target point on the floor, scale there, rotation about the vertical, and tilt.
 * Vertical views are orthographic; tilted ones use a perspective with the same scale at the target.
 */
export class CameraRig {
  x = 0;
  y = 0;
  scale = 50;
  yaw = 0;
  pitch = 0; // 0: vertical
  width = 1;
  height = 1;
  /** Overrides the view by a first-person or free camera; null: from above. */
  eye: Eye | null = null;

  private readonly eyes = new PerspectiveCamera(kEyeFov);
  private readonly flat = new OrthographicCamera();
  private readonly deep = new PerspectiveCamera();
  private glide: { pitch: number; yaw: number; x: number; y: number; scale: number } | null = null;

  get camera(): Camera {
    if (this.eye) return this.eyes;
    return this.pitch < 1e-3 ? this.flat : this.deep;
  }

  resize(width: number, height: number): void {
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
  }

  /** Whether an animated move is in progress. */
  get gliding(): boolean {
    return this.glide !== null;
  }

  /** Advances the animated move; false when at rest. */
  update(seconds: number): boolean {
    const { glide } = this;
    if (glide) {
      const t = 1 - Math.exp(-9 * seconds);
      this.pitch += t * (glide.pitch - this.pitch);
      this.yaw += t * (glide.yaw - this.yaw);
      this.x += t * (glide.x - this.x);
      this.y += t * (glide.y - this.y);
      this.scale *= (glide.scale / this.scale) ** t;
      const turned = Math.max(Math.abs(glide.pitch - this.pitch), Math.abs(glide.yaw - this.yaw)) < 2e-3;
      if (turned && Math.abs(glide.scale / this.scale - 1) < 2e-3) {
        Object.assign(this, glide);
        this.glide = null;
      }
    }
    this.place();
    return glide !== null;
  }

  glideTo(to: { pitch?: number; yaw?: number; x?: number; y?: number; scale?: number }): void {
    const now = this.glide ?? { pitch: this.pitch, yaw: this.yaw, x: this.x, y: this.y, scale: this.scale };
    this.glide = { ...now, ...to };
  }

  /** Tilts the view, or shows it from above with north up: +y on the screen upwards, +x to the right. */
  tilt(): void {
    if (this.pitch <= 0.02) return this.glideTo({ pitch: kTilted });
    this.yaw = Math.atan2(Math.sin(this.yaw), Math.cos(this.yaw)); // the shorter way round
    this.glideTo({ pitch: 0, yaw: 0 });
  }

  /** Vertical view with this world point at the top left corner. Cancels an animated move. */
  showFrom(left: number, top: number, scale: number): void {
    this.glide = null;
    Object.assign(this, { x: left + this.width / 2 / scale, y: top - this.height / 2 / scale, scale, yaw: 0, pitch: 0 });
    this.place();
  }

  /** Fits a box into the view inside the margins. */
  fit(box: Box, margins: Margins, mode: 'glide' | 'jump'): void {
    const trial = new CameraRig();
    trial.resize(this.width, this.height);
    trial.yaw = this.glide?.yaw ?? this.yaw;
    trial.pitch = this.glide?.pitch ?? this.pitch;
    trial.x = (box.x_min + box.x_max) / 2;
    trial.y = (box.y_min + box.y_max) / 2;
    trial.scale = kScale.least;
    for (let k = 0; k < kFitSteps; ++k) trial.fitBetter(box, margins);
    const { x, y, scale } = trial;
    if (mode === 'glide') this.glideTo({ x, y, scale });
    else Object.assign(this, { x, y, scale });
  }

  /** Perspective scale depends on the distance, which changes with the target: refines the fit from the previous one. */
  private fitBetter(box: Box, margins: Margins): void {
    this.place();
    const corners = [[box.x_min, box.y_min], [box.x_max, box.y_min], [box.x_max, box.y_max], [box.x_min, box.y_max]].map(([x, y]) => this.pixelOf(x, y, 0));
    const xs = corners.map((p) => p?.x ?? 0);
    const ys = corners.map((p) => p?.y ?? 0);
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const free = { x: this.width - margins.left - margins.right, y: this.height - margins.top - margins.bottom };
    const middle = this.floorAt((left + right) / 2, (top + bottom) / 2);
    const least = this.scale; // a degenerate box is shown at a size of at least 1 m
    const scale = clamp(least * Math.min(free.x / Math.max(right - left, least), free.y / Math.max(bottom - top, least)), kScale.least, kScale.most);
    if (middle) Object.assign(this, { ...this.centreFor(middle.x, middle.y, scale, margins), scale });
  }

  /** Target point for which a floor point is at the centre of the view inside the margins. */
  centreFor(x: number, y: number, scale: number, margins: Margins): { x: number; y: number } {
    const yaw = this.glide?.yaw ?? this.yaw;
    const [s, c] = [Math.sin(yaw), Math.cos(yaw)];
    const right = (margins.right - margins.left) / 2 / scale;
    const ahead = (margins.top - margins.bottom) / 2 / scale / Math.cos(this.glide?.pitch ?? this.pitch);
    return { x: x + c * right - s * ahead, y: y + s * right + c * ahead };
  }

  lookAt(x: number, y: number): void {
    this.x = x;
    this.y = y;
    if (this.glide) Object.assign(this.glide, { x, y });
  }

  /** Zooms about the floor point under the pointer. */
  zoom(factor: number, px: number, py: number): void {
    this.glide = null;
    const before = this.floorAt(px, py);
    this.scale = clamp(this.scale * factor, kScale.least, kScale.most);
    this.place();
    const after = this.floorAt(px, py);
    if (!before || !after) return;
    this.x += before.x - after.x;
    this.y += before.y - after.y;
    this.place();
  }

  turn(yaw: number, pitch: number): void {
    this.glide = null;
    this.yaw += yaw;
    this.pitch = clamp(this.pitch + pitch, 0, kPitchMost);
    if (this.pitch < 0.03) this.pitch = 0;
    this.place();
  }

  /** Intersection of a pixel's ray with the floor; null if there is none. */
  floorAt(px: number, py: number): Vector3 | null {
    return this.rayAt(px, py)(0);
  }

  /** The ray of a pixel, as a function from height z to its point there. */
  rayAt(px: number, py: number): (z: number) => Vector3 | null {
    const [x, y] = [(px / this.width) * 2 - 1, 1 - (py / this.height) * 2];
    const near = new Vector3(x, y, -1).unproject(this.camera);
    const far = new Vector3(x, y, 1).unproject(this.camera);
    return (z) => {
      const along = (z - near.z) / (far.z - near.z);
      return along >= 0 && along <= 1 ? near.clone().lerp(far, along) : null;
    };
  }

  /** Projection of a point to pixels; null outside the depth range. */
  pixelOf(x: number, y: number, z: number): { x: number; y: number } | null {
    const p = new Vector3(x, y, z).project(this.camera);
    if (p.z < -1 || p.z > 1) return null;
    return { x: ((p.x + 1) / 2) * this.width, y: ((1 - p.y) / 2) * this.height };
  }

  /** Approximate pixels per metre at a point. */
  scaleAt(x: number, y: number, z: number): number {
    if (this.camera === this.flat) return this.scale;
    const camera = this.eye ? this.eyes : this.deep;
    const far = Math.max(camera.position.distanceTo(new Vector3(x, y, z)), 0.1);
    return this.height / 2 / far / Math.tan((camera.fov * Math.PI) / 360);
  }

  /** Bounding box of the visible floor; clipped if the view reaches the horizon. */
  view(): Box {
    if (this.eye) {
      const { x, y } = this.eye;
      return { x_min: x - kEyeReach, y_min: y - kEyeReach, x_max: x + kEyeReach, y_max: y + kEyeReach };
    }
    const reach = (4 * Math.max(this.width, this.height)) / this.scale;
    const box = { x_min: Infinity, y_min: Infinity, x_max: -Infinity, y_max: -Infinity };
    for (const [px, py] of [[0, 0], [this.width, 0], [0, this.height], [this.width, this.height]]) {
      const p = this.floorAt(px, py);
      const x = p ? clamp(p.x, this.x - reach, this.x + reach) : px === 0 ? this.x - reach : this.x + reach;
      const y = p ? clamp(p.y, this.y - reach, this.y + reach) : this.y + reach;
      box.x_min = Math.min(box.x_min, x);
      box.x_max = Math.max(box.x_max, x);
      box.y_min = Math.min(box.y_min, p ? y : this.y - reach);
      box.y_max = Math.max(box.y_max, y);
    }
    return box;
  }

  /** A camera with the same target and direction, at the distance of equal scale in a person's field of view. */
  eyeHere(): Eye {
    if (this.eye) return { ...this.eye, fov: undefined };
    const pitch = Math.max(this.pitch - Math.PI / 2, -1.5);
    const far = this.height / 2 / this.scale / Math.tan((kEyeFov * Math.PI) / 360);
    const yaw = this.yaw + Math.PI / 2;
    const back = far * Math.cos(pitch);
    return { x: this.x - back * Math.cos(yaw), y: this.y - back * Math.sin(yaw), z: -far * Math.sin(pitch), yaw, pitch };
  }

  private placeEye({ x, y, z, yaw, pitch, fov }: Eye): void {
    const { eyes } = this;
    eyes.fov = fov === undefined ? kEyeFov : (fov * 180) / Math.PI;
    eyes.position.set(x, y, z);
    eyes.up.set(0, 0, 1);
    eyes.lookAt(x + Math.cos(yaw) * Math.cos(pitch), y + Math.sin(yaw) * Math.cos(pitch), z + Math.sin(pitch));
    eyes.aspect = this.width / this.height;
    eyes.near = 0.05;
    eyes.far = kEyeFar;
    eyes.updateProjectionMatrix();
    eyes.updateMatrixWorld();
  }

  private place(): void {
    if (this.eye) this.placeEye(this.eye);
    const distance = this.height / 2 / this.scale / Math.tan(kFov / 2);
    const back = Math.sin(this.pitch) * distance;
    const up = Math.cos(this.pitch) * distance;
    const s = Math.sin(this.yaw);
    const c = Math.cos(this.yaw);
    for (const camera of [this.flat, this.deep]) {
      camera.position.set(this.x + s * back, this.y - c * back, up);
      camera.up.set(-s, c, 0);
      camera.lookAt(this.x, this.y, 0);
    }
    const half = this.height / 2 / this.scale;
    this.flat.top = half;
    this.flat.bottom = -half;
    this.flat.right = (half * this.width) / this.height;
    this.flat.left = -this.flat.right;
    this.deep.fov = (kFov * 180) / Math.PI;
    this.deep.aspect = this.width / this.height;
    this.flat.near = distance - kHighest;
    this.deep.near = distance * 0.02;
    for (const camera of [this.flat, this.deep]) {
      camera.far = distance * 12 + 50;
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
    }
  }
}

function clamp(value: number, least: number, most: number): number {
  return Math.min(Math.max(value, least), most);
}
