// Tables beside the picture: the state of the run at the moment shown, the values of what is selected, the
// fractures.
import { find, make } from './dom';
import { History } from './history';
import { figure, nameOf, pretty, quantity } from './quantities';
import { Fracture, RunIndex, Values } from './server';

const row = (name: string, value: string, exact = '') =>
  [make('dt', {}, name), make('dd', exact ? { title: exact } : {}, value)] as const;

/** From the line of history.csv that belongs to the moment. */
export function showFigures(history: History, time: number): void {
  const list = find('figures');
  const at = history.rowAt(time);
  find('figures-section').hidden = at < 0;
  if (at < 0) return;
  const value = (column: string) => history.column(column)[at];
  const shown = (name: string, column: string, unit: string) =>
    Number.isFinite(value(column)) ? row(name, quantity(value(column), unit), `${value(column)} ${unit}`) : [];
  list.replaceChildren(
    ...shown('Well pressure', 'well_pressure_Pa', 'Pa'),
    ...shown('Well rate', 'well_rate_m2_per_s', 'm2/s'),
    ...shown('Injected', 'injected_volume_m2', 'm2'),
    ...row('Cracks', `${value('crack_count')}`),
    ...row('in tension, shear', `${value('tensile_cracks')}, ${value('shear_cracks')}`),
    ...shown('Longest fracture', 'fracture_length_m', 'm'),
    ...shown('its width', 'fracture_width_m', 'm'),
    ...shown('Farthest tip', 'tip_distance_m', 'm'),
  );
}

const meanings: Record<string, readonly string[]> = {
  mode: ['intact', 'tension', 'shear'],
  state: ['intact', 'broken in tension', 'broken in shear'],
  kind: ['rock', 'well'],
};

export function showSelection(title: string, values: readonly Values[] | null, note = ''): void {
  const panel = find('selection');
  if (!title) {
    panel.replaceChildren(
      make('p', { class: 'faint' }, 'Click a crack, a disc, a bond or a pore to read its values.'),
    );
    return;
  }
  const list = make('dl', { class: 'values' });
  for (const { name, unit, parts, values: numbers } of values ?? []) {
    const label = nameOf(name, unit);
    const meaning = unit === '' && numbers.length === 1 ? meanings[name]?.[Number(numbers[0])] : undefined;
    if (numbers.length > 1) {
      const length = Math.hypot(...numbers.map(Number));
      if (parts.join() === 'x,y' && name !== 'position')
        list.append(...row(label, quantity(length, unit), `${length} ${unit}`));
    }
    numbers.forEach((number, i) => {
      const part = numbers.length > 1 ? ` ${parts[i] ?? i}` : '';
      const value = number === null ? NaN : number;
      const text = meaning ?? (name === 'position' ? `${figure(value, 5)} m` : unit === '' ? figure(value, 7) : quantity(value, unit));
      list.append(...row(`${label}${part}`, text, `${value} ${pretty(unit)}`.trim()));
    });
  }
  panel.replaceChildren(make('h3', {}, title), ...(note ? [make('p', { class: 'faint' }, note)] : []), list);
}

const fewest = 12;

/** The fractures of the last snapshot, the longest first. */
export function showFractures(index: RunIndex | null, chosen: (fracture: number) => void): void {
  const panel = find('fractures');
  const fractures = index?.summary?.fractures ?? [];
  const last = index?.snapshots.at(-1);
  find('fractures-when').textContent = last && fractures.length ? `at ${quantity(last.time_s, 's')}` : '';
  if (!fractures.length) {
    panel.replaceChildren(make('p', { class: 'faint' }, 'None yet.'));
    return;
  }
  const order = fractures.map((_, i) => i).sort((a, b) => fractures[b].length_m - fractures[a].length_m);
  const head = ['', 'Cracks', 'Length', 'Width', 'Azimuth'].map((text) => make('th', {}, text));
  const body = make('tbody');
  for (const i of order.slice(0, fewest)) {
    const go = () => chosen(i);
    body.append(
      make(
        'tr',
        { tabindex: '0', title: describe(fractures[i]), click: go, keydown: (event) => (event as KeyboardEvent).key === 'Enter' && go() },
        ...cells(i, fractures[i]).map((text) => make('td', {}, text)),
      ),
    );
  }
  const more = fractures.length - fewest;
  panel.replaceChildren(
    make('table', { class: 'list' }, make('thead', {}, make('tr', {}, ...head)), body),
    ...(more > 0 ? [make('p', { class: 'faint' }, `and ${more} shorter ones: fractures.csv`)] : []),
  );
}

function cells(i: number, fracture: Fracture): string[] {
  const azimuth = `${((fracture.azimuth_rad * 180) / Math.PI).toFixed(0)}°`.replace('-', '−');
  return [
    `${i}`, `${fracture.crack_count}`, quantity(fracture.length_m, 'm', 3),
    quantity(fracture.largest_aperture_m, 'm', 3), azimuth,
  ];
}

function describe(fracture: Fracture): string {
  const shear = fracture.crack_count - fracture.tensile_cracks;
  return (
    `${fracture.tensile_cracks} cracks in tension, ${shear} in shear; volume ` +
    `${quantity(fracture.volume_m2, 'm2')}; mean pressure ${quantity(fracture.mean_pressure_Pa, 'Pa')}` +
    (fracture.well >= 0 ? `; at well ${fracture.well}` : '')
  );
}
