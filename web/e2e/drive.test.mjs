// A person drives in the page: keys, a gamepad, a thumb. PLAYHOUSE_PROGRAM=path of the program.

import assert from 'node:assert/strict';
import { after, afterEach, before, test } from 'node:test';
import { join } from 'node:path';
import { chooseRobot, pictures, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let viewer;
let page;

const pose = (name, on = page) => on.evaluate((robot) => window.playhouse.pose(robot), name);
const choose = (name, on = page) => chooseRobot(on, name);
const driven = (on = page) => on.evaluate(() => window.playhouse.driven);

/** Until the robot's velocities are what the test wants, as the panel tells them. */
function moves(what, on = page) {
  return on.waitForFunction((wanted) => {
    const number = (id) => Number.parseFloat(document.querySelector(`[data-testid=${id}]`).textContent);
    const [ahead, turn] = [number('speed-x'), number('speed-a')];
    const is = { ahead: ahead > 0.05, back: ahead < -0.05, left: turn > 5, right: turn < -5, fast: ahead > 0.45, still: ahead === 0 && turn === 0 };
    return is[wanted];
  }, what);
}

before(async () => {
  program = await startProgram('web/e2e/yard.world');
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
});

afterEach(async () => {
  await page.keyboard.press('Escape');
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('the selected robot drives while a key is held, and stops when it is let go', async () => {
  assert.ok(await page.locator('#drive').isHidden());
  await choose('guest');
  assert.match(await page.locator('#drive').textContent(), /arrows drive guest/);
  for (const [key, what] of [['w', 'ahead'], ['s', 'back'], ['a', 'left'], ['d', 'right'], ['ArrowUp', 'ahead'], ['ArrowLeft', 'left']]) {
    await page.keyboard.down(key);
    await moves(what);
    await page.keyboard.up(key);
    await moves('still');
  }
  assert.equal(await driven(), null);
});

test('it goes on for as long as the key is held, longer than one command lasts', async () => {
  await choose('guest');
  const start = await pose('guest');
  await page.keyboard.down('s');
  await page.waitForFunction((from) => Math.hypot(window.playhouse.pose('guest').x - from.x, window.playhouse.pose('guest').y - from.y) > 0.8, start);
  await page.keyboard.up('s');
  await moves('still');
});

test('Shift is faster, also when it is pressed later', async () => {
  await choose('mate');
  await page.keyboard.down('w');
  await moves('ahead');
  await page.keyboard.down('Shift');
  await moves('fast');
  await page.keyboard.up('Shift');
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('[data-testid=speed-x]').textContent) < 0.4);
  await page.keyboard.up('w');
  await moves('still');
});

test('keys that are typed drive nobody', async () => {
  await choose('guest');
  await page.keyboard.press('/');
  await page.keyboard.type('wwdd');
  assert.equal(await page.getByTestId('search').inputValue(), 'wwdd');
  assert.equal(await driven(), null);
  await page.getByTestId('search').fill('');
  await page.keyboard.press('Escape');
});

test('a field, a dialog or another window in between stops the robot, and the key must be pressed anew', async () => {
  const interruptions = [
    [() => page.getByTestId('search').focus(), () => page.getByTestId('search').blur()],
    [() => page.getByTestId('help').click(), () => page.keyboard.press('Escape')],
    [() => page.evaluate(() => window.dispatchEvent(new Event('blur'))), () => {}],
  ];
  for (const [interrupt, goBack] of interruptions) {
    await choose('guest');
    await page.keyboard.down('a');
    await moves('left');
    await interrupt();
    await moves('still');
    await goBack();
    await page.keyboard.down('a'); // what a held key repeats
    assert.equal(await driven(), null);
    await page.keyboard.up('a');
  }
});

test('another robot, or none, is selected: the first one stops', async () => {
  await choose('guest');
  await page.keyboard.down('a');
  await moves('left');
  await choose('mate');
  assert.equal(await driven(), null);
  await page.keyboard.up('a');
  await choose('guest');
  await moves('still');
});

test('a page that is gone leaves no robot running', async () => {
  const other = await watch(browser, program.page);
  await choose('guest', other.page);
  await other.page.keyboard.down('a');
  await moves('left', other.page);
  await choose('guest');
  await moves('left');
  await other.page.close();
  await moves('still');
});

test('a page that hangs leaves no robot running', async () => {
  const other = await watch(browser, program.page);
  await choose('guest', other.page);
  await choose('guest');
  await other.page.keyboard.down('a');
  await moves('left');
  let answer;
  const answered = new Promise((done) => (answer = done));
  await other.page.route('**/answered-late', async (route) => {
    await answered;
    await route.fulfill({ body: '' });
  });
  const hangs = other.page.evaluate(() => {
    const ask = new XMLHttpRequest();
    ask.open('GET', 'answered-late', false); // nothing else runs in the page until then
    ask.send();
  });
  await moves('still');
  answer();
  await hangs;
  await other.page.close();
});

test('a gamepad drives, and its stick may rest a little beside its middle', async () => {
  await choose('guest');
  await page.evaluate(() => {
    window.pad = { connected: true, axes: [0.08, -0.06, 0, 0], buttons: [] };
    navigator.getGamepads = () => [null, window.pad];
  });
  await pictures(page, 3); // each looks at the stick
  assert.equal(await driven(), null);
  await page.evaluate(() => (window.pad.axes = [-0.9, 0.1, 0, 0]));
  await moves('left');
  await page.evaluate(() => (window.pad.connected = false));
  await moves('still');
});

test('a thumb drives on a phone', async () => {
  const phone = await watch(browser, program.page, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  const at = await phone.page.evaluate(() => window.playhouse.pixel('guest'));
  await phone.page.touchscreen.tap(at.x, at.y);
  await phone.page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'guest');
  const stick = await phone.page.locator('#stick').boundingBox();
  const touch = await phone.page.context().newCDPSession(phone.page);
  const middle = { x: stick.x + stick.width / 2, y: stick.y + stick.height / 2 };
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [middle] });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: middle.x - 50, y: middle.y }] });
  await moves('left', phone.page);
  await phone.page.screenshot({ path: join(results, 'phone-drive.png') });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await moves('still', phone.page);
  assert.deepEqual(phone.errors, []);
  await phone.page.close();
});

test('who else decides is told', async () => {
  await choose('drifter');
  assert.match(await page.locator('#drive').textContent(), /controller wander/);
  await page.screenshot({ path: join(results, 'drive.png') });
  assert.deepEqual(viewer.errors, []);
});
