// Reports of sweeps in a browser: charts, loops and tables show the numbers of sweep.csv, points are chosen and searched.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, axeFindings, caseFile, folder, near, paper, placeOf, plotsIn, print, quantity, report, rotorFile, rowsOf, run, saved, stripFile, unfold, withReport } from './support.mjs';

const hostileTitle = '</script><img src="x" onerror="alert(1)"> & <b>bold</b>';
/** In the order of sweep.nc. */
const directions = ['+X', '+Y', '−X', '−Y'];

function sweep(name, file, keys, rest = [], exitCode = 0) {
  return run(['sweep', file, '-o', join(folder, name), ...keys.flatMap((key) => ['--over', key]), ...rest], exitCode);
}

before(() => {
  sweep('grid', caseFile, ['cycle.amplitude=60 um:90 um:10 um', 'friction.coefficient=[0, 0.1, 0.3]'], ['--set', 'cycle.steps=20', '--set', 'top_foil.yield_stress=2 GPa', '--set', `title=${JSON.stringify(hostileTitle)}`]);
  sweep('friction', caseFile, ['friction.coefficient=0:0.5:0.05'], ['--set', 'cycle.steps=20']);
  sweep('strips', stripFile, ['strip.displacement=5 um:25 um:5 um'], ['--command', 'strip']);
  const vibration = [
    'vibration.loads=[["0 N", "-50 N"], ["50 N", "0 N"]]', 'vibration.directions=["+X", "+Y"]', 'vibration.amplitudes=["1 um", "2 um", "5 um"]',
    'vibration.frequencies=["200 Hz", "400 Hz"]', 'vibration.steps=10',
  ];
  sweep('vibrations', caseFile, ['friction.coefficient=[0.05, 0.1, 0.2]'], ['--command', 'vibration', ...vibration.flatMap((pair) => ['--set', pair])]);
  report('vibrations.html', 'vibrations');
  const running = ['equilibrium.speeds=["30000 rpm", "45000 rpm"]', 'equilibrium.loads=[["30 N", "0 N"], ["50 N", "0 N"]]', 'film.rows=4', 'film.columns_per_pitch=4'];
  sweep('running', caseFile, ['bearing.radial_clearance=30 um:34 um:2 um'], ['--command', 'equilibrium', ...running.flatMap((pair) => ['--set', pair])]);
  report('running.html', 'running');
  const spinning = ['film.rows=4', 'film.columns_per_pitch=4', 'transient.steps_per_revolution=30', 'transient.revolutions_per_spectrum=2', 'transient.speed=[{to="9000 rpm", time="30 ms"}]'];
  run(['sweep', rotorFile, '-o', join(folder, 'spinning'), '--command', 'transient', '--over', 'transient.speed[1].to=9000 rpm:12000 rpm:1500 rpm', ...spinning.flatMap((pair) => ['--set', pair])]);
  report('spinning.html', 'spinning');
  sweep('yields', caseFile, ['top_foil.yield_stress=[1 GPa, 2 GPa]', 'friction.coefficient=[0.1, 0.2]'], ['--set', 'cycle.steps=5']);
  report('yields.html', 'yields');
  report('grid.html', 'grid');
  report('friction.html', 'friction');
  report('strips.html', 'strips');
  report('both.html', 'grid', 'friction');
});

function rowsIn(name) {
  return rowsOf(readFileSync(join(folder, name, 'sweep.csv'), 'utf8'));
}

/** Point by point, and in each by direction, as sweep.nc and the page have them. */
function sortedRowsIn(name) {
  const count = directions.length;
  return rowsIn(name)
    .map((row, i) => ({ row, point: Math.floor(i / count) }))
    .sort((a, b) => a.point - b.point || a.row.direction_deg - b.row.direction_deg)
    .map(({ row }) => row);
}

const over = 'Result vs. parameter';
const quantityChooser = (page) => page.getByRole('combobox', { name: `Quantity: ${over}` });
const chooser = (page, name) => page.getByRole('combobox', { name: `${name} shown` });

test('the chart shows the quantity chosen over the key, a line for each value of the other', () =>
  withReport('grid.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), hostileTitle);
    for (const [text, key] of [['Structural stiffness', 'loaded_stiffness_N_per_m'], ['Loss factor', 'loss_factor'], ['Clearance at 5 N', 'clearance_5N_m']]) {
      await quantityChooser(page).selectOption(text);
      await chooser(page, 'Direction').selectOption('+Y');
      const shown = rowsOf((await saved(page, over, /CSV/)).bytes.toString());
      const expected = rowsIn('grid').filter((row) => Number(row.direction_deg) === 90);
      assert.equal(shown.length, expected.length, text);
      assert.equal(new Set(shown.map((row) => `${row.cycle_amplitude_m} ${row.friction_coefficient}`)).size, expected.length, text);
      for (const row of shown) {
        const same = expected.find((one) => Math.abs(one.cycle_amplitude_m - row.cycle_amplitude_m) < 1e-9 && Math.abs(one.friction_coefficient - row.friction_coefficient) < 1e-6);
        near(Number(row[key]), Number(same[key]), 1e-6, `${text} at ${JSON.stringify(row)}`);
      }
      const chart = page.getByRole('region', { name: over }).locator('.chart');
      assert.match(await chart.getAttribute('aria-label'), new RegExp(`^${text} over Cycle: Amplitude · \\+Y · grid: .*coefficients 0\\.3 from`));
    }
    // Over the other key the lines change places.
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Coefficients of friction: Both coefficients');
    assert.equal(await page.getByRole('combobox', { name: 'Lines' }).inputValue(), 'Cycle: Amplitude');
    const legend = await page.getByRole('region', { name: over }).locator('.legend li').allTextContents();
    assert.deepEqual(legend, [60, 70, 80, 90].map((size) => `Amplitude ${size} µm`));
    await page.getByRole('combobox', { name: 'Lines' }).selectOption('Direction');
    assert.deepEqual(await page.getByRole('region', { name: over }).locator('.legend li').allTextContents(), directions);
  }));

test('of a command without a view of its own the parts of the points are told by their dimensions', () => {
  const page = readFileSync(join(folder, 'grid.html'), 'utf8');
  assert.equal(page.split('"swept_command":"cycle"').length, 2);
  writeFileSync(join(folder, 'other.html'), page.replace('"swept_command":"cycle"', '"swept_command":"hold"'));
  return withReport('other.html', async (page) => {
    assert.deepEqual(await chooser(page, 'Direction').locator('option').allTextContents(), directions);
    await chooser(page, 'Direction').selectOption('−X');
  });
});

test('a limit that is swept itself is no limit of the maps', () =>
  withReport('yields.html', async (page) => {
    const limit = page.getByRole('group', { name: 'Feasible region' }).getByLabel('Feasible where');
    assert.equal(await limit.locator('option:checked').textContent(), 'none');
  }));

test('maps over two keys come first, and pale is what misses a limit', () =>
  withReport('grid.html', async (page) => {
    const map = page.getByRole('region', { name: 'Map of maximum force' });
    assert.equal(await page.locator('.maps > .panel').count(), 3);
    const shown = rowsOf((await saved(page, 'Map of maximum force', /CSV/)).bytes.toString());
    const expected = rowsIn('grid').filter((row) => Number(row.direction_deg) === 0);
    assert.equal(shown.length, expected.length);
    for (const row of shown) {
      const same = expected.find((one) => Math.abs(one.cycle_amplitude_m - row.cycle_amplitude_m) < 1e-9 && Math.abs(one.friction_coefficient - row.friction_coefficient) < 1e-6);
      near(Number(row.max_force_N), Number(same.max_force_N), 1e-6, JSON.stringify(row));
    }
    const lines = async () => (await plotsIn(map)).locator('path[fill=none]').count();
    const limit = page.getByRole('group', { name: 'Feasible region' });
    // At first that of the case.
    assert.match(await map.locator('.subject').textContent(), /feasible where Maximum stress, top foil ≤ 2\.000 GPa/);
    assert.equal(await limit.getByLabel('Side of the limit').locator('option:checked').textContent(), 'at most');
    await limit.getByLabel('Feasible where').selectOption('none');
    const without = await lines();
    await limit.getByLabel('Feasible where').selectOption('Maximum force');
    await limit.getByLabel('Side of the limit').selectOption('at most');
    await limit.getByLabel('Limit', { exact: true }).fill('0.5');
    assert.match(await map.locator('.subject').textContent(), /feasible where Maximum force ≤ 500\.0 N/);
    assert.equal(await lines(), without + 1);
    // A click takes the nearest point, here that at the foot on the right.
    const plot = await plotsIn(map);
    const { width, height } = await plot.boundingBox();
    await plot.click({ position: { x: width - 24, y: height - 52 } });
    assert.equal(await chooser(page, 'Amplitude').inputValue(), '90 µm');
    assert.equal(await chooser(page, 'Both coefficients').inputValue(), '0');
  }));

test('a waterfall has the last spectrum of every run in time, and a click on one selects its run', () =>
  withReport('spinning.html', async (page) => {
    const panel = page.getByRole('region', { name: 'Waterfall' });
    assert.match(await panel.locator('.subject').textContent(), /^along X · 3 spectra of 2 revolutions each · largest .* · spinning$/);
    const shown = rowsOf((await saved(page, 'Waterfall', /CSV/)).bytes.toString());
    const once = shown.filter((row) => row.order === '1');
    assert.equal(shown.length, 3 * new Set(shown.map((row) => row.order)).size);
    const rpm = (row) => (Number(row.speed_rad_per_s) * 30) / Math.PI;
    once.forEach((row, i) => near(rpm(row), 9000 + 1500 * i, 1e-6, 'speed'));
    // The unbalance of 1 um is what moves these rotors, and their orbits are hardly larger.
    for (const row of once) assert.ok(row.amplitude_m > 0.8e-6 && row.amplitude_m < 3e-6, row.amplitude_m);
    assert.equal(await chooser(page, 'To').inputValue(), '12000 rpm');
    assert.deepEqual(once.map((row) => Number(row.transient_speed_1_to_rpm).toFixed(3)), ['9000.000', '10500.000', '12000.000']);
    const plot = await plotsIn(panel);
    const middle = await placeOf(plot.locator('image'));
    const { height } = await plot.locator('image').boundingBox();
    // Lines stay above the picture where the pointer is, too.
    const drawn = () => plot.locator('image, path[stroke-dasharray]').evaluateAll((all) => all.map((one) => one.tagName));
    const before = await drawn();
    assert.deepEqual([before[0], before.length], ['image', 4]);
    await plot.hover({ position: middle });
    await panel.locator('.tip').waitFor();
    assert.deepEqual(await drawn(), before);
    await plot.click({ position: { x: middle.x, y: middle.y + height / 2 - 10 } });
    assert.equal(await chooser(page, 'To').inputValue(), '9000 rpm');
  }));

test('a click on a point looks at it, and its loop is the thick one', () =>
  withReport('grid.html', async (page) => {
    const panel = page.getByRole('region', { name: over });
    const loops = page.getByRole('region', { name: 'Loops' });
    const mark = panel.locator('.cursor.point');
    await chooser(page, 'Amplitude').selectOption('70 µm');
    await chooser(page, 'Both coefficients').selectOption('0.3');
    await plotsIn(panel);
    const there = await placeOf(mark);
    const subject = await loops.locator('.subject').textContent();
    assert.equal(subject, 'Direct force vs. displacement · Both coefficients 0.3, +X · thick: Amplitude 70 µm · grid');
    await chooser(page, 'Amplitude').selectOption('90 µm');
    await chooser(page, 'Both coefficients').selectOption('0');
    assert.notDeepEqual(await placeOf(mark), there);
    await panel.locator('.chart').click({ position: there });
    assert.equal(await loops.locator('.subject').textContent(), subject);
    assert.deepEqual(await placeOf(mark), there);
    await panel.locator('.chart').hover({ position: { ...there, x: there.x + 2 } });
    const tip = await panel.locator('.tip').textContent();
    const row = rowsIn('grid').find((one) => one.direction_deg === '0' && Math.abs(one.cycle_amplitude_m - 7e-5) < 1e-9 && Number(one.friction_coefficient) > 0.25);
    near(quantity(tip.split('Structural stiffness').pop(), 'N/m'), Number(row.loaded_stiffness_N_per_m), 1e-3, tip);
    const widths = await (await plotsIn(loops)).locator('path[fill=none]').evaluateAll((paths) => paths.map((path) => Number(path.getAttribute('stroke-width'))));
    assert.equal(widths.filter((width) => width === 3).length, 1);
    assert.equal(widths.filter((width) => width === 1.3).length, 3);
  }));

test('the loops are those of single runs', async () => {
  run(['cycle', caseFile, '-o', join(folder, 'single'), '--set', 'cycle.steps=20', '--set', 'friction.coefficient=0.35']);
  await withReport('friction.html', async (page) => {
    await chooser(page, 'Direction').selectOption('−Y');
    const shown = rowsOf((await saved(page, 'Loops', /CSV/)).bytes.toString()).filter((row) => Math.abs(row.friction_coefficient - 0.35) < 1e-6);
    const single = rowsOf(readFileSync(join(folder, 'single', 'cycle.csv'), 'utf8')).filter((row) => Number(row.direction_deg) === 270);
    assert.equal(shown.length, single.length);
    shown.forEach((row, i) => {
      // Against a newton and a micrometre.
      for (const [name, floor] of [['displacement_m', 1e-12], ['force_direct_N', 1e-6]]) {
        assert.ok(Math.abs(row[name] - single[i][name]) <= 6e-7 * Math.abs(single[i][name]) + floor, `${name} of row ${i}`);
      }
    });
    // A family of eleven has a scale of colours.
    assert.deepEqual(await page.getByRole('region', { name: 'Loops' }).locator('.legend li').allTextContents(), ['Coefficients of friction: Both coefficients: 0 to 0.5']);
  });
});

test('the table has every point with units and definitions, and is searched', () =>
  withReport('grid.html', async (page) => {
    const table = page.getByRole('region', { name: 'Results by point' });
    assert.equal(await table.count(), 0);
    await unfold(page, 'Points');
    const rows = table.locator('tbody tr');
    const expected = sortedRowsIn('grid');
    assert.equal(await rows.count(), expected.length);
    const heads = await table.locator('thead th').allTextContents();
    const column = heads.findIndex((head) => head.startsWith('Maximum force'));
    const unit = heads[column].split(' ').pop();
    const shown = await rows.evaluateAll((all, i) => all.map((row) => row.children[i].textContent), column);
    shown.forEach((text, i) => near(quantity(`${text} ${unit}`, 'N'), Number(expected[i].max_force_N), 1e-3, `row ${i}`));
    assert.equal(await table.locator('thead a', { hasText: 'Loss factor' }).getAttribute('title'), await page.locator('#word-loss_factor dd').textContent());
    await page.getByRole('searchbox', { name: 'Search rows' }).fill('70 µm 0.3 -y');
    assert.deepEqual(await rows.locator('th').allTextContents(), ['70 µm', '0.3', '−Y']);
    assert.match(await table.locator('.count').textContent(), /^1 of 48 shown/);
    assert.equal(await table.locator('thead th', { hasText: 'Linear solves' }).count(), 0);
    await table.getByRole('button', { name: 'All' }).click();
    assert.equal(await table.locator('thead th', { hasText: 'Linear solves' }).count(), 1);
    assert.equal(await rows.count(), 1);
    const all = rowsOf((await saved(page, 'Results by point', /CSV/)).bytes.toString());
    near(Number(all[47].loop_energy_J), Number(expected[47].loop_energy_J), 1e-6, 'saved');
    assert.equal(all[47].status, 'converged');
  }));

test('the case of a sweep says that it is that of its first point', () =>
  withReport('grid.html', async (page) => {
    await unfold(page, 'Case and origin');
    assert.match(
      await page.getByRole('region', { name: 'Case', exact: true }).locator('.subject').textContent(),
      /The case of the first point\. Swept: Cycle: Amplitude 60 µm, 70 µm, 80 µm, 90 µm; Coefficients of friction: Both coefficients 0, 0\.1, 0\.3\./,
    );
    // An eighth of the rise is passed at 90 µm.
    assert.match(await page.locator('.warnings').textContent(), /cycle\.amplitude=90 um, friction\.coefficient=0: \+X: bump \d+ is compressed by/);
  }));

test('points that failed leave gaps and are told', async () => {
  // The last of them no bumps can carry.
  sweep('failed', caseFile, ['cycle.load=[100 N, 200 N, 100 kN]'], ['--set', 'cycle.steps=5'], 3);
  report('failed.html', 'failed');
  await withReport('failed.html', async (page) => {
    const warnings = await page.locator('.warnings').textContent();
    assert.match(warnings, /The run failed; its results are partial.*1 of 3 points failed: cycle\.load=100 kN: \+X, increment 1 of 10, .*: the load is not met/);
    assert.match(await page.locator('.about').textContent(), /· failed ·/);
    const shown = rowsOf((await saved(page, over, /CSV/)).bytes.toString()).filter((row) => row.direction === '+X');
    assert.deepEqual(shown.map((row) => row.loaded_stiffness_N_per_m === ''), [false, false, true]);
    await unfold(page, 'Points');
    await page.getByRole('searchbox', { name: 'Search rows' }).fill('load out of reach');
    assert.deepEqual(await page.locator('.points tbody tr').evaluateAll((rows) => rows.map((row) => row.children[0].textContent)), Array(4).fill('100 kN'));
    assert.match(await page.locator('.points tbody td').first().textContent(), /^–$/);
    // The chart is that of what there is.
    assert.doesNotMatch(await page.locator('.plot').first().innerHTML(), /NaN/);
  });
});

test('strips and several sweeps have sections of their own', async () => {
  await withReport('strips.html', async (page) => {
    await page.getByRole('combobox', { name: 'Cycle shown' }).selectOption('Cycle 2');
    const shown = rowsOf((await saved(page, over, /CSV/)).bytes.toString()).filter((row) => row.cycle === 'Cycle 2');
    const expected = rowsIn('strips').filter((row) => row.cycle === '2');
    assert.equal(shown.length, 5);
    shown.forEach((row, i) => near(Number(row.loaded_stiffness_N_per_m), Number(expected[i].loaded_stiffness_N_per_m), 1e-6, `row ${i}`));
  });
  await withReport('both.html', async (page) => {
    assert.deepEqual(await page.locator('nav a').allTextContents(), [
      'Sweep, grid', 'Points, grid', 'Case and origin, grid', 'Sweep, friction', 'Points, friction', 'Case and origin, friction', 'Glossary',
    ]);
    assert.match(await page.locator('.warnings').textContent(), /grid: cycle\.amplitude=90 um/);
  });
});

test('vibrations are drawn over the key, and over the amplitude', () =>
  withReport('vibrations.html', async (page) => {
    const shown = async (panel, quantityText) => {
      await page.getByRole('combobox', { name: `Quantity: ${panel}` }).selectOption(quantityText);
      const csv = (await saved(page, panel, /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\) N"/g, 'load');
      return rowsOf(csv);
    };
    const coefficients = JSON.parse(readFileSync(join(folder, 'vibrations', 'summary.json'), 'utf8')).points.flatMap(({ values, coefficients }) => coefficients.map((one) => ({ ...values, ...one })));
    const [friction, size] = ['friction.coefficient', 'amplitude_m'];
    const same = (a, b) => Math.abs(a - b) <= 1e-6 * Math.abs(b);
    await chooser(page, 'Static load').selectOption('(50, 0) N');
    await chooser(page, 'Amplitude').selectOption('2 µm');
    await chooser(page, 'Both coefficients').selectOption('0.1');
    // Lines differ in the amplitude, then in the key.
    for (const over of ['Coefficients of friction: Both coefficients', 'Amplitude']) {
      await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption(over);
      await page.getByRole('combobox', { name: 'Lines' }).selectOption(over === 'Amplitude' ? 'Coefficients of friction: Both coefficients' : 'Amplitude');
      const rows = await shown('Stiffness', 'Kxx');
      assert.equal(rows.length, 9, over);
      for (const row of rows) {
        const expected = coefficients.find((one) => one.load_x_N === 50 && same(row.friction_coefficient, one[friction]) && same(row.amplitude_m, one[size]));
        near(Number(row.kxx_N_per_m), expected.kxx_N_per_m, 1e-6, `${over} ${JSON.stringify(row)}`);
      }
      const legend = await page.getByRole('region', { name: 'Stiffness', exact: true }).locator('.legend li').allTextContents();
      assert.deepEqual(legend, over === 'Amplitude' ? ['0.05', '0.1', '0.2'].map((text) => `Both coefficients ${text}`) : [1, 2, 5].map((number) => `Amplitude ${number} µm`));
    }
    // What has no chart of its own is drawn, too.
    const energies = await shown('Other quantities', 'Loop energy');
    const expected = rowsIn('vibrations').filter((row) => row.load_x_N === '50' && row.direction_deg === '0');
    assert.equal(energies.length, expected.length);
    for (const row of energies) {
      const one = expected.find((other) => same(row.friction_coefficient, other.friction_coefficient) && same(row.amplitude_m, other.amplitude_m));
      near(Number(row.loop_energy_J), Number(one.loop_energy_J), 1e-6, 'loop energy');
    }
    assert.match(await page.getByRole('region', { name: 'Loops', exact: true }).locator('.subject').textContent(), /thick: Amplitude 2 µm · vibrations$/);
    const table = page.getByRole('region', { name: 'Loops by vibration' });
    assert.equal(await table.locator('tbody tr').count(), 3 * 2 * 2 * 3);
    await page.getByRole('searchbox', { name: 'Search rows: Coefficients by load' }).fill('0.2 50 5');
    assert.equal(await page.getByRole('region', { name: 'Coefficients by load' }).locator('tbody tr').count(), 2);
    assert.ok(await page.getByRole('region', { name: 'Case', exact: true }).isHidden());
    await unfold(page, 'Case and origin');
    assert.match(await page.getByRole('region', { name: 'Case', exact: true }).locator('.subject').textContent(), /Swept: Coefficients of friction: Both coefficients 0\.05, 0\.1, 0\.2\./);
    assert.deepEqual(await page.locator('nav a').allTextContents(), ['Sweep', 'Coefficients', 'Case and origin', 'Glossary']);
    assert.deepEqual(await axeFindings(page), []);
  }));

test('running bearings are drawn over the key, speed and load', () =>
  withReport('running.html', async (page) => {
    const expected = rowsIn('running');
    await chooser(page, 'Radial clearance').selectOption('32 µm');
    await chooser(page, 'Load').selectOption('(50, 0) N');
    await chooser(page, 'Speed').selectOption('45000 rpm');
    for (const [along, lines, count] of [['Bearing: Radial clearance', 'Load', 6], ['Speed', 'Bearing: Radial clearance', 6], ['Load', 'Speed', 4]]) {
      await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption(along);
      await page.getByRole('combobox', { name: 'Lines' }).selectOption(lines);
      for (const [text, key] of [['Minimum film thickness', 'h_min_m'], ['Power loss', 'power_W'], ['Stiffness, xx', 'kxx_N_per_m']]) {
        await quantityChooser(page).selectOption(text);
        const shown = rowsOf((await saved(page, over, /CSV/)).bytes.toString().replaceAll(/"\(([0-9]*), 0\) N"/g, '$1'));
        assert.equal(shown.length, count, along);
        for (const row of shown) {
          const one = expected.find(
            (other) =>
              Math.abs(other.bearing_radial_clearance_m - row.bearing_radial_clearance_m) < 1e-9 &&
              Number(other.load_x_N) === Number(row.load) &&
              Math.abs((other.speed_rad_per_s * 30) / Math.PI - row.speed_rpm) < 1,
          );
          near(Number(row[key]), Number(one[key]), 1e-6, `${text} at ${JSON.stringify(row)}`);
        }
      }
    }
    await unfold(page, 'Points');
    const table = page.getByRole('region', { name: 'Results by point' });
    assert.equal(await table.locator('tbody tr').count(), 12);
    await page.getByRole('searchbox', { name: 'Search rows' }).fill('32 30000 50');
    assert.deepEqual(await table.locator('tbody th').allTextContents(), ['32 µm', '30000 rpm', '(50, 0) N']);
    assert.deepEqual(await page.locator('nav a').allTextContents(), ['Sweep', 'Points', 'Case and origin', 'Glossary']);
    assert.deepEqual(await axeFindings(page), []);
  }));

test('saved pictures say what they are of', () =>
  withReport('grid.html', async (page) => {
    for (const [panel, name, texts] of [
      [over, 'Structural_stiffness-grid.svg', [over, 'Structural stiffness over Cycle: Amplitude', 'Both coefficients 0.3', '+X']],
      ['Loops', 'loops-force_direct-grid.svg', ['Direct force vs. displacement', 'thick: Amplitude 90 µm', 'Amplitude 60 µm']],
    ]) {
      const picture = await saved(page, panel, /SVG/);
      assert.equal(picture.name, name);
      const words = picture.bytes.toString().replace(/<[^>]*>/g, ' ').replace(/\s+/g, ' ');
      for (const text of texts) assert.ok(words.includes(text), `${panel} does not say ${text}: ${words.slice(0, 400)}`);
      assert.doesNotMatch(words, /NaN|undefined/);
    }
  }));

test('the keyboard reaches every choice', () =>
  withReport('grid.html', async (page) => {
    const controls = page.getByRole('group', { name: 'What is shown' }).locator('select');
    assert.equal(await controls.count(), 5);
    await controls.first().focus();
    for (let i = 1; i < 5; i += 1) await page.keyboard.press('Tab');
    const before = await page.getByRole('region', { name: 'Loops' }).locator('.subject').textContent();
    await page.keyboard.press('ArrowDown');
    assert.notEqual(await page.getByRole('region', { name: 'Loops' }).locator('.subject').textContent(), before);
  }));

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('both.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
  });
  await withReport('vibrations.html', assertFits);
  await withReport('grid.html', async (page) => {
    await unfold(page, 'Points');
    await print(page);
    for (const panel of await page.locator('.panel', { has: page.locator('.chart') }).all()) {
      const { height, width } = await panel.boundingBox();
      assert.ok(height < paper.height - 60 && width <= paper.width);
    }
    const [table, room] = await Promise.all(['.points .results', '.points'].map((one) => page.locator(one).boundingBox()));
    assert.ok(table.width <= room.width + 1, `${table.width} in ${room.width}`);
    assert.equal(await page.locator('.save, .control, input').evaluateAll((all) => all.filter((one) => one.getClientRects().length > 0).length), 0);
  });
});
