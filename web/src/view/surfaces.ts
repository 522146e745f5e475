import { MeshBasicMaterial, MeshLambertMaterial, MeshStandardMaterial, type Material, type Texture } from 'three';
import { kBits } from '../protocol/generated/views';
import type { Light, Model } from '../protocol/scene';

const kDull = 0.5; // what is rougher shines no more than cloth
const kGamma = 2.2;

/** The light in which surfaces are seen, and what of it they mirror. */
export interface Shine {
  light: Light;
  around: Texture;
}

/**
 * The surface of a body: in the light of its scene as what it is made of shines, and lamps as what shines itself; on the
 * map, where there is no light, plain. Only what is smooth pays for more than its color: software renderers draw it, too.
 */
export function surfaceOf(model: Model, alpha: number, shine: Shine | null): Material {
  const seenThrough = { transparent: alpha < 1, opacity: alpha, depthWrite: alpha >= 1 };
  if (shine && isLamp(model)) return new MeshBasicMaterial(seenThrough);
  const [metalness, roughness] = model.shine ?? [0, 1];
  if (!shine || roughness > kDull) return new MeshLambertMaterial(seenThrough);
  const envMap = metalness > 0 ? shine.around : null;
  return new MeshStandardMaterial({ ...seenThrough, metalness, roughness, envMap });
}

/** What gives light, always or when it is switched on. */
export function isLamp(model: Model): boolean {
  return model.lamp !== undefined || switchOf(model) !== null;
}

/** Whether a lamp gives light now, by the bits of its state. */
export function isLit(model: Model, state: number): boolean {
  const lit = switchOf(model);
  return lit === null ? model.lamp !== undefined : (state & lit) !== 0;
}

/** The bit of its state that says whether it is lit; null for what has no switch. */
function switchOf({ kind }: Model): number | null {
  const bits = (kBits as Record<string, number | Record<string, number>>)[kind];
  return typeof bits === 'object' && 'lit' in bits ? bits.lit : null;
}

/** How bright a face of a lamp is that is not lit, as a share of its color on a screen: what light there is falls on it. */
export function darkOf(light: Light): number {
  return Math.min(light.ambient + 0.5 * sunOf(light), 1) ** (1 / kGamma);
}

/** The light of a sun that is up. */
export function sunOf({ sun, to_sun }: Light): number {
  return to_sun[2] > 0 ? sun : 0;
}

export function disposeAll(materials: Material | Material[]): void {
  for (const material of Array.isArray(materials) ? materials : [materials]) material.dispose();
}
