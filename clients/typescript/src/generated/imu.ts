/**
 * Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation.
 *
 * Generated from interfaces/060_imu.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 60;

/** Pose by integration. (player_imu_data_state_t) */
export interface DataState {
  /** In m, m, m, rad, rad, rad, frame X_WS. */
  pose: common.Pose3d;
}

export const DataState: Codec<DataState> = new Codec<DataState>('imu.DataState', {
  zero: () => ({ pose: common.Pose3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    return { pose };
  },
});

/** Calibrated readings. (player_imu_data_calib_t) */
export interface DataCalib {
  /** In m/s^2, frame a_WS_S. */
  accelX: number;
  /** In m/s^2, frame a_WS_S. */
  accelY: number;
  /** In m/s^2, frame a_WS_S. */
  accelZ: number;
  /** In rad/s, frame v_WS_S. */
  gyroX: number;
  /** In rad/s, frame v_WS_S. */
  gyroY: number;
  /** In rad/s, frame v_WS_S. */
  gyroZ: number;
  /** Magnetic field, in a driver-specific unit (frame n_S). */
  magnX: number;
  /** Frame n_S. */
  magnY: number;
  /** Frame n_S. */
  magnZ: number;
}

export const DataCalib: Codec<DataCalib> = new Codec<DataCalib>('imu.DataCalib', {
  zero: () => ({ accelX: 0, accelY: 0, accelZ: 0, gyroX: 0, gyroY: 0, gyroZ: 0, magnX: 0, magnY: 0, magnZ: 0 }),
  write(to, value) {
    to.float32(value.accelX);
    to.float32(value.accelY);
    to.float32(value.accelZ);
    to.float32(value.gyroX);
    to.float32(value.gyroY);
    to.float32(value.gyroZ);
    to.float32(value.magnX);
    to.float32(value.magnY);
    to.float32(value.magnZ);
  },
  read(from) {
    const accelX = from.float32();
    const accelY = from.float32();
    const accelZ = from.float32();
    const gyroX = from.float32();
    const gyroY = from.float32();
    const gyroZ = from.float32();
    const magnX = from.float32();
    const magnY = from.float32();
    const magnZ = from.float32();
    return { accelX, accelY, accelZ, gyroX, gyroY, gyroZ, magnX, magnY, magnZ };
  },
});

/** Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t) */
export interface DataQuat {
  calibData: DataCalib;
  /** Real part (frame R_WS). */
  q0: number;
  /** Frame R_WS. */
  q1: number;
  /** Frame R_WS. */
  q2: number;
  /** Frame R_WS. */
  q3: number;
}

export const DataQuat: Codec<DataQuat> = new Codec<DataQuat>('imu.DataQuat', {
  zero: () => ({ calibData: DataCalib.make(), q0: 0, q1: 0, q2: 0, q3: 0 }),
  write(to, value) {
    DataCalib.write(to, value.calibData);
    to.float32(value.q0);
    to.float32(value.q1);
    to.float32(value.q2);
    to.float32(value.q3);
  },
  read(from) {
    const calibData = DataCalib.read(from);
    const q0 = from.float32();
    const q1 = from.float32();
    const q2 = from.float32();
    const q3 = from.float32();
    return { calibData, q0, q1, q2, q3 };
  },
});

/** Calibrated readings and orientation as angles. (player_imu_data_euler_t) */
export interface DataEuler {
  calibData: DataCalib;
  /** In rad, frame R_WS. */
  orientation: common.Orientation3d;
}

export const DataEuler: Codec<DataEuler> = new Codec<DataEuler>('imu.DataEuler', {
  zero: () => ({ calibData: DataCalib.make(), orientation: common.Orientation3d.make() }),
  write(to, value) {
    DataCalib.write(to, value.calibData);
    common.Orientation3d.write(to, value.orientation);
  },
  read(from) {
    const calibData = DataCalib.read(from);
    const orientation = common.Orientation3d.read(from);
    return { calibData, orientation };
  },
});

/** Pose, velocity and acceleration. (player_imu_data_fullstate_t) */
export interface DataFullstate {
  /** In m, m, m, rad, rad, rad, frame X_WS. */
  pose: common.Pose3d;
  /** In m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S. */
  vel: common.Pose3d;
  /** In m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S. */
  acc: common.Pose3d;
}

export const DataFullstate: Codec<DataFullstate> = new Codec<DataFullstate>('imu.DataFullstate', {
  zero: () => ({ pose: common.Pose3d.make(), vel: common.Pose3d.make(), acc: common.Pose3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    common.Pose3d.write(to, value.vel);
    common.Pose3d.write(to, value.acc);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const vel = common.Pose3d.read(from);
    const acc = common.Pose3d.read(from);
    return { pose, vel, acc };
  },
});

/** Selected data message. (player_imu_datatype_config_t) */
export interface DatatypeConfig {
  /** Its subtype. */
  value: number;
}

export const DatatypeConfig: Codec<DatatypeConfig> = new Codec<DatatypeConfig>('imu.DatatypeConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** Quantity that becomes the reference. (player_imu_reset_orientation_config_t) */
export interface ResetOrientationConfig {
  /** 0: heading, 1: orientation, 2: driver-specific. */
  value: number;
}

export const ResetOrientationConfig: Codec<ResetOrientationConfig> = new Codec<ResetOrientationConfig>('imu.ResetOrientationConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** A new orientation. (player_imu_reset_euler_config_t) */
export interface ResetEulerConfig {
  /** Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS). */
  orientation: common.Pose3d;
}

export const ResetEulerConfig: Codec<ResetEulerConfig> = new Codec<ResetEulerConfig>('imu.ResetEulerConfig', {
  zero: () => ({ orientation: common.Pose3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.orientation);
  },
  read(from) {
    const orientation = common.Pose3d.read(from);
    return { orientation };
  },
});

/** Pose by integration. */
export const DATA_STATE: MessageType<DataState> = new MessageType(60, Kind.DATA, 1, 'imu.data.state', DataState);

/** Calibrated readings. */
export const DATA_CALIB: MessageType<DataCalib> = new MessageType(60, Kind.DATA, 2, 'imu.data.calib', DataCalib);

/** Calibrated readings and orientation as a quaternion. */
export const DATA_QUAT: MessageType<DataQuat> = new MessageType(60, Kind.DATA, 3, 'imu.data.quat', DataQuat);

/** Calibrated readings and orientation as angles. */
export const DATA_EULER: MessageType<DataEuler> = new MessageType(60, Kind.DATA, 4, 'imu.data.euler', DataEuler);

/** Pose, velocity and acceleration. */
export const DATA_FULLSTATE: MessageType<DataFullstate> = new MessageType(
  60,
  Kind.DATA,
  5,
  'imu.data.fullstate',
  DataFullstate,
);

/** Selects which data message is sent. */
export const REQ_SET_DATATYPE: MessageType<DatatypeConfig> = new MessageType(
  60,
  Kind.REQ,
  1,
  'imu.req.set_datatype',
  DatatypeConfig,
);

/** Makes the current orientation the reference. */
export const REQ_RESET_ORIENTATION: MessageType<ResetOrientationConfig> = new MessageType(
  60,
  Kind.REQ,
  2,
  'imu.req.reset_orientation',
  ResetOrientationConfig,
);

/** Sets the current orientation. */
export const REQ_RESET_EULER: MessageType<ResetEulerConfig> = new MessageType(
  60,
  Kind.REQ,
  3,
  'imu.req.reset_euler',
  ResetEulerConfig,
);
