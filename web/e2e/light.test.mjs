// The light of a world, as who stands in it sees it: night and lamps with --engine arena, a map from above.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let browser;

before(async () => (browser = await startBrowser()));
after(async () => browser?.close());

/** The picture of a page: how bright it is from 0 to 1, row by row in bands of a tenth, and how bright its brightest spot. */
async function lightOf(page, name) {
  const coming = page.waitForEvent('download');
  await page.keyboard.press('p');
  const file = join(results, `light-${name}.png`);
  await (await coming).saveAs(file);
  return page.evaluate(async (png) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (byte) => byte.charCodeAt(0))], { type: 'image/png' }));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const bands = new Array(10).fill(0);
    let brightest = 0;
    for (let i = 0; i < data.length; i += 4) {
      const bright = (data[i] + data[i + 1] + data[i + 2]) / 765;
      bands[Math.floor((10 * i) / data.length)] += (bright / data.length) * 40;
      brightest = Math.max(brightest, bright);
    }
    return { bands, all: bands.reduce((a, b) => a + b) / 10, brightest };
  }, readFileSync(file).toString('base64'));
}

/** The yard at night by one engine, from above and through the lens of its robot. */
async function seenBy(engine, options = []) {
  const program = await startProgram('worlds/night.world', ['--engine', engine, ...options]);
  const { page, errors } = await watch(browser, program.page);
  await page.keyboard.press('n');
  const above = await lightOf(page, `${engine}-above`);
  await chooseRobot(page, 'r0');
  await page.keyboard.press('i');
  await page.waitForFunction(() => window.playhouse.eye !== null);
  const within = await lightOf(page, `${engine}-within`);
  assert.deepEqual(errors, []);
  await page.close();
  await program.stop();
  return { above, within };
}

test('who stands in a world of the arena sees its night and its lamps, who looks from above a map', async () => {
  const arena = await seenBy('arena');
  assert.ok(arena.above.all > 0.6, `from above: ${arena.above.all}`);
  assert.ok(arena.within.bands[0] < 0.25, `the sky: ${arena.within.bands}`);
  assert.ok(arena.within.bands[5] > 2 * arena.within.bands[0], `the wall in the light of lamps: ${arena.within.bands}`);
  assert.ok(arena.within.brightest > 0.7, `a lamp: ${arena.within.brightest}`);
});

test('the stage engine has no light of its own', async () => {
  const { within } = await seenBy('stage');
  assert.ok(within.bands[0] > 0.5, `the sky: ${within.bands}`);
});
