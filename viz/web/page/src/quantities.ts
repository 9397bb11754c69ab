// Numbers for people: SI units with the prefix an engineer would choose, names for the arrays of a run.

const prefixes: Record<string, readonly (readonly [number, string])[]> = {
  Pa: [[1e9, 'GPa'], [1e6, 'MPa'], [1e3, 'kPa'], [1, 'Pa']],
  m: [[1e3, 'km'], [0.1, 'm'], [1e-3, 'mm'], [1e-6, 'µm']],
  m2: [[0.1, 'm²'], [1e-4, 'cm²'], [1e-6, 'mm²']],
  s: [[1, 's'], [1e-3, 'ms'], [1e-6, 'µs']],
  N: [[1e6, 'MN'], [1e3, 'kN'], [1, 'N']],
  'N m': [[1e6, 'MN m'], [1e3, 'kN m'], [1, 'N m']],
  rad: [[1, 'rad'], [1e-3, 'mrad'], [1e-6, 'µrad']],
  'm2/s': [[0.1, 'm²/s'], [1e-4, 'cm²/s'], [1e-6, 'mm²/s']],
};

export interface Scale {
  /** Shown number = SI number / divisor. */
  divisor: number;
  unit: string;
}

/** The prefix for a quantity whose largest value is `size`. */
export function scaleFor(unit: string, size: number): Scale {
  const choices = prefixes[unit];
  if (!choices) return { divisor: 1, unit };
  const found = choices.find(([least]) => Math.abs(size) >= least * 0.9999999) ?? choices[choices.length - 1];
  const name = found[1];
  const divisor = name === 'm' ? 1 : name === 'm²' || name === 'm²/s' ? 1 : found[0];
  return { divisor, unit: name };
}

/** Four digits that matter, without a trailing tail of zeros. */
export function figure(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return 'not a number';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(digits - 1).replace('e+', 'e').replace('-', '−');
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return Number(value.toFixed(Math.min(decimals, 12)))
    .toString()
    .replace('-', '−');
}

export function quantity(value: number, unit: string, digits = 4): string {
  if (!Number.isFinite(value)) return 'not a number';
  const scale = scaleFor(unit, value === 0 ? Infinity : value);
  const shown = value === 0 ? { divisor: 1, unit: pretty(unit) } : scale;
  return `${figure(value / shown.divisor, digits)}${shown.unit ? ` ${shown.unit}` : ''}`;
}

export function pretty(unit: string): string {
  return unit.replace('m2', 'm²');
}

/** A time with as many decimals as tell neighbouring snapshots apart. */
export function timeText(seconds: number, step: number): string {
  const scale = scaleFor('s', Math.max(seconds, step) || 1);
  const decimals = Math.min(9, Math.max(0, Math.ceil(-Math.log10((step || 1) / scale.divisor)) + 1));
  return `${(seconds / scale.divisor).toFixed(decimals)} ${scale.unit}`;
}

/** Those that their own name does not tell. */
const names: Record<string, string> = {
  position: 'Centre', time_s: 'Broken at', step: 'In step', volume_m2: 'Volume per thickness',
};

/** What an array is called: by its own name without the unit. */
export function nameOf(array: string, unit: string): string {
  const suffix = unit ? `_${unit.replace('/', '_per_').replace(' ', '_')}` : '';
  const bare = suffix && array.endsWith(suffix) ? array.slice(0, -suffix.length) : array;
  const words = bare.replace(/_/g, ' ');
  return names[array] ?? words.charAt(0).toUpperCase() + words.slice(1);
}

export function bytesText(bytes: number): string {
  const [size, unit] = bytes >= 1e6 ? [bytes / 1e6, 'MB'] : bytes >= 1e3 ? [bytes / 1e3, 'kB'] : [bytes, 'bytes'];
  return `${size >= 100 || unit === 'bytes' ? Math.round(size) : size.toFixed(1)} ${unit}`;
}
