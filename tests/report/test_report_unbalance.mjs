// Reports of rotors with unbalance in a browser: Bode and polar plots, orbits, films and losses are those of unbalance.csv,
// peaks and multipliers those of summary.json, and what was not found is told.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, assertPanelsFitPaper, assertReads, folder, near, placeOf, plotsIn, quantity, report, rotorFile, rowsOf, run, saved, summaryOf, unfold, withReport } from './support.mjs';

const mesh = ['film.columns_per_pitch=4', 'film.rows=4'];

function unbalance(name, pairs, exitCode = 0) {
  return run(['unbalance', rotorFile, '-o', join(folder, name), ...[...mesh, ...pairs].flatMap((pair) => ['--set', pair])], exitCode);
}

before(() => {
  const tilting = ['rotor.bearings=["-60 mm", "60 mm"]', 'rotor.transverse_inertia=4e-3 kg m2', 'rotor.polar_inertia=5e-4 kg m2', 'rotor.unbalance=[{amount="2 g mm", at="30 mm"}, {amount="1 g mm", at="-60 mm", phase="90 deg"}]'];
  const orbits = ['unbalance.orbits=true', 'unbalance.steps_per_revolution=30'];
  unbalance('orbits', ['unbalance.speeds=["15000 rpm", "12000 rpm", "9000 rpm", "8000 rpm", "6000 rpm"]', ...orbits]);
  unbalance('tilting', ['unbalance.speeds={from="6000 rpm", to="18000 rpm", points=7}', ...tilting]);
  unbalance('back', ['unbalance.speeds=["-9000 rpm", "-12000 rpm"]', 'bearing.wrap=clockwise', ...orbits]);
  unbalance('one', ['unbalance.speeds=["12000 rpm"]', 'title=</script><b>x</b>']);
  unbalance('failed', ['unbalance.speeds=["12000 rpm", "50 rpm"]'], 3);
  const film = mesh.flatMap((pair) => ['--set', pair]);
  run(['sweep', rotorFile, '--command', 'unbalance', '--over', 'rotor.mass=[1 kg, 2 kg]', '-o', join(folder, 'masses'), ...film]);
  run(['montecarlo', rotorFile, '-o', join(folder, 'tolerances'), '--samples', '4', '--limit', 'largest_amplitude < 5 um', ...film, '--set', 'unbalance.speeds=["8000 rpm", "10000 rpm"]', '--set', 'montecarlo.command=unbalance', '--set', 'montecarlo.radial_clearance.std=2 um']);
  for (const name of ['orbits', 'tilting', 'back', 'one', 'failed', 'masses', 'tolerances']) report(`${name}.html`, name);
});

const csvOf = (name) => rowsOf(readFileSync(join(folder, name, 'unbalance.csv'), 'utf8'));
const panelOf = (page, name) => page.getByRole('region', { name, exact: true });
const shownIn = async (page, name) => rowsOf((await saved(page, name, /CSV/)).bytes.toString());
const chooser = (page, name) => page.getByRole('combobox', { name: `${name} shown` });
const tableOf = (page, name) => page.getByRole('group', { name, exact: true }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
const rpmOf = (row) => (row.speed_rad_per_s * 30) / Math.PI;
const plots = ['Bode plot: amplitude', 'Bode plot: phase', 'Polar plot'];

/** Outlines of the marks of a plot, and whether they are filled with the colour of their outline. */
async function marksIn(plot) {
  const all = await plot.locator('path').evaluateAll((paths) => paths.map((one) => [one.getAttribute('fill'), one.getAttribute('stroke'), one.getAttribute('stroke-width')]));
  return all.filter(([fill, stroke, width]) => stroke && fill && fill !== 'none' && fill !== 'transparent' && width).map(([fill, stroke]) => fill === stroke);
}

test('plots are those of unbalance.csv, at every station', () =>
  withReport('tilting.html', async (page) => {
    const stations = summaryOf('tilting').stations;
    assert.deepEqual(await chooser(page, 'Station').locator('option').allTextContents(), stations);
    assert.equal(stations[2], 'plane 1');
    for (const station of stations) {
      await chooser(page, 'Station').selectOption(station);
      const expected = csvOf('tilting').filter((row) => row.station === station);
      // A page may save ten files at once.
      for (const name of station === 'bearing 1' ? plots : plots.slice(0, 1)) {
        assert.match(await panelOf(page, name).locator('.subject').textContent(), new RegExp(`^${station}, at the rotation frequency`));
        const shown = await shownIn(page, name);
        assert.equal(shown.length, expected.length);
        for (const row of shown) {
          const same = expected.find((one) => one.kind === row.kind && Math.abs(rpmOf(one) - rpmOf(row)) < 0.1);
          for (const key of ['amplitude_x_m', 'phase_x_deg', 'amplitude_y_m', 'phase_y_deg']) near(Number(row[key]), Number(same[key]), 1e-6, key);
        }
      }
    }
  }));

test('lines are solid where contacts stick and dashed where they slide, and marks tell which orbits last', () =>
  withReport('orbits.html', async (page) => {
    const lasting = summaryOf('orbits').speeds.map((speed) => speed.orbit_lasts);
    const [stay, leave] = [true, false].map((which) => lasting.filter((one) => one === which).length);
    assert.ok(stay > 1 && leave > 0);
    for (const name of ['Bode plot: amplitude', 'Bode plot: phase']) {
      const plot = await plotsIn(panelOf(page, name));
      assert.equal(await plot.locator('path[stroke-dasharray]').count(), 2, name);
      const marks = await marksIn(plot);
      // Of X and of Y.
      assert.deepEqual([marks.filter((one) => one).length, marks.filter((one) => !one).length], [2 * stay, 2 * leave], name);
      const texts = await plot.locator('text').allTextContents();
      assert.ok(texts.includes('Speed (rpm)') && texts.includes(name.endsWith('phase') ? 'Phase (°)' : 'Amplitude (µm)'), texts.join());
      const legend = await panelOf(page, name).locator('.legend li').allTextContents();
      for (const axis of ['X', 'Y']) for (const kind of ['small orbits, full stick', 'small orbits, contacts sliding', 'periodic orbits with friction']) assert.ok(legend.includes(`${axis}, ${kind}`), legend.join());
      assert.ok(legend.includes('filled: the orbit lasts, hollow: it does not'));
    }
    const polar = await (await plotsIn(panelOf(page, 'Polar plot'))).locator('text').allTextContents();
    for (const text of ['0°', '90°', '180°', '−90°', 'Amplitude (µm)']) assert.ok(polar.includes(text), polar.join());
  }));

test('the polar plot is in true shape', () =>
  withReport('orbits.html', async (page) => {
    const panel = panelOf(page, 'Polar plot');
    const plot = await plotsIn(panel);
    // The circles of its guides, of many points, are as high as they are wide.
    const sizes = await plot.locator('path').evaluateAll((paths) => paths.filter((path) => path.getAttribute('d').split('L').length > 70).map((path) => path.getBBox()).map(({ width, height }) => [width, height]));
    assert.equal(sizes.length, 2);
    const [width, height] = sizes.sort((a, b) => b[0] - a[0])[0];
    assert.ok(width > 100);
    near(width, height, 1e-2, 'circle');
    // Cursors of stuck contacts lie at the amplitude and the phase of the speed: X, in parts of the circle that ends at 2 um.
    await chooser(page, 'Speed').selectOption('9000 rpm');
    const row = csvOf('orbits').find((one) => one.kind === 'linear_stuck' && Math.abs(rpmOf(one) - 9000) < 1);
    const cursor = await panel.locator('.cursor.point').first().boundingBox();
    const box = await plot.boundingBox();
    const x = (cursor.x + cursor.width / 2 - box.x - box.width / 2) / (width / 2);
    const y = -(cursor.y + cursor.height / 2 - box.y - box.height / 2) / (width / 2);
    const phase = (row.phase_x_deg * Math.PI) / 180;
    // A pixel is a hundredth of the circle.
    assert.ok(Math.abs(x - (row.amplitude_x_m / 2e-6) * Math.cos(phase)) < 0.02 && Math.abs(y - (row.amplitude_x_m / 2e-6) * Math.sin(phase)) < 0.02, `${x} ${y}`);
  }));

test('phases have no jumps by a turn', () =>
  withReport('orbits.html', async (page) => {
    const plot = await plotsIn(panelOf(page, 'Bode plot: phase'));
    const rows = csvOf('orbits').filter((row) => row.kind === 'linear_stuck').sort((a, b) => rpmOf(a) - rpmOf(b));
    const phases = rows.map((row) => Number(row.phase_y_deg));
    assert.ok(phases.some((phase, i) => i > 0 && Math.abs(phase - phases[i - 1]) > 180), 'they would not jump by themselves');
    const heights = await plot.locator('path[fill="none"]').evaluateAll((paths) => paths.map((path) => path.getAttribute('d').match(/[-.\d]+/g).map(Number).filter((_, i) => i % 2 === 1)));
    for (const ys of heights.filter((one) => one.length === rows.length)) {
      const steps = ys.slice(1).map((y, i) => Math.abs(y - ys[i]));
      assert.ok(Math.max(...steps) < 0.6 * (Math.max(...ys) - Math.min(...ys) + 1) + 40, ys.join());
    }
  }));

test('peaks, multipliers and films are those of summary.json', () =>
  withReport('orbits.html', async (page) => {
    const { peaks, speeds } = summaryOf('orbits');
    const kinds = { linear_sliding: 'Small orbits, contacts sliding', linear_stuck: 'Small orbits, full stick', orbit: 'Periodic orbits with friction' };
    const rows = await tableOf(page, 'Table of peaks');
    assert.ok(peaks.length >= 2);
    assert.equal(rows.length, peaks.length);
    rows.forEach(([kind, speed, size, station], i) => {
      assert.deepEqual([kind, station], [kinds[peaks[i].kind], 'bearing 1']);
      near(Number(speed.split(' ')[0]), rpmOf(peaks[i]), 1e-5, 'speed');
      near(quantity(size, 'm'), peaks[i].semi_major_m, 1e-3, 'orbit');
    });
    // It begins where small orbits are largest.
    const stuck = peaks.find(({ kind }) => kind === 'linear_stuck');
    const nearest = speeds.map(rpmOf).sort((a, b) => Math.abs(a - rpmOf(stuck)) - Math.abs(b - rpmOf(stuck)))[0];
    assert.equal(await chooser(page, 'Speed').inputValue(), `${Math.round(nearest)} rpm`);
    const multipliers = await shownIn(page, 'Floquet multipliers');
    for (const row of multipliers) {
      const same = speeds.find((one) => Math.abs(rpmOf(one) - rpmOf(row)) < 0.1);
      near(Number(row.largest_multiplier), same.largest_multiplier, 1e-6, 'multiplier');
      assert.equal(row.lasts, same.orbit_lasts ? 'lasts' : 'does not last');
      assert.equal(row.lasts === 'lasts', same.largest_multiplier <= 1);
    }
    assert.match(await panelOf(page, 'Floquet multipliers').locator('.subject').textContent(), new RegExp(`^${speeds.filter((speed) => speed.orbit_lasts).length} of 5 periodic orbits last`));
    const table = await tableOf(page, 'Table: Results by speed');
    const heads = await page.getByRole('group', { name: 'Table: Results by speed' }).locator('thead th').allTextContents();
    assert.deepEqual(heads.slice(0, 7), ['Speed', 'Minimum film thickness, equilibrium µm', 'Minimum film thickness, orbit µm', 'Friction loss, orbit nJ', 'Power, orbit W', 'Largest Floquet multiplier', 'Orbit']);
    speeds.forEach((speed, i) => {
      const own = speed.responses.find(({ kind }) => kind === 'orbit');
      near(quantity(`${table[i][1]} µm`, 'm'), speed.equilibrium_h_min_m, 1e-3, 'film');
      near(quantity(`${table[i][2]} µm`, 'm'), own.h_min_m, 1e-3, 'film');
      near(1e-9 * Number(table[i][3]), own.friction_loss_J, 1e-3, 'friction');
      near(Number(table[i][4]), own.power_W, 1e-3, 'power');
      assert.equal(table[i][6], speed.orbit_lasts ? 'lasts' : 'does not last');
    });
    // Over speed, in the order of the case.
    for (const [text, key] of [['Minimum film thickness', 'h_min_m'], ['Friction loss in a turn', 'friction_loss_J'], ['Power', 'power_W']]) {
      await page.getByRole('combobox', { name: 'Quantity: Film and losses' }).selectOption(text);
      const shown = await shownIn(page, 'Film and losses');
      speeds.forEach((speed, i) => near(Number(shown[i][`${key}_1`]), speed.responses.find(({ kind }) => kind === 'orbit')[key], 1e-6, key));
    }
  }));

test('orbits lie in the clearance where journals are, and enlarged they have their shape and sense', () =>
  withReport('orbits.html', async (page) => {
    const panel = panelOf(page, 'Orbits');
    const drawn = () =>
      panel.locator('svg.round').evaluate((root) =>
        [...root.querySelectorAll('path[fill="none"]')].map((path) => {
          const { x, y, width, height } = path.getBBox();
          const points = path.getAttribute('d').match(/[-.\d]+ [-.\d]+/g).map((pair) => pair.split(' ').map(Number));
          const [[x0, y0]] = points;
          const area = points.slice(1).reduce((sum, [px, py], i) => sum + (points[i][0] - x0) * (py - y0) - (px - x0) * (points[i][1] - y0), 0) / 2;
          return { x: x + width / 2, y: y + height / 2, width, height, area };
        }),
      );
    for (const speed of ['8000 rpm', '15000 rpm']) {
      await chooser(page, 'Speed').selectOption(speed);
      const row = csvOf('orbits').find((one) => one.kind === 'orbit' && Math.abs(rpmOf(one) - speed.split(' ')[0]) < 1);
      const told = await panel.locator('.subject').textContent();
      assert.ok(told.startsWith(`${speed}, clearance 31.80 µm, the periodic orbit ${speed === '8000 rpm' ? 'lasts' : 'does not last'}`), told);
      const circle = await panel.locator('svg.round circle[fill="none"]').evaluate((one) => ['cx', 'cy', 'r'].map((name) => Number(one.getAttribute(name))));
      const scale = circle[2] / 31.8e-6;
      const small = await drawn();
      assert.equal(small.length, 3);
      // Half of the way from end to end, of two harmonics, and a sixteenth of the turn that is left open: 3 %.
      near(small[2].x - circle[0], row.mean_x_m * scale, 0.02, 'x');
      near(circle[1] - small[2].y, row.mean_y_m * scale, 0.02, 'y');
      near(small[2].width, 2 * row.half_peak_to_peak_x_m * scale, 0.05, 'width');
      await panel.getByRole('button', { name: 'Enlarged' }).click();
      const large = await drawn();
      const size = await panel.locator('svg.round circle[fill="none"]').evaluate((one) => Number(one.getAttribute('r')));
      const label = quantity(await panel.locator('svg.round text').last().textContent(), 'm');
      near(large[2].width, (2 * row.half_peak_to_peak_x_m * size) / label, 0.03, 'width');
      near(large[2].height, (2 * row.half_peak_to_peak_y_m * size) / label, 0.03, 'height');
      // Forward, X to Y, is counterclockwise: negative where y points down.
      assert.equal(large[2].area < 0, Number(row.semi_minor_m) > 0);
      assert.doesNotMatch(await panel.locator('svg.round').innerHTML(), /NaN|undefined/);
      await panel.getByRole('button', { name: 'In the clearance' }).click();
    }
    const shown = await shownIn(page, 'Orbits');
    assert.equal(shown.length, 3 * 121);
  }));

test('a click on a point selects its speed', () =>
  withReport('tilting.html', async (page) => {
    const panel = panelOf(page, 'Bode plot: amplitude');
    await chooser(page, 'Speed').selectOption('8000 rpm');
    await plotsIn(panel);
    const there = await placeOf(panel.locator('.cursor.point').first());
    await chooser(page, 'Speed').selectOption('18000 rpm');
    await panel.locator('.chart').click({ position: there });
    assert.equal(await chooser(page, 'Speed').inputValue(), '8000 rpm');
    for (const name of [...plots, 'Orbits']) {
      const words = (await saved(page, name, /SVG/)).bytes.toString().replace(/<[^>]*>/g, ' ');
      assert.ok(words.includes(name) && words.includes('tilting'), name);
      assert.doesNotMatch(words, /NaN|undefined/);
    }
    // Both bearings in their clearance; all stations enlarged, along the axis.
    assert.equal(await panelOf(page, 'Orbits').locator('svg.round circle[fill="none"]').count(), 2);
    await panelOf(page, 'Orbits').getByRole('button', { name: 'Enlarged' }).click();
    const texts = await panelOf(page, 'Orbits').locator('svg.round text').allTextContents();
    assert.deepEqual(texts.filter((text) => text.includes('z = ')).map((text) => text.split(',')[0]), ['bearing 1', 'plane 2', 'plane 1', 'bearing 2']);
  }));

test('a rotor may turn from Y to X, and a single speed has its plots', async () => {
  await withReport('back.html', async (page) => {
    assert.deepEqual(await chooser(page, 'Speed').locator('option').allTextContents(), ['−9000 rpm', '−12000 rpm']);
    const texts = await (await plotsIn(panelOf(page, 'Bode plot: amplitude'))).locator('text').allTextContents();
    assert.ok(texts.includes('Speed, from Y to X (rpm)'), texts.join());
    assert.match(await page.locator('main').innerText(), /The orbits have no peak between these speeds/);
  });
  await withReport('one.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), '</script><b>x</b>');
    for (const name of plots) assert.ok((await (await plotsIn(panelOf(page, name))).locator('path').count()) > 3, name);
    assert.equal(await page.getByRole('region', { name: 'Floquet multipliers' }).count(), 0);
    assert.equal((await tableOf(page, 'Table: Results by speed')).length, 1);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  });
});

test('speeds without an equilibrium are told', () =>
  withReport('failed.html', async (page) => {
    assert.match(await page.locator('.warnings').textContent(), /The run failed; its results are partial/);
    const { speeds } = summaryOf('failed');
    const rows = await tableOf(page, 'Table: Results by speed');
    rows.forEach((row, i) => assert.ok(row.includes(speeds[i].status.replaceAll('_', ' ')), row.join()));
    await chooser(page, 'Speed').selectOption('50 rpm');
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), /^no equilibrium found: touchdown/);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('a report does not replace the file of the responses', () => {
  const before = readFileSync(join(folder, 'one', 'unbalance.csv'), 'utf8');
  assert.match(run(['report', join(folder, 'one'), '-o', join(folder, 'one', 'unbalance.csv'), '--force'], 4), /is one of the results that this report reads/);
  assert.equal(readFileSync(join(folder, 'one', 'unbalance.csv'), 'utf8'), before);
});

test('a sweep shows the largest amplitude over its key, and amplitudes over key and speed', () =>
  withReport('masses.html', async (page) => {
    const { points } = summaryOf('masses');
    const shown = await shownIn(page, 'Result vs. parameter');
    assert.deepEqual(shown.map((row) => row.rotor_mass_kg), ['1', '2']);
    points.forEach((point, i) => near(Number(shown[i].largest_amplitude_m), point.largest_amplitude_m, 1e-6, 'amplitude'));
    await unfold(page, 'Points');
    const heads = await page.getByRole('group', { name: 'Table: Results by point', exact: true }).locator('thead th').allTextContents();
    assert.deepEqual(heads.slice(0, 4), ['Rotor: Mass', 'Largest amplitude µm', 'Speed of the largest amplitude rpm', 'Amplitude / film']);
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Speed');
    await page.getByRole('combobox', { name: 'Quantity: Result vs. parameter' }).selectOption('Amplitude of the journals');
    assert.equal((await shownIn(page, 'Result vs. parameter')).length, 2 * 37);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('an ensemble shows how amplitudes scatter', () =>
  withReport('tolerances.html', async (page) => {
    const text = await page.locator('main').innerText();
    assert.match(text, /Largest amplitude/);
    assert.match(text, /largest_amplitude < 5 um\t4\t4\t/);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('words are words, links lead somewhere, and no row of panels is left half empty', async () => {
  for (const name of ['orbits', 'tilting']) {
    await withReport(`${name}.html`, async (page) => {
      await assertReads(page, /\bh min\b|krad|speed status|amplitude x|2x\b|linear_/gi);
    });
  }
});

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('tilting.html', assertFits);
  await withReport('orbits.html', async (page) => {
    await assertAccessible(page);
    await assertPanelsFitPaper(page);
  });
});
