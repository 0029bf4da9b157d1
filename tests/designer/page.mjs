// The page of `bumpfoil designer` in Chromium, for the tests that use it.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { reference, run } from './support.mjs';

export const modules = createRequire(join(process.env.BUMPFOIL_WEB, 'package.json'));
const { chromium } = modules('playwright-core');
export let folder;
export let file;
let browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'bumpfoil-designer-'));
  file = join(folder, 'designer.html');
  run('designer', '-o', file);
  browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

async function answers(page) {
  return Number(await page.evaluate(() => document.documentElement.dataset.answered ?? 0));
}

/** Does something to the case, and waits until that is answered. */
export async function answered(page, act) {
  const count = await answers(page);
  await act();
  await page.waitForFunction((before) => Number(document.documentElement.dataset.answered) > before, count);
}

/** Does something that a view with answers of its own, such as `.vibration`, then answers. */
export async function answeredIn(page, view, act = () => Promise.resolve()) {
  const count = Number((await page.locator(view).getAttribute('data-answered')) ?? 0);
  await act();
  await page.waitForFunction(([one, before]) => Number(document.querySelector(one).dataset.answered ?? 0) > before, [view, count]);
}

/** A page that has answered, and everything that goes wrong or out while it is shown. */
async function opened(fragment, options) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, ...options });
  // Vibrations take seconds, and many of them beside other tests.
  context.setDefaultTimeout(120000);
  const page = await context.newPage();
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => errors.push(message.text()));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) errors.push(request.url());
  });
  await page.goto(pathToFileURL(file).href + fragment);
  await page.waitForFunction(() => document.documentElement.dataset.answered);
  return { page, errors };
}

/** Shows the page as it opens. */
export async function withPage(check, { fragment = '', ...options } = {}) {
  const { page, errors } = await opened(fragment, options);
  await check(page);
  assert.deepEqual(errors, []);
  await page.context().close();
}

let shared;

/** Shows the page with the reference case, after other changes: to open it takes longer than most tests. */
export async function withSharedPage(check) {
  const { page, errors } = shared ?? (await opened('', {}));
  shared = undefined; // unless all goes well
  if ((await textOf(page)) !== reference) await write(page, reference);
  await page.getByRole('tab', { name: 'Loops' }).click();
  await check(page);
  assert.deepEqual(errors, []);
  shared = { page, errors };
}

/** Puts a text in the place of the case. */
export function write(page, text) {
  return answered(page, () => page.locator('.editor').evaluate((one, now) => {
    one.value = now;
    one.dispatchEvent(new Event('input', { bubbles: true }));
  }, text));
}

export const field = (page, key) => page.locator(`[data-key="${key}"] input:not([type="range"])`);
export const slider = (page, key) => page.locator(`[data-key="${key}"] input[type="range"]`);
export const tile = (page, key) => page.locator(`.tile[data-key="${key}"] strong`).textContent();

export async function type(page, key, text) {
  await answered(page, async () => {
    await field(page, key).fill(text);
    await field(page, key).press('Tab');
  });
}

/** Moves a slider, and waits until that is answered. */
export function slide(page, key, value) {
  return answered(page, () =>
    slider(page, key).evaluate((one, to) => {
      one.value = to;
      one.dispatchEvent(new Event('input', { bubbles: true }));
    }, value),
  );
}

export function textOf(page) {
  return page.locator('.editor').inputValue();
}
