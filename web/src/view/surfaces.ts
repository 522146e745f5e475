import { MeshBasicMaterial, MeshLambertMaterial, MeshStandardMaterial, type Material, type Texture } from 'three';
import { kBits } from '../protocol/generated/views';
import type { Light, Model } from '../protocol/scene';

const kDull = 0.5; // rougher surfaces are drawn purely diffuse
const kGamma = 2.2;

/** Lighting of surfaces, and the environment map for reflections. */
export interface Shine {
  light: Light;
  around: Texture;
}

/**
 * Material of a body: lit by the scene, lamps emissive; flat in map view. Only smooth
 * surfaces use a physically based material, for the sake of software renderers.
 */
export function surfaceOf(model: Model, alpha: number, shine: Shine | null): Material {
  const seenThrough = { transparent: alpha < 1, opacity: alpha, depthWrite: alpha >= 1 };
  if (shine && isLamp(model)) return new MeshBasicMaterial(seenThrough);
  const [metalness, roughness] = model.shine ?? [0, 1];
  if (!shine || roughness > kDull) return new MeshLambertMaterial(seenThrough);
  const envMap = metalness > 0 ? shine.around : null;
  return new MeshStandardMaterial({ ...seenThrough, metalness, roughness, envMap });
}

/** Whether a model emits light, permanently or switchable. */
export function isLamp(model: Model): boolean {
  return model.lamp !== undefined || switchOf(model) !== null;
}

/** Whether a lamp is lit, by its state bits. */
export function isLit(model: Model, state: number): boolean {
  const lit = switchOf(model);
  return lit === null ? model.lamp !== undefined : (state & lit) !== 0;
}

/** The state bit for "lit"; null for models without a switch. */
function switchOf({ kind }: Model): number | null {
  const bits = (kBits as Record<string, number | Record<string, number>>)[kind];
  return typeof bits === 'object' && 'lit' in bits ? bits.lit : null;
}

/** Display brightness of an unlit lamp's face, as a factor on its colour: it reflects the scene's light. */
export function darkOf(light: Light): number {
  return Math.min(light.ambient + 0.5 * sunOf(light), 1) ** (1 / kGamma);
}

/** The sun's brightness; 0 below the horizon. */
export function sunOf({ sun, to_sun }: Light): number {
  return to_sun[2] > 0 ? sun : 0;
}

export function disposeAll(materials: Material | Material[]): void {
  for (const material of Array.isArray(materials) ? materials : [materials]) material.dispose();
}
