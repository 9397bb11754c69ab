// What discs, pores, cracks and joints can be coloured by. The list comes with the index of a run: it is the one that the pictures are
// drawn by (viz/run/views.cpp). Other arrays of the discs are offered by their own name, so a new one shows up by itself.
import { ColourMap, Palette } from './colours';
import { nameOf } from './quantities';
import { ArrayHead, Grid, Numbers, NamedView } from './server';

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
  /** Of values that are states: their names. */
  states?: readonly string[];
  map(palette: Palette): ColourMap;
}

const maps: Record<NamedView['scale'], (palette: Palette) => ColourMap> = {
  magnitude: (palette) => palette.magnitude,
  'two-ways': (palette) => palette.twoWays,
  narrow: (palette) => palette.narrow,
  pressure: (palette) => palette.pressure,
  states: (palette) => palette.magnitude,  // not looked at: each state has a colour of its own
};

let views: NamedView[] = [];

export function setViews(list: NamedView[]): void {
  views = list;
}

/** The views that colour what `mesh` names: "discs", "cracks", "flow", "joints". */
export function viewsOf(mesh: string): NamedView[] {
  return views.filter((view) => view.mesh === mesh);
}

function valueOf({ how, component }: NamedView, width: number): Field['value'] {
  if (how === 'length') return (v, i) => Math.hypot(v[width * i], v[width * i + 1]);
  if (how === 'mean') return (v, i) => (v[width * i] + v[width * i + 1]) / 2;
  if (how === 'shear') return (v, i) => Math.hypot((v[width * i] - v[width * i + 1]) / 2, v[width * i + 2]);
  return (v, i) => v[width * i + component];
}

function fieldOf(view: NamedView, head: ArrayHead): Field {
  return {
    id: view.name, name: view.title, unit: head.unit, array: view.array, signed: view.scale === 'two-ways',
    states: view.scale === 'states' ? view.states : undefined,
    whole: view.all_values, note: view.note || undefined, map: maps[view.scale], value: valueOf(view, head.components),
  };
}

/** The fields of `mesh` that this grid has the arrays of. */
export function fieldsOf(mesh: string, grid: Grid): Field[] {
  const fields: Field[] = [];
  const told = new Set(['radius_m', 'disc_id']);
  for (const view of viewsOf(mesh)) {
    const head = grid.heads.get(view.array);
    if (head) fields.push(fieldOf(view, head));
    told.add(view.array);
  }
  if (mesh !== 'discs') return fields;
  for (const array of grid.heads.values()) {
    if (array.of !== 'points' || array.components !== 1 || told.has(array.name)) continue;
    fields.push({
      id: array.name, name: nameOf(array.name, array.unit), unit: array.unit, array: array.name, signed: false,
      map: maps.magnitude, value: (v, i) => v[i],
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
export function usualRange(
  field: Pick<Field, 'signed' | 'value' | 'whole'> & { id?: string }, values: Numbers, count: number,
): Range {
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
