// Measured loops beside computed ones: drawn together, and their differences listed.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { cycle, folder, near, quantity, rowsOf, run, saved, state, summaryOf, withReport } from './support.mjs';

/** All forces of the rig are this much of the computed ones, so that the differences are known. */
const softer = 0.8;

before(() => {
  cycle('truss', 'cycle.steps=40', 'cycle.directions=["+X", "+Y"]');
  const rows = rowsOf(readFileSync(join(folder, 'truss', 'cycle.csv'), 'utf8')).filter((row) => row.direction_deg === '0');
  const lines = rows.map((row) => `+X;${1e6 * row.displacement_m};${softer * row.force_direct_N}`.replaceAll('.', ','));
  writeFileSync(join(folder, 'rig.csv'), ['# a rig', 'direction;displacement_um;force_N', ...lines, ''].join('\n'));
  const points = lines.map((line) => line.slice('+X;'.length));
  writeFileSync(join(folder, 'twice.csv'), ['Weg [µm];Kraft [N]', ...points, ...points.slice(1), ''].join('\n'));
  run(['report', join(folder, 'truss'), '--measured', join(folder, 'twice.csv:+X'), '-o', join(folder, 'twice.html')]);
  run(['report', join(folder, 'truss'), '--measured', join(folder, 'rig.csv'), '-o', join(folder, 'measured.html')]);
});

test('the loops are in one chart, by their names', () =>
  withReport('measured.html', async (page) => {
    assert.match(await page.locator('.masthead').textContent(), /compared with measured loops/);
    const labels = await page.locator('#cycle-loops .chart').evaluateAll((all) => all.map((chart) => chart.getAttribute('aria-label')));
    assert.equal(labels.length, 2);
    const { max_force_N: most } = summaryOf('truss').cycles[0];
    near(quantity(labels[0].split('rig.csv ')[1], 'N'), softer * most, 1e-3, 'measured');
    near(quantity(labels[0].split('truss ')[1].split(',')[0], 'N'), most, 1e-3, 'computed');
    assert.doesNotMatch(labels[1], /rig/);
    const drawn = rowsOf((await saved(page, 'Loops, +X', 'CSV')).bytes.toString());
    assert.equal(drawn.filter((row) => row.run === 'rig.csv').length, 81);
    assert.deepEqual([...new Set(drawn.filter((row) => row.run === 'rig.csv').map((row) => row.branch))], ['loading', 'unloading']);
    // A rig knows no cross force.
    await page.getByRole('region', { name: 'Loops, +X', exact: true }).getByText('Cross', { exact: true }).click();
    assert.doesNotMatch(await page.locator('#cycle-loops .chart').first().getAttribute('aria-label'), /rig/);
  }));

test('of several cycles the last is shown, and the page says so', () =>
  withReport('twice.html', async (page) => {
    assert.match(await page.locator('.warnings').textContent(), /twice\.csv: \+X: 2 cycles found, the last is used\./);
    const [, measured, computed] = await page.locator('.results tr[data-key=loop_energy_J] td').allTextContents();
    near(quantity(`${measured} mJ`, 'J'), softer * quantity(`${computed} mJ`, 'J'), 1e-3, 'loop energy');
  }));

test('differences are listed against the measured loop', () =>
  withReport('measured.html', async (page) => {
    const cells = (key) => page.locator(`.results tr[data-key=${key}] td`).allTextContents();
    for (const [key, unit] of [['max_force_N', 'N'], ['loaded_stiffness_N_per_m', 'N/m'], ['loop_energy_J', 'J']]) {
      const [scale, measured, computed, difference, percent] = await cells(key);
      const value = summaryOf('truss').cycles[0][key];
      // Between increments the rig does not know where the force begins.
      const rounding = key.startsWith('loaded') ? 0.02 : 1e-3;
      near(quantity(`${measured} ${scale}`, unit), softer * value, rounding, key);
      near(quantity(`${computed} ${scale}`, unit), value, 1e-3, key);
      near(quantity(`${difference.replace('+', '')} ${scale}`, unit), (1 - softer) * value, 8 * rounding, key);
      assert.ok(Math.abs(Number.parseFloat(percent.replace('+', '')) - 100 * (1 / softer - 1)) < 200 * rounding, `${key}: ${percent}`);
    }
    assert.match(await page.locator('.results thead').textContent(), /rig\.csv \(reference\)/);
    assert.equal(await page.getByRole('combobox', { name: 'Reference run' }).inputValue(), 'rig.csv');
    // Where nothing was measured there is nothing to compare with.
    await page.getByRole('region', { name: 'Results by direction' }).getByText('+Y', { exact: true }).click();
    assert.doesNotMatch(await page.locator('.results thead').textContent(), /reference/);
  }));

test('of foils, loads and cases nothing is claimed that was not computed', () =>
  withReport('measured.html', async (page) => {
    for (const part of ['loads', 'energies', 'stresses', 'case']) assert.doesNotMatch(await page.locator(`#cycle-${part}`).textContent(), /rig\.csv/, part);
    // The computed one alone may be left out of sight: something is to be looked at.
    await page.getByRole('checkbox', { name: /truss/ }).click();
    assert.ok(await page.getByRole('checkbox', { name: /truss/ }).isChecked());
    const before = await state(page);
    await page.getByRole('checkbox', { name: /rig/ }).click();
    assert.deepEqual(await state(page), before);
    assert.match(await page.locator('.results thead').textContent(), /truss \(reference\)/);
  }));
