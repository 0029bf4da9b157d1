// Reports of rotors in a browser: the Campbell diagram, growth and root locus are those of stability.csv, onsets and speeds
// those of summary.json, and what was not found is told.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, assertPanelsFitPaper, assertReads, folder, near, placeOf, plotsIn, quantity, report, rotorFile, rowsOf, run, saved, summaryOf, unfold, withReport } from './support.mjs';

const mesh = ['film.columns_per_pitch=4', 'film.rows=4'];

function stability(name, pairs, exitCode = 0) {
  return run(['stability', rotorFile, '-o', join(folder, name), ...[...mesh, ...pairs].flatMap((pair) => ['--set', pair])], exitCode);
}

before(() => {
  const tilting = ['rotor.bearings=["-60 mm", "60 mm"]', 'rotor.transverse_inertia=4e-3 kg m2', 'rotor.polar_inertia=5e-4 kg m2'];
  stability('rotor', ['stability.speeds=["24000 rpm", "18000 rpm", "15000 rpm", "12000 rpm", "9000 rpm"]', ...tilting]);
  stability('back', ['stability.speeds=["-12000 rpm", "-13000 rpm", "-14000 rpm"]', 'bearing.wrap=clockwise']);
  stability('one', ['stability.speeds=["12000 rpm"]', 'title=</script><b>x</b>']);
  stability('failed', ['stability.speeds=["12000 rpm", "50 rpm"]'], 3);
  stability('nothing', ['stability.speeds=["12000 rpm", "13000 rpm"]', 'rotor.mass="2000 kg"'], 3);
  run(['sweep', rotorFile, '--command', 'stability', '--over', 'rotor.mass=[1 kg, 2 kg]', '-o', join(folder, 'masses'), ...mesh.flatMap((pair) => ['--set', pair])]);
  for (const name of ['rotor', 'back', 'one', 'failed', 'nothing', 'masses']) report(`${name}.html`, name);
});

const csvOf = (name) => rowsOf(readFileSync(join(folder, name, 'stability.csv'), 'utf8'));
const panelOf = (page, name) => page.getByRole('region', { name, exact: true });
const shownIn = async (page, name) => rowsOf((await saved(page, name, /CSV/)).bytes.toString());
const chooser = (page, name) => page.getByRole('combobox', { name: `${name} shown` });
const wordsOf = (kind) => (kind === 'stuck' ? 'full stick' : 'contacts sliding');
const contacts = (page, kind) => page.getByRole('group', { name: 'Contacts shown' }).getByRole('button', { name: new RegExp(wordsOf(kind), 'i') });
const tableOf = (page, name) => page.getByRole('group', { name, exact: true }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));

test('motions are those of stability.csv, with contacts sliding and stuck', () =>
  withReport('rotor.html', async (page) => {
    assert.equal(await contacts(page, 'sliding').getAttribute('aria-pressed'), 'true');
    assert.equal(await chooser(page, 'Speed').inputValue(), '24000 rpm');
    const { speeds } = summaryOf('rotor');
    for (const kind of ['sliding', 'stuck']) {
      await contacts(page, kind).click();
      const own = csvOf('rotor').filter((row) => row.contacts === kind);
      const lasting = new Set(own.filter((row) => Number(row.imag_rad_per_s) > 0 || Number(row.real_rad_per_s) > 0).map((row) => row.mode));
      const expected = own.filter((row) => lasting.has(row.mode));
      assert.ok(expected.length > 10);
      for (const panel of ['Campbell diagram', 'Growth over speed', 'Root locus']) {
        assert.match(await panelOf(page, panel).locator('.subject').textContent(), new RegExp(`^${wordsOf(kind)}`));
        const shown = await shownIn(page, panel);
        assert.equal(shown.length, expected.length);
        for (const row of shown) {
          assert.equal(row.contacts, kind);
          const same = expected.find((one) => one.mode === row.mode && Math.abs(one.speed_rad_per_s - row.speed_rad_per_s) < 1e-2);
          for (const key of ['real_rad_per_s', 'imag_rad_per_s']) near(Number(row[key]), Number(same[key]), 1e-6, `${key} of ${row.mode}`);
          near(Number(row.growth), same.real_rad_per_s / same.speed_rad_per_s, 1e-6, 'growth');
          const speed = speeds.find((one) => Math.abs(one.speed_rad_per_s - row.speed_rad_per_s) < 1e-2);
          near(Number(row.growth_by_coefficients), speed[`growth_by_coefficients${kind === 'stuck' ? '_stuck' : ''}`], 1e-6, 'growth by coefficients');
        }
        // The slowest first, whatever the order of the case.
        const drawn = shown.filter((row) => row.mode === shown[0].mode).map((row) => Number(row.speed_rad_per_s));
        assert.deepEqual(drawn, [...drawn].sort((a, b) => a - b));
      }
    }
  }));

test('marks are filled where a motion grows, and lines are at once and half the speed', () =>
  withReport('rotor.html', async (page) => {
    const growing = csvOf('rotor').filter((row) => row.contacts === 'sliding' && Number(row.real_rad_per_s) > 0).length;
    assert.ok(growing > 0);
    for (const panel of ['Campbell diagram', 'Growth over speed', 'Root locus']) {
      const plot = await plotsIn(panelOf(page, panel));
      // Marks have an outline in the colour of their fill, or in that of the line around the background.
      const marks = await plot.locator('path').evaluateAll((all) => all.map((one) => [one.getAttribute('fill'), one.getAttribute('stroke'), one.getAttribute('stroke-width')]).filter(([fill, stroke, width]) => stroke && fill !== 'none' && fill !== 'transparent' && width));
      const filled = marks.filter(([fill, stroke]) => fill === stroke).length;
      assert.equal(filled, growing, panel);
      assert.equal(marks.length, (await shownIn(page, panel)).length, panel);
    }
    const texts = await (await plotsIn(panelOf(page, 'Campbell diagram'))).locator('text').allTextContents();
    assert.ok(texts.includes('1×') && texts.includes('1/2×'), texts.join());
    assert.ok(texts.includes('Speed (rpm)') && texts.includes('Damped frequency (Hz)'));
    const legend = await panelOf(page, 'Growth over speed').locator('.legend li').allTextContents();
    const dotted = (await plotsIn(panelOf(page, 'Growth over speed'))).locator('path[stroke-dasharray]');
    assert.equal(await dotted.count(), 1);
    for (const entry of ['mode 1', 'filled: grows, hollow: decays', 'by synchronous coefficients', 'onset or end of whirl']) assert.ok(legend.includes(entry), legend.join());
  }));

test('onsets are said as the terminal says them', () =>
  withReport('rotor.html', async (page) => {
    const { onsets } = summaryOf('rotor');
    assert.ok(onsets.some((onset) => onset.contacts === 'stuck'));
    const rows = await tableOf(page, 'Table of onsets');
    assert.deepEqual(rows.map(([name]) => name), ['Onset of whirl, contacts sliding', 'Onset of whirl, full stick', 'By synchronous coefficients, contacts sliding', 'By synchronous coefficients, full stick']);
    rows.forEach(([, text], i) => {
      const own = onsets.filter((onset) => onset.contacts === ['sliding', 'stuck'][i % 2] && onset.by_coefficients === i > 1);
      const words = own.map((onset) => `whirl ${onset.begins ? 'begins' : 'ends'} at ${Number(((onset.speed_rad_per_s * 30) / Math.PI).toPrecision(6))} rpm, whirl ratio ${onset.whirl_ratio.toFixed(4)}${onset.jumps ? ' (contacts change there)' : ''}`);
      assert.equal(text, words.length > 0 ? words.join('') : 'none between these speeds');
    });
    assert.equal((await shownIn(page, 'Onsets of whirl')).length, onsets.length);
  }));

test('the table of the speeds is that of summary.json', () =>
  withReport('rotor.html', async (page) => {
    const rows = await tableOf(page, 'Table: Results by speed');
    const heads = await page.getByRole('group', { name: 'Table: Results by speed' }).locator('thead th').allTextContents();
    assert.deepEqual(heads, ['Speed', 'Minimum film thickness µm', 'Growth', 'Whirl ratio', 'Log. decrement', 'Whirl', 'Motion of', 'Growth, stuck', 'Growth by synchronous K, C', 'Stable']);
    const { speeds } = summaryOf('rotor');
    assert.equal(rows.length, speeds.length);
    speeds.forEach((speed, i) => {
      const [rpm, film, growth, ratio, decrement, sense, of, stuck, synchronous, stable] = rows[i];
      assert.equal(rpm, `${Math.round((speed.speed_rad_per_s * 30) / Math.PI)} rpm`);
      near(quantity(`${film} µm`, 'm'), speed.h_min_m, 1e-3, 'film');
      for (const [text, key] of [[growth, 'growth'], [ratio, 'whirl_ratio'], [decrement, 'least_log_decrement'], [stuck, 'growth_stuck'], [synchronous, 'growth_by_coefficients']]) near(quantity(text, ''), speed[key], 1e-3, key);
      const sliding = speed.motions.filter((motion) => motion.contacts === 'sliding');
      const fastest = sliding.find((motion) => motion.real_rad_per_s === Math.max(...sliding.map((one) => one.real_rad_per_s)));
      assert.deepEqual([sense, of, stable], [fastest.direction, fastest.of_foils ? 'foils' : 'rotor', speed.stable ? 'yes' : 'no']);
    });
  }));

test('orbits of the mode shape have the amplitudes and the sense of the motion', () =>
  withReport('rotor.html', async (page) => {
    const panel = panelOf(page, 'Mode shape');
    let before = '';
    for (const [motion, speed] of [['mode 1', '12000 rpm'], ['mode 2', '24000 rpm'], ['mode 1', '9000 rpm'], ['mode 3', '15000 rpm']]) {
      await chooser(page, 'Speed').selectOption(speed);
      await chooser(page, 'Motion').selectOption(motion);
      const row = csvOf('rotor').find((one) => one.contacts === 'sliding' && `mode ${one.mode}` === motion && Math.abs((one.speed_rad_per_s * 30) / Math.PI - speed.split(' ')[0]) < 1);
      const told = await panel.locator('.subject').textContent();
      near(Number(told.match(/^(\S+) Hz/)[1]), row.imag_rad_per_s / (2 * Math.PI), 1e-3, 'frequency');
      assert.ok(told.includes(`${row.direction} whirl`) && told.includes(speed), told);
      const stations = await shownIn(page, 'Mode shape');
      assert.deepEqual(stations.map(({ station, z_m: z }) => `${station} ${Number(z).toFixed(2)}`), ['bearing 1 -0.06', 'station 3 0.00', 'bearing 2 0.06']);
      const amplitudes = stations.flatMap((one) => [Number(one.shape_amplitude_x), Number(one.shape_amplitude_y)]);
      near(Math.max(...amplitudes), 1, 1e-6, 'largest');
      // Of the larger orbit, the extent of what is drawn over that of the axes.
      const drawn = await panel.locator('svg.round').evaluate((root) =>
        [...root.querySelectorAll('path[fill="none"]')].map((path) => {
          const { width, height } = path.getBBox();
          const points = path.getAttribute('d').match(/[-.\d]+ [-.\d]+/g).map((pair) => pair.split(' ').map(Number));
          const [[x0, y0]] = points;
          const area = points.slice(1).reduce((sum, [x, y], i) => sum + (points[i][0] - x0) * (y - y0) - (x - x0) * (points[i][1] - y0), 0) / 2;
          return { width, height, area };
        }),
      );
      assert.equal(drawn.length, 3);
      stations.forEach((one, i) => {
        // A twelfth of the turn is left open, which shortens the extent by 1 - cos(pi / 12) = 3 % of half of it at most.
        near(drawn[i].width, 2 * 0.36 * 220 * one.shape_amplitude_x, 0.02, 'extent along X');
        near(drawn[i].height, 2 * 0.36 * 220 * one.shape_amplitude_y, 0.02, 'extent along Y');
        // Counterclockwise, X to Y, is negative where y points down; the open part takes less than a hundredth.
        const turn = Math.sin(((one.shape_phase_x_deg - one.shape_phase_y_deg) * Math.PI) / 180);
        near(drawn[i].area, -Math.PI * (0.36 * 220) ** 2 * one.shape_amplitude_x * one.shape_amplitude_y * turn, 0.02, 'area');
        if (one.station.startsWith('bearing')) assert.equal(turn > 0, row.direction === 'forward');
      });
      const drawing = await panel.locator('svg.round').innerHTML();
      assert.notEqual(drawing, before);
      assert.doesNotMatch(drawing, /NaN|undefined/);
      before = drawing;
    }
  }));

test('a click on a mark selects speed and motion', () =>
  withReport('rotor.html', async (page) => {
    const panel = panelOf(page, 'Campbell diagram');
    await chooser(page, 'Speed').selectOption('12000 rpm');
    await chooser(page, 'Motion').selectOption('mode 1');
    await plotsIn(panel);
    const there = await placeOf(panel.locator('.cursor.point'));
    await chooser(page, 'Speed').selectOption('24000 rpm');
    await chooser(page, 'Motion').selectOption('mode 2');
    await panel.locator('.chart').click({ position: there });
    assert.equal(await chooser(page, 'Speed').inputValue(), '12000 rpm');
    assert.equal(await chooser(page, 'Motion').inputValue(), 'mode 1');
    for (const name of ['Campbell diagram', 'Growth over speed', 'Root locus', 'Mode shape']) {
      const words = (await saved(page, name, /SVG/)).bytes.toString().replace(/<[^>]*>/g, ' ');
      for (const text of [name, 'contacts sliding', 'rotor']) assert.ok(words.includes(text), `${name} does not say ${text}`);
      assert.doesNotMatch(words, /NaN|undefined/);
    }
  }));

test('a rotor may turn from Y to X', () =>
  withReport('back.html', async (page) => {
    assert.deepEqual(await chooser(page, 'Speed').locator('option').allTextContents(), ['−12000 rpm', '−13000 rpm', '−14000 rpm']);
    const texts = await (await plotsIn(panelOf(page, 'Growth over speed'))).locator('text').allTextContents();
    assert.ok(texts.includes('Speed, from Y to X (rpm)'), texts.join());
    const rows = (await shownIn(page, 'Growth over speed')).filter((row) => row.mode === '1');
    const { speeds } = summaryOf('back');
    assert.equal(rows.length, 3);
    rows.forEach((row, i) => near(Number(row.speed_rad_per_s), speeds[i].speed_rad_per_s, 1e-6, 'speed'));
    // It grows where the files say so.
    assert.deepEqual(speeds.map(({ growth }) => growth > 0), (await tableOf(page, 'Table: Results by speed')).map(([, , growth]) => !growth.startsWith('−')));
    const onsets = (await tableOf(page, 'Table of onsets'))[0][1];
    const [found] = summaryOf('back').onsets;
    assert.ok(onsets.includes(`at −${Number((-(found.speed_rad_per_s * 30) / Math.PI).toPrecision(6))} rpm`), onsets);
  }));

test('a single speed has its diagrams, and titles are no markup', () =>
  withReport('one.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), '</script><b>x</b>');
    for (const panel of ['Campbell diagram', 'Growth over speed', 'Root locus']) {
      const plot = await plotsIn(panelOf(page, panel));
      assert.ok((await plot.locator('path').count()) > 5);
    }
    assert.equal((await tableOf(page, 'Table: Results by speed')).length, 1);
    assert.deepEqual((await tableOf(page, 'Table of onsets')).map(([, text]) => text), Array(4).fill('none between these speeds'));
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('speeds without an equilibrium are told', async () => {
  for (const name of ['failed', 'nothing']) {
    await withReport(`${name}.html`, async (page) => {
      const told = await page.locator('.warnings').textContent();
      assert.match(told, /The run failed; its results are partial/);
      await page.getByRole('region', { name: 'Results by speed' }).getByRole('button', { name: 'All' }).click();
      const { speeds } = summaryOf(name);
      const rows = await tableOf(page, 'Table: Results by speed');
      assert.equal(rows.length, 2);
      rows.forEach((row, i) => assert.ok(row.includes(speeds[i].status.replaceAll('_', ' ')), row.join()));
      assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
      if (name === 'nothing') return;
      await chooser(page, 'Speed').selectOption('50 rpm');
      assert.match(await panelOf(page, 'Mode shape').locator('.subject').textContent(), /^no equilibrium found: touchdown/);
    });
  }
});

test('a report does not replace the file of the motions', () => {
  const before = readFileSync(join(folder, 'one', 'stability.csv'), 'utf8');
  assert.match(run(['report', join(folder, 'one'), '-o', join(folder, 'one', 'stability.csv'), '--force'], 4), /is one of the results that this report reads/);
  assert.equal(readFileSync(join(folder, 'one', 'stability.csv'), 'utf8'), before);
});

test('a sweep shows onsets over its key, and growth over key and speed', () =>
  withReport('masses.html', async (page) => {
    const panel = panelOf(page, 'Result vs. parameter');
    const { points } = summaryOf('masses');
    const shown = await shownIn(page, 'Result vs. parameter');
    assert.deepEqual(shown.map((row) => row.rotor_mass_kg), ['1', '2']);
    await unfold(page, 'Points');
    const rows = await tableOf(page, 'Table: Results by point');
    const heads = await page.getByRole('group', { name: 'Table: Results by point', exact: true }).locator('thead th').allTextContents();
    assert.equal(heads[1], 'Onset of whirl rpm');
    const onsets = rows.map((row) => Number(row[1]));
    shown.forEach((row, i) => near(onsets[i], (row.onset_speed_rad_per_s * 30) / Math.PI, 1e-3, 'onset'));
    points.forEach((point, i) => near(Number(shown[i].onset_speed_rad_per_s), point.onset_speed_rad_per_s, 1e-6, 'onset'));
    assert.ok((await (await plotsIn(panel)).locator('text').allTextContents()).includes('Onset of whirl (rpm)'));
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Speed');
    await page.getByRole('combobox', { name: 'Quantity: Result vs. parameter' }).selectOption('Growth');
    assert.equal((await shownIn(page, 'Result vs. parameter')).length, 26);
    assert.deepEqual(await panel.locator('.legend li').allTextContents(), ['Mass 1 kg', 'Mass 2 kg']);
    assert.equal((await tableOf(page, 'Table: Results by point and speed')).length, 26);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('words are words, links lead somewhere, and no row of panels is left half empty', async () => {
  for (const name of ['rotor', 'masses']) {
    await withReport(`${name}.html`, async (page) => {
      await assertReads(page, /\bh min\b|krad|speed status/gi);
    });
  }
});

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('rotor.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
    await assertPanelsFitPaper(page);
  });
});
