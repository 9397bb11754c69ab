// Curves of the history over time, with a cursor at the moment shown. A click or a drag goes to that time.
import { css, palette, Rgb } from './colours';
import { ticks } from './annotations';
import { History, measured } from './history';
import { figure, scaleFor } from './quantities';

export interface Curve {
  id: string;
  name: string;
  unit: string;
  lines: { column: string; name: string; colour: () => Rgb }[];
}

const plainLine = (column: string, colour = () => palette().water) => [{ column, name: '', colour }];

const besideMeasured = (column: string) => [
  { column, name: 'computed', colour: () => palette().water },
  { column: measured, name: 'measured', colour: () => palette().pull },
];

/** What can be drawn from this history; wells count from 0, the first has no number. */
export function curvesOf(history: History): Curve[] {
  const curves: Curve[] = [];
  for (const column of history.names()) {
    const match = /^well(_\d+)?_(pressure_Pa|rate_m2_per_s)$/.exec(column);
    if (!match) continue;
    const number = match[1] ? ` ${match[1].slice(1)}` : '';
    const pressure = match[2] === 'pressure_Pa';
    curves.push({
      id: column, name: pressure ? `Well${number} pressure` : `Well${number} rate`,
      unit: pressure ? 'Pa' : 'm2/s',
      lines: column === 'well_pressure_Pa' && history.line(measured).times.length ? besideMeasured(column) : plainLine(column),
    });
  }
  const more: Curve[] = [
    {
      id: 'cracks', name: 'Cracks', unit: '',
      lines: [
        { column: 'tensile_cracks', name: 'tension', colour: () => palette().ink },
        { column: 'shear_cracks', name: 'shear', colour: () => palette().shear },
      ],
    },
    { id: 'length', name: 'Fracture length', unit: 'm', lines: plainLine('fracture_length_m') },
    { id: 'width', name: 'Largest aperture', unit: 'm', lines: plainLine('fracture_width_m') },
    { id: 'volume', name: 'Fracture volume per thickness', unit: 'm2', lines: plainLine('fracture_volume_m2') },
    { id: 'injected', name: 'Injected per thickness', unit: 'm2', lines: plainLine('injected_volume_m2') },
    { id: 'leaked', name: 'Leaked per thickness', unit: 'm2', lines: plainLine('leaked_volume_m2') },
    { id: 'tip', name: 'Farthest tip', unit: 'm', lines: plainLine('tip_distance_m') },
  ];
  curves.push(...more.filter(({ lines }) => lines.every(({ column }) => history.names().includes(column))));
  return curves;
}

const room = { left: 52, right: 14, top: 22, bottom: 24 };
const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

export class Chart {
  private end = 1;

  constructor(private canvas: HTMLCanvasElement, seek: (time: number) => void) {
    let pressed = false;
    const go = (event: PointerEvent) => {
      const box = canvas.getBoundingClientRect();
      const share = (event.clientX - box.left - room.left) / (box.width - room.left - room.right);
      seek(Math.min(1, Math.max(0, share)) * this.end);
    };
    canvas.addEventListener('pointerdown', (event) => {
      pressed = true;
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener('pointermove', (event) => pressed && go(event));
    for (const name of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(name, () => (pressed = false));
  }

  draw(history: History, curve: Curve | undefined, now: number): void {
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const pen = this.canvas.getContext('2d') as CanvasRenderingContext2D;
    pen.scale(ratio, ratio);
    if (!curve || history.rows === 0) return;

    const times = history.column('time_s');
    this.end = times[times.length - 1] || 1;
    let [low, high] = [0, 0];
    for (const { column } of curve.lines) {
      const line = history.line(column);
      line.values.forEach((value, i) => {
        if (line.times[i] > this.end) return;
        if (value < low) low = value;
        if (value > high) high = value;
      });
    }
    const scale = scaleFor(curve.unit, Math.max(high, -low) || 1);
    if (!(high > low)) high = low + scale.divisor;
    high += (high - low) * 0.06;

    const [w, h] = [width - room.left - room.right, height - room.top - room.bottom];
    const x = (time: number) => room.left + (time / this.end) * w;
    const y = (value: number) => room.top + h - ((value - low) / (high - low)) * h;
    this.drawAxes(pen, scale, low, high, x, y, width, height);
    for (const { column, colour } of curve.lines) {
      const line = history.line(column);
      const fill = column === measured ? '' : css(colour(), 0.08);
      drawLine(pen, line.times, line.values, this.end, x, y, css(colour()), fill, room.top + h);
    }
    this.drawCursor(pen, history, curve, scale, now, x, y, width, h);
  }

  private drawAxes(
    pen: CanvasRenderingContext2D, scale: { divisor: number; unit: string }, low: number, high: number,
    x: (time: number) => number, y: (value: number) => number, width: number, height: number,
  ): void {
    const { grid, faint } = palette();
    pen.font = `11px ${family}`;
    pen.fillStyle = css(faint);
    pen.strokeStyle = css(grid);
    pen.lineWidth = 1;
    pen.textAlign = 'right';
    for (const tick of ticks(low / scale.divisor, high / scale.divisor, 3)) {
      const at = Math.round(y(tick * scale.divisor)) + 0.5;
      pen.beginPath();
      pen.moveTo(room.left, at);
      pen.lineTo(width - room.right, at);
      pen.stroke();
      pen.fillText(figure(tick, 5), room.left - 8, at + 4);
    }
    const time = scaleFor('s', this.end);
    pen.textAlign = 'center';
    const marks = ticks(0, this.end / time.divisor, Math.max(2, Math.floor(width / 110)));
    marks.forEach((tick, i) => {
      const last = i === marks.length - 1;
      const text = `${figure(tick, 5)}${last ? ` ${time.unit}` : ''}`;
      pen.fillText(text, Math.min(x(tick * time.divisor), width - pen.measureText(text).width / 2 - 2), height - 6);
    });
    pen.textAlign = 'left';
  }

  private drawCursor(
    pen: CanvasRenderingContext2D, history: History, curve: Curve, scale: { divisor: number; unit: string },
    now: number, x: (time: number) => number, y: (value: number) => number, width: number, h: number,
  ): void {
    const at = Math.min(x(now), width - room.right);
    pen.strokeStyle = css(palette().faint);
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(at, room.top);
    pen.lineTo(at, room.top + h);
    pen.stroke();
    const texts: string[] = [];
    for (const { column, name, colour } of curve.lines) {
      const { times, values } = history.line(column);
      const value = values[history.rowAt(now, times)];
      if (!Number.isFinite(value)) continue;
      pen.beginPath();
      pen.arc(at, y(value), 3.5, 0, 2 * Math.PI);
      pen.fillStyle = css(colour());
      pen.fill();
      pen.lineWidth = 1.5;
      pen.strokeStyle = css(palette().paper);
      pen.stroke();
      texts.push(`${figure(value / scale.divisor)}${name ? ` ${name}` : ''}`);
    }
    if (!texts.length) return;
    const text = `${texts.join(', ')}${scale.unit ? ` ${scale.unit}` : ''}`;
    pen.font = `600 12px ${family}`;
    const wide = pen.measureText(text).width;
    const left = Math.min(Math.max(at - wide / 2, room.left), width - room.right - wide);
    pen.fillStyle = css(palette().ink);
    pen.fillText(text, left, 12);
  }
}

/** At most the lowest and highest value per pixel: a history of a million steps draws as fast as a short one. */
function drawLine(
  pen: CanvasRenderingContext2D, times: readonly number[], values: readonly number[], end: number,
  x: (time: number) => number, y: (value: number) => number, stroke: string, fill: string, floor: number,
): void {
  const path = new Path2D();
  let pixel = NaN;
  let lowest = 0;
  let highest = 0;
  let previous = NaN;
  for (let i = 0; i < times.length && times[i] <= end; ++i) {
    if (!Number.isFinite(values[i])) continue;
    const here = Math.round(x(times[i]) * 2) / 2;
    const value = y(values[i]);
    if (here !== pixel) {
      if (!Number.isNaN(pixel)) {
        path.lineTo(pixel, lowest);
        path.lineTo(pixel, highest);
        path.lineTo(pixel, previous);
      }
      pixel = here;
      lowest = highest = value;
      path.lineTo(here, value);
    }
    lowest = Math.min(lowest, value);
    highest = Math.max(highest, value);
    previous = value;
  }
  path.lineTo(pixel, previous);
  pen.strokeStyle = stroke;
  pen.lineWidth = 1.75;
  pen.lineJoin = 'round';
  pen.stroke(path);
  if (!fill) return;
  const area = new Path2D(path);
  area.lineTo(pixel, floor);
  area.lineTo(x(times[0]), floor);
  pen.fillStyle = fill;
  pen.fill(area);
}
