// The page in a real browser against the program: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { openPage, pictures, results, startBrowser, startProgram, ticks, watch } from './program.mjs';

let program;
let browser;
let viewer;
let page;

const tick = (on = page) => on.evaluate(() => window.playhouse.tick);
const pose = (name, on = page) => on.evaluate((robot) => window.playhouse.pose(robot), name);
const pixel = (name, on = page) => on.evaluate((robot) => window.playhouse.pixel(robot), name);
const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);
const by = (id, on = page) => on.getByTestId(id);

/** Carries a robot of a paused world to a pixel. */
async function carry(name, to) {
  const from = await pose(name);
  const at = await pixel(name);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  for (let k = 1; k <= 8; ++k) await page.mouse.move(at.x + ((to.x - at.x) * k) / 8, at.y + ((to.y - at.y) * k) / 8);
  await page.mouse.up();
  await page.waitForFunction(
    ([robot, start]) => Math.hypot(window.playhouse.pose(robot).x - start.x, window.playhouse.pose(robot).y - start.y) > 0.2,
    [name, from],
  );
}

/** The robot farthest from every other one, of those that nothing covers; runs in the page. */
function loneliest() {
  const { robots, pixel } = window.playhouse;
  const places = robots.map((name) => ({ name, ...pixel(name) }));
  const room = (a) => Math.min(...places.filter((b) => b !== a).map((b) => Math.hypot(a.x - b.x, a.y - b.y)));
  const free = places.filter(({ x, y }) => document.elementFromPoint(x, y)?.tagName === 'CANVAS');
  return free.sort((a, b) => room(b) - room(a))[0].name;
}

/** Everything at rest: the world paused, and its last tick on the page. */
async function pause(on = page) {
  if (!(await on.evaluate(() => window.playhouse.paused))) await by('pause', on).click();
  await on.waitForFunction(() => window.playhouse.paused);
}

async function goOn(on = page) {
  if (await on.evaluate(() => window.playhouse.paused)) await by('pause', on).click();
  await on.waitForFunction(() => !window.playhouse.paused);
}

before(async () => {
  program = await startProgram('worlds/cave.world');
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('the page shows the world, its robots and a running clock', async () => {
  assert.match(await by('world').textContent(), /cave/);
  await page.waitForFunction(() => document.querySelector('[data-testid=link]').dataset.state === 'live');
  const robots = await page.evaluate(() => window.playhouse.robots);
  assert.ok(robots.includes('amber') && robots.includes('guest'), robots.join());
  assert.match(await by('count').textContent(), new RegExp(`^${robots.length} robots`));
  const first = await by('time').textContent();
  await page.waitForFunction((text) => document.querySelector('[data-testid=time]').textContent !== text, first);
});

test('robots move', async () => {
  const names = await page.evaluate(() => window.playhouse.robots);
  const start = await Promise.all(names.map((name) => pose(name)));
  await page.waitForFunction(
    ([all, from]) => {
      const moved = (name, k) => {
        const now = window.playhouse.pose(name);
        return Math.hypot(now.x - from[k].x, now.y - from[k].y) > 0.2;
      };
      return all.filter(moved).length >= 5;
    },
    [names, start],
  );
});

test('sensor data of the robots in view arrives', async () => {
  await page.waitForFunction(() => window.playhouse.scans > 10);
});

test('pause stops every robot', async () => {
  await pause();
  const names = await page.evaluate(() => window.playhouse.robots);
  const [t, start] = [await tick(), await Promise.all(names.map((name) => pose(name)))];
  await pictures(page, 10);
  assert.equal(await tick(), t);
  assert.deepEqual(await Promise.all(names.map((name) => pose(name))), start);
  assert.equal(await by('mode').textContent(), 'paused');
});

test('step advances one tick', async () => {
  const t = await tick();
  await by('step').click();
  await page.waitForFunction((before) => window.playhouse.tick > before, t);
  await pictures(page, 5);
  assert.equal(await tick(), t + 1);
  await page.keyboard.press('.');
  await page.waitForFunction((before) => window.playhouse.tick > before, t + 1);
  assert.equal(await tick(), t + 2);
});

test('speed changes how fast the world runs', async () => {
  await goOn();
  await by('speed').selectOption('5');
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('[data-testid=factor]').textContent) > 3);
  await by('speed').selectOption('1');
  await page.waitForFunction(() => Number.parseFloat(document.querySelector('[data-testid=factor]').textContent) < 1.5);
});

test('speed keys count however quickly they are pressed', async () => {
  await by('speed').selectOption('50');
  await page.waitForFunction(() => window.playhouse.speed === 50);
  await page.evaluate(() => {
    for (let k = 0; k < 3; ++k) window.dispatchEvent(new KeyboardEvent('keydown', { key: '<' }));
  });
  await page.waitForFunction(() => window.playhouse.speed === 2);
  assert.equal(await by('speed').inputValue(), '2');
  await page.keyboard.press('<');
  await page.waitForFunction(() => window.playhouse.speed === 1);
});

test('a click on a robot shows its devices live', async () => {
  await pause();
  await page.waitForFunction(() => !window.playhouse.gliding);
  const at = await pixel('guest');
  await page.mouse.click(at.x, at.y);
  await page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'guest');
  assert.equal(await by('selected').textContent(), 'guest');
  await goOn();
  // Nobody drives the guest, so its sensors sleep: selecting it makes them measure.
  await page.waitForFunction(() => /nearest/.test(document.querySelector('#panel').textContent) && !/no data yet/.test(document.querySelector('#panel').textContent));
  assert.match(await by('place-x').textContent(), /^-?\d+\.\d\d m$/);
  await page.locator('[data-robot=amber]').click();
  await page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'amber');
  const odometry = await by('odometry').textContent();
  await page.waitForFunction((text) => document.querySelector('[data-testid=odometry]').textContent !== text, odometry);
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.querySelector('#panel').hidden);
});

test('the name of a selected robot has room beside everything that is said of it', async () => {
  await page.locator('[data-robot=amber]').click();
  await by('follow').click();
  const cut = await page.evaluate(() => {
    for (const tag of document.querySelectorAll('#panel header .tag')) tag.hidden = false;
    const name = document.querySelector('#panel h2');
    return name.scrollWidth > name.clientWidth;
  });
  assert.equal(cut, false);
  await page.screenshot({ path: join(results, 'panel.png') });
  await page.keyboard.press('Escape');
});

test('and in the list, beside its state and its address', async () => {
  const cut = await page.evaluate(() => {
    const entry = document.querySelector('[data-robot=guest]');
    const [name, tag] = [entry.querySelector('.name'), entry.querySelector('.tag')];
    const [was, hidden] = [name.textContent, tag.hidden];
    [name.textContent, tag.hidden] = ['turquoise-12', false];
    const [room, needs] = [name.clientWidth, name.scrollWidth];
    const out = tag.getBoundingClientRect().right > entry.getBoundingClientRect().right;
    [name.textContent, tag.hidden] = [was, hidden];
    return { room, needs, out };
  });
  assert.ok(cut.room > 40 && cut.room >= cut.needs && !cut.out, JSON.stringify(cut));
});

test('from above north is up, although the file turns the view', async () => {
  const axes = () => page.evaluate(() => [[0, 0], [0, 1], [1, 0]].map(([x, y]) => window.playhouse.pixelAt(x, y)));
  const [from, ahead] = await axes();
  assert.ok(Math.abs(ahead.x - from.x) > 5, 'the file turns it');
  await by('tilt').click();
  await page.waitForFunction(() => !window.playhouse.gliding);
  const [middle, north, east] = await axes();
  assert.ok(Math.abs(north.x - middle.x) < 0.1 && north.y < middle.y - 5, JSON.stringify([middle, north]));
  assert.ok(Math.abs(east.y - middle.y) < 0.1 && east.x > middle.x + 5, JSON.stringify([middle, east]));
  await page.screenshot({ path: join(results, 'top.png') });
  await by('tilt').click();
  await page.waitForFunction(() => !window.playhouse.gliding);
});

test('dragging a robot moves it in the world', async () => {
  await pause();
  await page.keyboard.press('f');
  await page.waitForFunction(() => !window.playhouse.gliding);
  const at = await pixel('guest');
  await carry('guest', { x: at.x + 40, y: at.y - 32 });
  const second = await watch(browser, program.page);
  assert.ok(apart(await pose('guest', second.page), await pose('guest')) < 0.002, 'another viewer sees it there too');
  await second.page.close();
});

test('everything on the screen is also what was carried beyond the walls', async () => {
  await pause();
  for (let k = 0; k < 5; ++k) {
    await page.mouse.move(640, 400);
    await page.mouse.wheel(0, 240);
  }
  const back = await pose('guest');
  await carry('guest', { x: 260, y: 780 });
  await page.mouse.move(640, 400);
  await page.mouse.wheel(0, -2400);
  await page.keyboard.press('f');
  await page.waitForFunction(() => !window.playhouse.gliding);
  const at = await pixel('guest');
  assert.ok(at && at.x > 0 && at.x < 1280 && at.y > 0 && at.y < 800, `the guest is at ${at?.x}, ${at?.y}`);
  assert.ok(apart(await pose('guest'), back) > 8, 'it was carried far');
  await carry('guest', await page.evaluate((p) => window.playhouse.pixelAt(p.x, p.y), back));
});

test('two viewers see the same and either may pause', async () => {
  await goOn();
  const other = await watch(browser, program.page);
  await pause(other.page);
  await page.waitForFunction(() => window.playhouse.paused);
  await pictures(page, 5);
  assert.equal(await tick(), await tick(other.page));
  assert.deepEqual(await pose('coral'), await pose('coral', other.page));
  await goOn(other.page);
  await page.waitForFunction(() => !window.playhouse.paused);
  assert.deepEqual(other.errors, []);
  await other.page.close();
});

test('the search finds a robot and the help opens', async () => {
  await page.keyboard.press('/');
  await page.keyboard.type('azu');
  assert.match(await by('count').textContent(), /^1 of/);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'azure');
  await by('search').fill('');
  await page.keyboard.press('Escape');
  const help = page.locator('#help');
  for (let times = 0; times < 2; ++times) {
    await page.keyboard.press('?');
    assert.ok(await help.isVisible());
    assert.equal(await help.evaluate((dialog) => dialog.scrollTop), 0, 'it opens at its top');
    await help.evaluate((dialog) => (dialog.scrollTop = 1000));
    await page.keyboard.press('Escape');
    assert.ok(!(await help.isVisible()));
  }
});

test('a page that does not draw says that it is too slow, and does not blame the program', async (t) => {
  const slow = await openPage(browser);
  t.after(() => slow.close());
  await slow.addInitScript(() => {
    const draw = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (frame) => (window.stands ? ((window.frame = frame), 0) : draw(frame));
    window.goOn = () => ((window.stands = false), draw(window.frame));
  });
  await slow.goto(program.page);
  await slow.waitForFunction(() => window.playhouse?.tick > 0);
  await slow.evaluate(() => (window.stands = true));
  await slow.locator('#lost').filter({ hasText: 'This page is too slow' }).waitFor();
  assert.ok(await by('pause', slow).isEnabled(), 'the program hears it');
  await slow.evaluate(() => window.goOn());
  await slow.locator('#lost').waitFor({ state: 'hidden' });
});

test('the page works on a phone', async () => {
  const phone = await watch(browser, program.page, { viewport: { width: 390, height: 844 }, hasTouch: true, deviceScaleFactor: 2 });
  const wide = await phone.page.evaluate(() => document.documentElement.scrollWidth > innerWidth || document.querySelector('#bar').scrollWidth > innerWidth);
  assert.equal(wide, false, 'nothing sticks out');
  await pause(phone.page);
  await phone.page.waitForFunction(() => !window.playhouse.gliding);
  const robot = await phone.page.evaluate(loneliest);
  const at = await pixel(robot, phone.page);
  await phone.page.touchscreen.tap(at.x, at.y);
  await phone.page.waitForFunction((name) => document.querySelector('#panel').dataset.robot === name, robot);
  await goOn(phone.page);
  await ticks(phone.page, 5);
  await phone.page.screenshot({ path: join(results, 'phone.png') });
  assert.deepEqual(phone.errors, []);
  await phone.page.close();
});

test('a browser that cannot draw is told why', async () => {
  const poor = await openPage(browser);
  await poor.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const errors = [];
  poor.on('pageerror', (error) => errors.push(error.message));
  await poor.goto(program.page);
  await poor.waitForFunction(() => !document.querySelector('#lost').hidden);
  assert.match(await poor.locator('#lost').textContent(), /no WebGL 2/);
  assert.deepEqual(errors, []);
  await poor.close();
});

test('a page under a name that only points here is told what to do', async () => {
  const other = await openPage(browser);
  const answer = await other.goto(program.page.replace('127.0.0.1', 'elsewhere.localhost'));
  assert.equal(answer.status(), 421);
  assert.match(await other.locator('body').textContent(), /"elsewhere.localhost:\d+" is not a name of this program.*--web-host/);
  await other.close();
});

test('a page of another port of this machine can neither control nor frame the program', async () => {
  const stranger = createServer((_, answer) => {
    answer.setHeader('Content-Type', 'text/html');
    answer.end(`<iframe src="${program.page}"></iframe>`);
  });
  await new Promise((done) => stranger.listen(0, '127.0.0.1', done));
  const other = await openPage(browser);
  await other.goto(`http://127.0.0.1:${stranger.address().port}/`);
  const live = new URL('live', program.page).href.replace(/^http/, 'ws');
  const opened = (from) =>
    from.evaluate(
      (url) =>
        new Promise((done) => {
          const socket = new WebSocket(url);
          socket.onopen = () => done(true);
          socket.onerror = () => done(false);
        }),
      live,
    );
  assert.equal(await opened(other), false);
  assert.equal(await opened(page), true);
  const frame = other.frames()[1];
  assert.equal(await frame.evaluate(() => document.querySelector('#picture')), null);
  await other.close();
  stranger.close();
});

test('the page says so when the program is gone, and comes back with it', async () => {
  await ticks(page, 15);
  await page.screenshot({ path: join(results, 'viewer.png') });
  assert.deepEqual(viewer.errors, []);
  const port = new URL(program.page).port;
  await program.stop();
  await page.locator('#lost').filter({ hasText: 'Connection lost' }).waitFor();
  program = await startProgram('worlds/cave.world', [], port);
  await page.waitForFunction(() => document.querySelector('#lost').hidden && window.playhouse.tick > 0);
});
