import { MeshBasicMaterial, MeshStandardMaterial, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import type { Light } from '../protocol/scene';
import { isPainted, materialIn } from './meshes';

const shine = { light: {} as Light, around: new Texture() };
const standard = (material: unknown) => material as MeshStandardMaterial;

describe('materials of files', () => {
  const metal = new MeshStandardMaterial({ metalness: 0.9 });

  it('that are metals mirror what is around in the light of a scene', () => {
    const shown = standard(materialIn(shine, metal));
    expect(shown.metalness).toBe(0.9);
    expect(shown.envMap).toBe(shine.around);
    expect(standard(materialIn(shine, new MeshStandardMaterial({ metalness: 0 }))).envMap).toBeNull();
  });

  it('that are metals have their color on the map', () => {
    const shown = standard(materialIn(null, metal));
    expect(shown.metalness).toBe(0);
    expect(shown.envMap).toBeNull();
    expect(metal.metalness).toBe(0.9);
    expect(materialIn(null, new MeshBasicMaterial())).toBeInstanceOf(MeshBasicMaterial);
  });
});

describe('surfaces of looks', () => {
  it('have the color of the model where the file is white and has no texture', () => {
    expect(isPainted(new MeshStandardMaterial({ color: 0xffffff }))).toBe(true);
    expect(isPainted(new MeshStandardMaterial({ color: 0xfff0ff }))).toBe(false);
    expect(isPainted(new MeshStandardMaterial({ color: 0xffffff, map: new Texture() }))).toBe(false);
  });
});
