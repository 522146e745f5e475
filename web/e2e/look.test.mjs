// What a person reads off the page: names, devices, labels, what a thing is; and how the page fits its screen.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let viewer;
let page;

const pixel = (name, on = page) => on.evaluate((robot) => window.playhouse.pixel(robot), name);
const pixelAt = (x, y, on = page) => on.evaluate((p) => window.playhouse.pixelAt(...p), [x, y]);
const settled = (on = page) => on.waitForFunction(() => !window.playhouse.gliding);
const choose = (name, on = page) => chooseRobot(on, name);
const labels = () => page.evaluate(() => window.playhouse.labels);

async function fit() {
  await page.keyboard.press('Escape');
  await page.keyboard.press('f');
  await settled();
}

/** Whether nothing lies over a robot. */
async function isInSight(name, on = page) {
  const { x, y } = await pixel(name, on);
  return on.evaluate((at) => document.elementFromPoint(...at)?.id === 'picture', [x, y]);
}

/** Another size of the window, and a picture of it: what is below the bar moves with it. */
async function resize(on, width, height) {
  await on.setViewportSize({ width, height });
  await on.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
}

/** What lies over the picture, by its id; waits for the end of an alarm, as of a page that is too slow. */
async function boxes(on) {
  const found = await on.waitForFunction(
    () =>
      document.getElementById('lost').hidden &&
      ['bar', 'robots', 'panel', 'clock', 'chat', 'drive', 'stick', 'notice'].flatMap((id) => {
        const { left, top, right, bottom, width } = document.getElementById(id).getBoundingClientRect();
        return width > 0 ? [{ id, left, top, right, bottom }] : [];
      }),
  );
  return found.jsonValue();
}

async function nothingOverlaps(on) {
  const all = await boxes(on);
  const { width, height } = on.viewportSize();
  for (const a of all) {
    assert.ok(a.left >= 0 && a.right <= width && a.top >= 0 && a.bottom <= height, `#${a.id} is on the screen: ${JSON.stringify(a)}`);
    for (const b of all) {
      const apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      assert.ok(a.id >= b.id || apart, `#${a.id} and #${b.id} overlap: ${JSON.stringify([a, b])}`);
    }
  }
  return all.map(({ id }) => id);
}

before(async () => {
  program = await startProgram('web/e2e/yard.world');
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('a robot is told with the devices that a client opens, in the list and in the panel', async () => {
  assert.match(await page.locator('#robots [data-robot=guest]').textContent(), /^guest.*position2d:0$/);
  await choose('mate');
  const devices = await page.locator('#panel [data-device]').allTextContents();
  assert.deepEqual(devices.filter((name) => name.startsWith('position2d')), ['position2d:1']);
  assert.ok(devices.some((name) => name.startsWith('fiducial:')), devices.join());
  assert.match(await page.getByTestId('type').textContent(), /marker 14/);
  await page.getByTestId('search').fill('position2d:2');
  assert.match(await page.getByTestId('count').textContent(), /^1 of 3/);
  assert.ok(await page.locator('#robots [data-robot=drifter]').isVisible());
  await page.getByTestId('search').fill('');
  await page.getByTestId('search').blur();
});

test('a fiducial finder tells whom it sees', async () => {
  await choose('mate');
  await page.waitForFunction(() => /guest \(13\)/.test(document.querySelector('[data-testid=fiducials]').textContent));
});

test('labels are names, of what is large enough on the screen', async () => {
  await fit();
  await page.mouse.move(640, 790);
  await page.waitForFunction(() => window.playhouse.labels.length >= 4);
  assert.deepEqual((await labels()).sort(), ['drifter', 'guest', 'lighthouse', 'mate']);
  await page.keyboard.press('m');
  await page.waitForFunction(() => window.playhouse.labels.length === 3);
  await page.keyboard.press('m');
  await page.mouse.move(640, 400);
  await page.mouse.wheel(0, 1400);
  await page.waitForFunction(() => window.playhouse.labels.length <= 1);
  await fit();
});

test('what is on the screen is saved as a picture', async () => {
  const coming = page.waitForEvent('download');
  await page.getByTestId('picture').click();
  const download = await coming;
  assert.match(download.suggestedFilename(), /^\w+\.\d+\.\ds\.png$/);
  const file = join(results, 'picture-of-the-page.png');
  await download.saveAs(file);
  const bytes = readFileSync(file);
  assert.deepEqual([...bytes.subarray(1, 4)], [...Buffer.from('PNG')]);
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [1280, 800]);
  const colors = await page.evaluate(async (png) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (byte) => byte.charCodeAt(0))], { type: 'image/png' }));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, bytes.toString('base64'));
  assert.ok(colors > 20, `${colors} colors`);
});

test('everything on the screen uses the screen, and nothing lies over it', async () => {
  for (const tilted of [false, true]) {
    await fit();
    const list = (await boxes(page)).find(({ id }) => id === 'robots');
    const corners = await Promise.all([[-6, -4.1], [6, -4.1], [6, 4.1], [-6, 4.1]].map(([x, y]) => pixelAt(x, y)));
    const [xs, ys] = [corners.map(({ x }) => x), corners.map(({ y }) => y)];
    assert.ok(Math.min(...xs) >= list.right && Math.max(...xs) <= 1280 && Math.min(...ys) >= 62 && Math.max(...ys) <= 750, JSON.stringify(corners));
    const used = Math.max((Math.max(...xs) - Math.min(...xs)) / (1280 - list.right), (Math.max(...ys) - Math.min(...ys)) / 688);
    assert.ok(used > 0.85, `${used} of the free screen is used`);
    await page.screenshot({ path: join(results, tilted ? 'fit-tilted.png' : 'fit.png') });
    await page.keyboard.press('t');
    await settled();
  }
});

test('a robot chosen in the list comes to the middle of what nothing covers', async () => {
  await fit();
  await choose('mate');
  await settled();
  const all = await boxes(page);
  const [list, panel, bar] = ['robots', 'panel', 'bar'].map((name) => all.find(({ id }) => id === name));
  const { x, y } = await pixel('mate');
  assert.ok(Math.abs(x - (list.right + panel.left) / 2) < 30, `${x} between ${list.right} and ${panel.left}`);
  assert.ok(Math.abs(y - (bar.bottom + 744) / 2) < 60, `${y} between ${bar.bottom} and the clock`);
  assert.ok(await isInSight('mate'));
});

test('a robot does not see itself', async () => {
  await fit();
  await choose('guest');
  await page.keyboard.press('i');
  await page.waitForFunction(() => window.playhouse.eye !== null);
  await page.screenshot({ path: join(results, 'own-eyes.png') });
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => window.playhouse.eye === null);
});

test('what the mouse pointed at ends with the mouse, and when the robot is gone', async () => {
  await fit();
  await choose('guest');
  await fit();
  const at = await pixel('guest');
  await page.mouse.move(at.x, at.y);
  await page.waitForFunction(() => window.playhouse.hovered === 'guest');
  await page.mouse.move(at.x, 30);
  await page.waitForFunction(() => window.playhouse.hovered === null);
  await page.mouse.move(at.x, at.y);
  await page.waitForFunction(() => window.playhouse.hovered === 'guest');
  await page.mouse.down();
  await page.mouse.up();
  await page.mouse.move(at.x + 1, at.y);
  await page.waitForFunction(() => window.playhouse.hovered === 'guest');
  await page.keyboard.down('w');
  await page.waitForFunction(() => window.playhouse.hovered === null);
  await page.keyboard.up('w');
});

test('a click on what is no robot says what it is', async () => {
  await fit();
  const wall = await pixelAt(2, 4);
  await page.mouse.click(wall.x, wall.y);
  assert.equal(await page.locator('#notice').textContent(), 'north, a model');
  assert.ok(await page.locator('#panel').isHidden());
  const crate = await pixelAt(3, 2);
  await page.mouse.click(crate.x, crate.y);
  assert.equal(await page.getByTestId('selected').textContent(), 'crate_a');
  assert.match(await page.getByTestId('type').textContent(), /^model, no devices$/);
  assert.ok(await page.locator('#drive').isHidden());
});

test('nothing overlaps on a phone, and the selected robot is in sight', async () => {
  const phone = await watch(browser, program.page, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await nothingOverlaps(phone.page);
  await phone.page.screenshot({ path: join(results, 'phone-start.png') });
  await phone.page.getByTestId('list').tap();
  await choose('mate', phone.page);
  await settled(phone.page);
  const shown = await nothingOverlaps(phone.page);
  for (const id of ['bar', 'robots', 'panel', 'clock']) assert.ok(shown.includes(id), id);
  assert.ok(await isInSight('mate', phone.page), 'beside the list');
  await phone.page.screenshot({ path: join(results, 'phone-list.png') });
  await phone.page.getByTestId('list').tap();
  assert.ok((await nothingOverlaps(phone.page)).includes('stick'));
  const at = await pixel('mate', phone.page);
  const panel = await phone.page.locator('#panel').boundingBox();
  assert.ok(at.y > 110 && at.y < panel.y, `the robot is at ${at.y}, the panel begins at ${panel.y}`);
  await phone.page.screenshot({ path: join(results, 'phone-robot.png') });
  assert.deepEqual(phone.errors, []);
  await phone.page.close();
});

test('nothing overlaps on small windows', async () => {
  await choose('guest');
  for (const [width, height] of [[1380, 800], [1280, 800], [1120, 800], [1024, 768], [900, 700], [760, 700]]) {
    await resize(page, width, height);
    await nothingOverlaps(page);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  assert.deepEqual(viewer.errors, []);
});

/**
 * Buttons of the bar that somebody would click in vain: outside of it, or below something else. Waits until the link
 * is live: a page that draws in software beside other work may lose it, which disables what needs it.
 */
async function outOfReach(on) {
  const found = await on.waitForFunction(() => {
    if (document.querySelector('[data-testid=link]').dataset.state !== 'live') return null;
    const bar = document.getElementById('bar').getBoundingClientRect();
    const shown = [...document.querySelectorAll('#bar button, #bar select, #bar .brand')].filter((each) => each.offsetWidth > 0);
    const bad = shown.filter((each) => {
      const { left, top, right, bottom } = each.getBoundingClientRect();
      const inside = left >= bar.left && right <= bar.right && top >= bar.top && bottom <= bar.bottom;
      return !inside || !each.contains(document.elementFromPoint((left + right) / 2, (top + bottom) / 2));
    });
    return { count: shown.length, bad: bad.map((each) => each.textContent) };
  });
  return found.jsonValue();
}

test('every button of the bar can be reached, however narrow the window', async (test) => {
  const room = await startProgram('worlds/room.world', ['--engine', 'arena']);
  test.after(() => room.stop());
  const other = await watch(browser, room.page);
  const guest = await watch(browser, room.page);
  await guest.page.getByTestId('join').click();
  await guest.page.keyboard.press('Enter');
  for (const id of ['wave', 'people', 'add', 'save']) await guest.page.getByTestId(id).waitFor();
  for (const [width, height, least] of [[1280, 800, 15], [1024, 768, 15], [900, 700, 15], [760, 700, 15], [360, 740, 10]]) {
    await resize(guest.page, width, height);
    const { count, bad } = await outOfReach(guest.page);
    assert.deepEqual(bad, [], `at ${width}`);
    assert.ok(count >= least, `${count} at ${width}`);
    await nothingOverlaps(guest.page);
  }
  await guest.page.getByTestId('layers').click();
  const sheet = await guest.page.locator('.sheet:not([hidden])').boundingBox();
  assert.ok(sheet.x >= 0 && sheet.x + sheet.width <= 360, JSON.stringify(sheet));
  assert.deepEqual([...guest.errors, ...other.errors], []);
  await Promise.all([guest.page.close(), other.page.close()]);
});

test('a page without its program looks like one', async () => {
  await choose('guest');
  await program.stop();
  await page.locator('#lost').filter({ hasText: 'Connection lost. Trying again' }).waitFor();
  for (const control of ['pause', 'step', 'speed']) assert.ok(await page.getByTestId(control).isDisabled(), control);
  assert.ok(await page.locator('#drive').isHidden());
  assert.match(await page.locator('#stage').evaluate((stage) => getComputedStyle(stage).filter), /opacity/);
  await page.screenshot({ path: join(results, 'lost.png') });
  program = await startProgram('web/e2e/yard.world', [], new URL(program.page).port);
  await page.waitForFunction(() => document.querySelector('#lost').hidden && window.playhouse.tick > 0);
  assert.ok(await page.getByTestId('pause').isEnabled());
  assert.equal(await page.locator('#stage').evaluate((stage) => getComputedStyle(stage).filter), 'none');
});
