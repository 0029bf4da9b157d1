// Reports of vibrations in a browser: coefficients, loss factors and loops are those of the files, warnings are told.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, caseFile, folder, near, paper, plotsIn, print, quantity, report, rowsOf, run, saved, summaryOf, withReport } from './support.mjs';

const axes = ['xx', 'xy', 'yx', 'yy'];
const omega = 2 * Math.PI * 200;

function vibration(name, pairs, exitCode = 0) {
  return run(['vibration', caseFile, '-o', join(folder, name), ...pairs.flatMap((pair) => ['--set', pair])], exitCode);
}

before(() => {
  const settings = ['vibration.directions=["+X", "+Y"]', 'vibration.amplitudes=["1 um", "2 um", "5 um"]', 'vibration.frequencies=["200 Hz", "400 Hz"]', 'vibration.steps=20'];
  vibration('vib', ['vibration.loads=[["0 N", "-50 N"], ["50 N", "0 N"]]', ...settings]);
  vibration('failed', ['vibration.loads=[["0 N", "-50 N"], ["0 N", "-1 MN"]]', ...settings], 3);
  report('vib.html', 'vib');
  report('failed.html', 'failed');
});

const csvOf = (name, file) => rowsOf(readFileSync(join(folder, name, file), 'utf8'));
const chooser = (page, name) => page.getByRole('combobox', { name: `${name} shown` });
const legendOf = (page, panel) => page.getByRole('region', { name: panel, exact: true }).locator('.legend li').allTextContents();

test('stiffness and damping are drawn over the amplitude at the load chosen', () =>
  withReport('vib.html', async (page) => {
    assert.deepEqual(await legendOf(page, 'Stiffness'), axes.map((one) => `K${one}`));
    assert.deepEqual(await legendOf(page, 'Damping'), axes.map((one) => `ωc${one}`));
    for (const [load, text] of ['(0, −50) N', '(50, 0) N'].entries()) {
      await chooser(page, 'Static load').selectOption(text);
      const expected = csvOf('vib', 'coefficients.csv').filter((row) => Number(row.load_x_N) === [0, 50][load] && Math.abs(row.frequency_rad_per_s - omega) < 1);
      const stiffness = rowsOf((await saved(page, 'Stiffness', /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\) N"/g, 'load'));
      const damping = rowsOf((await saved(page, 'Damping', /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\) N"/g, 'load'));
      assert.equal(expected.length, 3);
      expected.forEach((row, i) => {
        near(Number(stiffness[i].amplitude_m), Number(row.amplitude_m), 1e-6, 'amplitude');
        // Of entries that symmetry makes small, a millionth of the largest.
        const floor = 1e-6 * Number(row.kyy_N_per_m);
        for (const one of axes) {
          const [k, c] = [Number(row[`k${one}_N_per_m`]), omega * Number(row[`c${one}_N_s_per_m`])];
          assert.ok(Math.abs(stiffness[i][`k${one}_N_per_m`] - k) <= 1e-6 * Math.abs(k) + floor, `K${one}`);
          assert.ok(Math.abs(damping[i][`omega_c${one}_N_per_m`] - c) <= 1e-6 * Math.abs(c) + floor, `c${one}`);
        }
      });
    }
    // One entry by itself: lines tell the loads apart, and along the loads the amplitudes.
    await page.getByRole('combobox', { name: 'Quantity: Stiffness' }).selectOption('Kxx');
    assert.deepEqual(await legendOf(page, 'Stiffness'), ['(0, −50) N', '(50, 0) N']);
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Static load');
    assert.deepEqual(await legendOf(page, 'Stiffness'), ['Amplitude 1 µm', 'Amplitude 2 µm', 'Amplitude 5 µm']);
    assert.deepEqual((await (await plotsIn(page.getByRole('region', { name: 'Stiffness' }))).locator('text').allTextContents()).filter((text) => text.endsWith(' N')), ['(0, −50) N', '(50, 0) N']);
  }));

test('columns of tables are called as in the CSV files', () =>
  withReport('vib.html', async (page) => {
    for (const [table, file, places] of [['Coefficients by load', 'coefficients.csv', 3], ['Loops by vibration', 'vibration.csv', 3]]) {
      const [header] = (await saved(page, table, /CSV/)).bytes.toString().split('\n');
      const columns = header.trim().split(',').slice(places);
      assert.ok(columns.length > 10, table);
      for (const column of columns) assert.ok(column in csvOf('vib', file)[0], `${column} of ${table}`);
    }
  }));

test('the loss factor is that of each load and direction', () =>
  withReport('vib.html', async (page) => {
    await chooser(page, 'Static load').selectOption('(0, −50) N');
    await page.getByRole('combobox', { name: 'Lines' }).selectOption('Direction');
    assert.deepEqual(await legendOf(page, 'Loss factor'), ['+X', '+Y']);
    const shown = rowsOf((await saved(page, 'Loss factor', /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\) N"/g, 'load'));
    const expected = csvOf('vib', 'vibration.csv').filter((row) => Number(row.load_y_N) === -50);
    assert.equal(shown.length, 6);
    shown.forEach((row) => {
      const same = expected.find((one) => Math.abs(one.amplitude_m - row.amplitude_m) < 1e-9 && Number(one.direction_deg) === (row.direction === '+X' ? 0 : 90));
      near(Number(row.loss_factor), Number(same.loss_factor), 1e-6, JSON.stringify(row));
    });
  }));

test('the loops enclose the loop energy, and have a cross force', () =>
  withReport('vib.html', async (page) => {
    await chooser(page, 'Static load').selectOption('(0, −50) N');
    await chooser(page, 'Direction').selectOption('+Y');
    const rows = rowsOf((await saved(page, 'Loops', /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\) N"/g, 'load')).filter((row) => Math.abs(row.amplitude_m - 2e-6) < 1e-9);
    let energy = 0;
    for (let i = 1; i < rows.length; i += 1) energy += 0.5 * (Number(rows[i].force_direct_N) + Number(rows[i - 1].force_direct_N)) * (rows[i].displacement_m - rows[i - 1].displacement_m);
    const same = csvOf('vib', 'vibration.csv').find((row) => Number(row.load_y_N) === -50 && Number(row.direction_deg) === 90 && Math.abs(row.amplitude_m - 2e-6) < 1e-9);
    // Displacements about 40 µm in binary32, of a loop of 4 µm.
    near(energy, Number(same.loop_energy_J), 1e-4, 'energy');
    const loops = page.getByRole('region', { name: 'Loops', exact: true });
    await loops.getByRole('button', { name: 'Cross' }).click();
    assert.match(await loops.locator('.subject').textContent(), /^Cross force vs. displacement · \(0, −50\) N, \+Y · thick: Amplitude 5 µm/);
  }));

test('the tables are those of the files', () =>
  withReport('vib.html', async (page) => {
    const table = page.getByRole('region', { name: 'Coefficients by load' });
    const expected = csvOf('vib', 'coefficients.csv');
    await table.getByRole('button', { name: 'All' }).click();
    const cells = await table.locator('tbody tr').evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
    assert.deepEqual(cells[1].slice(0, 3), ['(0, −50) N', '1 µm', '400 Hz']);
    const heads = await table.locator('thead th').allTextContents();
    for (const [name, key, unit] of [['Kyy', 'kyy_N_per_m', 'N/m'], ['cyy', 'cyy_N_s_per_m', 'N s/m'], ['Loss factor Y', 'loss_factor_y', '']]) {
      const column = heads.findIndex((head) => head.startsWith(name));
      const shownUnit = heads[column].slice(name.length).trim();
      cells.forEach((row, i) => near(quantity(`${row[column]} ${shownUnit.replace(' s/m', '')}`.trim(), unit.replace(' s/m', '')), Number(expected[i][key]), 1e-3, `${name} ${i}`));
    }
    const vibrations = page.getByRole('region', { name: 'Loops by vibration' });
    await vibrations.getByRole('searchbox').fill('+y 5 µm');
    assert.equal(await vibrations.locator('tbody tr').count(), 2);
    assert.equal(await page.getByRole('region', { name: 'At the static loads' }).locator('tbody tr').count(), 2);
    for (const term of await page.locator('.points a.term').all()) {
      assert.equal(await page.locator(`#glossary ${await term.evaluate((one) => one.hash)} dd`).textContent(), await term.getAttribute('title'));
    }
  }));

test('what failed or did not settle is told', () =>
  withReport('failed.html', async (page) => {
    const { failures, warnings } = summaryOf('failed');
    assert.equal(failures.length, 1);
    const told = await page.locator('.warnings').textContent();
    for (const text of [...failures, ...warnings, 'The run failed']) assert.ok(told.includes(text), text);
    const loads = page.getByRole('region', { name: 'At the static loads' });
    assert.deepEqual(await loads.locator('tbody tr').nth(1).locator('td').evaluateAll((all) => all.slice(0, 3).map((cell) => cell.textContent)), ['load out of reach', '–', '–']);
    await chooser(page, 'Static load').selectOption('(0, −1) MN');
    assert.equal(await page.locator('.plot svg').count(), 5);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

/** A report as that of a command without a view of its own. */
function asOther(file, other) {
  const page = readFileSync(join(folder, file), 'utf8');
  assert.ok(page.includes('"kind":"vibration"'));
  writeFileSync(join(folder, other), page.replaceAll('"kind":"vibration"', '"kind":"hold"'));
}

test('results without a view of their own have charts, and a table for each set of dimensions', async () => {
  asOther('vib.html', 'other.html');
  await withReport('other.html', async (page) => {
    assert.deepEqual(await page.locator('h2').allTextContents(), ['Results of hold', 'Case and origin', 'Glossary']);
    const by = 'Results by load and amplitude';
    const table = rowsOf((await saved(page, 'Results by load, amplitude and frequency', /CSV/)).bytes.toString());
    const expected = csvOf('vib', 'coefficients.csv');
    assert.equal(table.length, expected.length);
    table.forEach((row, i) => {
      assert.equal(Number(row.load), expected[i].load_y_N === '-50' ? 1 : 2);
      for (const name of ['amplitude_m', 'frequency_rad_per_s', 'cyy_N_s_per_m']) near(Number(row[name]), Number(expected[i][name]), 1e-6, `${name} of row ${i}`);
    });
    // Stiffness is the same at every frequency.
    const first = expected.filter((row) => Math.abs(row.frequency_rad_per_s - omega) < 1);
    const stiffness = rowsOf((await saved(page, by, /CSV/)).bytes.toString());
    assert.equal(stiffness.length, first.length);
    stiffness.forEach((row, i) => near(Number(row.kyy_N_per_m), Number(first[i].kyy_N_per_m), 1e-6, `Kyy of row ${i}`));
    await page.getByRole('combobox', { name: `Quantity: ${by}: chart` }).selectOption('Kyy');
    await page.getByRole('combobox', { name: `${by}: chart, over` }).selectOption('Amplitude');
    await page.getByRole('combobox', { name: `${by}: chart, Load shown` }).selectOption('1');
    const drawn = rowsOf((await saved(page, `${by}: chart`, /CSV/)).bytes.toString()).filter((row) => Number(row.load) === 1);
    assert.equal(drawn.length, 3);
    drawn.forEach((row, i) => near(Number(row.kyy_N_per_m), Number(first[i].kyy_N_per_m), 1e-6, `amplitude ${i}`));
    const directions = await page.getByRole('region', { name: 'Results by load, direction and amplitude', exact: true }).locator('tbody tr').evaluateAll((rows) => rows.map((row) => row.children[1].textContent));
    assert.deepEqual([...new Set(directions)], ['+X', '+Y']);
    await assertAccessible(page);
    await assertFits(page);
  });
});

test('of several results without a view one that failed is shown as far as it is known', async () => {
  report('several.html', 'vib', 'failed');
  asOther('several.html', 'others.html');
  await withReport('others.html', async (page) => {
    assert.deepEqual(await page.locator('h2').allTextContents(), ['Results of hold, vib', 'Case and origin, vib', 'Results of hold, failed', 'Case and origin, failed', 'Glossary']);
    const told = await page.locator('.warnings').textContent();
    for (const text of summaryOf('failed').failures) assert.ok(told.includes(text), text);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined|Infinity/);
    const ids = await page.locator('[id]').evaluateAll((all) => all.map(({ id }) => id));
    assert.equal(new Set(ids).size, ids.length);
  });
});

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('vib.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
    await print(page);
    for (const panel of await page.locator('.panel', { has: page.locator('.chart') }).all()) {
      const { height, width } = await panel.boundingBox();
      assert.ok(height < paper.height - 60 && width <= paper.width);
    }
    for (const points of await page.locator('.points').all()) {
      const [table, room] = await Promise.all([points.locator('.results'), points].map((one) => one.boundingBox()));
      assert.ok(table.width <= room.width + 1, `${table.width} in ${room.width}`);
    }
  });
});
