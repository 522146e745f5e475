// What `playhouse convert` writes as glTF is what three.js reads.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { Box3, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { finish } from './program.mjs';

async function converted(world) {
  const folder = mkdtempSync(join(tmpdir(), 'playhouse-gltf-'));
  try {
    const file = join(folder, 'made.glb');
    const { code, said } = await finish('convert', world, '-o', file);
    assert.equal(code, 0, said);
    const bytes = readFileSync(file);
    return await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the cave is as large in three.js as in its file, with y up, and its robots are in it', async () => {
  const { scene } = await converted('worlds/cave.world');
  scene.updateMatrixWorld(true);
  const size = new Box3().setFromObject(scene).getSize(new Vector3());
  assert.ok(Math.abs(size.x - 16) < 0.01 && Math.abs(size.z - 16) < 0.01, `${size.x} ${size.z}`);
  assert.ok(size.y > 0.5 && size.y < 2, `${size.y}`);
  const coral = scene.getObjectByName('coral');
  assert.ok(coral, 'a robot has its name');
  let triangles = 0;
  coral.traverse((thing) => {
    if (thing.isMesh) triangles += thing.geometry.index.count / 3;
  });
  assert.ok(triangles >= 28, `${triangles} triangles: an octagon with top and bottom, and a laser`);
});
