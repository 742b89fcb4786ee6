// Colours and lines of the style crate. Written by `LITTLEWOOD_WRITE=1 cargo test -p littlewood-web generated::`; do not edit.

import type { Class, Mode } from './tables';

/** Colours of what is not data. */
export const INKS = [
  'paper',
  'ink',
  'soft',
  'faint',
  'line',
  'hatch',
  'region',
  'ground',
  'no_value',
  'mixed',
] as const;
export type Ink = (typeof INKS)[number];

/** Vectors that are drawn at the hoop. */
export const ARROWS = [
  'normal_force',
  'friction_force',
  'slip',
  'impulse',
] as const;
export type Arrow = (typeof ARROWS)[number];

/** Curves of the phase plane. */
export const CURVES = [
  'slip_limit',
  'normal_force_zero',
  'separatrix',
  'lift_off',
  'chatter',
  'level',
  'band_of_rest',
] as const;
export type Curve = (typeof CURVES)[number];

/** Colours for what has none of its own. */
export const ACCENTS = [
  'violet',
  'teal',
  'brown',
] as const;
export type Accent = (typeof ACCENTS)[number];

/** Lines of the plane of impulses. */
export const IMPULSE_LINES = [
  'sticking',
  'greatest_compression',
  'termination',
  'static_cone',
  'kinetic_cone',
] as const;
export type ImpulseLine = (typeof IMPULSE_LINES)[number];

/** Where the energy of the start is, in the order in which the core gives it. */
export const ENERGY_PARTS = [
  'potential',
  'kinetic',
  'lost_to_friction',
  'lost_to_rolling_resistance',
  'lost_in_impacts',
] as const;
export type EnergyPart = (typeof ENERGY_PARTS)[number];

export interface Palette {
  ink: Readonly<Record<Ink, string>>;
  mode: Readonly<Record<Mode, string>>;
  /** A class in a map that lies behind curves. */
  class: Readonly<Record<Class, string>>;
  arrow: Readonly<Record<Arrow, string>>;
  curve: Readonly<Record<Curve, string>>;
  impulse: Readonly<Record<ImpulseLine, string>>;
  energy: Readonly<Record<EnergyPart, string>>;
  accent: Readonly<Record<Accent, string>>;
  /** Classes of landings in a map, the fewer the paler. */
  hops: readonly string[];
  /** The region where the hoop can roll, over whatever is below. */
  region: string;
}

/** The colours on each paper. */
export const PALETTES = {
  light: {
    ink: {
      paper: '#ffffff',
      ink: '#222222',
      soft: '#6b6b6b',
      faint: '#9a9a9a',
      line: '#c4c4c4',
      hatch: '#c2c2c2',
      region: '#e3ecf2',
      ground: '#eceae4',
      no_value: '#e4e4e4',
      mixed: '#f4f4f4',
    },
    mode: {
      rolling: '#004b87',
      sliding: '#bf5300',
      gliding: '#c66d9e',
      flight: '#2e9dd4',
      rest: '#300000',
      skidding: '#300c8a',
    },
    class: {
      leaves_at_once: '#8182a1',
      lifts_off_later: '#edc773',
      rolls_forever: '#d9e5eb',
      repeats_forever: '#739a98',
      slips_forever: '#ad8d7d',
      in_contact: '#b3bbc8',
      particle_at_plane: '#d7cae1',
      particle_at_bottom: '#967b8f',
      particle_at_top: '#aca973',
      painleve: '#737373',
      unresolved: '#a8a8a8',
      invalid: '#f0f0f0',
      not_computed: '#ffffff',
      rests: '#d6eac7',
    },
    arrow: {
      normal_force: '#006d4e',
      friction_force: '#9a1b6a',
      slip: '#7f6100',
      impulse: '#d7263d',
    },
    curve: {
      slip_limit: '#9a1b6a',
      normal_force_zero: '#006d4e',
      separatrix: '#222222',
      lift_off: '#006d4e',
      chatter: '#d7263d',
      level: '#9a9a9a',
      band_of_rest: '#300000',
    },
    impulse: {
      sticking: '#7f6100',
      greatest_compression: '#222222',
      termination: '#222222',
      static_cone: '#9a1b6a',
      kinetic_cone: '#9a1b6a',
    },
    energy: {
      potential: '#693c99',
      kinetic: '#08828e',
      lost_to_friction: '#9a1b6a',
      lost_to_rolling_resistance: '#b08163',
      lost_in_impacts: '#d7263d',
    },
    accent: {
      violet: '#693c99',
      teal: '#08828e',
      brown: '#b08163',
    },
    hops: ['#f9f7fb', '#eae4f1', '#dcd1e7', '#cdbedd', '#bfabd3', '#b098c9', '#a185bf', '#9372b5', '#845fab'],
    region: '#2222221f',
  },
  dark: {
    ink: {
      paper: '#14171d',
      ink: '#eceef2',
      soft: '#aab0bd',
      faint: '#7d8594',
      line: '#3b414d',
      hatch: '#444b58',
      region: '#232b36',
      ground: '#24231f',
      no_value: '#292929',
      mixed: '#060606',
    },
    mode: {
      rolling: '#018de9',
      sliding: '#fb9d52',
      gliding: '#ec98d6',
      flight: '#95e1fa',
      rest: '#fcfcc0',
      skidding: '#7d3fdc',
    },
    class: {
      leaves_at_once: '#898099',
      lifts_off_later: '#4c370d',
      rolls_forever: '#092e3f',
      repeats_forever: '#3c7a77',
      slips_forever: '#88695e',
      in_contact: '#434d5c',
      particle_at_plane: '#41374f',
      particle_at_bottom: '#957c86',
      particle_at_top: '#63600d',
      painleve: '#959799',
      unresolved: '#5d5e61',
      invalid: '#202124',
      not_computed: '#14171d',
      rests: '#163018',
    },
    arrow: {
      normal_force: '#4fd1a1',
      friction_force: '#fe79b7',
      slip: '#f0c44c',
      impulse: '#ff4d4d',
    },
    curve: {
      slip_limit: '#fe79b7',
      normal_force_zero: '#4fd1a1',
      separatrix: '#eceef2',
      lift_off: '#4fd1a1',
      chatter: '#ff4d4d',
      level: '#7d8594',
      band_of_rest: '#fcfcc0',
    },
    impulse: {
      sticking: '#f0c44c',
      greatest_compression: '#eceef2',
      termination: '#eceef2',
      static_cone: '#fe79b7',
      kinetic_cone: '#fe79b7',
    },
    energy: {
      potential: '#9a7fd1',
      kinetic: '#35aab5',
      lost_to_friction: '#fe79b7',
      lost_to_rolling_resistance: '#dcc0ae',
      lost_in_impacts: '#ff4d4d',
    },
    accent: {
      violet: '#9a7fd1',
      teal: '#35aab5',
      brown: '#dcc0ae',
    },
    hops: ['#191b24', '#262536', '#332f47', '#413a59', '#4e446a', '#5b4e7c', '#68588e', '#75629f', '#826cb1'],
    region: '#eceef21f',
  },
} as const satisfies Record<'light' | 'dark', Palette>;

/** Dashes of a line that shows a mode, in units of its width. */
export const MODE_DASHES = {
  rolling: [],
  sliding: [5.0, 2.5],
  gliding: [6.0, 2.0, 1.0, 2.0],
  flight: [1.0, 1.8],
  rest: [6.0, 2.0, 1.0, 2.0, 1.0, 2.0],
  skidding: [2.5, 1.8],
} as const satisfies Record<Mode, readonly number[]>;

export interface LineRow {
  label: string;
  /** In units of the width. */
  dash: readonly number[];
  width: number;
}

export interface CurveRow extends LineRow {
  labelOnSlope: string;
  /** The letter of the paper. */
  letter: string | null;
  /** What it means to the hoop. */
  meaning: string | null;
}

/** The table of curves. */
export const CURVE_ROWS = {
  slip_limit: { label: 'f: |F| = μₛ N in rolling', labelOnSlope: 'f: |F| = μₛ N in rolling', letter: 'f', meaning: 'rolling uses up all friction: beyond it, it slips', dash: [5.0, 2.5], width: 2.4 },
  normal_force_zero: { label: 'n: N = 0 in rolling', labelOnSlope: 'n: N = 0 in rolling', letter: 'n', meaning: 'a rolling hoop would no longer press on the ground', dash: [], width: 2.4 },
  separatrix: { label: 'separatrix', labelOnSlope: 'separatrix', letter: null, meaning: null, dash: [], width: 1.6 },
  lift_off: { label: 'lift-off: h cos θ θ′² = 1', labelOnSlope: 'lift-off: h cos θ θ′² = cos α', letter: null, meaning: 'above it: it leaves the ground at once', dash: [2.5, 1.8], width: 1.6 },
  chatter: { label: 'bounces grow out of rolling', labelOnSlope: 'bounces grow out of rolling', letter: null, meaning: null, dash: [1.0, 1.8], width: 1.6 },
  level: { label: 'orbits of rolling', labelOnSlope: 'orbits of rolling', letter: null, meaning: null, dash: [], width: 0.8 },
  band_of_rest: { label: 'band of rest', labelOnSlope: 'band of rest', letter: null, meaning: 'without motion it stays here: the ground holds it', dash: [], width: 4.8 },
} as const satisfies Record<Curve, CurveRow>;

/** The table of lines of the plane of impulses. */
export const IMPULSE_LINE_ROWS = {
  sticking: { label: 'sticking: u = 0', dash: [6.0, 2.0, 1.0, 2.0], width: 1.6 },
  greatest_compression: { label: 'greatest compression: w = 0', dash: [5.0, 2.5], width: 1.6 },
  termination: { label: 'termination', dash: [], width: 0.8 },
  static_cone: { label: 'friction cone: |J| = μₛ P', dash: [5.0, 2.5], width: 1.6 },
  kinetic_cone: { label: 'friction cone: |J| = μₖ P', dash: [1.0, 1.8], width: 1.6 },
} as const satisfies Record<ImpulseLine, LineRow>;

/** In words. */
export const ENERGY_LABELS = {
  potential: 'potential',
  kinetic: 'kinetic',
  lost_to_friction: 'lost to friction',
  lost_to_rolling_resistance: 'lost to rolling resistance',
  lost_in_impacts: 'lost in impacts',
} as const satisfies Record<EnergyPart, string>;
