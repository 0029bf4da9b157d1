// Reports of paths in a browser: the way in the plane, forces, tangents and the energies of orbits are those of the files.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertFits, axeFindings, caseFile, folder, near, paper, placeOf, print, quantity, report, rowsOf, run, saved, summaryOf, withReport } from './support.mjs';

before(() => {
  const orbit = ['path.centre=["0 um", "-40 um"]', 'path.semi_axes=["10 um", "5 um"]', 'path.orbits=3', 'path.steps=40'];
  run(['path', caseFile, '-o', join(folder, 'orbit'), ...orbit.flatMap((pair) => ['--set', pair])]);
  report('orbit.html', 'orbit');
});

const rows = () => rowsOf(readFileSync(join(folder, 'orbit', 'path.csv'), 'utf8'));

/** Seven digits; what is small against the largest of its column counts against that. */
function same(shown, expected, name, own = name) {
  assert.equal(shown.length, expected.length);
  const largest = Math.max(...expected.map((row) => Math.abs(Number(row[own]))));
  shown.forEach((row, i) => assert.ok(Math.abs(row[name] - expected[i][own]) <= 1e-6 * largest, `${name} of row ${i}: ${row[name]}, not ${expected[i][own]}`));
}

test('the way in the plane, forces, tangents and energies are those of path.csv', () =>
  withReport('orbit.html', async (page) => {
    const shown = async (panel) => rowsOf((await saved(page, panel, /CSV/)).bytes.toString());
    const plane = await shown('In the plane');
    for (const name of ['x_m', 'y_m']) same(plane, rows(), name);
    assert.deepEqual(plane.map((row) => row.orbit), rows().map((row) => row.orbit));
    const forces = await shown('Forces');
    for (const name of ['force_x', 'force_y']) same(forces, rows(), name, `${name}_N`);
    const chooser = page.getByRole('combobox', { name: 'Quantity: Tangent stiffness' });
    for (const [text, end] of [['Sliding contacts', ''], ['Full stick', '_stuck']]) {
      await chooser.selectOption(text);
      const tangents = await shown('Tangent stiffness');
      // Of loose foils they are absent.
      const known = rows().filter((row) => row[`kyy${end}_N_per_m`] !== '');
      for (const axes of ['xx', 'xy', 'yx', 'yy']) same(tangents.filter((row) => row[`kyy${end}`] !== ''), known, `k${axes}${end}`, `k${axes}${end}_N_per_m`);
    }
  }));

test('the plane has the same scale both ways, and a click looks at a point in all charts', () =>
  withReport('orbit.html', async (page) => {
    const mark = page.getByRole('region', { name: 'In the plane' }).locator('.cursor.point');
    const list = page.getByRole('combobox', { name: 'Increment shown' });
    // A quarter of the orbit apart: 10 um across, 5 um upwards.
    const placeAt = async (increment) => {
      await list.selectOption(String(increment));
      return placeOf(mark);
    };
    const [right, top, left, bottom] = [await placeAt(80), await placeAt(90), await placeAt(100), await placeAt(110)];
    near((right.x - left.x) / (bottom.y - top.y), 2, 0.02, 'shape of the ellipse');
    const forces = page.getByRole('region', { name: 'Forces' }).locator('.cursor.point').first();
    const before = await forces.boundingBox();
    await page.getByRole('region', { name: 'In the plane' }).locator('.chart').click({ position: left });
    assert.match(await list.inputValue(), /^(60|100|140)$/);
    assert.notDeepEqual(await forces.boundingBox(), before);
  }));

test('every orbit has its energy, and what has not settled is told', () =>
  withReport('orbit.html', async (page) => {
    const [{ loop_energies_J: energies, warnings }] = summaryOf('orbit').cycles;
    const shown = rowsOf((await saved(page, 'Energy per orbit', /CSV/)).bytes.toString());
    shown.forEach((row, i) => near(Number(row.loop_energies), energies[i], 1e-6, `orbit ${i + 1}`));
    const table = page.getByRole('region', { name: 'Orbits' });
    const unit = (await table.locator('thead th').nth(1).textContent()).split(' ').pop();
    for (const [i, cell] of (await table.locator('tbody td:nth-child(2)').allTextContents()).entries()) near(quantity(`${cell} ${unit}`, 'J'), energies[i], 1e-3, `orbit ${i + 1}`);
    assert.equal(energies.length, 3);
    assert.equal(warnings.length, 1);
    assert.ok((await page.locator('.warnings').textContent()).includes(warnings[0]));
  }));

test('columns of the results are called as in summary.json', () =>
  withReport('orbit.html', async (page) => {
    const [header] = (await saved(page, 'Results of the path', /CSV/)).bytes.toString().split('\n');
    const [cycle] = summaryOf('orbit').cycles;
    for (const column of header.trim().split(',')) assert.ok(column in cycle, column);
  }));

test('centre and axes of an orbit have their unit', () =>
  withReport('orbit.html', async (page) => {
    const row = (name) => page.locator('table.case tr', { has: page.getByRole('rowheader', { name, exact: true }) }).locator('td').textContent();
    assert.equal(await row('Centre'), '0 m, −40 µm');
    assert.equal(await row('Semi-axes'), '10 µm, 5 µm');
  }));

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('orbit.html', async (page) => assert.deepEqual(await axeFindings(page), []), { colorScheme: 'dark' });
  await withReport('orbit.html', assertFits);
  await withReport('orbit.html', async (page) => {
    await print(page);
    for (const panel of await page.locator('.panel', { has: page.locator('.chart') }).all()) assert.ok((await panel.boundingBox()).height < paper.height - 60);
    for (const points of await page.locator('.points').all()) {
      const [table, room] = await Promise.all([points.locator('.results'), points].map((one) => one.boundingBox()));
      assert.ok(table.width <= room.width + 1, `${table.width} in ${room.width}`);
    }
  });
});
