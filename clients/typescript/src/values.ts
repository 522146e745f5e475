/** Values of the proxies. SI units and radians; x forward, y left, z up, angles counter-clockwise. */

import { InvalidValue } from './errors.js';
import { camera } from './generated/index.js';

/**
 * A pose in the plane: x and y in m, a is the heading in rad, counter-clockwise, 0 along the frame's x, in (-pi, pi] as
 * servers report it. The frame is documented where a pose is returned.
 */
export interface Pose {
  x: number;
  y: number;
  a: number;
}

/**
 * A pose in space: x, y, z in m; roll, pitch, yaw in rad: rotations about z by yaw, then about the new y by pitch, then
 * about the new x by roll. The frame is documented where a pose is returned.
 */
export interface Pose3d {
  x: number;
  y: number;
  z: number;
  roll: number;
  pitch: number;
  yaw: number;
}

/** Extents in m along x, y and z. */
export interface Size {
  x: number;
  y: number;
  z: number;
}

/** x and y in m/s, a in rad/s, in the robot's frame. */
export type Velocity = Pose;

/** Ranges in m and their directions in rad, pairwise, in the order of measurement. */
export class Scan {
  constructor(
    readonly ranges: Float32Array | Float64Array,
    /** Counter-clockwise from the sensor's x axis. */
    readonly angles: Float64Array,
    readonly maxRange: number,
    /** The server's, in s. */
    readonly time: number,
  ) {}

  /** The minimum range between two directions; maxRange if no beam is there. */
  nearest(low = -Math.PI, high = Math.PI): number {
    let found = Infinity;
    let any = false;
    this.ranges.forEach((range, i) => {
      const angle = this.angles[i]!;
      if (!(low <= angle && angle <= high)) return;
      any = true;
      if (range < found) found = range;
    });
    return any ? found : this.maxRange;
  }

  /** End points of the beams, in m in the sensor's frame. */
  points(): { x: number; y: number }[] {
    return Array.from(this.ranges, (range, i) => {
      const angle = this.angles[i]!;
      return { x: range * Math.cos(angle), y: range * Math.sin(angle) };
    });
  }
}

/** A marker in view: its id, and its pose in the sensor's frame. */
export class Marker {
  constructor(readonly id: number, readonly pose: Pose3d) {}

  /** In m. */
  get distance(): number {
    return Math.hypot(this.pose.x, this.pose.y);
  }

  /** In rad. */
  get bearing(): number {
    return Math.atan2(this.pose.y, this.pose.x);
  }
}

/** Format of raw pixels -> their channels, and the bytes of one. */
const kChannels = new Map<number, [channels: number, bytes: number]>([
  [camera.FORMAT_MONO8, [1, 1]],
  [camera.FORMAT_MONO16, [1, 2]],
  [camera.FORMAT_RGB888, [3, 1]],
]);

/** An image: rows from the top, pixels from the left. */
export class Image {
  constructor(
    readonly width: number,
    readonly height: number,
    /**
     * One of camera.FORMAT_MONO8, FORMAT_MONO16 (of Playhouse: depth in mm, little-endian, 0 if nothing is in range),
     * FORMAT_RGB565 and FORMAT_RGB888.
     */
    readonly format: number,
    readonly isJpeg: boolean,
    /** The pixels, or a JPEG file. */
    readonly data: Uint8Array,
    /** The server's, in s. */
    readonly time: number,
  ) {}

  /**
   * [red, green, blue], or [brightness], or [depth in mm]. Throws InvalidValue for a JPEG file, for other formats,
   * outside the image, and if the data are shorter than the image.
   */
  pixel(column: number, row: number): number[] {
    const known = kChannels.get(this.format);
    if (this.isJpeg || !known) throw new InvalidValue('pixels can be told of raw MONO8, MONO16 and RGB888 alone');
    const isInside = column >= 0 && column < this.width && row >= 0 && row < this.height;
    if (!isInside || !Number.isInteger(column) || !Number.isInteger(row)) {
      throw new InvalidValue(`pixel ${column}, ${row} is outside the ${this.width} x ${this.height} picture`);
    }
    const [channels, bytes] = known;
    const first = (row * this.width + column) * channels * bytes;
    if (first + channels * bytes > this.data.length) {
      throw new InvalidValue(`the picture has fewer bytes than pixels: ${this.data.length}`);
    }
    if (bytes === 2) return [this.data[first]! + 256 * this.data[first + 1]!];
    return [...this.data.subarray(first, first + channels)];
  }

  /**
   * For images of a camera with `image "segmentation"`: the id of the model at the pixel, as in client.models(), up to
   * 24 bits; undefined without a model. Throws InvalidValue as pixel(), and for other formats.
   */
  modelId(column: number, row: number): number | undefined {
    const [red, green, blue] = this.pixel(column, row);
    if (red === undefined || green === undefined || blue === undefined) {
      throw new InvalidValue('which model a pixel shows is told by RGB888 alone');
    }
    const number = (red << 16) | (green << 8) | blue;
    return number > 0 ? number - 1 : undefined;
  }
}

/** Along x, y and z, or about them. */
export type Vector = [x: number, y: number, z: number];

/** An orientation, the real part first. */
export type Quaternion = [number, number, number, number];

/** A color, from 0 to 255. */
export type Rgb = [red: number, green: number, blue: number];
export type Rgba = [red: number, green: number, blue: number, alpha: number];

/** Whether a battery is being charged. */
export const Charging = { IMPOSSIBLE: -1, NO: 0, YES: 1 } as const;
export type Charging = (typeof Charging)[keyof typeof Charging];

/** Orientation in rad. */
export interface Attitude {
  roll: number;
  pitch: number;
  yaw: number;
}

/** Covariance of a pose in the plane, of x, y (m) and a (rad): xx, yy, aa are variances. */
export interface Covariance {
  xx: number;
  yy: number;
  aa: number;
  xy: number;
  ya: number;
  xa: number;
}

/** The covariance of independent errors with these standard deviations, in m, m and rad. */
export function covarianceOfDeviations(x: number, y: number, a: number): Covariance {
  return { xx: x * x, yy: y * y, aa: a * a, xy: 0, ya: 0, xa: 0 };
}

/** The data of a planner, poses on the map. */
export interface PlannerState {
  /** Whether there is a path to the goal. */
  valid: boolean;
  /** Whether the goal is reached. */
  done: boolean;
  /** The robot's. */
  pose: Pose;
  goal: Pose;
  /** Where the robot drives to now. */
  waypoint: Pose;
  /** Of the waypoint in the path, -1 if there is none. */
  index: number;
  /** Number of waypoints of the path. */
  count: number;
  /** The server's, in s. */
  time: number;
}

/** A planned path: its waypoints on the map, from the robot to the goal, and its length in m. */
export interface Path {
  waypoints: Pose[];
  length: number;
}

/** A cell of a map: its column from the left and its row from the bottom, from 0. */
export interface Cell {
  column: number;
  row: number;
}

/** The grid of a map. */
export class Grid {
  constructor(
    /** Length of a cell's side, in m. */
    readonly cellSize: number,
    /** In cells, as the height. */
    readonly width: number,
    readonly height: number,
    /** Pose of the lower left corner of cell 0, 0 in the world. */
    readonly origin: Pose,
  ) {}

  /** The cell with this point of the world (m); undefined beyond the map. */
  cellOf(x: number, y: number): Cell | undefined {
    const [dx, dy] = [x - this.origin.x, y - this.origin.y];
    const [c, s] = [Math.cos(this.origin.a), Math.sin(this.origin.a)];
    const column = (c * dx + s * dy) / this.cellSize;
    const row = (c * dy - s * dx) / this.cellSize;
    if (!(column >= 0 && column < this.width && row >= 0 && row < this.height)) return undefined;
    return { column: Math.floor(column), row: Math.floor(row) };
  }
}
