// Measured loops beside computed ones: drawn together, and their differences listed. Fits of cases to such loops, and
// keys that were chosen.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { before, test } from 'node:test';
import { assertPanelsFitPaper, axeFindings, caseFile, cycle, folder, near, plotsIn, quantity, report, rowsOf, run, saved, state, summaryOf, withReport } from './support.mjs';

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
  const parameters = '{key="friction.coefficient", start=0.1, lower=0.0, upper=0.5}, {key="bearing.radial_clearance", start="30 um", lower="20 um", upper="40 um"}';
  const settings = ['fit.starts=1', 'fit.profile=true', `fit.parameter=[${parameters}]`, 'fit.data[1].points=20'];
  run(['fit', join(dirname(caseFile), 'fit.toml'), '-o', join(folder, 'fit'), ...settings.flatMap((pair) => ['--set', pair])]);
  report('fit.html', 'fit');
  writeFileSync(join(folder, 'shaken.csv'), 'amplitude_um,load_y_N,direction_deg,stiffness_MN/m,loss_factor\n1,-50,90,12,0.4\n2,-50,90,10.5,0.25\n1,-50,0,2,0.3\n');
  const shaken = `fit.data=[{experiment="vibration", file=${JSON.stringify(join(folder, 'shaken.csv'))}, stiffness_std=5e5, loss_factor_std=0.05}]`;
  const one = ['fit.starts=1', `fit.parameter=[{key="friction.coefficient", start=0.1, lower=0.0, upper=0.5}]`, 'vibration={loads=[["0 N", "-50 N"]], directions=["+Y"], amplitudes=["1 um"], frequencies=["1 Hz"], steps=4}', shaken];
  run(['fit', join(dirname(caseFile), 'fit.toml'), '-o', join(folder, 'shaken'), ...one.flatMap((pair) => ['--set', pair])]);
  report('shaken.html', 'shaken');
  const keys = '{key="friction.coefficient", lower=0.05, upper=0.4}, {key="bearing.radial_clearance", lower="25 um", upper="35 um"}';
  const aims = ['optimise.command=cycle', 'optimise.maximise=loop_energy', 'optimise.minimise=max_force', 'optimise.limits=["max_force > 600 N"]'];
  const search = ['optimise.evaluations=60', 'optimise.starts=1', 'optimise.front=1', 'cycle.steps=10', 'cycle.directions=["+X"]', 'solver.name=events'];
  run(['optimise', caseFile, '-o', join(folder, 'optimised'), ...[...aims, ...search, `optimise.key=[${keys}]`, 'optimise.tolerance=0.05'].flatMap((pair) => ['--set', pair])]);
  report('optimised.html', 'optimised');
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

test('a fit is shown with its values, correlations, loops, residuals and profiles', () =>
  withReport('fit.html', async (page) => {
    const { parameters, reduced_chi_square: chi } = summaryOf('fit');
    const [friction, clearance] = parameters;
    const table = (name) => page.getByRole('group', { name, exact: true }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
    const [first, second] = await table('Table of fitted values');
    assert.equal(first[0], 'Coefficients of friction: Both coefficients');
    near(Number(first[1]), friction.fitted_value, 1e-4, 'friction');
    assert.deepEqual(first[3].split(' to ').map(Number), [friction.lower_95, friction.upper_95].map((one) => Number(one.toPrecision(5))));
    assert.equal(second[6], 'µm');
    near(quantity(`${second[1]} µm`, 'm'), clearance.fitted_value, 1e-4, 'clearance');
    near(quantity(`${second[2]} µm`, 'm'), clearance.standard_error, 1e-2, 'its error');
    near(quantity(`${second[4].split(' to ')[1]} µm`, 'm'), clearance.profile_upper_95, 1e-4, 'by its profile');
    const values = page.getByRole('region', { name: 'Fitted values', exact: true });
    near(Number(/per degree of freedom (\S+),/.exec(await values.locator('.subject').textContent())[1]), chi, 1e-2, 'chi-square');
    near(Number((await table('Table of correlations'))[0][2].replace('−', '-')), friction.correlations[1], 1e-2, 'correlation');
    const points = rowsOf(readFileSync(join(folder, 'fit', 'fit.csv'), 'utf8'));
    const drawn = rowsOf((await saved(page, 'Measured and fitted force', 'CSV')).bytes.toString());
    const left = rowsOf((await saved(page, 'Residuals of the force', 'CSV')).bytes.toString());
    assert.equal(drawn.length, points.length);
    points.forEach((point, i) => {
      assert.equal(drawn[i].series, point.series);
      near(Number(drawn[i].measured), Number(point.measured_value), 1e-6, 'measured');
      near(Number(drawn[i].fitted), Number(point.model_value), 1e-6, 'fitted');
      near(Number(left[i].residual), Number(point.value_residual), 1e-6, 'residual');
    });
    const marks = await (await plotsIn(page.getByRole('region', { name: 'Residuals of the force', exact: true }))).locator('text').allTextContents();
    assert.ok(marks.includes('Residual (std. deviations)') && marks.includes('Displacement (µm)'), marks.join());
    const profile = rowsOf((await saved(page, 'Profile of Bearing: Radial clearance', 'CSV')).bytes.toString());
    assert.equal(profile.length, 13);
    profile.forEach(({ value, cost_increase: cost }, i) => {
      near(Number(value), clearance.profile[i].profile_value, 1e-6, 'value');
      near(Number(cost), clearance.profile[i].profile_cost, 1e-6, 'cost');
    });
    assert.match(await page.locator('.warnings').textContent(), /does not explain the data/);
    assert.deepEqual(await axeFindings(page), []);
    await assertPanelsFitPaper(page);
  }));

test('of a table every quantity has its charts, with a curve for each load and direction', () =>
  withReport('shaken.html', async (page) => {
    const points = rowsOf(readFileSync(join(folder, 'shaken', 'fit.csv'), 'utf8')).filter(({ quantity: name }) => name === 'loss_factor');
    const drawn = rowsOf((await saved(page, 'Measured and fitted loss factor', 'CSV')).bytes.toString());
    assert.deepEqual(drawn.map(({ measured }) => Number(measured)), [0.4, 0.25, 0.3]);
    points.forEach((point, i) => near(Number(drawn[i].fitted), Number(point.model_value), 1e-6, 'fitted'));
    const region = page.getByRole('region', { name: 'Measured and fitted stiffness', exact: true });
    assert.match(await region.locator('.legend').textContent(), /load \(0, -50\) N, along 90 deg.*along 0 deg/);
    const marks = await (await plotsIn(region)).locator('text').allTextContents();
    assert.ok(marks.includes('Stiffness (MN/m)') && marks.includes('Amplitude (µm)'), marks.join());
  }));

test('an optimisation is shown with its best point, limits, front and all points', () =>
  withReport('optimised.html', async (page) => {
    const { keys, limits, front, best_point: best } = summaryOf('optimised');
    const table = (name) => page.getByRole('group', { name, exact: true }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
    const [, clearance] = await table('Table of best values');
    assert.equal(clearance[0], 'Bearing: Radial clearance');
    near(quantity(`${clearance[1]} ${clearance[5]}`, 'm'), keys[1].best_value, 1e-4, 'clearance');
    const [[text, value, margin]] = await table('Table of limits');
    assert.equal(text, 'maximum force > 600 N');
    const clearances = page.getByRole('region', { name: 'Case', exact: true }).getByRole('table').filter({ hasText: 'Bearing: Radial clearance' });
    assert.match(await clearances.textContent(), /Lower bound25 µm/);
    // Aims and limits of the case in the words of the tables.
    const chosen = page.getByRole('region', { name: 'Case', exact: true }).getByRole('table').filter({ hasText: 'Evaluations' });
    const lines = await chosen.getByRole('row').evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent).join(': ')));
    for (const line of ['Maximise: loop energy', 'Minimise: maximum force', 'Limits: maximum force > 600 N']) assert.ok(lines.includes(line), lines.join('\n'));
    near(quantity(value, 'N'), limits[0].value, 1e-4, 'value');
    near(quantity(margin, 'N'), limits[0].margin, 1e-2, 'margin');
    const points = rowsOf(readFileSync(join(folder, 'optimised', 'points.csv'), 'utf8'));
    const drawn = rowsOf((await saved(page, 'Loop energy over Coefficients of friction: Both coefficients', 'CSV')).bytes.toString());
    assert.equal(drawn.length, points.length);
    points.forEach((point, i) => {
      near(Number(drawn[i].loop_energy), Number(point.loop_energy_J), 1e-6, 'aim');
      assert.equal(drawn[i].feasible, point.feasible);
    });
    assert.ok(front.includes(best) && front.length > 1);
    const marks = await (await plotsIn(page.getByRole('region', { name: 'Front of both aims', exact: true }))).locator('text').allTextContents();
    assert.ok(marks.some((mark) => mark.startsWith('Loop energy (')), marks.join());
    assert.deepEqual(await axeFindings(page), []);
    await assertPanelsFitPaper(page);
  }));
