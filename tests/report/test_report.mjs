// Reports in a real browser: the numbers shown are those of the results, what can be moved moves, nothing is fetched.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { assertFits, assertLoopsInSight, caseFile, cycle, folder, laptop, moveTo, near, program, placeOf, quantity, report, rowsOf, run, saved, state, stripFile, summaryOf, withReport } from './support.mjs';

const hostileTitle = '</script><img src="x" onerror="alert(1)"> {a|b} \u2028 & <b>bold</b>';
const steps = 100;
const directions = [0, 180, 90, 270];

before(() => {
  cycle('truss', `title=${JSON.stringify(hostileTitle)}`, `cycle.steps=${steps}`);
  cycle('frame', 'bump_foil.model=frame', 'cycle.steps=20', 'cycle.directions=["+X", "37.5 deg"]');
  report('one.html', 'truss');
  report('two.html', 'truss', 'frame');
});

test('a hostile title is text, and the file is small', () =>
  withReport('one.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), hostileTitle);
    assert.equal(await page.locator('img, h1 *').count(), 0);
    assert.ok((await page.title()).startsWith('</script><img'));
    assert.ok(statSync(join(folder, 'one.html')).size < 3e6);
  }));

test('the table shows the numbers of summary.json', () =>
  withReport('one.html', async (page) => {
    const { cycles } = summaryOf('truss');
    const units = { _N_per_m: 'N/m', _N: 'N', _J: 'J', _Pa: 'Pa', _m: 'm', _s: 's' };
    const rows = await page.locator('.results tr[data-key]').evaluateAll((all) =>
      all.map((row) => [row.dataset.key, ...[...row.querySelectorAll('td')].map((cell) => cell.firstChild?.data ?? '')]),
    );
    assert.ok(rows.length > 15);
    let compared = 0;
    for (const [key, unit, ...cells] of rows) {
      assert.equal(cells.length, cycles.length);
      cells.forEach((cell, k) => {
        const expected = cycles[k][key];
        if (typeof expected !== 'number' || cell.includes('10')) return;
        const end = Object.keys(units).find((one) => key.endsWith(one));
        // Four significant digits, three of the time taken.
        near(quantity(`${cell} ${unit}`.trim(), end ? units[end] : ''), expected, 6e-3, key);
        compared += 1;
      });
      // Units only where there are values.
      if (cells.every((cell) => cell === '–')) assert.equal(unit, '', key);
    }
    assert.ok(rows.some(([, unit, ...cells]) => unit === '' && cells.every((cell) => cell === '–')));
    assert.ok(compared > 60, `${compared} compared`);
    assert.deepEqual(await page.locator('[data-key=converged] td').allTextContents(), ['', 'yes', 'yes', 'yes', 'yes']);
  }));

test('every chart is drawn', () =>
  withReport('one.html', async (page) => {
    const charts = page.locator('.chart');
    const perDirection = 3 * directions.length;
    assert.equal(await charts.count(), 2 + perDirection);
    for (let i = 0; i < 2 + perDirection; i += 1) {
      assert.ok((await charts.nth(i).locator('svg path').count()) > 5, await charts.nth(i).getAttribute('aria-label'));
    }
    for (const drawing of ['.round', '.unwrapped']) assert.ok((await page.locator(`${drawing} path`).count()) > 5);
    const label = await page.locator('#cycle-loops .chart').getAttribute('aria-label');
    for (const [i, name] of ['+X', '−X', '+Y', '−Y'].entries()) {
      const shown = label.split(`${name} `)[1].split(/[,]/)[0];
      near(quantity(shown, 'N'), summaryOf('truss').cycles[i].max_force_N, 1e-3, name);
    }
  }));

test('the case of a dry bearing has no gas', () =>
  withReport('one.html', async (page) => {
    const groups = await page.locator('table.case th.group').allTextContents();
    assert.ok(groups.includes('Bump foil'));
    assert.deepEqual(groups.filter((name) => name === 'Gas' || name === 'Film'), []);
  }));

test('beside the bearing the loops end where it does', () =>
  withReport('one.html', async (page) => {
    const bottoms = await page.locator('.beside').evaluate((both) => [...both.querySelectorAll('.panel')].map((panel) => panel.getBoundingClientRect().bottom));
    assert.ok(Math.max(...bottoms) - Math.min(...bottoms) < 40, bottoms.join());
  }, { viewport: { width: 1920, height: 1080 } }));

test('the slider and its keys move the bearing', () =>
  withReport('one.html', async (page) => {
    const rows = rowsOf(readFileSync(join(folder, 'truss', 'cycle.csv'), 'utf8'));
    const slider = page.locator('.player input');
    const start = await state(page);
    assert.equal(start.index, steps);
    await slider.focus();
    await page.keyboard.press('Home');
    const first = await state(page);
    assert.equal(first.index, 0);
    assert.notEqual(first.drawing, start.drawing);
    assert.notEqual(first.round, start.round);
    await moveTo(page, 130);
    await page.keyboard.press('ArrowRight');
    const { index, readout } = await state(page);
    assert.equal(index, 131);
    const [displacement, force, branch] = readout.split(' · ');
    const row = rows.find((one) => Number(one.direction_deg) === 0 && Number(one.increment) === 131);
    near(quantity(displacement, 'm'), Number(row.displacement_m), 1e-3, 'displacement');
    near(quantity(force, 'N'), Number(row.force_direct_N), 1e-3, 'force');
    assert.equal(branch, `unloading 131 / ${2 * steps}`);
    await page.locator('.player select').selectOption('+Y');
    assert.notEqual((await state(page)).drawing, first.drawing);
    assert.equal((await state(page)).index, 131);
  }));

test('play runs along the cycle until it is stopped', () =>
  withReport('one.html', async (page) => {
    await moveTo(page, 10);
    const before = await state(page);
    await page.getByRole('button', { name: 'Play the cycle' }).click();
    await page.waitForFunction(() => Number(document.querySelector('.player input').value) > 12);
    await page.getByRole('button', { name: 'Pause' }).click();
    const stopped = await state(page);
    assert.notEqual(stopped.drawing, before.drawing);
    await sleep(100);
    assert.equal((await state(page)).index, stopped.index);
    // From the end it starts anew, and stops there by itself.
    await moveTo(page, 2 * steps - 2);
    await page.getByRole('button', { name: 'Play the cycle' }).click();
    await page.getByRole('button', { name: 'Play the cycle' }).waitFor();
    assert.equal((await state(page)).index, 2 * steps);
  }));

test('a click on the loop moves the bearing there, and the mark on the loop follows the bearing', () =>
  withReport('one.html', async (page) => {
    const mark = page.locator('#cycle-loops .cursor.point');
    await moveTo(page, 75);
    const wanted = await state(page);
    const there = await placeOf(mark);
    await moveTo(page, 180);
    const elsewhere = await placeOf(mark);
    assert.ok(Math.hypot(there.x - elsewhere.x, there.y - elsewhere.y) > 50);
    await page.locator('#cycle-loops .chart', { has: page.locator('.cursor.point') }).click({ position: there });
    const reached = await state(page);
    assert.deepEqual(reached, wanted);
    assert.deepEqual(await placeOf(mark), there);
    // Values with units stand beside the pointer.
    const tip = await page.locator('#cycle-loops .tip').textContent();
    const cycle = rowsOf(readFileSync(join(folder, 'truss', 'cycle.csv'), 'utf8')).find(
      (one) => Number(one.direction_deg) === 0 && Number(one.increment) === 75,
    );
    assert.match(tip, /75, loading/);
    near(quantity(tip.split('Direct force')[1].split('Cross')[0], 'N'), Number(cycle.force_direct_N), 1e-3, tip);
  }));

test('data and drawings can be saved', () =>
  withReport('one.html', async (page) => {
    const loops = await saved(page, 'Loops', /CSV/);
    assert.equal(loops.name, 'loops-force_direct-truss-+X-_X-+Y-_Y.csv'.replaceAll('_X', '-X').replaceAll('_Y', '-Y'));
    const shown = rowsOf(loops.bytes.toString());
    const expected = rowsOf(readFileSync(join(folder, 'truss', 'cycle.csv'), 'utf8'));
    assert.equal(shown.length, expected.length);
    shown.forEach((row, i) => {
      for (const name of ['direction_deg', 'increment', 'displacement_m', 'force_direct_N', 'force_cross_N']) {
        // Seven digits; what rounding left of zero counts against a newton and a micrometre.
        const floor = name.endsWith('_N') ? 1e-6 : 1e-12;
        assert.ok(Math.abs(row[name] - expected[i][name]) <= 6e-7 * Math.abs(expected[i][name]) + floor, `${name} of row ${i}`);
      }
      assert.equal(row.branch, expected[i].branch);
    });
    const results = rowsOf((await saved(page, 'Results by direction', /CSV/)).bytes.toString());
    near(Number(results.find((row) => row.quantity === 'loop_energy_J')['+Y']), summaryOf('truss').cycles[2].loop_energy_J, 1e-6, 'loop energy');
    const drawings = ['Loops', 'The foils, unwrapped', 'The bearing', 'Contact states along the path'];
    for (const name of drawings) {
      const drawing = (await saved(page, name, /SVG/)).bytes.toString();
      assert.match(drawing, /^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
      assert.doesNotMatch(drawing, /NaN|undefined/);
    }
    // The browser takes seconds until it thinks itself idle enough to write a picture: all of them meanwhile.
    const downloads = [];
    const keep = (one) => downloads.push(one);
    page.on('download', keep);
    for (const name of drawings) await page.getByRole('region', { name, exact: true }).getByRole('button', { name: /PNG/ }).click();
    while (downloads.length < drawings.length) await page.waitForEvent('download');
    page.off('download', keep);  // the page is that of all tests
    for (const one of downloads) {
      const picture = readFileSync(await one.path());
      assert.deepEqual([...picture.subarray(1, 4)], [...Buffer.from('PNG')]);
      assert.ok(picture.length > 5000, one.suggestedFilename());
    }
    assert.equal(new Set(downloads.map((one) => one.suggestedFilename())).size, drawings.length);
  }));

test('loads and states are those of the results', () =>
  withReport('one.html', async (page) => {
    const rows = rowsOf((await saved(page, 'Bump loads, +Y', /CSV/)).bytes.toString());
    const expected = summaryOf('truss').cycles[2].bump_loads_N;
    assert.equal(rows.length, expected.length);
    rows.forEach((row, i) => assert.ok(Math.abs(row.normal_force_N - expected[i]) <= 1e-6 * Math.abs(expected[i]) + 1e-6));
    const states = rowsOf((await saved(page, 'Contact states along the path', /CSV/)).bytes.toString());
    assert.equal(states.length, 3 * 26 * (2 * steps + 1));
    const closed = states.filter((row) => row.increment === String(steps) && row.interface === 'top_bump' && row.state !== 'open');
    assert.equal(closed.length, summaryOf('truss').cycles[0].bump_loads_N.filter((load) => load > 0).length);
  }));

test('runs are compared in the same charts', () =>
  withReport('two.html', async (page) => {
    const loops = page.getByRole('region', { name: 'Loops, +X' });
    for (const name of ['truss', 'frame']) assert.equal(await loops.locator('.plot text', { hasText: name }).count(), 1);
    assert.match(await page.locator('.case .differs').allTextContents().then(String), /Model.*truss.*frame/);
    const truss = await state(page);
    await page.getByRole('combobox', { name: 'Run', exact: true }).selectOption('frame');
    const frame = await state(page);
    assert.equal(frame.index, 20);
    assert.notEqual(frame.drawing, truss.drawing);
    near(quantity(frame.readout.split(' · ')[1], 'N'), summaryOf('frame').cycles[0].max_force_N, 1e-3, 'frame');
  }));

test('a strip is shown by its cycles, beside a bearing', async () => {
  run(['strip', stripFile, '-o', join(folder, 'strip')]);
  report('strip.html', 'strip', 'truss');
  await withReport('strip.html', async (page) => {
    const { cycles } = summaryOf('strip');
    const table = page.getByRole('region', { name: 'Results by cycle' });
    const [unit, ...cells] = await table.locator('[data-key=max_force_N] td').allTextContents();
    cells.forEach((cell, i) => near(quantity(`${cell} ${unit}`, 'N'), cycles[i].max_force_N, 1e-3, `cycle ${i + 1}`));
    assert.equal(cells.length, cycles.length);
    const bar = page.locator('.view', { has: page.locator('#strip-loops') }).locator('.player');
    near(quantity((await bar.locator('output').textContent()).split(' · ')[1], 'N'), cycles[0].max_force_N, 1e-3, 'bar');
    const drawing = page.locator('#strip-loops .unwrapped');
    const before = await drawing.innerHTML();
    await bar.locator('input').focus();
    await page.keyboard.press('Home');
    assert.notEqual(await drawing.innerHTML(), before);
    assert.doesNotMatch(await drawing.innerHTML(), /NaN/);
    assert.equal(await page.locator('#cycle-loops .round').count(), 1);
    assert.equal(await page.locator('#strip-loops .round').count(), 0);
  });
});

test('a partial run is shown as far as it got, and called partial', async () => {
  const target = join(folder, 'partial');
  const running = spawn(program, ['cycle', caseFile, '-o', target, '--quiet', '--set', 'cycle.steps=20000']);
  const ended = new Promise((resolve) => running.on('exit', resolve));
  while (!existsSync(target)) await sleep(5);
  await sleep(200);
  running.kill('SIGINT');
  assert.equal(await ended, 130);
  report('partial.html', 'partial');
  await withReport('partial.html', async (page) => {
    const warnings = await page.locator('.warnings').textContent();
    await assertLoopsInSight(page, 'a partial run');
    assert.match(warnings, /The run was interrupted; its results are partial/);
    assert.match(warnings, /interrupted after increment \d+ of 40000, [\d.]+ .m\./);
    assert.match(warnings, /−Y: not started: the run was interrupted/);
    assert.match(await page.locator('.about').textContent(), /· interrupted ·/);
    assert.ok((await page.locator('.unwrapped path').count()) > 5);
    await page.locator('.player select').selectOption('−Y');
    assert.equal(await page.locator('.player output').textContent(), '−Y: not started: the run was interrupted');
  }, laptop);
});

test('a failed run says why and where', async () => {
  const [displacement, ...others] = readFileSync(stripFile, 'utf8').split('\n').filter((line) => /^displacement/.test(line));
  assert.deepEqual(others, []);
  const pressed = join(folder, 'pressed.toml');
  writeFileSync(pressed, readFileSync(stripFile, 'utf8').replace(displacement, 'load = "1 MN"'));
  run(['strip', pressed, '-o', join(folder, 'failed')], 3);
  const [{ failed_increment: increment, reason }] = summaryOf('failed').cycles;
  report('failed.html', 'failed');
  await withReport('failed.html', async (page) => {
    const warnings = await page.locator('.warnings').textContent();
    assert.match(warnings, /The run failed; its results are partial/);
    assert.match(warnings, new RegExp(`Cycle 1: failed at increment ${increment} of 40, [\\d.]+ .m: ${reason}\\.`));
    assert.match(await page.locator('.card').first().textContent(), /failed at increment/);
  });
});

test('it fits every width, in light and dark, and on paper', async () => {
  const colours = new Set();
  for (const colorScheme of ['light', 'dark']) {
    await withReport(
      'one.html',
      async (page) => {
        await assertFits(page);
        colours.add(await page.evaluate(() => getComputedStyle(document.body).backgroundColor));
      },
      { viewport: { width: 360, height: 800 }, colorScheme },
    );
  }
  assert.equal(colours.size, 2);
  await withReport('one.html', async (page) => {
    const light = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    await page.getByRole('button', { name: 'Dark' }).click();
    assert.notEqual(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), light);
    assert.ok((await page.pdf()).length > 20_000);
  });
});

test('the keyboard alone reaches what can be chosen', () =>
  withReport('one.html', async (page) => {
    const reached = new Set();
    for (let i = 0; i < 150; i += 1) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent));
    }
    for (const name of ['Increment of the cycle', 'Play the cycle', 'Direction', 'Magnification of displacements', 'Loops: save the drawing as SVG', 'Direct']) {
      assert.ok(reached.has(name), name);
    }
    const foils = page.locator('.unwrapped');
    await foils.focus();
    await page.keyboard.press('ArrowRight');
    assert.match(await page.locator('.bump-values').textContent(), /^Bump 1: load/);
  }));
