/** The rotor on its bearings: where whirl begins, and how the motions are damped that are damped least. */
import { motionCharts } from '../charts/motions';
import type { Place } from '../data/grid';
import { at, capital } from '../data/run';
import { speedText } from '../data/states';
import { formatNumber, formatQuantity } from '../data/units';
import { Whirls } from '../data/whirls';
import { choice, el } from '../ui/dom';
import { GridSelection } from '../ui/grid_selection';
import type { CyclesAnswer, InputErrors, StabilityAnswer } from './format';
import { NumberControl } from './number_control';
import { notesOf, remarks } from './remarks';
import { isRefused, quickMesh, settled, type Request, type Solver } from './solver';
import { isSeen } from './tabs';
import { compared, tile } from './tiles';

const rpm = Math.PI / 30;
/** Speeds of a case that names none, over the one that is requested: from the highest on, since low ones may carry nothing. */
const usualSpeeds = Array.from({ length: 11 }, (_, i) => 1.5 - i / 8);
/** About how many speeds the answer has that comes first. */
const quickSpeeds = 6;

interface Design {
  text: string;
  answer: CyclesAnswer;
}

type Answer = StabilityAnswer | InputErrors;

/** What tiles show of a run. */
interface Facts {
  /** The first speed at which whirl begins, rad/s; NaN if none was found, of which the text says why. */
  onset: number;
  onsetText: string;
  onsetMore: string;
  /** Motions of rotor and foils that are damped least; none where they decay so fast that they are not looked for. */
  rotor: Place | undefined;
  foils: Place | undefined;
  decrement: number;
  /** Hz */
  frequency: number;
  thinnest: number;
}

/** With one that is requested, in its place among them. */
function withSpeed(speeds: number[], speed: number): number[] {
  if (speeds.some((one) => Math.abs(one - speed) <= 1e-9 * Math.abs(speed))) return speeds;
  const behind = speeds.findIndex((one, i) => i > 0 && (one - speed) * (at(speeds, i - 1) - speed) < 0);
  if (behind > 0) return [...speeds.slice(0, behind), speed, ...speeds.slice(behind)];
  const [first, last] = [speeds[0] ?? NaN, speeds[speeds.length - 1] ?? NaN];
  return Math.abs(first - speed) < Math.abs(last - speed) ? [speed, ...speeds] : [...speeds, speed];
}

/** Some of them, the ends and the one that is requested among them. */
function fewOf(speeds: number[], speed: number): number[] {
  const last = speeds.length - 1;
  const kept = new Set(Array.from({ length: quickSpeeds }, (_, i) => Math.round((i * last) / (quickSpeeds - 1))));
  return withSpeed(speeds.filter((_, i) => kept.has(i)), speed);
}

/** Speeds of [stability] and, first, the one that the case runs at. */
function speedsIn({ answer }: Design): { speeds: number[] | undefined; own: number | undefined } {
  const of = (table: string): number[] | undefined => (answer.run.summary.case[table] as { speeds?: number[] } | undefined)?.speeds;
  const speeds = of('stability');
  const highest = speeds?.reduce((most, speed) => (Math.abs(speed) > Math.abs(most) ? speed : most), 0);
  return { speeds, own: of('equilibrium')?.[0] ?? highest };
}

/** Views of one run; the next one takes its place. */
class RotorViews {
  readonly root: HTMLElement;
  private readonly whirls: Whirls;
  private before: Whirls | undefined;
  private readonly selection: GridSelection;
  private readonly tiles = el('div', { class: 'tiles' });
  private readonly caption = el('p', { class: 'note' });

  constructor(now: StabilityAnswer, speed: number) {
    this.whirls = new Whirls({ ...now.run, name: 'rotor' });
    const { whirls } = this;
    this.selection = new GridSelection([whirls.speed, whirls.contacts, whirls.motion], [whirls.speed]);
    this.lookAt(speed);
    this.selection.onChange(() => this.fill());
    this.root = el(
      'div',
      {},
      el('div', { class: 'numbers' }, choice('Contacts shown', whirls.contacts.texts.map((text, value) => ({ value, text: capital(text) })), 0, (contacts) => this.selection.show({ place: { contacts } })), this.caption, this.tiles),
      el('div', { class: 'multiples' }, ...motionCharts(whirls, this.selection, ['Campbell diagram', 'Growth over speed'], () => this.before)),
    );
    this.fill();
  }

  show(now: StabilityAnswer, before: StabilityAnswer | undefined, speed: number): void {
    this.whirls.replace({ ...now.run, name: 'rotor' });
    this.before = before && new Whirls({ ...before.run, name: 'baseline' });
    this.lookAt(speed);
  }

  /** At the motion of the rotor that is damped least at a speed. */
  private lookAt(speed: number): void {
    const place = { ...placeOf(this.whirls, speed), contacts: this.contacts };
    this.selection.show({ place: { motion: 0, ...place, ...this.whirls.leastDamped(place, false) } });
  }

  private get contacts(): number {
    return this.selection.index(this.whirls.contacts);
  }

  private fill(): void {
    const { whirls, before } = this;
    const speed = at(whirls.speeds, this.selection.place['speed'] ?? 0);
    this.caption.textContent = `At ${speedText(speed)}; decrement, frequency and whirl are those of the motion of the rotor that is damped least. Click a point for another speed.`;
    const now = factsOf(whirls, speed, this.contacts);
    const old = before && factsOf(before, speed, this.contacts);
    const change = (value: (facts: Facts) => number): string => (old ? compared(value(now), value(old)) : '');
    const { rotor, foils, frequency } = now;
    const growth = (motion: Place): string => (whirls.growthRateAt(motion) > 0 ? 'grow' : 'decay');
    const found = whirls.shortfallAt(placeOf(whirls, speed)) === '';
    this.tiles.replaceChildren(
      tile('onset', 'Onset of whirl', now.onsetText, now.onsetMore, change(({ onset }) => onset)),
      tile('log_decrement', 'Log. decrement', formatNumber(now.decrement, 3), rotor ? `${growth(rotor)}s` : '', change(({ decrement }) => decrement)),
      tile('frequency', 'Frequency', Number.isFinite(frequency) ? `${formatNumber(frequency, 4)} Hz` : '–', Number.isFinite(frequency) ? `${formatNumber((2 * Math.PI * frequency) / Math.abs(speed), 3)} of the speed` : ''),
      tile('direction', 'Whirl', (rotor && whirls.wordAt('direction', rotor)) || '–'),
      tile('foils', 'Motions of the foils', foils ? growth(foils) : found ? 'decay' : '–', foils ? oscillation(whirls, foils) : ''),
      tile('h_min', 'Minimum film', formatQuantity(now.thinnest, 'm', 3), change(({ thinnest }) => thinnest)),
    );
  }
}

function oscillation(whirls: Whirls, motion: Place): string {
  const decrement = whirls.numberAt('log_decrement', motion);
  return Number.isFinite(decrement) ? `log. decrement ${formatNumber(decrement, 3)}, ${formatNumber(whirls.frequencyAt(motion), 3)} Hz` : 'without oscillation';
}

/** A place that is none where the run has no such speed. */
function placeOf(whirls: Whirls, speed: number): Place {
  return { speed: whirls.speeds.findIndex((one) => Math.abs(one - speed) <= 1e-6 * Math.abs(speed)) };
}

function factsOf(whirls: Whirls, speed: number, contacts: number): Facts {
  const place = { ...placeOf(whirls, speed), contacts };
  const rotor = whirls.leastDamped(place, false);
  return {
    ...onsetOf(whirls, contacts),
    rotor,
    foils: whirls.leastDamped(place, true),
    decrement: rotor ? whirls.numberAt('log_decrement', rotor) : NaN,
    frequency: rotor ? whirls.frequencyAt(rotor) : NaN,
    thinnest: whirls.numberAt('h_min', place),
  };
}

/** The first onset; else on which side of the speeds it lies. */
function onsetOf(whirls: Whirls, contacts: number): Pick<Facts, 'onset' | 'onsetText' | 'onsetMore'> {
  const begins = whirls.onsets(contacts).filter((onset) => onset.begins && !onset.by_coefficients);
  const [first] = begins.sort((a, b) => Math.abs(a.speed_rad_per_s) - Math.abs(b.speed_rad_per_s));
  if (first) {
    const more = `${first.of_foils ? 'of the foils, ' : ''}whirl ratio ${formatNumber(first.whirl_ratio, 3)}`;
    return { onset: first.speed_rad_per_s, onsetText: speedText(first.speed_rad_per_s), onsetMore: more };
  }
  const fastest = whirls.places(contacts).map((place): Place => ({ ...place, motion: whirls.fastest(place) }));
  const known = fastest.filter((place) => Number.isFinite(whirls.growthRateAt(place)));
  const grows = (place: Place | undefined): boolean => place !== undefined && whirls.growthRateAt(place) > 0;
  const textAt = (place: Place | undefined): string => speedText(whirls.speeds[place?.['speed'] ?? 0] ?? NaN);
  const [lowest] = known;
  let [onsetText, onsetMore] = ['–', ''];
  if (grows(lowest)) {
    onsetText = `below ${textAt(lowest)}`;
    onsetMore = lowest && whirls.numberAt('of_foils', lowest) === 1 ? 'the foils are unstable there' : '';
  } else if (lowest && !known.some(grows)) {
    onsetText = `above ${textAt(known[known.length - 1])}`;
  }
  return { onset: NaN, onsetText, onsetMore };
}

export class RotorView {
  readonly root: HTMLElement;
  private readonly caption = el('p', { class: 'note', role: 'status' });
  private readonly add = el('button', { type: 'button', class: 'quiet' }, 'Add this rotor to the case');
  private readonly notes = el('div');
  private readonly place = el('div');
  private readonly speed = new NumberControl(() => this.refresh());
  private views: RotorViews | undefined;
  private designs: { now: Design; before: Design } | undefined;
  /** Speeds of the case when it was last read. */
  private said = '';
  /** What the answers are to, or will be. */
  private begun = '';
  /** Answers to what is shown, by their requests. */
  private known = new Map<string, Answer>();

  /**
   * @param quick      for the answers that come first
   * @param withRotor  gives a case that has no rotor the usual one
   * @param change     takes a case in the place of that which is worked on
   */
  constructor(
    private readonly quick: Solver,
    private readonly slow: Solver,
    private readonly withRotor: (text: string) => string,
    change: (text: string) => void,
  ) {
    this.speed.call('Speed', 'rpm', [1000, 120000, 500]);
    this.speed.value = 45000;
    this.add.addEventListener('click', () => this.designs && change(this.withRotor(this.designs.now.text)));
    this.root = el('div', { class: 'rotor' }, el('div', { class: 'tools', role: 'group', 'aria-label': 'Rotor' }, this.speed.root, this.add), this.caption, this.notes, this.place);
  }

  show(now: Design, before: Design): void {
    this.designs = { now, before };
    const { speeds, own } = speedsIn(now);
    const said = JSON.stringify([speeds, own]);
    if (own !== undefined && said !== this.said) this.speed.value = own / rpm;
    this.said = said;
    this.refresh();
  }

  /** Computes what is in sight, unless it has begun. */
  refresh(): void {
    if (!isSeen(this.root) || !this.designs) return;
    const { now, before } = this.designs;
    this.add.hidden = hasRotor(now);
    const speed = this.speed.value * rpm;
    if (!Number.isFinite(speed)) {
      this.caption.textContent = 'Enter the speed as a number.';
      this.begun = '';
      this.root.setAttribute('aria-busy', 'false');
      return;
    }
    const designs = now.text === before.text ? [now] : [now, before];
    const wanted = JSON.stringify([designs.map(({ text }) => text), speed]);
    if (wanted === this.begun) return;
    this.begun = wanted;
    this.root.setAttribute('aria-busy', 'true');
    void this.compute(wanted, designs, speed);
  }

  /** What answers soon, and once the design has settled what answers exactly. */
  private async compute(wanted: string, designs: Design[], speed: number): Promise<void> {
    const began = performance.now();
    const requests = designs.map((design): [Request, Request] => {
      const text = hasRotor(design) ? design.text : this.withRotor(design.text);
      const speeds = withSpeed(speedsIn(design).speeds ?? usualSpeeds.map((ratio) => ratio * speed), speed);
      return [
        { what: 'stability', text, speeds: fewOf(speeds, speed), mesh: quickMesh },
        { what: 'stability', text, speeds },
      ];
    });
    const keys = requests.map((pair) => pair.map((request) => JSON.stringify(request)));
    this.known = new Map([...this.known].filter(([key]) => keys.flat().includes(key)));
    for (const quick of [true, false]) {
      if (!quick) await new Promise((resolve) => setTimeout(resolve, Math.max(0, began + settled - performance.now())));
      for (const [i, pair] of requests.entries()) {
        const key = at(at(keys, i), quick ? 0 : 1);
        while (!this.known.has(key)) {
          // What is no longer in sight begins anew when it is looked at again.
          if (!isSeen(this.root)) this.begun = '';
          if (this.begun !== wanted) return;
          // Without one, a change or another request came first.
          const answer = await (quick ? this.quick : this.slow).ask<StabilityAnswer>(quick ? pair[0] : pair[1]);
          if (answer) this.known.set(key, answer);
        }
        const [now, before] = keys.map((pairs) => this.known.get(at(pairs, quick ? 0 : 1)));
        if (now) this.draw(now, before && !isRefused(before) ? before : undefined, speed, at(designs, 0), quick);
        if (this.begun !== wanted) return;
      }
      this.root.dataset[quick ? 'quick' : 'answered'] = String(Number(this.root.dataset[quick ? 'quick' : 'answered'] ?? 0) + 1);
      if (quick) this.root.dataset['took'] = (performance.now() - began).toFixed(0);
    }
    this.root.setAttribute('aria-busy', 'false');
  }

  private draw(now: Answer, before: StabilityAnswer | undefined, speed: number, design: Design, quick: boolean): void {
    this.place.classList.toggle('stale', isRefused(now));
    if (isRefused(now)) {
      this.caption.textContent = `This rotor cannot be computed${this.views ? '; showing the last valid results' : ''}.`;
      this.notes.replaceChildren(...remarks(now.errors.map(({ message }) => message)));
      return;
    }
    const { mass } = now.run.summary.case['rotor'] as { mass?: number };
    const of = mass === undefined ? '' : ` of ${Number(mass.toPrecision(4))} kg`;
    const rotor = hasRotor(design) ? `Rotor${of}.` : `The case has no rotor. A rotor${of} is assumed: half of it on each of two equal bearings, weight along −Y.`;
    this.caption.textContent = `${rotor} ${quick ? 'Preview on a coarse mesh; the result on the mesh of the case follows …' : 'On the mesh of the case.'}`;
    this.notes.replaceChildren(...remarks(notesOf(now.run)));
    if (!this.views) {
      this.views = new RotorViews(now, speed);
      this.place.replaceChildren(this.views.root);
    }
    this.views.show(now, before, speed);
  }
}

function hasRotor({ answer }: Design): boolean {
  return answer.run.summary.case['rotor'] !== undefined;
}
