// Meshes of a world's files in the page: served, loaded, drawn with their colours and textures.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let page;
const asked = [];
const said = [];

before(async () => {
  program = await startProgram('worlds/mesh.world', ['--engine', 'arena']);
  browser = await startBrowser();
  ({ page } = await watch(browser, program.page));
  page.on('console', (message) => said.push(message.text()));
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('each file is served as glTF, once for the world', async () => {
  const address = new URL('meshes/0.glb', program.page);
  const reply = await fetch(address);
  assert.equal(reply.status, 200);
  assert.equal(reply.headers.get('content-type'), 'model/gltf-binary');
  const bytes = await reply.arrayBuffer();
  assert.equal(new TextDecoder().decode(bytes.slice(0, 4)), 'glTF');
  assert.equal((await fetch(address, { headers: { 'If-None-Match': reply.headers.get('etag') } })).status, 304);
  assert.equal((await fetch(new URL('meshes/99.glb', program.page))).status, 404);
});

// Table, barrel and ramp, and the look of a laser scanner.
test('the page draws them instead of their outlines', async () => {
  const drawn = () => page.waitForFunction(() => window.playhouse?.meshes === 4, null, { timeout: 30000 });
  await drawn();  // whatever it asks for is here
  page.on('request', (request) => asked.push(request.url()));
  await page.reload();
  await drawn();
  assert.equal(asked.filter((url) => url.includes('/meshes/')).length, 4, 'a file is loaded once, however many look so');
  assert.deepEqual(said.filter((line) => /mesh|Content Security/i.test(line)), []);
  await page.screenshot({ path: join(results, 'mesh.png') });
});
