// What comes from the program: the index of the run, its history, and grids as messages (the format is
// described in viz/web/server/grid.hpp). Addresses are relative, since the page lies below a random key.

export type Series = 'discs' | 'bonds' | 'cracks' | 'flow' | 'joints';

export interface Snapshot {
  step: number;
  time_s: number;
  files: Partial<Record<Series, string>>;
}

export interface Fracture {
  crack_count: number;
  tensile_cracks: number;
  length_m: number;
  extent_m: number;
  reach_m: number;
  azimuth_rad: number;
  mean_aperture_m: number;
  largest_aperture_m: number;
  volume_m2: number;
  mean_pressure_Pa: number;
  well: number;
}

export interface Well {
  x_m: number;
  y_m: number;
  radius_m: number; // of a circle as large as the hole between disc centres
  asked_radius_m?: number; // 0: a pore that was made a well; not there in older runs
}

export interface Summary {
  title?: string;
  stress_convention?: string;
  ended?: string;
  model?: { width_m: number; height_m: number };
  wells?: Well[];
  fractures?: Fracture[];
  state?: { time_s: number };
}

/** One line of viz/run/views.cpp. */
export interface NamedView {
  name: string;
  title: string;
  label: string;
  note: string;
  mesh: string;
  array: string;
  how: 'component' | 'length' | 'mean' | 'shear';
  component: number;
  scale: 'magnitude' | 'two-ways' | 'narrow' | 'pressure' | 'states';
  all_values: boolean;
  /** What values 0, 1, 2, 3 mean, on the scale 'states'. */
  states: string[];
}

export interface RunIndex {
  folder: string;
  there: boolean;
  identity: string;
  running: boolean;
  age_s: number;
  snapshots: Snapshot[];
  summary: Summary | null;
  files: { name: string; bytes: number }[];
  views: NamedView[];
}

export interface Values {
  name: string;
  unit: string;
  parts: string[];
  values: (number | null)[];
}

export type Numbers = Float32Array | Int32Array | Float64Array;

/** What an array is, whether its numbers are here or not. */
export interface ArrayHead {
  name: string;
  of: string;
  unit: string;
  components: number;
}

export interface GridArray extends ArrayHead {
  values: Numbers;
}

/** One decoded VTU file. */
export class Grid {
  readonly arrays = new Map<string, GridArray>();
  /** All arrays of the file, by name. */
  readonly heads = new Map<string, ArrayHead>();
  readonly points: number;
  readonly cells: number;
  readonly time: number;

  constructor(readonly message: ArrayBuffer) {
    const bytes = new DataView(message);
    if (message.byteLength < 8 || bytes.getUint32(0, false) !== 0x48464731)
      throw new Error('the server sent no grid; is it of the same version as the page?');
    const length = bytes.getUint32(4, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(message, 8, length)));
    this.points = head.points;
    this.cells = head.cells;
    this.time = head.time_s;
    for (const array of [...head.arrays, ...head.others]) if (array.of !== 'geometry') this.heads.set(array.name, array);
    for (const array of head.arrays) {
      const place = 8 + length + array.offset;
      const make = { f32: Float32Array, i32: Int32Array, f64: Float64Array }[array.type as 'f32' | 'i32' | 'f64'];
      this.arrays.set(array.of === 'geometry' ? `#${array.name}` : array.name, {
        ...array,
        values: new make(message, place, array.length),
      });
    }
  }

  values(name: string): Numbers {
    return this.arrays.get(name)?.values ?? new Float32Array(0);
  }

  get positions(): Numbers {
    return this.values('#position');
  }
}

async function answerTo(address: string): Promise<Response> {
  const response = await fetch(address, { cache: 'no-store' });
  if (!response.ok) throw new Error((await response.text()).trim() || `the server answered ${response.status}`);
  return response;
}

export async function fetchRun(): Promise<RunIndex> {
  return (await answerTo('api/run')).json();
}

/** The lines of history.csv from byte `from` on; null if the file is shorter, so another run's. */
export async function fetchHistory(from: number): Promise<string | null> {
  const response = await fetch(`api/history?from=${from}`, { cache: 'no-store' });
  if (response.status === 416) return null;
  return response.ok ? response.text() : '';
}

/** A field's pressures over time as a table; empty if there are none. */
export async function fetchRecord(): Promise<string> {
  return (await answerTo('api/record')).text();
}

export async function fetchGrid(file: string, arrays: readonly string[]): Promise<Grid> {
  const chosen = arrays.length ? `&arrays=${arrays.map(encodeURIComponent).join(',')}` : '';
  return new Grid(await (await answerTo(`api/grid?file=${encodeURIComponent(file)}${chosen}`)).arrayBuffer());
}

export async function fetchValues(file: string, of: 'points' | 'cells', index: number): Promise<Values[]> {
  return (await answerTo(`api/values?file=${encodeURIComponent(file)}&of=${of}&index=${index}`)).json();
}
