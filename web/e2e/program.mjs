// Starts the program and a browser for the tests of the page.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');

/** Where pictures go. */
export const results = process.env.PLAYHOUSE_TEST_RESULTS ?? join(root, 'build/test-results');
mkdirSync(results, { recursive: true });

const program = process.env.PLAYHOUSE_PROGRAM ?? join(root, 'build/playhouse');

/**
 * Runs a world and waits until its page is there.
 * @param {string} world its path, from the source root
 * @param {string[]} options
 * @param {string} port of the page; '0': any free one
 * @returns {Promise<{page: string, port: number, says: (pattern: RegExp) => Promise<void>, stop: () => Promise<number | null>}>}
 */
export async function startProgram(world, options = [], port = '0') {
  if (!existsSync(program)) throw new Error(`no program at ${program} (make build, or set PLAYHOUSE_PROGRAM)`);
  return started(program, ['run', resolve(root, world), '--port', '0', '--web', port, ...options]);
}

/** Serves the devices of a configuration file and waits until its page is there. */
export async function serve(file, options = ['--port', '0'], port = '0') {
  return started(program, ['serve', file, '--web', port, ...options]);
}

/** Runs an experiment, named from the source root, in the same way; its page is on any free port. */
export async function startScenario(script, options = []) {
  return started('python3', [resolve(root, script), ...options, '--', '--web', '0'], { ...process.env, PLAYHOUSE_PROGRAM: program });
}

/** What a command that serves a page says, and how to end it. */
async function started(command, words, env = process.env) {
  const child = spawn(command, words, { cwd: root, env, stdio: ['ignore', 'pipe', 'pipe'] });
  const exit = new Promise((done) => child.once('exit', (code) => done(code)));
  let said = '';
  const hear = (bytes) => {
    said += bytes;
    child.emit('said');
  };
  child.stdout.on('data', hear);
  const [page, clients] = await new Promise((found, fail) => {
    child.once('error', fail);
    child.once('exit', (code) => fail(new Error(`${command} ended with ${code}:\n${said}`)));
    child.stderr.on('data', (bytes) => {
      hear(bytes);
      const places = [/web page: (http:\S+)/, /Player clients: \S+:(\d+)/].map((place) => said.match(place)?.[1]);
      if (places.every(Boolean)) found(places);
    });
  });
  const stop = async () => {
    child.kill('SIGTERM');
    return exit;
  };
  const says = async (pattern) => {
    const signal = AbortSignal.timeout(kPatienceMs);
    const fail = () => {
      throw new Error(`${pattern} is not in:\n${said}`);
    };
    while (!pattern.test(said)) await once(child, 'said', { signal }).catch(fail);
  };
  return { page, port: Number(clients), says, stop };
}

/** What `playhouse check` makes of a file. */
export function check(file) {
  return finish('check', file);
}

/** Runs a command to its end. Worlds are named from the source root. */
export function finish(...words) {
  const child = spawn(program, words, { cwd: root, stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (bytes) => (said += bytes));
  return new Promise((done) => child.once('close', (code) => done({ code, said })));
}

/** Debian's Chromium, drawing in software. */
export function startBrowser() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
      '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    ],
  });
}

/** What is waited for at most: a picture drawn in software takes seconds where other work goes on. */
const kPatienceMs = 90000;

/** An empty page with that patience. */
export async function openPage(browser, options = {}) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(kPatienceMs);
  return page;
}

/** A page that shows the world at this tick or later, and the errors it met. */
export async function watch(browser, url, options = {}, leastTick = 1) {
  const page = await openPage(browser, { viewport: { width: 1280, height: 800 }, ...options });
  const errors = [];
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  await page.goto(url);
  await page.waitForFunction((tick) => window.playhouse?.tick >= tick, leastTick);
  return { page, errors };
}

/** Waits until a page has drawn so many pictures: what was under way, and whatever else should not be, shows by then. */
export function pictures(page, count) {
  return page.evaluate(
    (count) =>
      new Promise((done) => {
        const next = () => (--count < 0 ? done() : requestAnimationFrame(next));
        next();
      }),
    count,
  );
}

/** Waits until a page shows the running world so many ticks later. */
export async function ticks(page, count) {
  const from = await page.evaluate(() => window.playhouse.tick);
  await page.waitForFunction((tick) => window.playhouse.tick >= tick, from + count);
}

/** Selects a robot in the list of a page. */
export async function chooseRobot(page, name) {
  await page.locator(`#robots [data-robot="${name}"]`).click();
  await page.waitForFunction((robot) => document.querySelector('#panel').dataset.robot === robot, name);
}
