/** Where the foils of a bearing or a strip are. Nothing is drawn here. */
import { at, largest, type Run } from '../data/run';

/** Foils of their own, from a weld to a free end; a bearing without pads and a strip have one. Places along are from the weld. */
export interface Pad {
  /** "pad 2"; empty where there is one alone. */
  readonly name: string;
  readonly firstBump: number;
  readonly firstFoot: number;
  readonly feet: number;
  /** Where the pitch of each of its bumps begins, and where the last one ends. */
  readonly borders: number[];
  readonly length: number;
  /** Polar angle of the weld. */
  readonly weldAngle: number;
  /** Along the foils: +1 counterclockwise, -1 clockwise. */
  readonly sense: number;
  /** Displacement of the centre of its circle away from its middle. */
  readonly lobe: number;
  /** Where the weld is when all pads are laid flat, one behind the other. */
  readonly begin: number;
}

/** A sheet under bumps of a pad, between two places along it, m. */
export interface Shim {
  pad: Pad;
  begin: number;
  end: number;
  thickness: number;
}

interface FoilOfCase {
  shim?: { from: number; to: number; thickness: number }[];
}

/** Of each pad of the results, which of the case it is: those of a split top foil are strip after strip. */
function padOfCase(run: Run, number: number): number {
  return Math.floor(number / Math.max(1, ...run.perNode('pad_strip')));
}

function shimsOf(run: Run, pads: Pad[]): Shim[] {
  const { case: input } = run.data.summary;
  const own = (input['pad'] ?? []) as { bump_foil?: FoilOfCase }[];
  return pads.flatMap((pad, number) => {
    const foil = own[padOfCase(run, number)]?.bump_foil ?? (input['bump_foil'] as FoilOfCase | undefined);
    const last = pad.borders.length - 1; // a strip may have fewer bumps than the foil
    return (foil?.shim ?? [])
      .filter(({ from }) => from <= last)
      .map(({ from, to, thickness }) => ({ pad, begin: at(pad.borders, from - 1), end: at(pad.borders, Math.min(to, last)), thickness }));
  });
}

/** Numbers per bump: of each, or one for all. */
function ofBumps(run: Run, name: string): number[] {
  const each = run.perNode(name);
  return each.length > 0 ? each : Array.from({ length: run.bumps }, () => run.scalar(name));
}

function padsOf(run: Run): Pad[] {
  const { case: input } = run.data.summary;
  const bearing = (input['bearing'] ?? {}) as { weld_angle?: number; wrap?: string };
  const given = (input['pad'] ?? []) as { weld_edge?: string }[];
  const pitches = ofBumps(run, 'bump_pitch');
  const wound = bearing.wrap === 'counterclockwise' ? 1 : -1;
  const owners = (node: 'bump' | 'foot', count: number): number[] => {
    const each = run.perNode(`${node}_pad`);
    return each.length > 0 ? each : Array.from({ length: count }, () => 1);
  };
  const [bumps, feet] = [owners('bump', run.bumps), owners('foot', run.feet)];
  const pads: Pad[] = [];
  let begin = 0;
  for (let number = 1; number <= run.pads; number += 1) {
    const borders = pitches.filter((_, bump) => bumps[bump] === number).reduce((places, pitch) => [...places, at(places, places.length - 1) + pitch], [0]);
    const length = at(borders, borders.length - 1);
    pads.push({
      name: run.pads > 1 ? `pad ${number}` : '',
      firstBump: bumps.indexOf(number),
      firstFoot: feet.indexOf(number),
      feet: feet.filter((pad) => pad === number).length,
      borders,
      length,
      weldAngle: run.perNode('pad_weld_angle')[number - 1] ?? bearing.weld_angle ?? Math.PI,
      sense: given[padOfCase(run, number - 1)]?.weld_edge === 'trailing' ? -wound : wound,
      lobe: run.perNode('pad_lobe')[number - 1] ?? 0,
      begin,
    });
    begin += length + Math.max(...pitches);
  }
  return pads;
}

/** Of lines of graded foils: all are to be seen, and none covers what is beside it. */
const [leastWeight, mostWeight] = [0.4, 2.6];

/** What does not change while the journal moves. */
export class BearingGeometry {
  readonly radius: number;
  readonly pads: Pad[];
  readonly shims: Shim[];
  readonly halfLengths: number[];
  /** Of the tallest bump: there the top foil lies, and all arcs are drawn as high. */
  readonly rise: number;
  readonly clearance: number;
  readonly crestPlaces: number[];
  readonly footPlaces: number[];
  readonly crestOffsets: number[];
  /** Of the bump foil at each bump; all 0 in results that do not have it. */
  readonly thicknesses: number[];
  readonly sleeveGaps: number[];
  readonly twoFeet: boolean;
  readonly topFoil: boolean;
  /** A strip may be free at both ends. */
  readonly welded: boolean;
  private farthest: Reach | undefined;

  constructor(readonly run: Run) {
    this.radius = run.scalar('bearing_radius');
    this.pads = padsOf(run);
    this.shims = shimsOf(run, this.pads);
    this.halfLengths = ofBumps(run, 'bump_half_length');
    this.rise = Math.max(...ofBumps(run, 'bump_rise'));
    this.clearance = run.scalar('radial_clearance');
    const places = (flat: string, round: string): number[] =>
      run.kind.flat ? run.perNode(flat) : run.perNode(round).map((angle) => angle * this.radius);
    this.crestPlaces = places('crest_position', 'theta');
    this.footPlaces = places('foot_position', 'foot_theta');
    const offsets = run.perNode('crest_offset');
    this.crestOffsets = offsets.length > 0 ? offsets : run.perNode('height_error');
    this.thicknesses = ofBumps(run, 'bump_thickness');
    this.sleeveGaps = run.perNode('sleeve_gap');
    this.twoFeet = run.feet === 2 * run.bumps;
    this.topFoil = run.interfaces.some(({ name }) => name === 'journal_top');
    this.welded = (run.data.summary.case['strip'] as { weld?: string } | undefined)?.weld !== 'none';
  }

  /** Of all pads laid flat. */
  get length(): number {
    const last = at(this.pads, this.pads.length - 1);
    return last.begin + last.length;
  }

  /** How far the foils of the run move at most. */
  get reach(): Reach {
    this.farthest ??= reachOf(this);
    return this.farthest;
  }

  padOfBump(bump: number): Pad {
    return at(this.pads.filter(({ firstBump }) => firstBump <= bump).slice(-1), 0);
  }

  padOfFoot(foot: number): Pad {
    return at(this.pads.filter(({ firstFoot }) => firstFoot <= foot).slice(-1), 0);
  }

  polarAngle(pad: Pad, along: number): number {
    return pad.weldAngle + (pad.sense * along) / this.radius;
  }

  /** By which the lobe of a pad brings its foils and the sleeve under them inwards. */
  lobeAt(pad: Pad, along: number): number {
    return pad.lobe === 0 ? 0 : pad.lobe * Math.cos((along - 0.5 * pad.length) / this.radius);
  }

  /** How wide the line of a bump is drawn against that of a foil that is as thick everywhere: with the stiffness of the sheet. */
  lineWeight(bump: number): number {
    const mean = this.thicknesses.reduce((sum, one) => sum + one, 0) / this.thicknesses.length;
    return this.isGraded ? Math.min(Math.max(leastWeight, (at(this.thicknesses, bump) / mean) ** 3), mostWeight) : 1;
  }

  /** Whether the bump foil is not as thick everywhere. */
  get isGraded(): boolean {
    return new Set(this.thicknesses).size > 1;
  }

  /** Height of the arc of a bump at a distance from its crest. */
  arc(bump: number, distance: number): number {
    const radius = (at(this.halfLengths, bump) ** 2 + this.rise ** 2) / (2 * this.rise);
    return Math.sqrt(radius ** 2 - distance ** 2) - (radius - this.rise);
  }

  /** The bump whose pitch a place along all pads laid flat lies in, or the nearest one. */
  bumpAt(flat: number): number {
    const pad = at(this.pads.filter(({ begin }, i) => i === 0 || begin <= flat).slice(-1), 0);
    const bumps = pad.borders.length - 1;
    const number = pad.borders.filter((border) => border <= flat - pad.begin).length - 1;
    return pad.firstBump + Math.min(Math.max(0, number), bumps - 1);
  }

  /** Feet at the start and the end of a bump's arc; none at the start of the first one of a truss that is welded there. */
  feetOf(bump: number): [number | undefined, number] {
    if (this.twoFeet) return [2 * bump, 2 * bump + 1];
    if (this.run.feet > this.run.bumps) return [bump, bump + 1];
    return [bump > this.padOfBump(bump).firstBump ? bump - 1 : undefined, bump];
  }
}

/** How far a run moves at most, whatever the increment (m). */
export interface Reach {
  /** Along the foil, either way. */
  along: number;
  /** Of the parts of the foils and, in a flat one, of the plate: most inwards, and most outwards (negative). */
  inwards: number;
  outwards: number;
}

function reachOf(geometry: BearingGeometry): Reach {
  const { cycles, kind } = geometry.run;
  const extremes = (name: string, sign: number): [number, number] => {
    let [least, most] = [0, 0];
    for (const cycle of cycles) {
      for (const value of cycle.field(name).values) {
        if (sign * value > most) most = sign * value;
        if (sign * value < least) least = sign * value;
      }
    }
    return [least, most];
  };
  const error = [Math.min(0, ...geometry.crestOffsets), Math.max(0, ...geometry.crestOffsets)] as const;
  const crest = extremes('crest_v', -1);
  const ranges: (readonly [number, number])[] = [
    [crest[0] + error[0], crest[1] + error[1]],
    extremes('foot_v', -1),
    extremes('top_displacement', -1),
    [-Math.max(0, ...geometry.sleeveGaps), 0],
    ...(kind.flat ? cycles.map((cycle): [number, number] => [-Math.max(0, ...cycle.values('displacement')), -Math.min(0, ...cycle.values('displacement'))]) : []),
  ];
  return {
    along: largest(...cycles.flatMap((cycle) => ['crest_u', 'foot_u'].map((name) => cycle.field(name).values))),
    inwards: Math.max(...ranges.map(([, most]) => most)),
    outwards: Math.min(...ranges.map(([least]) => least)),
  };
}
