// What the tests of reports share: results by the program, reports of them, and pages that show these.
//
// Environment: BUMPFOIL_PROGRAM, BUMPFOIL_CASE, BUMPFOIL_STRIP_CASE, BUMPFOIL_RUNNING_CASE, BUMPFOIL_ROTOR_CASE, BUMPFOIL_PADS_CASE, BUMPFOIL_CHROMIUM, and BUMPFOIL_WEB, the folder with node_modules.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

export const { BUMPFOIL_PROGRAM: program, BUMPFOIL_CASE: caseFile, BUMPFOIL_STRIP_CASE: stripFile, BUMPFOIL_RUNNING_CASE: runningFile, BUMPFOIL_ROTOR_CASE: rotorFile, BUMPFOIL_PADS_CASE: padsFile } = process.env;
export const modules = createRequire(join(process.env.BUMPFOIL_WEB, 'package.json'));
const { chromium } = modules('playwright-core');
const prefixes = { p: 1e-12, n: 1e-9, µ: 1e-6, m: 1e-3, k: 1e3, M: 1e6, G: 1e9 };

/** Of results and reports; removed at the end. */
export let folder;
let browser;
let page;
let url;
let errors = [];

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'bumpfoil-report-'));
  // Optimising a page's code takes longer than a page is looked at here: a tenth of the time is saved without.
  const args = ['--no-sandbox', '--disable-gpu', '--js-flags=--no-opt --no-maglev'];
  browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM, args });
  page = await browser.newPage();
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => errors.push(message.text()));
  page.on('dialog', (dialog) => errors.push(`dialog: ${dialog.message()}`));
  page.on('request', (request) => {
    if (request.url().split('#')[0] !== url && !/^(data|blob):/.test(request.url())) errors.push(request.url());
  });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** What the program says; with the exit code that is due. */
export function run(args, exitCode = 0) {
  const done = spawnSync(program, [...args, '--quiet'], { encoding: 'utf8' });
  assert.equal(done.status, exitCode, done.stderr);
  return done.stderr;
}

export function cycle(name, ...pairs) {
  run(['cycle', caseFile, '-o', join(folder, name), ...pairs.flatMap((pair) => ['--set', pair])]);
}

export function report(file, ...names) {
  run(['report', ...names.map((name) => join(folder, name)), '-o', join(folder, file)]);
}

export function summaryOf(name) {
  return JSON.parse(readFileSync(join(folder, name, 'summary.json'), 'utf8'));
}

export function rowsOf(csv) {
  const [header, ...lines] = csv.trim().split(/\r?\n/);
  const names = header.split(',');
  const cells = (line) => line.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/).map((cell) => cell.replaceAll('"', ''));
  return lines.map((line) => Object.fromEntries(cells(line).map((cell, i) => [names[i], cell])));
}

/** Shows a report as one that was just opened, and fails where anything goes wrong or out meanwhile. All are shown by one page: that a
browser makes another costs more than most reports. */
export async function withReport(file, check, { viewport = { width: 1280, height: 900 }, colorScheme = 'light' } = {}) {
  await page.goto('about:blank');
  await page.setViewportSize(viewport);
  await page.emulateMedia({ media: null, colorScheme });
  url = pathToFileURL(join(folder, file)).href;
  errors = [];
  await page.goto(url);
  await page.locator('html[data-drawn]').waitFor();
  await check(page);
  assert.deepEqual(errors, []);
}

/** Goes to a part that is folded at first. */
export function unfold(page, part) {
  return page.getByRole('navigation').getByRole('link', { name: part }).click();
}

/** "739.3 N" as 739.3, in SI. */
export function quantity(text, base) {
  const [number, unit = ''] = text.replaceAll('−', '-').split(' ');
  const prefix = unit.slice(0, unit.length - base.length);
  assert.ok(unit.endsWith(base) && (prefix === '' || prefix in prefixes), text);
  return Number(number) * (prefix === '' ? 1 : prefixes[prefix]);
}

export function near(actual, expected, relative, what) {
  assert.ok(Math.abs(actual - expected) <= relative * Math.abs(expected) + 1e-15, `${what}: ${actual}, not ${expected}`);
}

export async function saved(page, panelName, button) {
  const download = page.waitForEvent('download');
  await page.getByRole('region', { name: panelName, exact: true }).getByRole('button', { name: button }).click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/** Plots within a place, once they show what is chosen now: a chart out of sight is drawn when one comes to it, and knows a
frame later that it is in sight. */
export async function plotsIn(place) {
  const charts = place.locator('.chart');
  for (const chart of await charts.all()) {
    await chart.scrollIntoViewIfNeeded();
    await chart.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await chart.and(chart.page().locator(':not([aria-busy])')).waitFor();
  }
  return charts.locator('.plot');
}

/** Where the middle of a mark is on its chart, for a click there: that holds wherever the page moves the chart meanwhile. */
export function placeOf(mark) {
  return mark.evaluate((one) => {
    const chart = one.closest('.chart').getBoundingClientRect();
    const { x, y, width, height } = one.getBoundingClientRect();
    return { x: x + width / 2 - chart.x, y: y + height / 2 - chart.y };
  });
}

/** What is drawn of the foils, and where the bar says that it is. */
export async function state(page) {
  return {
    index: Number(await page.locator('.player input').inputValue()),
    readout: await page.locator('.player output').textContent(),
    drawing: await page.locator('.unwrapped').innerHTML(),
    round: await page.locator('.round').innerHTML(),
  };
}

export async function moveTo(page, index) {
  await page.locator('.player input').evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, index);
}

/** Of a laptop. */
export const laptop = { viewport: { width: 1366, height: 768 } };

export function bottomOf(box) {
  return box.y + box.height;
}

/** The loops are to be seen down to their axis before one scrolls. */
export async function assertLoopsInSight(page, what) {
  const axis = await page.locator('#cycle-loops .chart').first().locator('text', { hasText: 'Displacement' }).boundingBox();
  const bar = await page.locator('.player').boundingBox();
  assert.ok(bottomOf(axis) <= bar.y, `${what}: ${bottomOf(axis)} is under the bar at ${bar.y}`);
}

/** A4 with margins of 12 mm, at 96 pixels to the inch. */
export const paper = { width: (186 / 25.4) * 96, height: (273 / 25.4) * 96 };

/** Lays a page out as it is printed. */
export async function print(page) {
  await page.emulateMedia({ media: 'print' });
  await page.setViewportSize({ width: Math.round(paper.width), height: 1000 });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  // What they chose is said in words: nobody can choose on paper.
  assert.equal(await page.locator('select').evaluateAll((all) => all.filter((one) => one.getClientRects().length > 0).length), 0);
}

/** What axe-core finds by these rules, be it minor; by all of them unless given. */
export async function axeFindings(page, rules) {
  await page.evaluate(readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8'));
  // What passes is only counted.
  const options = { resultTypes: ['violations'], ...(rules && { runOnly: rules }) };
  const { violations, passes } = await page.evaluate(async (given) => {
    // Pictures are one thing for readers of the screen, and by far the most elements; rows and entries of lists often
    // differ by their texts alone. They are put aside meanwhile: what is excluded takes as long as all else.
    const kinds = new Map();
    const isRepeated = (one) => {
      const all = [one, ...one.querySelectorAll('*')];
      if (all.some((part) => part.id)) return false;
      const kind = all.map((part) => [part.tagName, part.getAttribute('class'), ...part.getAttributeNames()].join()).join(';');
      const before = kinds.get(one.parentNode) ?? new Set();
      const repeated = before.has(kind);
      kinds.set(one.parentNode, before.add(kind));
      return repeated;
    };
    const pictures = '.plot > *, .round > *, .unwrapped > *';
    const places = [...document.querySelectorAll(`${pictures}, tr, li, dl > *`)]
      .filter((one) => one.matches(pictures) || isRepeated(one))
      .map((one) => [one, one.parentNode, one.nextSibling]);
    for (const [one] of places) one.remove();
    const found = await globalThis.axe.run(given);
    for (const [one, parent, next] of places.reverse()) parent.insertBefore(one, next);
    return found;
  }, options);
  assert.ok(passes.length > (rules ? 0 : 20));
  return violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`);
}

/** Axe-core finds nothing, in light and in dark, which differ by their colours alone. */
export async function assertAccessible(page) {
  assert.deepEqual(await axeFindings(page), [], 'light');
  await page.emulateMedia({ colorScheme: 'dark' });
  assert.deepEqual(await axeFindings(page, ['color-contrast', 'link-in-text-block']), [], 'dark');
  await page.emulateMedia({ colorScheme: 'light' });
}

/** Whether the page has room for all that is on it, at widths from that of a phone to that of a large screen. */
export async function assertFits(page) {
  for (const width of [360, 768, 1366, 1920, 2560]) {
    await page.setViewportSize({ width, height: 900 });
    // Charts follow the width a frame later, and that frame is late on machines with much to do.
    const fits = page.waitForFunction(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth, undefined, { timeout: 10000 });
    await fits.catch(async () => {
      assert.fail(`${await page.evaluate(() => document.documentElement.scrollWidth)} px wide at ${width}`);
    });
  }
}

/// Words of a page are words, its links lead somewhere, and no row of its panels is left half empty.
/// @param noWords  what no text of it may have
export async function assertReads(page, noWords) {
  const text = await page.locator('main').innerText();
  assert.deepEqual(text.match(noWords), null);
  const dead = await page.locator('a[href^="#"]').evaluateAll((links) => links.map((link) => link.getAttribute('href')).filter((href) => !document.getElementById(href.slice(1))));
  assert.deepEqual([...new Set(dead)], []);
  const ends = await page.locator('.multiples').evaluateAll((groups) => groups.map((group) => [group.getBoundingClientRect().right, group.lastElementChild.getBoundingClientRect().right]));
  for (const [group, last] of ends) assert.ok(Math.abs(group - last) < 1, `${last} of ${group}`);
}

/// On paper every panel with a drawing fits a page.
export async function assertPanelsFitPaper(page) {
  await print(page);
  for (const panel of await page.locator('.panel', { has: page.locator('.chart, .round') }).all()) {
    const { height, width } = await panel.boundingBox();
    assert.ok(height < paper.height - 60 && width <= paper.width);
  }
}
