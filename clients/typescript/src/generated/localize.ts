/**
 * Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose.
 *
 * Generated from interfaces/025_localize.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 25;

/** A hypothesis. (player_localize_hypoth_t) */
export interface Hypoth {
  /** Mean of the hypothesis (in m, m, rad, frame X_MR). */
  mean: common.Pose2d;
  /** Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad). */
  cov: Float64Array;
  /** Weight; the weights sum to 1. */
  alpha: number;
}

export const Hypoth: Codec<Hypoth> = new Codec<Hypoth>('localize.Hypoth', {
  zero: () => ({ mean: common.Pose2d.make(), cov: new Float64Array(6), alpha: 0 }),
  write(to, value) {
    common.Pose2d.write(to, value.mean);
    to.exactly('cov', value.cov.length, 6);
    to.float64s(value.cov);
    to.float64(value.alpha);
  },
  read(from) {
    const mean = common.Pose2d.read(from);
    const cov = from.float64s(6);
    const alpha = from.float64();
    return { mean, cov, alpha };
  },
});

/** The hypotheses. (player_localize_data_t) */
export interface Data {
  /** Number of queued sensor readings. */
  pendingCount: number;
  /** Time of the last processed reading (in s). */
  pendingTime: number;
  hypoths: Hypoth[];
}

export const Data: Codec<Data> = new Codec<Data>('localize.Data', {
  zero: () => ({ pendingCount: 0, pendingTime: 0, hypoths: [] }),
  write(to, value) {
    to.uint32(value.pendingCount);
    to.float64(value.pendingTime);
    to.length('hypoths', value.hypoths.length, 419429);
    to.length('hypoths', value.hypoths.length, 419429);
    for (const each of value.hypoths) Hypoth.write(to, each);
  },
  read(from) {
    const pendingCount = from.uint32();
    const pendingTime = from.float64();
    const hypothsCount = from.uint32();
    const hypoths = from.many(from.length('hypoths', hypothsCount, 80), () => Hypoth.read(from));
    return { pendingCount, pendingTime, hypoths };
  },
});

/** Pose of the robot. (player_localize_set_pose_t) */
export interface SetPose {
  /** Mean of the hypothesis (in m, m, rad, frame X_MR). */
  mean: common.Pose2d;
  /** Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad). */
  cov: Float64Array;
}

export const SetPose: Codec<SetPose> = new Codec<SetPose>('localize.SetPose', {
  zero: () => ({ mean: common.Pose2d.make(), cov: new Float64Array(6) }),
  write(to, value) {
    common.Pose2d.write(to, value.mean);
    to.exactly('cov', value.cov.length, 6);
    to.float64s(value.cov);
  },
  read(from) {
    const mean = common.Pose2d.read(from);
    const cov = from.float64s(6);
    return { mean, cov };
  },
});

/** One particle. (player_localize_particle_t) */
export interface Particle {
  /** The particle's estimate of the robot's pose (in m, m, rad, frame X_MR). */
  pose: common.Pose2d;
  /** Weight. */
  alpha: number;
}

export const Particle: Codec<Particle> = new Codec<Particle>('localize.Particle', {
  zero: () => ({ pose: common.Pose2d.make(), alpha: 0 }),
  write(to, value) {
    common.Pose2d.write(to, value.pose);
    to.float64(value.alpha);
  },
  read(from) {
    const pose = common.Pose2d.read(from);
    const alpha = from.float64();
    return { pose, alpha };
  },
});

/** The particles of the filter. (player_localize_get_particles_t) */
export interface GetParticles {
  /** Of the most likely hypothesis (in m, m, rad, frame X_MR). */
  mean: common.Pose2d;
  /** Of the most likely hypothesis (in m^2). */
  variance: number;
  particles: Particle[];
}

export const GetParticles: Codec<GetParticles> = new Codec<GetParticles>('localize.GetParticles', {
  zero: () => ({ mean: common.Pose2d.make(), variance: 0, particles: [] }),
  write(to, value) {
    common.Pose2d.write(to, value.mean);
    to.float64(value.variance);
    to.length('particles', value.particles.length, 1048574);
    to.length('particles', value.particles.length, 1048574);
    for (const each of value.particles) Particle.write(to, each);
  },
  read(from) {
    const mean = common.Pose2d.read(from);
    const variance = from.float64();
    const particlesCount = from.uint32();
    const particles = from.many(from.length('particles', particlesCount, 32), () => Particle.read(from));
    return { mean, variance, particles };
  },
});

/** The hypotheses, the most likely first. */
export const DATA_HYPOTHS: MessageType<Data> = new MessageType(25, Kind.DATA, 1, 'localize.data.hypoths', Data);

/** Sets the robot's pose estimate. */
export const REQ_SET_POSE: MessageType<SetPose> = new MessageType(25, Kind.REQ, 1, 'localize.req.set_pose', SetPose);

/** Requests the particles of the driver's filter. */
export const REQ_GET_PARTICLES: MessageType<GetParticles> = new MessageType(
  25,
  Kind.REQ,
  2,
  'localize.req.get_particles',
  GetParticles,
);
