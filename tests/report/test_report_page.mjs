// The page of reports as people use it: several runs beside each other, pictures, paper, keyboard, words, many runs.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { before, test } from 'node:test';
import { assertLoopsInSight, axeFindings, bottomOf, caseFile, cycle, folder, laptop, moveTo, near, paper, plotsIn, print, quantity, report, rowsOf, run, saved, stripFile, summaryOf, withReport } from './support.mjs';

const phone = { viewport: { width: 360, height: 800 } };

before(() => {
  cycle('demo');
  cycle('slippery', 'friction.coefficient=0.2', 'cycle.steps=40');
  run(['strip', stripFile, '-o', join(folder, 'free'), '--set', 'strip.weld=none', '--set', 'strip.top_foil=true']);
  report('one.html', 'demo');
  report('two.html', 'demo', 'slippery');
  report('all.html', 'demo', 'slippery', 'free');
  report('free.html', 'free');
});

test('at 1366x768 the axis of the loops is above the bar, with one run and with two', async () => {
  for (const file of ['one.html', 'two.html']) {
    await withReport(file, (page) => assertLoopsInSight(page, file), laptop);
  }
});

test('of several runs, a point chosen on any loop moves a bearing that is in sight', async () => {
  for (const options of [laptop, phone]) {
    await withReport(
      'two.html',
      async (page) => {
        const bearing = page.locator('.in-sight .round');
        const panels = page.locator('#cycle-loops .panel', { has: page.locator('.chart') });
        assert.equal(await panels.count(), 4);
        for (let i = 0; i < 4; i += 1) {
          const plot = panels.nth(i).locator('.plot');
          // Its end, which is where the points are.
          await plot.evaluate((one) => window.scrollBy(0, one.getBoundingClientRect().bottom - window.innerHeight + 130));
          const before = await bearing.innerHTML();
          const { width, height } = await plot.boundingBox();
          await plot.click({ position: { x: 0.62 * width, y: 0.62 * height } });
          assert.notEqual(await bearing.innerHTML(), before, `panel ${i}`);
          const box = await bearing.boundingBox();
          const bar = await page.locator('.player').boundingBox();
          assert.ok(box.y >= 0 && bottomOf(box) <= bar.y && box.height > 200, `panel ${i}: ${JSON.stringify(box)}`);
        }
      },
      options,
    );
  }
});

test('saved pictures say what they are of', () =>
  withReport('two.html', async (page) => {
    await page.getByRole('group', { name: 'Direction: main results' }).getByRole('button', { name: '−Y' }).click();
    const expected = [
      ['Loops, −Y', 'loops-force_direct-demo-slippery--Y.svg', ['Loops, −Y', 'Direct force vs. displacement', 'demo, slippery', 'loading', 'unloading', 'demo (reference)', 'slippery']],
      ['Bump loads, +Y', 'loads-top_bump-demo-slippery-+Y.svg', ['Bump loads, +Y', 'Top foil on bumps', 'bar: at full displacement', 'slippery']],
      ['Contact states along the path', 'contact-states-demo--Y.svg', ['Contact states along the path', 'demo · −Y', 'open', 'stick, or closed without friction', 'slip backward', 'Feet on sleeve']],
      ['Energies, −X', 'energies-demo-slippery--X.svg', ['Energies, −X', 'dissipated by friction', 'slippery']],
      ['Largest bending stress, −X', 'stress-demo-slippery--X.svg', ['Largest bending stress, −X', 'top foil at the weld']],
      ['The bearing', 'bearing-demo--Y-100.svg', ['The bearing', 'demo', '−Y', 'full displacement', 'height of bumps ×', 'normal force', 'slip forward', 'stick', 'weld']],
      ['The foils, unwrapped', 'foils-demo--Y-100.svg', ['The foils, unwrapped', 'demo', '−Y', 'friction on the bump foil', 'slip backward', 'top foil']],
    ];
    for (const [panel, name, texts] of expected) {
      const picture = await saved(page, panel, /SVG/);
      assert.equal(picture.name, name);
      // Lines may be broken between words.
      const words = picture.bytes.toString().replace(/<[^>]*>/g, ' ').replace(/\s+/g, ' ');
      for (const text of texts) assert.ok(words.includes(text), `${panel} does not say ${text}: ${words.slice(0, 400)}`);
    }
  }));

/** Numbers along the axes of the loops of every direction. */
async function axesOf(page) {
  const panels = page.locator('#cycle-loops .panel', { has: page.locator('.chart') });
  const axes = [];
  for (const panel of await panels.all()) {
    const plot = await plotsIn(panel);
    axes.push((await plot.locator('text').allTextContents()).filter((text) => /^[\d.]+$/.test(text)).join(' '));
  }
  assert.equal(axes.length, 4);
  return axes;
}

test('compared charts share their axes until they are set free', () =>
  withReport('two.html', async (page) => {
    assert.equal(new Set(await axesOf(page)).size, 1);
    await page.getByRole('checkbox', { name: 'Same axes in compared charts' }).uncheck();
    assert.ok(new Set(await axesOf(page)).size > 1);
    await page.getByRole('checkbox', { name: 'Same axes in compared charts' }).check();
    assert.equal(new Set(await axesOf(page)).size, 1);
  }));

test('bump loads tell the runs apart, with a mark for each', () =>
  withReport('two.html', async (page) => {
    await moveTo(page, 70);
    const loads = page.getByRole('region', { name: 'Bump loads, +X', exact: true });
    assert.match(await loads.locator('.legend').textContent(), /demo \(reference\)slippery/);
    const rows = rowsOf((await saved(page, 'Bump loads, +X', /CSV/)).bytes.toString());
    // The same part of the way, in runs of 100 and of 40 increments to the turning point.
    assert.deepEqual([...new Set(rows.map((row) => `${row.run} ${row.increment}`))], ['demo 70', 'slippery 28']);
    const loaded = rows.filter((row) => Number(row.normal_force_there_N) > 0);
    assert.ok(new Set(loaded.map((row) => row.run)).size === 2);
    const dark = await (await plotsIn(loads)).locator('path').evaluateAll((paths) => paths.filter((path) => path.getAttribute('fill') === '#1c2329').length);
    assert.equal(dark, loaded.length);
  }));

test('results have differences from the reference that was chosen', () =>
  withReport('two.html', async (page) => {
    const of = (name) => summaryOf(name).cycles[0].max_force_N;
    const cells = async () => (await page.locator('[data-key=max_force_N] td').allTextContents()).slice(1).map((text) => Number(text.replace('−', '-').replace(' %', '')));
    const heads = () => page.locator('.results thead th').allTextContents();
    const references = page.getByRole('combobox', { name: 'Reference run' });
    assert.deepEqual((await heads()).slice(2), ['demo (reference)', 'slippery', 'difference', 'in %']);
    let [, , difference, percent] = await cells();
    near(difference, of('slippery') - of('demo'), 6e-3, 'difference');
    near(percent, (100 * (of('slippery') - of('demo'))) / of('demo'), 6e-3, 'percent');
    await references.selectOption('slippery');
    assert.deepEqual((await heads()).slice(2), ['slippery (reference)', 'demo', 'difference', 'in %']);
    [, , difference, percent] = await cells();
    near(difference, of('demo') - of('slippery'), 6e-3, 'difference');
    near(percent, (100 * (of('demo') - of('slippery'))) / of('slippery'), 6e-3, 'percent');
    await page.getByRole('group', { name: 'Direction of the results' }).getByRole('button', { name: '+Y' }).click();
    const [unit, , demo] = await page.locator('[data-key=max_force_N] td').allTextContents();
    near(quantity(`${demo} ${unit}`, 'N'), summaryOf('demo').cycles[2].max_force_N, 1e-3, '+Y');
  }));

test('tiles lead with the structural stiffness, and tables have the clearances asked for', async () => {
  cycle('clearances', 'cycle.steps=40', 'cycle.amplitude=95 um', 'cycle.clearance_forces=["2 N", "5 N", "5 kN"]');
  report('clearances.html', 'clearances');
  await withReport('clearances.html', async (page) => {
    const { cycles } = summaryOf('clearances');
    const tile = page.locator('.card').first();
    near(quantity(await tile.locator('strong').textContent(), 'N/m'), cycles[0].loaded_stiffness_N_per_m, 6e-3, 'headline');
    assert.match(await tile.textContent(), /structural stiffness.*secant with free travel/);
    for (const [i, { force_N: force, displacement_m: displacement }] of cycles[0].clearances.entries()) {
      const row = page.locator('.results tr', { hasText: `Clearance at ${['2 N', '5 N', '5000 N'][i]}` });
      const [unit, shown] = await row.locator('td').allTextContents();
      if (displacement === null) assert.equal(shown, '–', String(force));
      else near(quantity(`${shown} ${unit}`, 'm'), displacement, 1e-3, String(force));
    }
    for (const name of ['Take-up point', 'Specific damping capacity', 'Structural stiffness']) assert.equal(await page.locator('.results th', { hasText: name }).count(), 1, name);
    // An eighth of the rise is passed here.
    assert.match(await page.locator('.warnings').textContent(), /\+X: bump \d+ is compressed by .* of its rise/);
  });
});

/** Charts whose texts are not wholly in their places once the page is told of paper: the browser prints what is there then. */
function cutOnPaper(page) {
  return page.evaluate(() => {
    window.dispatchEvent(new Event('beforeprint'));
    const charts = [...document.querySelectorAll('.chart')].map((chart) => {
      const place = chart.querySelector('.plot').getBoundingClientRect();
      const cut = [...chart.querySelectorAll('text')].filter((text) => {
        const { left, right, bottom } = text.getBoundingClientRect();
        return left < place.left - 1 || right > place.right + 1 || bottom > place.bottom + 1;
      });
      return { name: chart.closest('.panel').getAttribute('aria-label'), texts: [...chart.querySelectorAll('text')].map((text) => text.textContent), cut: cut.map((text) => text.textContent) };
    });
    const foils = document.querySelector('.unwrapped');
    const [drawn, room] = [foils, foils.parentElement].map((one) => one.getBoundingClientRect().width);
    charts.push({ name: 'The foils', texts: [], cut: drawn > room + 1 ? [`${drawn} px in ${room} px`] : [] });
    window.dispatchEvent(new Event('afterprint'));
    return charts;
  });
}

test('on paper no card is torn, the first page is full, charts say what they are of', async () => {
  for (const file of ['one.html', 'all.html']) {
    await withReport(file, async (page) => {
      const charts = await cutOnPaper(page);
      assert.ok(charts.length > 10);
      for (const { name, cut } of charts) assert.deepEqual(cut, [], name);
      const { texts } = charts.find(({ name }) => name === 'Bump loads, +X');
      assert.ok(Math.max(...texts.filter((text) => /^\d+$/.test(text)).map(Number)) >= 25, String(texts));
      await print(page);
      const panels = await page.locator('.panel').evaluateAll((all) =>
        all.map((panel) => ({
          name: panel.getAttribute('aria-label'),
          height: panel.getBoundingClientRect().height,
          inside: getComputedStyle(panel).breakInside,
          // A chain of parts that must not be parted is parted anywhere.
          chained: [panel, ...panel.querySelectorAll('*')].some((part) => getComputedStyle(part).breakAfter === 'avoid' && part.tagName !== 'H2'),
          subject: panel.querySelector('.subject')?.getBoundingClientRect().height,
          chart: panel.querySelector('.chart, .round, .unwrapped') !== null,
          interface: panel.querySelector('.subject')?.textContent,
        })),
      );
      assert.ok(panels.length > 15);
      for (const { name, height, inside, chained, subject, chart } of panels) {
        assert.equal(inside, 'avoid', name);
        assert.ok(!chained, name);
        assert.ok(height < paper.height - 60, `${name} of ${height} px fits no page`);
        if (chart) assert.ok(subject > 0, name);
      }
      for (const one of panels.filter(({ name }) => name.startsWith('Bump loads'))) assert.match(one.interface, /Top foil on bumps|Plate on/);
      const first = await page.locator('.panel').first().boundingBox();
      assert.ok(bottomOf(first) < paper.height, `the first panel ends at ${bottomOf(first)}`);
      assert.equal(await page.locator('.player, .save, .chooser, nav').evaluateAll((all) => all.filter((one) => one.getClientRects().length > 0).length), 0);
    });
  }
});

test('the drawings name their parts and say how much they exaggerate', () =>
  withReport('one.html', async (page) => {
    for (const drawing of ['.round', '.unwrapped']) {
      assert.deepEqual((await page.locator(`${drawing} .part-name`).allTextContents()).sort(), ['bump foil', 'journal', 'sleeve', 'top foil', 'weld']);
    }
    // As large as those of the page, also where the drawing is small.
    for (const width of [1280, 360]) {
      await page.setViewportSize({ width, height: 800 });
      await page.waitForFunction(() => {
        const round = document.querySelector('.round');
        const shown = Math.min(round.clientWidth, round.clientHeight) / round.viewBox.baseVal.width;
        return [...round.querySelectorAll('text')].every((text) => Math.abs(shown * Number(text.getAttribute('font-size')) - 11) < 0.3);
      });
    }
    const subject = page.getByRole('region', { name: 'The foils, unwrapped' }).locator('.subject');
    const factors = async () => /height of bumps ×([\d.]+), displacements and gaps ×([\d.]+), slip ×([\d.]+)/.exec(await subject.textContent()).slice(1).map(Number);
    const [height, displacement] = await factors();
    assert.ok(height > 1);
    near(displacement / height, 4, 0.05, 'default factor');
    await page.getByRole('combobox', { name: 'Magnification of displacements' }).selectOption('×2');
    near((await factors())[1] / (await factors())[0], 2, 0.05, 'factor chosen');
    assert.match(await subject.textContent(), /displacements and gaps against heights ×2\./);
  }));

/** Parts of a drawing that are not wholly in it. */
function outside(page, drawing, parts) {
  return page.locator(drawing).evaluate((root, selector) => {
    const { width, height } = root.viewBox.baseVal;
    return [...root.querySelectorAll(selector)]
      .map((part) => part.getBBox())
      .filter((box) => box.x < 0 || box.y < 0 || box.x + box.width > width || box.y + box.height > height)
      .map((box) => `${box.x} ${box.y} ${box.width} ${box.height}`);
  }, parts);
}

async function atAnyMagnification(page, increments, check) {
  const factors = page.getByRole('combobox', { name: 'Magnification of displacements' });
  const names = await factors.locator('option').allTextContents();
  assert.ok(names.includes('×1000'));
  for (const factor of names) {
    await factors.selectOption(factor);
    // All along the way at the least and at the most.
    for (const increment of factor === names[0] || factor === names.at(-1) ? increments : increments.slice(-1)) {
      await moveTo(page, increment);
      await check(`${factor}, increment ${increment}`);
    }
  }
}

test('a free strip is wholly inside its picture at any magnification', () =>
  withReport('free.html', (page) =>
    // Arrows of forces stand where they must.
    atAnyMagnification(page, [0, 10, 20, 33, 40], async (where) =>
      assert.deepEqual(await outside(page, '.unwrapped', 'path[fill=none], rect, circle, text'), [], where),
    ),
  ));

test('the foils of a bearing are inside both pictures at any magnification', () =>
  withReport('one.html', (page) =>
    atAnyMagnification(page, [0, 100, 170], async (where) => {
      assert.deepEqual(await outside(page, '.unwrapped', '.foil, text'), [], where);
      assert.deepEqual(await outside(page, '.round', '.foil, text'), [], where);
      const foils = await page.locator('.round .foil').evaluateAll((paths) => paths.map((path) => path.getAttribute('d')));
      const places = foils.flatMap((path) => path.slice(1).split('L').map((point) => point.split(' ').map(Number)));
      // The sleeve has a radius of 192 about (240, 240); the foils cover 0.6 of it at most, and a line.
      assert.ok(Math.min(...places.map(([x, y]) => Math.hypot(x - 240, y - 240))) > 0.35 * 192, where);
    }),
  ));

test('the keyboard finds landmarks, groups of one stop each, and the slider soon', () =>
  withReport('all.html', async (page) => {
    for (const role of ['banner', 'navigation', 'main', 'contentinfo']) assert.equal(await page.getByRole(role).count(), 1, role);
    const links = await page.locator('nav a').allTextContents();
    assert.equal(new Set(links).size, links.length, String(links));
    const focused = () => page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent);
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'Skip to the results');
    let tabs = 1;
    for (; tabs < 30 && (await focused()) !== 'Increment of the cycle'; tabs += 1) await page.keyboard.press('Tab');
    assert.ok(tabs <= 10, `${tabs} tabs`);
    const group = page.getByRole('group', { name: 'Direction of the results' });
    await group.getByRole('button', { name: '+X' }).focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await focused(), '−X');
    await page.keyboard.press('End');
    assert.equal(await focused(), '−Y');
    await page.keyboard.press('Enter');
    assert.match(await page.getByRole('region', { name: 'Results by direction' }).locator('.subject').textContent(), /^−Y/);
    await page.keyboard.press('Tab');
    assert.equal(await group.evaluate((one) => one.contains(document.activeElement)), false);
    await page.keyboard.press('Shift+Tab');
    assert.equal(await focused(), '−Y');
  }));

test('axe finds nothing', async () => {
  for (const [file, colorScheme] of [['one.html', 'light'], ['two.html', 'dark'], ['free.html', 'dark']]) {
    await withReport(
      file,
      async (page) => assert.deepEqual(await axeFindings(page), [], file),
      { colorScheme },
    );
  }
});

test('every quantity has its definition, beside it and in the glossary', () =>
  withReport('one.html', async (page) => {
    const terms = await page.locator('.results th[scope=row]').evaluateAll((all) => all.map((row) => [row.textContent, row.querySelector('a')?.title, row.querySelector('a')?.hash]));
    assert.ok(terms.length > 20);
    // Names that say all there is to say have none.
    assert.deepEqual(terms.filter(([, title]) => !title).map(([name]) => name), ['Elastic energy at full displacement', 'Increments per branch']);
    for (const [, title, hash] of terms.filter(([, one]) => one)) {
      const entry = page.locator(`#glossary ${hash}`);
      assert.equal(await entry.locator('dd').textContent(), title);
      assert.doesNotMatch(title, /`|\^|\bpi\b/);
    }
    assert.equal(terms.find(([name]) => name === 'First contact')[1], 'Displacement at which the journal first touches the top foil.');
    for (const name of ['Work J', 'Direct force N', 'Stress, top foil at the weld Pa', 'Bump load N']) {
      assert.equal(await page.locator('#glossary dt', { hasText: new RegExp(`^${name}$`) }).count(), 1, name);
    }
  }));

test('stresses are drawn along the path, and the largest has its place', () =>
  withReport('one.html', async (page) => {
    const { cycles } = summaryOf('demo');
    const rows = rowsOf((await saved(page, 'Largest bending stress, −X', /CSV/)).bytes.toString());
    const most = Math.max(...rows.flatMap((row) => [row.stress_top_foil_Pa, row.stress_top_foil_weld_Pa].map((text) => Math.abs(Number(text)))));
    near(most, cycles[1].max_stress_top_foil_Pa, 1e-6, 'largest stress');
    const places = await page.locator('[data-key=max_stress_top_foil_Pa] .place').allTextContents();
    assert.equal(places.length, 4);
    cycles.forEach(({ max_stress_top_foil_at: { place, bump, increment } }, i) =>
      assert.ok(places[i].startsWith(`${bump === null ? place : `${place} of bump ${bump}`}, increment ${increment}, `), places[i]),
    );
  }));

test('no path of the machine is in the file', () => {
  const page = readFileSync(join(folder, 'two.html'), 'utf8');
  for (const path of [folder, dirname(caseFile)]) assert.ok(!page.includes(path), path);
  assert.match(page, /"command_line":"bumpfoil cycle gen1\.toml -o slippery /);
});

test('fifty runs stay usable: searched, chosen, in the colours of what differs', async () => {
  const names = Array.from({ length: 50 }, (_, i) => `mu${i}`);
  names.forEach((name, i) => cycle(`fifty/${name}`, `friction.coefficient=${i / 100}`, 'cycle.steps=10', 'cycle.amplitude=95 um', 'cycle.directions=["+X", "+Y"]'));
  // As a shell lists them: mu0, mu1, mu10, ...
  report('fifty.html', ...names.map((name) => `fifty/${name}`).sort());
  await withReport('fifty.html', async (page) => {
    await assertLoopsInSight(page, 'fifty runs');
    const loops = page.getByRole('region', { name: 'Loops, +X' });
    const curves = async () => (await plotsIn(loops)).locator('path').evaluateAll((paths) => new Set(paths.filter((path) => path.getAttribute('fill') === 'none').map((path) => path.getAttribute('stroke'))).size);
    // A warning of each is not in the way of the results.
    assert.equal(await page.locator('.warnings li:visible').count(), 1);
    await page.locator('.warnings summary').click();
    assert.equal(await page.locator('.warnings li:visible').count(), 100);
    // As many colours as values, and those of the axes.
    assert.ok((await curves()) >= 50);
    assert.match(await page.locator('.scale').textContent(), /^Coefficients of friction 0.*0\.49/);
    // Pictures and paper have no chooser that tells what the colours are.
    assert.match((await saved(page, 'Loops, +X', /SVG/)).bytes.toString(), />Coefficients of friction 0 to 0\.49</);
    await page.locator('.chooser summary').click();
    assert.deepEqual((await page.locator('.run-list label').allTextContents()).slice(0, 3), ['mu0 (reference) · 0', 'mu1 · 0.01', 'mu2 · 0.02']);
    await page.getByRole('searchbox', { name: 'Search runs' }).fill('mu4');
    assert.equal(await page.locator('.run-list label:visible').count(), 11);
    await page.getByRole('button', { name: 'Show those found' }).click();
    assert.match(await page.locator('.count').textContent(), /11 of 50 shown, 11 found/);
    assert.ok((await curves()) < 20);
    assert.deepEqual(await page.getByRole('combobox', { name: 'Run', exact: true }).locator('option').allTextContents(), [names[4], ...names.slice(40)]);
    // Two are chosen by hand, and compared in the table.
    await page.getByRole('checkbox', { name: 'mu41' }).uncheck();
    assert.match(await page.locator('.count').textContent(), /10 of 50/);
    await page.getByRole('searchbox', { name: 'Search runs' }).fill('mu0');
    const began = Date.now();
    await page.getByRole('button', { name: 'Show all' }).click();
    await page.getByRole('combobox', { name: 'Run', exact: true }).selectOption('mu25');
    const took = Date.now() - began;
    assert.match(await page.locator('.card').first().textContent(), /mu4.*mu25/);
    assert.equal(await page.locator('.results thead .run').count(), 50);
    // Paper has room for two, and says of how many they are.
    const printed = await page.evaluate(() => {
      window.dispatchEvent(new Event('beforeprint'));
      const results = document.querySelector('.panel:has(.results)');
      return [results.querySelector('.subject').textContent, ...[...results.querySelectorAll('thead .run')].map((run) => run.textContent)];
    });
    assert.deepEqual(printed, ['+X · mu4, mu25, of 50 runs · reference mu4', 'mu4 (reference)', 'mu25']);
    await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
    assert.equal(await page.locator('.results thead .run').count(), 50);
    console.log(`fifty runs: all shown and another one chosen in ${took} ms`);
    // Far more than it takes: a machine that is busy with other tests is no judge of speed.
    assert.ok(took < 30000, `${took} ms`);
  }, laptop);
});

test('the demo is painted at once', () =>
  withReport('one.html', async (page) => {
    const took = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
    console.log(`first paint of the demo: ${Math.round(took)} ms`);
    // A second on a machine at rest; one that is busy with other tests is no judge of it.
    assert.ok(took < 10000, `${took} ms`);
  }));
