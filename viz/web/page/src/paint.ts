// From the grids of a moment to colours and shapes, and to the keys that explain them.
import { ColourMap, palette, Rgb } from './colours';
import { colourAll, Field, fieldsOf, Range, usualRange } from './fields';
import { figure } from './quantities';
import { height, paint, Scene } from './scene';
import { Grid, Snapshot } from './server';
import { polygons, quads } from './shapes';

export interface Settings {
  discs: boolean;
  discColour: string; // 'plain' or a field's id
  pores: boolean;
  bonds: boolean;
  cracks: boolean;
  crackColour: string; // 'mode', 'fracture' or a field's id
  crackWidth: 'even' | 'aperture';
  joints: boolean;
  jointColour: string; // a field's id
  range: 'last' | 'shown' | 'held';
}

export const usualSettings: Settings = {
  discs: true, discColour: 'plain', pores: true, bonds: false, cracks: true,
  crackColour: 'mode', crackWidth: 'even', joints: true, jointColour: 'joint-aperture', range: 'last',
};

/** The grids of one snapshot; null: not there, or not asked for. */
export interface Moment {
  snapshot: Snapshot;
  discs: Grid;
  cracks: Grid | null;
  flow: Grid | null;
  bonds: Grid | null;
  /** Contacts of smooth joints. */
  joints: Grid | null;
  /** What pressures mean in this run, if it must be said. */
  pressureNote?: string;
}

export type Key =
  | { kind: 'scale'; title: string; note?: string; map: ColourMap; range: Range; unit: string }
  | { kind: 'swatches'; title: string; note?: string; entries: { colour: Rgb; text: string }[] };

const shearMode = 2; // in the array mode; 1 is tension

function fieldOfDiscs(grid: Grid, id: string): Field | null {
  return fieldsOf('discs', grid).find((field) => field.id === id) ?? null;
}

export class Painter {
  private held = new Map<string, Range>();
  private cached = new Map<string, Range>();
  meanRadius = 1;

  constructor(private scene: Scene) {}

  /** Another run: ranges that were held, and all that is known. */
  forget(): void {
    this.held.clear();
    this.cached.clear();
  }

  /** Draws `now`; scales follow `reference`, the moment that settings.range names. */
  paint(now: Moment, reference: Moment, settings: Settings): Key[] {
    const keys: Key[] = [];
    this.meanRadius = mean(now.discs.values('radius_m')) || this.meanRadius;
    this.paintDiscs(now, reference, settings, keys);
    this.paintPores(now, reference, settings, keys);
    this.paintBonds(now, settings, keys);
    this.paintCracks(now, reference, settings, keys);
    this.paintJoints(now, reference, settings, keys);
    return keys;
  }

  private range(field: Field, now: Grid, reference: Grid, mode: Settings['range'], key: string): Range {
    const from = mode === 'last' ? reference : now;
    const known = mode === 'held' ? this.held.get(key) : undefined;
    if (known) return known;
    const values = from.values(field.array);
    const width = from.arrays.get(field.array)?.components ?? 1;
    const stored = `${key} ${from.time} ${values.length}`;
    const range = this.cached.get(stored) ?? usualRange(field, values, values.length / width);
    this.cached.set(stored, range);
    this.held.set(key, range);
    return range;
  }

  private scale(keys: Key[], field: Field, range: Range, note = field.note): ColourMap {
    const map = field.map(palette());
    keys.push({ kind: 'scale', title: field.name, note, map, range, unit: field.unit });
    return map;
  }

  private paintDiscs(now: Moment, reference: Moment, settings: Settings, keys: Key[]): void {
    if (!settings.discs) return this.scene.discs.hide();
    const grid = now.discs;
    const count = grid.points;
    const field = fieldOfDiscs(grid, settings.discColour);
    let colours: Uint8Array;
    if (field && grid.arrays.has(field.array)) {
      this.scene.discs.setHeight(height.discs);
      const range = this.range(field, grid, reference.discs, settings.range, `discs ${field.id}`);
      colours = colourAll(field, grid.values(field.array), count, range, this.scale(keys, field, range));
    } else {
      // Pores cover the plane, so plain discs are drawn above them, as outlines.
      const outlined = settings.pores && now.flow !== null;
      this.scene.discs.setHeight(outlined ? height.outlines : height.discs);
      colours = new Uint8Array(4 * count);
      for (let i = 0; i < count; ++i) paint(colours, i, palette().disc, outlined ? 0 : 255);
    }
    this.scene.discs.show(grid.positions, grid.values('radius_m'), colours, this.scene.view);
  }

  private paintPores(now: Moment, reference: Moment, settings: Settings, keys: Key[]): void {
    const grid = now.flow;
    if (!settings.pores || !grid) return this.scene.pores.show(null);
    const field = fieldsOf('flow', grid).find(({ id }) => id === 'pressure');
    if (!field) return this.scene.pores.show(null);
    const range = this.range(field, grid, reference.flow ?? grid, settings.range, 'pores');
    const map = this.scale(keys, field, range, now.pressureNote);
    const colours = colourAll(field, grid.values(field.array), grid.cells, range, map);
    this.scene.pores.show(polygons(grid.positions, grid.values('#first'), grid.values('#corner'), colours));
  }

  private paintBonds(now: Moment, settings: Settings, keys: Key[]): void {
    const grid = now.bonds;
    if (!settings.bonds || !grid) return this.scene.bonds.show(null);
    const force = grid.values('normal_force_N');
    const state = grid.values('state');
    const { pull, push } = palette();
    const largest = usualRange({ signed: false, value: (v, i) => Math.abs(v[i]) }, force, force.length).high;
    const colours = new Uint8Array(4 * grid.cells);
    for (let i = 0; i < grid.cells; ++i) paint(colours, i, force[i] > 0 ? pull : push);
    const least = 0.5 * this.scene.view.metresPerPixel();
    const half = (i: number) =>
      state[i] !== 0 ? 0 : Math.max(least, 0.3 * this.meanRadius * Math.min(1, Math.abs(force[i]) / largest));
    this.scene.bonds.show(quads(grid.cells, this.ends(grid), half, colours));
    keys.push({
      kind: 'swatches', title: 'Forces across bonds', note: `width by force; widest ${figure(largest / 1e6, 3)} MN`,
      entries: [{ colour: push, text: 'compression' }, { colour: pull, text: 'tension' }],
    });
  }

  private paintCracks(now: Moment, reference: Moment, settings: Settings, keys: Key[]): void {
    const grid = now.cracks;
    if (!settings.cracks || !grid || grid.cells === 0) {
      this.scene.halo.show(null);
      return this.scene.cracks.show(null);
    }
    const colours = this.crackColours(grid, reference.cracks ?? grid, settings, keys);
    const pixel = this.scene.view.metresPerPixel() * this.scene.pixelRatio;
    const opening = grid.values('aperture_m');
    const enlarged = settings.crackWidth === 'aperture' ? this.enlargement(reference.cracks ?? grid) : 0;
    const half = (i: number) =>
      enlarged > 0
        ? Math.max(0.6 * pixel, (Math.max(0, opening[i]) * enlarged) / 2)
        : Math.max(1.3 * pixel, 0.14 * this.meanRadius);
    if (enlarged > 0) keys[keys.length - 1].note = `widths are apertures × ${enlarged}`;
    const ends = this.ends(grid);
    const paper = new Uint8Array(4 * grid.cells);
    for (let i = 0; i < grid.cells; ++i) paint(paper, i, palette().paper, 170);
    this.scene.halo.show(quads(grid.cells, ends, (i) => half(i) + pixel, paper));
    this.scene.cracks.show(quads(grid.cells, ends, half, colours));
  }

  private crackColours(grid: Grid, reference: Grid, settings: Settings, keys: Key[]): Uint8Array {
    const field = fieldsOf('cracks', grid).find(({ id }) => id === settings.crackColour);
    if (field && grid.arrays.has(field.array)) {
      const range = this.range(field, grid, reference, settings.range, `cracks ${field.id}`);
      return colourAll(field, grid.values(field.array), grid.cells, range, this.scale(keys, field, range));
    }
    const colours = new Uint8Array(4 * grid.cells);
    const { tension, shear, series } = palette();
    if (settings.crackColour === 'fracture') {
      const fracture = grid.values('fracture');
      for (let i = 0; i < grid.cells; ++i) paint(colours, i, series[Math.max(0, fracture[i]) % series.length]);
      keys.push({ kind: 'swatches', title: 'Cracks by fracture', note: 'colours repeat', entries: [] });
      return colours;
    }
    const mode = grid.values('mode');
    for (let i = 0; i < grid.cells; ++i) paint(colours, i, mode[i] === shearMode ? shear : tension);
    keys.push({
      kind: 'swatches', title: 'Cracks',
      entries: [{ colour: tension, text: 'tension' }, { colour: shear, text: 'shear' }],
    });
    return colours;
  }

  /** Over the cracks: each contact of a broken joint is one of them, too. */
  private paintJoints(now: Moment, reference: Moment, settings: Settings, keys: Key[]): void {
    const grid = now.joints;
    const field = settings.joints && grid ? fieldsOf('joints', grid).find(({ id }) => id === settings.jointColour) : null;
    if (!grid || !field) return this.scene.joints.show(null);
    const pixel = this.scene.view.metresPerPixel() * this.scene.pixelRatio;
    const half = Math.max(2 * pixel, 0.25 * this.meanRadius);
    const colours = field.states
      ? this.stateColours(grid.values(field.array), field, keys)
      : this.jointColours(grid, reference.joints ?? grid, field, settings, keys);
    this.scene.joints.show(quads(grid.cells, this.ends(grid), () => half, colours));
  }

  private jointColours(grid: Grid, reference: Grid, field: Field, settings: Settings, keys: Key[]): Uint8Array {
    const range = this.range(field, grid, reference, settings.range, `joints ${field.id}`);
    return colourAll(field, grid.values(field.array), grid.cells, range, this.scale(keys, field, range));
  }

  private stateColours(values: ArrayLike<number>, field: Field, keys: Key[]): Uint8Array {
    const { faint, push, shear, tension } = palette();
    const signs = [faint, push, shear, tension];
    const colours = new Uint8Array(4 * values.length);
    for (let i = 0; i < values.length; ++i) paint(colours, i, signs[Math.min(3, Math.max(0, values[i]))]);
    const entries = (field.states ?? []).map((text, i) => ({ colour: signs[i], text }));
    keys.push({ kind: 'swatches', title: field.name, entries });
    return colours;
  }

  /** The round factor by which the widest crack becomes as wide as a disc's radius. */
  private enlargement(grid: Grid): number {
    let widest = 0;
    for (const aperture of grid.values('aperture_m')) widest = Math.max(widest, aperture);
    if (!(widest > 0)) return 1;
    const wanted = this.meanRadius / widest;
    if (wanted <= 1) return 1;
    const power = 10 ** Math.floor(Math.log10(wanted));
    return power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1);
  }

  private ends(grid: Grid) {
    const [position, first, corner] = [grid.positions, grid.values('#first'), grid.values('#corner')];
    return (i: number): [number, number, number, number] => {
      const [a, b] = [2 * corner[first[i]], 2 * corner[first[i] + 1]];
      return [position[a], position[a + 1], position[b], position[b + 1]];
    };
  }
}

function mean(values: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < values.length; ++i) sum += values[i];
  return values.length ? sum / values.length : 0;
}
