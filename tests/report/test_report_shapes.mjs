// Bearings that are not round, and foils whose sheet changes its thickness: how reports show them.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, caseFile, folder, plotsIn, report, rowsOf, run, saved, withReport } from './support.mjs';

const examples = dirname(caseFile);
const panelName = 'Sleeve and journal, out of round';
const few = ['--set', 'cycle.steps=4', '--set', 'cycle.directions=["+X"]'];

before(() => {
  for (const name of ['out_of_round', 'graded', 'gen1']) run(['cycle', join(examples, `${name}.toml`), '-o', join(folder, name), ...few]);
  report('out_of_round.html', 'out_of_round');
  report('graded.html', 'graded');
  report('compared.html', 'gen1', 'out_of_round');
});

/** What the formulas of docs/profiles.md give for examples/out_of_round.toml, m. */
function deviations(degrees) {
  const profile = rowsOf(readFileSync(join(examples, 'sleeve_profile.csv'), 'utf8').replace(/^#.*\n/, '')).map((row) => 1e-6 * Number(row.deviation_um));
  const place = (profile.length * degrees) / 360;
  const [from, to] = [Math.floor(place), Math.floor(place) + 1].map((i) => profile[i % profile.length]);
  const phi = (degrees * Math.PI) / 180;
  // Foils go clockwise from 180 degrees, by 26 pitches.
  const theta = (((Math.PI - phi) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  const end = (26 * 4.572) / 19.05;
  const taper = theta <= end ? (10e-6 * theta) / end : NaN;
  return {
    sleeve: from + (to - from) * (place - Math.floor(place)) + taper,
    taper,
    journal: 3e-6 * Math.cos(3 * phi - Math.PI / 6) + 1.5e-6 * Math.cos(2 * phi),
  };
}

test('deviations over the angle are those of the case, as data and drawn', () =>
  withReport('out_of_round.html', async (page) => {
    const panel = page.getByRole('region', { name: panelName });
    const rows = rowsOf((await saved(page, panelName, /CSV/)).bytes.toString());
    assert.equal(rows.length, 721);
    const due = rows.map((row) => deviations(Number(row.phi_deg)));
    const names = ['sleeve', 'journal', 'taper'];
    rows.forEach((row, i) => {
      for (const name of names) {
        const text = row[`${name}_deviation_m`];
        if (Number.isNaN(due[i][name])) assert.equal(text, '', `${name} at ${row.phi_deg}`);
        // Seven digits of the largest.
        else assert.ok(Math.abs(Number(text) - due[i][name]) < 1e-11, `${name} at ${row.phi_deg}: ${text}, not ${due[i][name]}`);
      }
    });
    const plot = (await plotsIn(panel)).first();
    const words = (await plot.locator('text').allTextContents()).join(' ');
    assert.match(words, /Angle from X towards Y \(°\)/);
    assert.match(words, /Deviation of the radius \(µm\)/);
    assert.match(await panel.locator('.chart').getAttribute('aria-label'), /sleeve −2\.21 µm to 14\.8 µm; journal −4\.21 µm to 4\.43 µm; taper of the sleeve alone 0 m to 10\.0 µm/);
    // Labels of the axis tell what a place on it stands for, lines go through their numbers there.
    const ticks = await plot.locator('text').evaluateAll((all) => all.map((one) => [Number(one.textContent.replace('−', '-')), one.getBoundingClientRect().y + one.getBoundingClientRect().height / 2, one.getAttribute('text-anchor')]));
    const levels = ticks.filter(([number, , anchor]) => anchor === 'end' && Number.isFinite(number)).sort(([a], [b]) => a - b);
    const [[least, foot], [most, top]] = [levels[0], levels.at(-1)];
    const { lines, left, width } = await plot.locator('svg').evaluate((svg) => ({
      lines: [...svg.querySelectorAll('path[fill="none"][stroke-width="1.8"]')].map((path) => {
        const { e, f } = path.getScreenCTM();
        return Array.from({ length: 201 }, (_, i) => path.getPointAtLength((i / 200) * path.getTotalLength())).map(({ x, y }) => [x + e, y + f]);
      }),
      left: svg.getBoundingClientRect().x,
      width: svg.getBoundingClientRect().width,
    }));
    assert.equal(lines.length, names.length);
    const [begin, span] = [left + 62, width - 62 - 24];
    names.forEach((name, i) => {
      for (const [x, y] of lines[i]) {
        const shown = least + ((y - foot) * (most - least)) / (top - foot);
        const values = [-0.5, 0, 0.5].map((aside) => deviations(Math.min(360, Math.max(0, ((x - begin) / span) * 360 + aside)))[name]).filter(Number.isFinite);
        assert.ok(values.some((value) => Math.abs(shown - 1e6 * value) < 0.35), `${name} at ${x}: ${shown}, not ${values}`);
      }
    });
    // The tip of the pointer, and a picture.
    await plot.hover({ position: { x: 62 + 0.25 * (width - 86), y: 60 } });
    const tip = await panel.locator('.tip').textContent();
    assert.match(tip, /^90° from X towards Y/);
    assert.match(tip, /journal−3\.00 µm/);
    const { name, bytes } = await saved(page, panelName, /SVG/);
    assert.match(name, /^deviations-out_of_round\.svg$/);
    assert.match(bytes.toString(), /taper of the sleeve alone/);
  }));

test('compared with a round one its lines have its name, and round ones have no such chart', async () => {
  await withReport('compared.html', async (page) => {
    const panel = page.getByRole('region', { name: panelName });
    assert.deepEqual(await panel.locator('.legend li').allTextContents(), ['sleeve, out_of_round', 'journal, out_of_round', 'taper of the sleeve alone, out_of_round']);
  });
  await withReport('graded.html', async (page) => assert.equal(await page.getByRole('region', { name: panelName }).count(), 0));
});

test('where the sheet is thicker the line of the foil is wider, in both views', () =>
  withReport('graded.html', async (page) => {
    const mean = (5 * 0.127 + 21 * 0.102) / 26;
    for (const [view, width] of [['.round', 1.7], ['.unwrapped', 2]]) {
      const lines = await page.locator(`${view} path.bump-foil`).evaluateAll((all) => all.map((one) => ({ width: Number(one.getAttribute('stroke-width')), ...(({ x, width }) => ({ from: x, to: x + width }))(one.getBBox()) })));
      assert.deepEqual(lines.map((one) => one.width), [0.127, 0.102].map((thickness) => Number((width * (thickness / mean) ** 3).toFixed(2))));
      const panel = page.locator('.panel', { has: page.locator(view) });
      assert.match(await panel.locator('.subject').textContent(), /Bump foil 102 µm to 127 µm thick, line width scales with the cube\.$/);
      if (view === '.round') continue;
      // The change is between the numbers of bumps 5 and 6.
      const number = (bump) => page.locator('.unwrapped text', { hasText: new RegExp(`^${bump}$`) }).first().evaluate((one) => Number(one.getAttribute('x')));
      const [[thick, thin], before, behind] = [lines, await number(5), await number(6)];
      assert.ok(thick.from < before && Math.abs(thick.to - thin.from) < 0.1 && thick.to > before && thick.to < behind, JSON.stringify(lines));
    }
  }));

test('axe finds nothing, and the page fits screens', () =>
  withReport('out_of_round.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
  }));

test('foils of many bumps fit screens of half a laptop, and scroll to the bump that is chosen where they do not', () =>
  withReport('graded.html', async (page) => {
    const place = page.locator('.scroller', { has: page.locator('.unwrapped') });
    const excess = () => place.evaluate((one) => one.scrollWidth - one.clientWidth);
    for (const width of [1366, 768, 400]) {
      await page.setViewportSize({ width, height: 768 });
      await page.waitForFunction((most) => document.querySelector('.unwrapped').getBoundingClientRect().width < most, width);
      assert.equal(await excess(), 0, `at ${width}`);
    }
    await page.setViewportSize({ width: 300, height: 768 });
    await page.waitForFunction(() => document.querySelector('.unwrapped').parentElement.clientWidth < 290);
    assert.ok((await excess()) > 20);
    await page.locator('.unwrapped').focus();
    await page.keyboard.press('ArrowLeft');
    assert.match(await page.locator('.bump-values').textContent(), /^Bump 26:/);
    assert.equal(await place.evaluate((one) => Math.round(one.scrollLeft)), await excess());
  }));
