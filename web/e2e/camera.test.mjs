// What cameras see, in the page: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let shown;

before(async () => {
  program = await startProgram('worlds/camera.world');
  browser = await startBrowser();
  shown = await watch(browser, program.page);
  await chooseRobot(shown.page, 'r0');
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

/** Colors of an image in the panel, each with its pixels. */
function colors(nth) {
  return shown.page.getByTestId('image').nth(nth).evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const counts = {};
    for (let k = 0; k < data.length; k += 4) {
      const color = data.slice(k, k + 3).join();
      counts[color] = (counts[color] ?? 0) + 1;
    }
    return counts;
  });
}

test('a selected robot shows what its cameras see', async () => {
  const { page } = shown;
  await page.waitForFunction(() => [...document.querySelectorAll('[data-testid=image]')].filter((canvas) => canvas.dataset.tick > 0).length === 2);
  const seen = await colors(0);
  assert.ok(seen['255,0,0'] > 20, `the red pillar: ${JSON.stringify(seen)}`);
  assert.ok(seen['34,139,34'] > 20, `the green pillar: ${JSON.stringify(seen)}`);
  assert.ok(Object.keys(await colors(1)).length > 20, 'distances are many');
  await page.getByTestId('image').first().scrollIntoViewIfNeeded();
  await page.screenshot({ path: join(results, 'camera.png') });
});

test('what it sees changes as it drives', async () => {
  const { page } = shown;
  const before = await colors(0);
  await page.waitForFunction((tick) => window.playhouse.tick > tick, (await page.evaluate(() => window.playhouse.tick)) + 20);
  await assert.doesNotReject(page.waitForFunction(() => document.querySelector('[data-testid=image]').dataset.tick > 20));
  assert.notDeepEqual(await colors(0), before);
});

test('the image is shown large, and the world through its lens', async () => {
  const { page } = shown;
  const widthOf = async () => (await page.getByTestId('image').first().boundingBox()).width;
  const small = await widthOf();
  await page.getByTestId('enlarge').first().click();
  assert.ok((await widthOf()) > 2 * small, 'it is more than twice as large');
  await page.screenshot({ path: join(results, 'camera-large.png') });
  await page.getByTestId('enlarge').first().click();
  assert.equal(await widthOf(), small);
  await page.keyboard.press('i');
  await page.waitForFunction(() => window.playhouse.eye?.fov > 0);
  const [eye, robot] = await page.evaluate(() => [window.playhouse.eye, window.playhouse.drawn('r0')]);
  assert.ok(Math.hypot(eye.x - robot.x, eye.y - robot.y) < 0.5, 'it is on the robot');
  await page.screenshot({ path: join(results, 'camera-lens.png') });
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => window.playhouse.eye === null);
});

test('the page met no error', () => {
  assert.deepEqual(shown.errors, []);
});
