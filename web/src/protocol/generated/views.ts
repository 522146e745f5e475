// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
import type { Pose, Rgba } from '../scene';

/** The kind of a model. */
export type Kind = 'plain' | 'position' | 'ranger' | 'fiducial' | 'blobfinder' | 'bumper' | 'blinkenlight' | 'lightindicator' | 'gripper' | 'actuator' | 'wifi' | 'camera' | 'detector' | 'custom' | 'imu' | 'gps';

/** Optional traits of models of any kind. */
export type Trait = 'pack';

/** Bits of a model's state; bits of a kind apply to models of that kind only. */
export const kBits = {
  subscribed: 1,
  position: { stalled: 2, motor_on: 4 },
  blinkenlight: { lit: 2, enabled: 4 },
  lightindicator: { lit: 2 },
  actuator: { stalled: 2, motor_on: 4, braked: 8 },
} as const;

/** A mobile base: a robot that drives in the plane. SI units and radians. */
export interface PositionView {
  vx: number; // m/s
  vy: number; // m/s
  va: number; // rad/s
  ox: number; // m
  oy: number; // m
  oa: number; // rad, in (-pi, pi]
}

/** A fiducial finder: detects markers (models with a fiducial_return) and reports their ids and poses. SI units and radians. */
export interface FiducialView {
  target: number;
  id: number;
  range: number; // m
  bearing: number; // rad, in (-pi, pi]
  heading: number; // rad, in (-pi, pi]
}

/** A camera that reports regions of one color (blobs). SI units and radians. */
export interface BlobfinderView {
  color: number;
  left: number;
  right: number;
  range: number; // m
}

/** Contact switches. SI units and radians. */
export interface BumperView {
  hit: number;
}

/** A flashing lamp. SI units and radians. */
export interface BlinkenlightView {
  period: number; // s
  dutycycle: number;
}

/** A gripper: two paddles that close around an object and carry it. SI units and radians. */
export interface GripperView {
  paddles: number;
  closing: number;
  lift: number;
  rising: number;
  held: number;
  beams: number;
  contacts: number;
}

/** A prismatic or revolute joint that moves the models on it. SI units and radians. */
export interface ActuatorView {
  position: number; // m or rad
  velocity: number; // m/s or rad/s
}

/** A radio: reports the received radios of its network with their signal levels, and carries messages between them. SI units and radians. */
export interface WifiView {
  station: number;
  level: number;
  quality: number;
}

/** A camera with pan, tilt and zoom. It renders color, gray, depth or segmentation images of bodies, floor and sky. SI units and radians. */
export interface CameraView {
  sample: number;
}

/** A sensor specified in the world file: what it detects and penetrates, its range, resolution and noise (docs/detectors.md). SI units and radians. */
export interface DetectorView {
  target: number;
  range: number; // m
  bearing: number; // rad, in (-pi, pi]
  level: number;
  bodies: number;
}

/** A model or sensor implemented in a shared library. SI units and radians. */
export interface CustomView {
  reading: number;
}

/** An inertial measurement unit: measures specific force and turn rate, and estimates its orientation. SI units and radians. */
export interface ImuView {
  ax: number;
  ay: number;
  az: number;
  wx: number; // rad/s
  wy: number; // rad/s
  wz: number; // rad/s
  heading: number; // rad, in (-pi, pi]
}

/** A satellite receiver: reports its position on the earth, derived from the world's latitude, longitude and altitude. SI units and radians. */
export interface GpsView {
  x: number; // m
  y: number; // m
  z: number; // m
}

/** A battery that supplies a model and its descendants without one of their own. SI units and radians. */
export interface PackView {
  stored: number; // J
  capacity: number; // J
  watts: number; // W
  charging: number;
}

/** Per kind, the fields sent during a run. */
export interface Views {
  position: PositionView;
  fiducial: FiducialView[];
  blobfinder: BlobfinderView[];
  bumper: BumperView[];
  blinkenlight: BlinkenlightView;
  gripper: GripperView;
  actuator: ActuatorView;
  wifi: WifiView[];
  camera: CameraView[];
  detector: DetectorView[];
  custom: CustomView[];
  imu: ImuView;
  gps: GpsView;
  pack: PackView;
}

export type Code = 'varint' | 'zigzag' | 'turn' | 'rgba';

/** Encoding of a view: the code of each number, and its quantum. */
export interface ViewFormat {
  kind: keyof Views;
  list: boolean;
  fields: readonly (readonly [name: string, code: Code, worth: number])[];
}

export const kViews: readonly ViewFormat[] = [
  { kind: 'position', list: false, fields: [['vx', 'zigzag', 0.001], ['vy', 'zigzag', 0.001], ['va', 'zigzag', 0.001], ['ox', 'zigzag', 0.001], ['oy', 'zigzag', 0.001], ['oa', 'turn', 1]] },
  { kind: 'fiducial', list: true, fields: [['target', 'varint', 1], ['id', 'zigzag', 1], ['range', 'varint', 0.001], ['bearing', 'turn', 1], ['heading', 'turn', 1]] },
  { kind: 'blobfinder', list: true, fields: [['color', 'rgba', 1], ['left', 'varint', 1], ['right', 'varint', 1], ['range', 'varint', 0.001]] },
  { kind: 'bumper', list: true, fields: [['hit', 'zigzag', 1]] },
  { kind: 'blinkenlight', list: false, fields: [['period', 'varint', 0.001], ['dutycycle', 'varint', 0.001]] },
  { kind: 'gripper', list: false, fields: [['paddles', 'varint', 0.001], ['closing', 'zigzag', 1], ['lift', 'varint', 0.001], ['rising', 'zigzag', 1], ['held', 'zigzag', 1], ['beams', 'varint', 1], ['contacts', 'varint', 1]] },
  { kind: 'actuator', list: false, fields: [['position', 'zigzag', 0.001], ['velocity', 'zigzag', 0.001]] },
  { kind: 'wifi', list: true, fields: [['station', 'varint', 1], ['level', 'zigzag', 1], ['quality', 'varint', 1]] },
  { kind: 'camera', list: true, fields: [['sample', 'varint', 1]] },
  { kind: 'detector', list: true, fields: [['target', 'varint', 1], ['range', 'varint', 0.001], ['bearing', 'turn', 1], ['level', 'varint', 0.001], ['bodies', 'varint', 1]] },
  { kind: 'custom', list: true, fields: [['reading', 'zigzag', 0.001]] },
  { kind: 'imu', list: false, fields: [['ax', 'zigzag', 0.001], ['ay', 'zigzag', 0.001], ['az', 'zigzag', 0.001], ['wx', 'zigzag', 0.001], ['wy', 'zigzag', 0.001], ['wz', 'zigzag', 0.001], ['heading', 'turn', 1]] },
  { kind: 'gps', list: false, fields: [['x', 'zigzag', 0.001], ['y', 'zigzag', 0.001], ['z', 'zigzag', 0.001]] },
  { kind: 'pack', list: false, fields: [['stored', 'zigzag', 1], ['capacity', 'zigzag', 1], ['watts', 'zigzag', 0.001], ['charging', 'varint', 1]] },
];

/** One transducer or scanner of a ranger. */
export interface Sensor {
  pose: Pose; // m, m, m, rad
  size: [number, number, number]; // m
  range: [number, number]; // m
  fov: number; // rad
  samples: number;
  color: Rgba;
}

/** Fields of the prototype of a model; only those of its kind are present. */
export interface KindStart {
  drive?: 'diff' | 'omni' | 'walk' | 'car';
  trail?: number;
  sensors?: Sensor[]; // ranger
  range?: number; // m
  fov?: number; // rad
  pan?: number; // rad
  image?: [number, number]; // px
  bpose?: Pose[]; // m, m, m, rad
  blength?: number[]; // m
  paddle?: [number, number, number];
  joint?: 'linear' | 'rotational';
  lowest?: number; // m or rad
  highest?: number; // m or rad
  axis?: [number, number, number]; // 1
  resolution?: [number, number]; // px
  view?: [number, number]; // rad
  shows?: 'color' | 'gray' | 'depth' | 'segmentation';
  reach?: [number, number]; // m
  library?: string;
  satellites?: number;
  traits?: Trait[];
}
