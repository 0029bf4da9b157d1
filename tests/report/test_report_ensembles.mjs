// Reports of ensembles in a browser: distributions, statistics, yields and sensitivities are those of the files, and a click
// shows a bearing that is the one of `cycle --sample`.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, caseFile, folder, near, paper, placeOf, plotsIn, print, quantity, report, rowsOf, run, runningFile, saved, summaryOf, unfold, withReport } from './support.mjs';

const samples = 60;
const settings = ['montecarlo.bump_height.distribution="normal"', 'montecarlo.bump_height.std="10 um"', 'montecarlo.friction_top_bump.distribution="uniform"', 'montecarlo.friction_top_bump.lower=-0.05', 'montecarlo.friction_top_bump.upper=0.05', 'cycle.directions=["+X", "+Y"]', 'cycle.steps=20'];
const sets = [...settings, 'title=</script><b>many</b>'].flatMap((pair) => ['--set', pair]);

before(() => {
  run(['montecarlo', caseFile, '-o', join(folder, 'many'), '--samples', String(samples), '--limit', 'clearance_5N > 20 um', '--limit', 'max_force < 800 N', ...sets]);
  report('many.html', 'many');
  // A negative coefficient of friction is invalid.
  run(['montecarlo', caseFile, '-o', join(folder, 'few'), '--samples', '8', '--set', 'montecarlo.friction_top_bump.std=0.2', '--set', 'cycle.steps=10', '--set', 'cycle.directions=["+X"]'], 3);
  run(['cycle', caseFile, '-o', join(folder, 'alone'), '--set', 'cycle.steps=10']);
  report('few.html', 'few', 'alone');
  const film = ['montecarlo.command=equilibrium', 'montecarlo.radial_clearance.std=1 um', 'film.columns_per_pitch=4', 'film.rows=6', 'equilibrium.steps=2', 'equilibrium.loads=[["20 N", "0 N"], ["40 N", "0 N"]]'];
  run(['montecarlo', runningFile, '-o', join(folder, 'running'), '--samples', '12', '--limit', 'h_min > 5 um', ...film.flatMap((pair) => ['--set', pair])]);
  report('running.html', 'running');
});

const panelOf = (page, name) => page.getByRole('region', { name, exact: true });
const csvOf = async (page, name) => rowsOf((await saved(page, name, /CSV/)).bytes.toString());
const directionChooser = (page) => page.getByRole('combobox', { name: 'Direction shown' });

test('histograms count every bearing, and say mean and percentiles of the direction looked at', () =>
  withReport('many.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), '</script><b>many</b>');
    const { statistics } = summaryOf('many');
    // Quantities with limits stand first; the rest is folded.
    assert.equal(await page.locator('.maps > .panel:visible').count(), 3);
    for (const [key, unit] of [['clearance_5N_m', 'm'], ['max_force_N', 'N']]) {
      near(quantity(await page.locator(`.tile[data-key="${key}"] strong`).textContent(), unit), statistics['+X'][key].mean, 1e-3, key);
    }
    assert.equal(await panelOf(page, 'Maximum bump load').locator('.chart').isVisible(), false);
    await page.getByText('more distributions').click();
    for (const [name, key, unit] of [['Maximum force', 'max_force_N', 'N'], ['Structural stiffness', 'loaded_stiffness_N_per_m', 'N/m'], ['Maximum bump load', 'largest_bump_load_N', 'N']]) {
      for (const direction of ['+X', '+Y']) {
        await directionChooser(page).selectOption(direction);
        const found = statistics[direction][key];
        const bars = await csvOf(page, name);
        assert.equal(bars.reduce((sum, row) => sum + Number(row.bearings), 0), samples, `${name} ${direction}`);
        const from = Object.keys(bars[0])[1];
        const below = bars.reduce((sum, row) => sum + (Number(row[from]) < found.p50 ? Number(row.bearings) : 0), 0);
        assert.ok(below >= samples / 2 - 1, `${below} are below the median`);
        const subject = await panelOf(page, name).locator('.subject').textContent();
        near(quantity(subject.match(/mean (\S+ \S+) ±/)[1], unit), found.mean, 1e-3, 'mean');
        near(quantity(subject.match(/± (\S+ \S+) \(95 %\)/)[1], unit), found.mean_interval_95[1] - found.mean, 1e-3, 'interval');
        near(quantity(subject.match(/5 % below (\S+ [^,]+),/)[1], unit), found.p5, 1e-3, 'p5');
        near(quantity(subject.match(/5 % above (\S+ \S+)/)[1], unit), found.p95, 1e-3, 'p95');
        assert.ok(subject.includes(` · ${direction} · `));
      }
    }
  }));

test('the tables are those of summary.json', () =>
  withReport('many.html', async (page) => {
    const { statistics, limits, yield: all } = summaryOf('many');
    const rows = (await page.getByRole('group', { name: 'Table of yields' }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent))));
    assert.deepEqual(rows.map((row) => row.slice(0, 3)), [...limits.map((one) => [one.limit, String(one.passed), String(samples)]), ['all together', String(all.passed), String(samples)]]);
    near(quantity(rows[2][3].replace(' %', ''), ''), (100 * all.passed) / samples, 1e-2, 'yield');
    await directionChooser(page).selectOption('+Y');
    const shown = await page.locator('tr[data-key="loop_energy_J"] > *').allTextContents();
    near(quantity(`${shown[2]} ${shown[1]}`, 'J'), statistics['+Y'].loop_energy_J.mean, 1e-3, 'mean');
    near(quantity(`${shown[11]} ${shown[1]}`, 'J'), statistics['+Y'].loop_energy_J.p99, 1e-3, 'p99');
    await unfold(page, 'Statistics');
    const saidOfAll = await csvOf(page, 'Statistics of the bearings');
    const force = saidOfAll.find((row) => row.quantity === 'max_force_N' && row.direction_deg === '90');
    near(Number(force.std), statistics['+Y'].max_force_N.std, 1e-6, 'std');
  }));

test('sensitivities and bump loads are those of summary.json', () =>
  withReport('many.html', async (page) => {
    const { sensitivities, bump_loads: loads } = summaryOf('many');
    const heights = await csvOf(page, 'Sensitivity to bump heights');
    const common = rowsOf((await saved(page, 'Sensitivity to inputs common to a bearing', /CSV/)).bytes.toString().replaceAll(/"[^"]*"/g, 'friction'));
    for (const [direction, degrees] of [['+X', '0'], ['+Y', '90']]) {
      const found = sensitivities[direction].max_force;
      const rows = heights.filter((row) => row.direction_deg === degrees);
      assert.deepEqual(rows.map((row) => Number(row.factor)), Array.from({ length: 26 }, (_, i) => i + 1));
      rows.forEach((row, i) => near(Number(row.max_force), found.bump_height[i], 1e-6, `bump ${i + 1}`));
      const friction = common.find((row) => row.direction_deg === degrees);
      near(Number(friction.max_force), found.friction_top_bump, 1e-6, 'friction');
    }
    const spread = await csvOf(page, 'Bump loads');
    near(Number(spread.find((row) => row.bump === '20' && row.direction_deg === '0').std_N), loads['+X'].std_N[19], 1e-6, 'std');
    // The largest of them is told to those who cannot see the bars.
    const label = await panelOf(page, 'Sensitivity to bump heights').locator('.chart').getAttribute('aria-label');
    const sizes = sensitivities['+X'].max_force.bump_height.map(Math.abs);
    assert.ok(label.includes(`most on ${sizes.indexOf(Math.max(...sizes)) + 1} `), label);
  }));

test('a click on a histogram or a loop shows the bearing, which is that of cycle --sample', async () => {
  run(['cycle', caseFile, '-o', join(folder, 'seventeen'), '--sample', `${join(folder, 'many', 'ensemble.nc')}:17`, ...['cycle.directions=["+X", "+Y"]', 'cycle.steps=20'].flatMap((pair) => ['--set', pair])]);
  await withReport('many.html', async (page) => {
    const runs = page.getByRole('combobox', { name: 'Run', exact: true });
    assert.equal(await runs.locator('option').count(), 20);
    await runs.selectOption('Sample 17');
    assert.match(await panelOf(page, 'The bearing').locator('.subject').textContent(), /^Sample 17 · \+X/);
    const shown = (await csvOf(page, 'Loops, +X')).filter((row) => row.run === 'Sample 17');
    const alone = rowsOf(readFileSync(join(folder, 'seventeen', 'cycle.csv'), 'utf8')).filter((row) => Number(row.direction_deg) === 0);
    // Every other increment of each branch, and both ends.
    assert.equal(shown.length, (alone.length + 1) / 2);
    for (const row of shown) {
      const same = alone.find(({ increment }) => increment === row.increment);
      assert.ok(Math.abs(row.force_direct_N - same.force_direct_N) < 1e-3, `${row.force_direct_N}, not ${same.force_direct_N}`);
    }
    // Of the fan only this one is thick.
    const panel = panelOf(page, 'Loops, +X');
    const widths = await (await plotsIn(panel)).locator('path[fill=none]').evaluateAll((paths) => paths.map((path) => Number(path.getAttribute('stroke-width'))));
    assert.equal(widths.filter((width) => width === 1.1).length, 19);
    // Its number stands in the histogram, at which a click looks at it again.
    const histogram = panelOf(page, 'Maximum force');
    const { x } = await placeOf(histogram.locator('.cursor.line'));
    const bearing = await page.locator('.round').innerHTML();
    await runs.selectOption('Sample 0');
    assert.notEqual(await page.locator('.round').innerHTML(), bearing);
    await histogram.locator('.chart').click({ position: { x, y: 100 } });
    assert.equal(await runs.evaluate((list) => list.options[list.selectedIndex].textContent), 'Sample 17');
    // The direction that is looked at goes with the bearing, and the other way round.
    await page.getByRole('region', { name: /^Position along the cycle/ }).getByRole('combobox', { name: 'Direction' }).selectOption('+Y');
    assert.equal(await directionChooser(page).inputValue(), '+Y');
    await directionChooser(page).selectOption('+X');
    assert.match(await panelOf(page, 'The bearing').locator('.subject').textContent(), /^Sample 17 · \+X/);
  });
});

test('what failed is told, and what is no bearing is not looked at', () =>
  withReport('few.html', async (page) => {
    const { failed } = summaryOf('few');
    assert.ok(failed.length > 0 && failed.length < 8);
    const told = await page.locator('.warnings').textContent();
    assert.match(told, /The run failed; its results are partial/);
    assert.match(told, new RegExp(`${failed.length} cycles failed: `));
    assert.equal(await page.getByRole('heading', { name: `The first ${8 - failed.length} bearings, few` }).count(), 1);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
    // Beside the report of a cycle.
    assert.equal(await page.getByRole('heading', { name: 'Loops and bearing' }).count(), 1);
  }));

test('pictures are complete', () =>
  withReport('many.html', async (page) => {
    const picture = await saved(page, 'Maximum force', /SVG/);
    assert.equal(picture.name, 'distribution-max_force-many-+X.svg');
    const words = picture.bytes.toString().replace(/<[^>]*>/g, ' ').replace(/\s+/g, ' ');
    for (const text of ['Maximum force', 'mean', 'median', '5 % to 95 % of the bearings', '+X']) assert.ok(words.includes(text), text);
    assert.doesNotMatch(picture.bytes.toString(), /NaN|undefined/);
  }));

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('many.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
    await print(page);
    for (const panel of await page.locator('.panel', { has: page.locator('.chart') }).all()) {
      const { height, width } = await panel.boundingBox();
      assert.ok(height < paper.height - 60 && width <= paper.width);
    }
  });
});

test('running bearings are looked at state by state', () =>
  withReport('running.html', async (page) => {
    const { statistics } = summaryOf('running');
    const states = ['45000 rpm, load (20, 0) N', '45000 rpm, load (40, 0) N'];
    assert.deepEqual(Object.keys(statistics), states);
    for (const state of states) {
      await page.getByRole('combobox', { name: 'State shown' }).selectOption(state);
      const subject = await panelOf(page, 'Minimum film thickness').locator('.subject').textContent();
      assert.ok(subject.includes(` · ${state} · `), subject);
      near(quantity(subject.match(/mean (\S+ \S+) ±/)[1], 'm'), statistics[state].h_min_m.mean, 1e-3, 'mean');
      const shown = await page.locator('tr[data-key="power_W"] > *').allTextContents();
      near(quantity(`${shown[2]} ${shown[1]}`, 'W'), statistics[state].power_W.mean, 1e-3, 'mean');
    }
    const [head, ...bars] = (await saved(page, 'Minimum film thickness', /CSV/)).bytes.toString().trimEnd().split('\n');
    assert.match(head, /^state,/);
    assert.ok(bars.every((bar) => bar.startsWith(`"${states[1]}",`)));
    assert.equal(bars.reduce((sum, bar) => sum + Number(bar.slice(bar.lastIndexOf(',') + 1)), 0), 12);
    // Of a truss that is not known, and has no picture.
    assert.equal(await panelOf(page, 'Maximum stress, bump foil').count(), 0);
    assert.equal(await page.getByRole('region', { name: /^The first/ }).count(), 0);
    assert.ok((await panelOf(page, 'Bump loads').locator('.subject').textContent()).startsWith('Mean and standard deviation · '));
  }));
