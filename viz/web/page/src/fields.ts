// What discs and cracks can be coloured by: how a value comes out of the arrays of a grid, its unit, and the
// scale that suits it. Arrays nobody wrote about here are offered by their own name, so a new one shows up by
// itself.
import { ColourMap, Palette } from './colours';
import { nameOf } from './quantities';
import { Grid, Numbers } from './server';

export interface Field {
  id: string;
  name: string;
  unit: string;
  /** The array it is made of. */
  array: string;
  value(values: Numbers, i: number): number;
  /** Symmetric about zero, in two colours. */
  signed: boolean;
  /** Smooths over the whole range instead of the middle 98 %. */
  whole?: boolean;
  note?: string;
  map(palette: Palette): ColourMap;
}

const magnitude = (palette: Palette) => palette.magnitude;
const twoWays = (palette: Palette) => palette.twoWays;
const narrow = (palette: Palette) => palette.narrow;

const stress = 'stress_Pa';

export const discFields: Field[] = [
  {
    id: 'displacement', name: 'Displacement', unit: 'm', array: 'displacement_m', signed: false, map: magnitude,
    value: (v, i) => Math.hypot(v[2 * i], v[2 * i + 1]), note: 'since the initial equilibration',
  },
  {
    id: 'displacement_x', name: 'Displacement along x', unit: 'm', array: 'displacement_m', signed: true,
    map: twoWays, value: (v, i) => v[2 * i],
  },
  {
    id: 'displacement_y', name: 'Displacement along y', unit: 'm', array: 'displacement_m', signed: true,
    map: twoWays, value: (v, i) => v[2 * i + 1],
  },
  {
    id: 'mean_stress', name: 'Mean stress', unit: 'Pa', array: stress, signed: true, map: twoWays,
    value: (v, i) => (v[3 * i] + v[3 * i + 1]) / 2, note: 'compression positive',
  },
  {
    id: 'shear_stress', name: 'Largest shear stress', unit: 'Pa', array: stress, signed: false, map: magnitude,
    value: (v, i) => Math.hypot((v[3 * i] - v[3 * i + 1]) / 2, v[3 * i + 2]),
  },
  {
    id: 'stress_xx', name: 'Stress xx', unit: 'Pa', array: stress, signed: true, map: twoWays,
    value: (v, i) => v[3 * i], note: 'compression positive',
  },
  {
    id: 'stress_yy', name: 'Stress yy', unit: 'Pa', array: stress, signed: true, map: twoWays,
    value: (v, i) => v[3 * i + 1], note: 'compression positive',
  },
  {
    id: 'stress_xy', name: 'Stress xy', unit: 'Pa', array: stress, signed: true, map: twoWays,
    value: (v, i) => v[3 * i + 2],
  },
  {
    id: 'rotation', name: 'Rotation', unit: 'rad', array: 'rotation_rad', signed: true, map: twoWays,
    value: (v, i) => v[i], note: 'anticlockwise positive',
  },
  {
    id: 'intact_bonds', name: 'Intact bonds', unit: '', array: 'intact_bonds', signed: false, whole: true,
    map: magnitude, value: (v, i) => v[i],
  },
];

export const crackFields: Field[] = [
  {
    id: 'aperture', name: 'Aperture', unit: 'm', array: 'aperture_m', signed: false, whole: true, map: narrow,
    value: (v, i) => v[i],
  },
  {
    id: 'time', name: 'Time of breaking', unit: 's', array: 'time_s', signed: false, whole: true, map: narrow,
    value: (v, i) => v[i],
  },
  {
    id: 'pressure', name: 'Pressure in cracks', unit: 'Pa', array: 'pressure_Pa', signed: false, whole: true,
    map: narrow, value: (v, i) => v[i],
  },
];

export const pressureField: Field = {
  id: 'fluid', name: 'Fluid pressure', unit: 'Pa', array: 'pressure_Pa', signed: false, whole: true,
  map: (palette) => palette.pressure, value: (v, i) => v[i],
};

const known = new Set(['radius_m', 'displacement_m', 'rotation_rad', stress, 'intact_bonds', 'disc_id']);

/** The fields of the discs in this grid. */
export function fieldsOfDiscs(grid: Grid): Field[] {
  const fields = discFields.filter((field) => grid.heads.has(field.array));
  for (const array of grid.heads.values()) {
    if (array.of !== 'points' || array.components !== 1 || known.has(array.name)) continue;
    fields.push({
      id: array.name, name: nameOf(array.name, array.unit), unit: array.unit, array: array.name, signed: false,
      map: magnitude, value: (v, i) => v[i],
    });
  }
  return fields;
}

export interface Range {
  low: number;
  high: number;
}

/** The range a scale shows: all values, or the middle 98 % where single discs stick out. Fields with a sign
 * are shown symmetrically. */
export function usualRange(field: Field, values: Numbers, count: number): Range {
  const step = Math.max(1, Math.floor(count / 100000));
  const sample: number[] = [];
  for (let i = 0; i < count; i += step) {
    const value = field.value(values, i);
    if (Number.isFinite(value)) sample.push(value);
  }
  if (!sample.length) return { low: 0, high: 1 };
  sample.sort((a, b) => a - b);
  const cut = field.whole ? 0 : Math.floor(sample.length * 0.01);
  let low = sample[cut];
  let high = sample[sample.length - 1 - cut];
  if (field.signed) {
    high = Math.max(Math.abs(low), Math.abs(high));
    low = -high;
  } else if (low >= 0 && (!field.whole || field.id === 'aperture')) {
    low = 0;
  }
  if (!(high > low)) high = low + (Math.abs(low) * 1e-3 || 1);
  return { low, high };
}

/** Red, green, blue, opacity of each item. */
export function colourAll(
  field: Field, values: Numbers, count: number, range: Range, map: ColourMap,
): Uint8Array {
  const colours = new Uint8Array(4 * count);
  const table = map.table;
  const factor = 1 / (range.high - range.low);
  for (let i = 0; i < count; ++i) {
    const slot = 3 * ColourMap.slot((field.value(values, i) - range.low) * factor);
    colours[4 * i] = table[slot];
    colours[4 * i + 1] = table[slot + 1];
    colours[4 * i + 2] = table[slot + 2];
    colours[4 * i + 3] = 255;
  }
  return colours;
}
