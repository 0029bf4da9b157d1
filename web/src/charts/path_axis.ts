import type { Cycle } from '../data/run';
import { axisTitle, scaleFor, type Scale } from '../data/units';
import type { Look } from '../ui/theme';
import { axis } from './chart';
import { tickText } from './ticks';

/** Journal trajectory: displacement up to the turning point, and back again beyond it. */
export class PathAxis {
  readonly scale: Scale;
  private readonly amplitude: number;
  private readonly end: number;
  /** One push from the start and the way back, the same for all. */
  private readonly same: boolean;

  constructor(cycles: Cycle[]) {
    this.amplitude = Math.max(0, ...cycles.map((cycle) => cycle.amplitude));
    this.same = cycles.every(
      (cycle) =>
        cycle.amplitude === this.amplitude && cycle.lastIncrement === 2 * cycle.steps && cycle.value('displacement', 0) === 0,
    );
    const ways = cycles.map((cycle) => cycle.path(cycle.size - 1)).filter(Number.isFinite);
    this.end = this.same ? 2 * this.amplitude : Math.max(0, ...ways);
    this.scale = scaleFor(this.amplitude, 'm');
  }

  position(cycle: Cycle, index: number): number {
    return cycle.path(index) * this.scale.factor;
  }

  private get turning(): number {
    return this.amplitude * this.scale.factor;
  }

  /** Marked by the displacement; by the way itself where the runs turn at different ones. */
  option(current: Look, width: number, more: object = {}): object {
    const end = this.end * this.scale.factor;
    const values = this.same ? this.ticks(width) : undefined;
    return axis(current, this.same ? axisTitle('Displacement: push, then pull back', this.scale) : axisTitle('Travel, push and pull', this.scale), {
      min: 0,
      max: end,
      axisLabel: {
        color: current.muted,
        fontSize: 12,
        hideOverlap: true,
        formatter: (x: number) => tickText(this.same && x > this.turning ? end - x : x),
        ...(values ? { customValues: values } : {}),
      },
      axisTick: { lineStyle: { color: current.line }, ...(values ? { customValues: values } : {}) },
      splitLine: { show: false },
      ...more,
    });
  }

  private ticks(width: number): number[] {
    const turning = this.turning;
    if (!(turning > 0)) return [0];
    const wanted = turning / Math.max(1, Math.min(6, width / 160));
    const power = 10 ** Math.floor(Math.log10(wanted));
    const step = ([1, 2, 5, 10].find((digit) => digit * power >= wanted) ?? 10) * power;
    const ways: number[] = [];
    for (let x = 0; x < turning - 0.4 * step; x += step) ways.push(x);
    return [...ways, turning, ...ways.map((x) => 2 * turning - x).reverse()];
  }
}
