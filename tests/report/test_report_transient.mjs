// Reports of rotors in time in a browser: charts and tables are those of transient.csv and summary.json, orbits those of
// the steps, a slider moves the journals, spectra lie where their frequencies are, and a run that ended early says so.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, assertPanelsFitPaper, assertReads, folder, near, placeOf, plotsIn, quantity, report, rotorFile, rowsOf, run, saved, summaryOf, withReport } from './support.mjs';

const coarse = ['film.columns_per_pitch=4', 'film.rows=4', 'transient.steps_per_revolution=30', 'transient.revolutions_per_spectrum=2'];

function transient(name, pairs, exitCode = 0) {
  run(['transient', rotorFile, '-o', join(folder, name), ...[...coarse, ...pairs].flatMap((pair) => ['--set', pair])], exitCode);
  report(`${name}.html`, name);
}

before(() => {
  transient('coast', ['transient.speed={from="12000 rpm", to="6000 rpm", time="80 ms"}', 'title=</script><b>x</b>']);
  const tilting = ['rotor.bearings=["-60 mm", "60 mm"]', 'rotor.transverse_inertia=4e-3 kg m2', 'rotor.polar_inertia=5e-4 kg m2', 'rotor.unbalance=[{amount="20 g mm", at="30 mm"}]'];
  const rough = 'asperity={sigma="0.3 um", density="17000 1/mm2", radius="10 um", friction=0.2}';
  transient('rubbing', [...tilting, rough, 'transient.speed=[{from="0 rpm", to="6000 rpm", time="40 ms"}, {to="6000 rpm", time="20 ms"}]', 'transient.longest_step=1 ms']);
  transient('failed', ['rotor.unbalance=[{amount="60 g mm"}]', 'transient.speed={to="8000 rpm", time="80 ms"}'], 3);
  transient('none', ['transient.speed={to="50 rpm", time="80 ms"}'], 3);
  transient('back', ['bearing.wrap=clockwise', 'transient.speed={to="-9000 rpm", time="9 ms"}']);
});

const csvOf = (name) => rowsOf(readFileSync(join(folder, name, 'transient.csv'), 'utf8'));
const panelOf = (page, name) => page.getByRole('region', { name, exact: true });
const shownIn = async (page, name) => rowsOf((await saved(page, name, /CSV/)).bytes.toString());
const tableOf = (page, name) => page.getByRole('group', { name, exact: true }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
const choose = (page, panel, text) => page.getByRole('combobox', { name: `Quantity: ${panel}` }).selectOption(text);
const slider = (page) => page.getByRole('slider', { name: 'Step of the run' });
const moveSlider = (page, index) =>
  slider(page).evaluate((one, value) => {
    one.value = String(value);
    one.dispatchEvent(new Event('input', { bubbles: true }));
  }, index);

/** Along X and Y, px from the middle of the circle of a station, and its radius. */
const circleOf = async (page, station = 0) => {
  const [x, y, r] = await panelOf(page, 'Orbits').locator('svg.round circle[fill="none"]').nth(station).evaluate((one) => ['cx', 'cy', 'r'].map((name) => Number(one.getAttribute(name))));
  return { x, y, r };
};

/** The way of the journal in the revolution that is shown: the last that is drawn, and the widest line. */
const orbitBox = (page) => panelOf(page, 'Orbits').locator('svg.round path[fill="none"][stroke-width="2"]').first().evaluate((path) => (({ x, y, width, height }) => ({ x, y, width, height }))(path.getBBox()));

test('what is charted over revolutions is that of transient.csv', () =>
  withReport('coast.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), '</script><b>x</b>');
    const rows = csvOf('coast');
    assert.equal(rows.length, 12);
    for (const [panel, text, keys] of [
      ['Motion', 'Amplitude along X', ['half_peak_to_peak_x_m', 'amplitude_x_m', 'amplitude_x_half_m', 'amplitude_x_2x_m']],
      ['Motion', 'Amplitude along Y', ['half_peak_to_peak_y_m', 'amplitude_y_m', 'amplitude_y_half_m', 'amplitude_y_2x_m']],
      ['Film', undefined, ['thinnest_film_m']],
      ['Speed and losses', 'Power', ['mean_power_W']],
      ['Energy', 'Energy in a revolution', ['revolution_force_work_J', 'revolution_film_work_J', 'revolution_friction_loss_J', 'revolution_stored_energy_J', 'energy_defect_J']],
      ['Energy', 'Dissipation of the films in a revolution', ['revolution_film_dissipation_J']],
    ]) {
      if (text) await choose(page, panel, text);
      const shown = await shownIn(page, panel);
      assert.deepEqual(shown.map((row) => row.revolution), rows.map((row) => row.revolution));
      for (const key of keys) rows.forEach((row, i) => row[key] === '' ? assert.equal(shown[i][key], '', key) : near(Number(shown[i][key]), Number(row[key]), 1e-6, key));
    }
    // Along speed the axis is that of rotation.
    await page.getByRole('group', { name: 'What charts go along' }).getByRole('button', { name: 'Over speed' }).click();
    const texts = await (await plotsIn(panelOf(page, 'Motion'))).locator('text').allTextContents();
    assert.ok(texts.includes('Speed (rpm)'), texts.join());
    assert.ok(texts.includes('8000') && !texts.includes('8'), texts.join());
  }));

test('the main results are those of summary.json', () =>
  withReport('coast.html', async (page) => {
    const summary = summaryOf('coast');
    const tiles = Object.fromEntries(await page.locator('.tile').evaluateAll((all) => all.map((one) => [one.querySelector('.what').textContent, one.querySelector('strong').textContent])));
    assert.equal(tiles.Status, 'complete');
    assert.equal(tiles['Whole revolutions'], String(summary.revolutions));
    near(quantity(tiles['Largest half peak-to-peak'], 'm'), summary.largest_half_peak_to_peak_m, 1e-3, 'half peak-to-peak');
    near(quantity(tiles['Minimum film thickness'], 'm'), summary.thinnest_film_of_run_m, 1e-3, 'film');
    near(quantity(tiles['Friction loss'], 'J'), summary.friction_loss_of_run_J, 1e-3, 'friction');
    const energies = (await tableOf(page, 'Table of energies')).map(([, value]) => quantity(value, 'J'));
    const expected = ['entrained_J', 'forces_J', 'dissipated_J', 'friction_J', 'stored_J', 'defect_J'].map((key) => summary.energy[key]);
    assert.equal(energies.length, expected.length);
    expected.forEach((value, i) => near(energies[i], value, 1e-3, 'energy'));
    assert.equal(await panelOf(page, 'Rubs').count(), 0);
  }));

test('orbits lie in the clearance where the journal is, and the slider moves it', () =>
  withReport('coast.html', async (page) => {
    const rows = csvOf('coast');
    const subject = panelOf(page, 'Orbits').locator('.subject');
    assert.match(await subject.textContent(), /^revolution 12 of 12, 6000 rpm, clearance 31.80 µm/);
    // Of 30 steps a revolution the fifth begins with step 120: what is between 0 and its end is moved to.
    await moveSlider(page, 4 * 30 + 10);
    assert.match(await subject.textContent(), /^revolution 5 of 12, /);
    const { x, y, r } = await circleOf(page);
    const scale = r / 31.8e-6;
    const box = await orbitBox(page);
    near(box.width, 2 * rows[4].half_peak_to_peak_x_m * scale, 0.01, 'width');
    near(box.height, 2 * rows[4].half_peak_to_peak_y_m * scale, 0.01, 'height');
    assert.ok(Math.abs(box.x + box.width / 2 - x - rows[4].mean_x_m * scale) < 0.1 * box.width + 0.2);
    assert.ok(Math.abs(y - box.y - box.height / 2 - rows[4].mean_y_m * scale) < 0.1 * box.height + 0.2);
    await panelOf(page, 'Orbits').getByRole('button', { name: 'Enlarged' }).click();
    const size = quantity((await panelOf(page, 'Orbits').locator('svg.round text').allTextContents()).find((text) => text.endsWith('m')), 'm');
    const enlarged = await circleOf(page);
    const steps = (await shownIn(page, 'Orbits')).map((row) => [Number(row.x_m), Number(row.y_m)]);
    assert.equal(steps.length, 31);
    near(steps[30][0], Number(rows[4].section_x_m), 1e-6, 'section');
    near(steps[30][1], Number(rows[4].section_y_m), 1e-6, 'section');
    // About the middle of the orbit, in parts of the circle, whose radius is rounded to two digits.
    const [meanX, meanY] = [0, 1].map((axis) => steps.reduce((sum, step) => sum + step[axis], 0) / steps.length);
    for (const step of [1, 14, 29]) {
      await moveSlider(page, 4 * 30 + step);
      const [left, top] = await panelOf(page, 'Orbits').locator('svg.round .journal').evaluate((one) => ['cx', 'cy'].map((name) => Number(one.getAttribute(name))));
      near(left - enlarged.x, ((steps[step][0] - meanX) * enlarged.r) / size, 0.03, 'x');
      near(enlarged.y - top, ((steps[step][1] - meanY) * enlarged.r) / size, 0.03, 'y');
    }
    assert.match(await page.locator('.steps output').textContent(), /^revolution 5 · .* · film /);
  }));

test('play moves the journal from revolution to revolution, and a click on a chart goes to one', () =>
  withReport('coast.html', async (page) => {
    await page.getByRole('button', { name: 'Play the run' }).click();
    await page.waitForFunction(() => Number(document.querySelector('.steps input').value) > 35);
    await page.getByRole('button', { name: 'Pause' }).click();
    const index = Number(await slider(page).inputValue());
    assert.ok(index < 360);
    const film = panelOf(page, 'Film');
    await plotsIn(film);
    const mark = film.locator('.cursor.point').first();
    const cursor = await placeOf(mark);
    await moveSlider(page, 355);
    assert.notDeepEqual(await placeOf(mark), cursor);
    await film.locator('.chart').first().click({ position: cursor });
    const shown = Math.floor((index - 1) / 30) + 1;
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), new RegExp(`^revolution ${shown} of 12`));
  }));

test('the waterfall has the spectra of the file, with lines at half of the speed and at it', () =>
  withReport('coast.html', async (page) => {
    const panel = panelOf(page, 'Waterfall');
    const plot = await plotsIn(panel);
    const shown = await shownIn(page, 'Waterfall');
    const orders = [...new Set(shown.map((row) => row.order))];
    assert.equal(shown.length, 6 * orders.length);
    assert.deepEqual(orders.slice(0, 3), ['0', '0.5', '1']);
    // Under a Hann window a sine wave at an order has its full amplitude.
    const once = shown.filter((row) => row.order === '1').map((row) => Number(row.amplitude_m));
    csvOf('coast').filter((row) => row.revolution % 2 === 0).forEach((row, i) => near(once[i], row.amplitude_x_m, 0.1, '1x'));
    const largest = Math.max(...shown.map((row) => Number(row.amplitude_m)));
    near(quantity((await panel.locator('.subject').textContent()).match(/largest (.*?m)/)[1], 'm'), largest, 1e-3, 'largest');
    assert.match(await panel.locator('.legend').textContent(), /^0 to .*µm$/);
    const texts = await plot.locator('text').allTextContents();
    for (const text of ['½x', '1x', '2x', 'Speed (rpm)', 'Order: frequency / speed']) assert.ok(texts.includes(text), `${text} of ${texts.join()}`);
    const image = plot.locator('image');
    const light = await image.evaluate((one) => one.getAttribute('href') ?? one.getAttribute('xlink:href'));
    assert.match(light, /^data:image\/png/);
    // The largest amplitude is the stripe at 1x; where there is none it is white.
    const stripe = await image.evaluate(async (one) => {
      const picture = new Image();
      picture.src = one.getAttribute('href') ?? one.getAttribute('xlink:href');
      await picture.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
      const context = canvas.getContext('2d');
      context.drawImage(picture, 0, 0);
      const { data } = context.getImageData(0, Math.floor(picture.height / 2), picture.width, 1);
      const pixels = Array.from({ length: picture.width }, (_, i) => [...data.subarray(4 * i, 4 * i + 3)]);
      // The last colour of the bar.
      const most = pixels.flatMap((pixel, i) => (Math.hypot(pixel[0] - 168, pixel[1] - 116, pixel[2]) < 40 ? [i] : []));
      return { middle: (most[0] + most[most.length - 1]) / 2 / picture.width, last: pixels[pixels.length - 1] };
    });
    const drawn = await image.boundingBox();
    const label = await plot.locator('text', { hasText: /^1x$/ }).boundingBox();
    assert.ok(Math.abs(drawn.x + stripe.middle * drawn.width - label.x - label.width / 2) < 0.02 * drawn.width, `${stripe.middle}`);
    assert.ok(Math.min(...stripe.last) > 240, stripe.last.join());
    await panel.getByRole('button', { name: 'Frequency' }).click();
    assert.ok((await plot.locator('text').allTextContents()).includes('Frequency (Hz)'));
    await panel.getByRole('button', { name: 'Log' }).click();
    assert.match(await panel.locator('.legend').textContent(), /logarithmic$/);
    await panel.getByRole('button', { name: 'Over revolutions' }).click();
    assert.ok((await plot.locator('text').allTextContents()).includes('Revolution'));
    // A spectrum leads to the orbit in its middle: the lowest to that of revolutions 1 and 2.
    const middle = await placeOf(plot.locator('image'));
    const { width, height } = await plot.locator('image').boundingBox();
    await plot.click({ position: { x: middle.x - 0.1 * width, y: middle.y + height / 2 - 4 } });
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), /^revolution [12] of 12/);
    await page.getByRole('button', { name: 'Dark' }).click();
    assert.notEqual(await plot.locator('image').evaluate((one) => one.getAttribute('href') ?? one.getAttribute('xlink:href')), light);
    for (const name of ['Waterfall', 'Orbits']) assert.doesNotMatch((await saved(page, name, /SVG/)).bytes.toString(), /NaN|undefined/);
  }));

test('rubs are listed, each bearing has its orbits, and its station can be chosen', () =>
  withReport('rubbing.html', async (page) => {
    const { rubs } = summaryOf('rubbing');
    assert.ok(rubs.length > 0);
    const rows = await tableOf(page, 'Table of rubs');
    assert.equal(rows.length, rubs.length);
    rows.forEach(([bearing, begin, end, , load], i) => {
      assert.equal(bearing, `bearing ${rubs[i].bearing}`);
      near(quantity(begin, 's'), rubs[i].begin_s, 1e-3, 'begin');
      near(quantity(end, 's'), rubs[i].end_s, 1e-3, 'end');
      near(quantity(load, 'N'), rubs[i].asperity_load_N, 1e-3, 'load');
    });
    assert.equal(await page.locator('.tile', { hasText: 'Rubs' }).locator('strong').textContent(), String(rubs.length));
    assert.match(await page.locator('.warnings').textContent(), /journals touch foils in/);
    await choose(page, 'Film', 'Largest asperity load');
    const loads = await shownIn(page, 'Film');
    csvOf('rubbing').filter((row) => row.station === 'bearing 2').forEach((row, i) => near(Number(loads[i].largest_asperity_load_N_2), Number(row.largest_asperity_load_N), 1e-6, 'load'));
    const panel = panelOf(page, 'Orbits');
    assert.equal(await panel.locator('svg.round circle[fill="none"]').count(), 2);
    assert.equal(await panel.locator('svg.round .journal').count(), 2);
    await panel.getByRole('button', { name: 'Enlarged' }).click();
    const texts = await panel.locator('svg.round text').allTextContents();
    assert.deepEqual(texts.filter((text) => text.includes('z = ')).map((text) => text.split(',')[0]), ['bearing 1', 'plane 1', 'bearing 2']);
    await page.getByRole('combobox', { name: 'Station shown' }).selectOption('plane 1');
    const motion = await shownIn(page, 'Motion');
    csvOf('rubbing').filter((row) => row.station === 'plane 1').forEach((row, i) => near(Number(motion[i].amplitude_x_m), Number(row.amplitude_x_m), 1e-6, 'amplitude'));
    assert.match(await panelOf(page, 'Waterfall').locator('.subject').textContent(), /^plane 1, along X/);
  }));

test('a run that ends early says why, and shows its last steps', () =>
  withReport('failed.html', async (page) => {
    const summary = summaryOf('failed');
    assert.match(await page.locator('.warnings').textContent(), /The run failed; its results are partial.*the march ends after/);
    assert.equal(await page.locator('.tile', { hasText: 'Status' }).locator('strong').textContent(), summary.end_status.replaceAll('_', ' '));
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), new RegExp(`^revolution ${summary.revolutions + 1}, not completed, 8000 rpm`));
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('a run that did not begin says so', () =>
  withReport('none.html', async (page) => {
    assert.match(await page.locator('.warnings').textContent(), /no equilibrium found to start from, at 50 rpm/);
    assert.deepEqual(await page.locator('.tile strong').allTextContents(), ['touchdown', '0']);
    assert.equal(await page.locator('.chart, .round').count(), 0);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('a rotor may turn from Y to X, and a run of one revolution has its orbit', () =>
  withReport('back.html', async (page) => {
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), /^revolution 2, not completed, 9000 rpm/);
    assert.equal(await panelOf(page, 'Waterfall').count(), 0);
    await moveSlider(page, 5);
    assert.match(await panelOf(page, 'Orbits').locator('.subject').textContent(), /^revolution 1 of 1, 9000 rpm/);
    const steps = await shownIn(page, 'Orbits');
    assert.equal(steps.length, 31);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('words are words, links lead somewhere, and no row of panels is left half empty', () =>
  withReport('rubbing.html', async (page) => {
    await assertReads(page, /\bh min\b|krad|half way|amplitude x|2x\b.*_|thinnest film of run/gi);
  }));

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('rubbing.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
  });
  await withReport('coast.html', async (page) => {
    await assertPanelsFitPaper(page);
    assert.ok(!(await page.locator('.steps').isVisible()));
  });
});
