/** What the page has fields for, and between which values their sliders go; SI. Whatever a field is given is computed. */

export interface Group {
  /** Of the table in the case file. */
  path: string;
  /** It can be added to the case and taken out of it. */
  optional: boolean;
  open: boolean;
  /** There may be several of it, counted from 1. */
  list?: true;
  /** Key that counts it: the list has as many tables as that says, or none. */
  countedBy?: string;
}

export const groups: Group[] = [
  { path: 'bearing', optional: false, open: true },
  { path: 'bump_foil', optional: false, open: true },
  { path: 'top_foil', optional: false, open: true },
  { path: 'friction', optional: false, open: true },
  { path: 'pad', optional: true, open: false, list: true },
  { path: 'equilibrium', optional: true, open: false },
  { path: 'width', optional: false, open: false },
  { path: 'cycle', optional: true, open: false },
  { path: 'bearing.sleeve_waviness', optional: true, open: false, list: true },
  { path: 'bearing.journal_waviness', optional: true, open: false, list: true },
  { path: 'bump_foil.section', optional: true, open: false, list: true },
  { path: 'bump_foil.shim', optional: true, open: false, list: true },
  { path: 'bump_foil.strip', optional: true, open: false, list: true, countedBy: 'bump_foil.strips' },
  { path: 'bump_foil.truss', optional: true, open: false },
  { path: 'gas', optional: false, open: false },
  { path: 'film', optional: false, open: false },
  { path: 'rotor', optional: true, open: false },
  { path: 'stability', optional: true, open: false },
  { path: 'solver', optional: false, open: false },
  { path: 'montecarlo', optional: true, open: false },
];

/** Of these keys a case gives one: whoever sets one takes out the other. */
export const alternatives = [
  ['bearing.radius', 'bearing.diameter'],
  ['cycle.amplitude', 'cycle.load'],
  ['gas.preset', 'gas.viscosity'],
  ['width.tilt', 'width.moment'],
];

/** Lists of two numbers, along X and Y. */
export const pairs = ['width.tilt', 'width.moment', 'rotor.gravity'];

/** Keys of the tables above that nothing here answers to, or that come from files: of films over walls in place of foils, of limits, matrices. */
export const without = ['film.wall', 'film.wall_stiffness', 'film.closed', 'film.h_lift_off', 'equilibrium.limits', 'equilibrium.ross_version', 'montecarlo.limits', ...['M', 'C', 'G', 'K'].map((name) => `rotor.matrix.${name}`)];

/** One key that stands for several: whoever sets one of these gives the others what it was, and takes it out. */
export const commons = [{ once: 'friction.coefficient', each: ['friction.top_bump', 'friction.bump_sleeve'] }];

const [um, mm, deg, GPa, MN] = [1e-6, 1e-3, Math.PI / 180, 1e9, 1e6];

/** Ends of the slider, and its step where that is not a fine one; of lists those of the first. */
export const ranges: Record<string, [least: number, most: number, step?: number]> = {
  'bearing.radius': [5 * mm, 60 * mm],
  'bearing.diameter': [10 * mm, 120 * mm, 0.5 * mm],
  'bearing.axial_length': [5 * mm, 120 * mm],
  'bearing.radial_clearance': [-40 * um, 160 * um],
  'bearing.weld_angle': [0, 360 * deg, 1 * deg],
  'bearing.taper': [-50 * um, 50 * um],
  'bearing.sleeve_waviness[1].harmonic': [1, 12, 1],
  'bearing.sleeve_waviness[1].amplitude': [0, 30 * um],
  'bearing.sleeve_waviness[1].phase': [0, 360 * deg, 1 * deg],
  'bearing.journal_waviness[1].harmonic': [1, 12, 1],
  'bearing.journal_waviness[1].amplitude': [0, 30 * um],
  'bearing.journal_waviness[1].phase': [0, 360 * deg, 1 * deg],
  'bump_foil.shim[1].thickness': [0, 100 * um],
  'bump_foil.strip[1].stagger': [0, 5 / 6, 1 / 6],
  'bump_foil.strip[1].thickness': [0.03 * mm, 0.3 * mm],
  'pad[1].weld_angle': [0, 360 * deg, 1 * deg],
  'pad[1].arc': [20 * deg, 180 * deg, 1 * deg],
  'pad[1].lobe': [0, 60 * um],
  'bearing.pad_gap': [0, 60 * deg, 1 * deg],
  'bump_foil.bumps': [3, 60, 1],
  'bump_foil.pitch': [1 * mm, 12 * mm],
  'bump_foil.length': [0.5 * mm, 10 * mm],
  'bump_foil.height': [0.15 * mm, 1.5 * mm],
  'bump_foil.thickness': [0.03 * mm, 0.3 * mm],
  'bump_foil.strips': [1, 7, 1],
  'bump_foil.strip_gap': [0, 10 * mm, 0.1 * mm],
  'bump_foil.youngs_modulus': [50 * GPa, 300 * GPa],
  'bump_foil.poisson_ratio': [0, 0.49, 0.01],
  'top_foil.thickness': [0.03 * mm, 0.4 * mm],
  'top_foil.youngs_modulus': [50 * GPa, 300 * GPa],
  'top_foil.poisson_ratio': [0, 0.49, 0.01],
  'friction.coefficient': [0, 1, 0.01],
  'friction.top_bump': [0, 1, 0.01],
  'friction.bump_sleeve': [0, 1, 0.01],
  'cycle.amplitude': [1 * um, 200 * um],
  'cycle.load': [1, 500],
  'cycle.steps': [10, 200, 5],
  'cycle.cycles': [1, 20, 1],
  'gas.temperature': [200, 900, 1],
  'gas.ambient_pressure': [1e4, 1e6],
  'gas.mean_free_path': [0, 0.5 * um],
  'rotor.mass': [0.1, 20],
  'rotor.gravity[1]': [-20, 20],
  'width.modes': [1, 5, 1],
  'width.tilt[1]': [-0.5e-3, 0.5e-3],
  'width.moment[1]': [-0.5, 0.5],
  'width.conicity': [-50 * um, 50 * um],
  'width.crowning': [-50 * um, 50 * um],
  'film.columns_per_pitch': [4, 12, 2],
  'film.rows': [4, 24, 1],
  'film.h_floor': [0, 2 * um],
  'bump_foil.truss.k1': [1 * MN, 500 * MN],
  'bump_foil.truss.k2': [0.1 * MN, 50 * MN],
  'bump_foil.truss.k3': [0.1 * MN, 20 * MN],
  'bump_foil.truss.k4': [0.1 * MN, 100 * MN],
  'bump_foil.truss.theta_d': [2 * deg, 60 * deg],
};
