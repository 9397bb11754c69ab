// What stands on the picture: keys, scale bar, time, wells, frame, what is selected. Drawn on a canvas above
// the model, and by the same lines into a picture that is saved.
import { css, palette } from './colours';
import { Key } from './paint';
import { figure, pretty, scaleFor } from './quantities';
import { Well } from './server';
import { View } from './view';

export interface Standing {
  title: string; // empty: none
  time: string;
  note: string;
  keys: Key[];
  wells: Well[];
  model: { width_m: number; height_m: number } | null;
  /** Outline of what is selected [m]. */
  selected: { circle?: readonly [number, number, number]; line?: readonly number[]; polygon?: readonly number[] } | null;
  pointer: readonly [number, number] | null;
}

type Pen = CanvasRenderingContext2D;

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

/** `ratio`: pixels of the canvas per pixel of the layout. */
export function drawAnnotations(pen: Pen, view: View, ratio: number, standing: Standing): void {
  pen.save();
  drawOutlines(pen, view, ratio, standing);
  pen.scale(ratio, ratio);
  const [width, height] = [view.width / ratio, view.height / ratio];
  drawHeading(pen, standing);
  drawScaleBar(pen, view, ratio, height);
  if (standing.pointer) drawPointer(pen, standing.pointer, width, height);
  drawKeys(pen, standing.keys, width);
  pen.restore();
}

function drawOutlines(pen: Pen, view: View, ratio: number, { model, wells, selected }: Standing): void {
  const { frame, well, mark, paper } = palette();
  if (model) {
    const [left, top] = view.toScreen(0, model.height_m);
    const [right, bottom] = view.toScreen(model.width_m, 0);
    pen.lineWidth = ratio;
    pen.strokeStyle = css(frame);
    pen.strokeRect(left, top, right - left, bottom - top);
  }
  for (const { x_m, y_m, radius_m, asked_radius_m } of wells) {
    const radius = Math.max((asked_radius_m || radius_m) / view.metresPerPixel(), 3 * ratio);
    circle(pen, view, [x_m, y_m], radius, css(well), 1.75 * ratio);
  }
  if (!selected) return;
  for (const [colour, width] of [[css(paper, 0.85), 6], [css(mark), 3]] as const) {
    if (selected.circle) {
      const [x, y, r] = selected.circle;
      circle(pen, view, [x, y], Math.max(r / view.metresPerPixel(), 2 * ratio), colour, width * ratio);
    }
    const corners = selected.line ?? selected.polygon;
    if (!corners) continue;
    pen.beginPath();
    for (let i = 0; i + 1 < corners.length; i += 2) pen.lineTo(...view.toScreen(corners[i], corners[i + 1]));
    if (selected.polygon) pen.closePath();
    pen.lineWidth = width * ratio;
    pen.lineCap = 'round';
    pen.lineJoin = 'round';
    pen.strokeStyle = colour;
    pen.stroke();
  }
}

function circle(
  pen: Pen, view: View, centre: readonly [number, number], radius: number, colour: string, width: number,
): void {
  pen.beginPath();
  pen.arc(...view.toScreen(...centre), radius, 0, 2 * Math.PI);
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.stroke();
}

/** Text with a rim of paper, readable on anything. */
function write(pen: Pen, text: string, x: number, y: number, font: string, colour: string): void {
  pen.font = font;
  pen.lineJoin = 'round';
  pen.lineWidth = 4;
  pen.strokeStyle = css(palette().paper, 0.85);
  pen.strokeText(text, x, y);
  pen.fillStyle = colour;
  pen.fillText(text, x, y);
}

function drawHeading(pen: Pen, { title, time, note }: Standing): void {
  const { ink, faint } = palette();
  let y = 28;
  if (title) {
    write(pen, title, 16, y, `600 15px ${family}`, css(ink));
    y += 24;
  }
  write(pen, time, 16, y, `600 18px ${family}`, css(ink));
  write(pen, note, 16, y + 19, `12px ${family}`, css(faint));
}

function drawScaleBar(pen: Pen, view: View, ratio: number, height: number): void {
  const metresPerPixel = view.metresPerPixel() * ratio;
  const wanted = 130 * metresPerPixel;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1);
  const pixels = length / metresPerPixel;
  const { divisor, unit } = scaleFor('m', length);
  const [x, y] = [16, height - 18];
  const ink = css(palette().ink);
  for (const [colour, width] of [[css(palette().paper, 0.85), 6], [ink, 2]] as const) {
    pen.beginPath();
    pen.moveTo(x, y - 4);
    pen.lineTo(x, y);
    pen.lineTo(x + pixels, y);
    pen.lineTo(x + pixels, y - 4);
    pen.lineWidth = width;
    pen.lineJoin = 'miter';
    pen.strokeStyle = colour;
    pen.stroke();
  }
  write(pen, `${figure(length / divisor)} ${unit}`, x, y - 9, `500 12px ${family}`, ink);
}

function drawPointer(pen: Pen, [x, y]: readonly [number, number], width: number, height: number): void {
  pen.textAlign = 'right';
  const text = `x ${figure(x, 5)} m   y ${figure(y, 5)} m`;
  write(pen, text, width - 16, height - 18, `12px ${family}`, css(palette().faint));
  pen.textAlign = 'left';
}

const card = { width: 212, pad: 12, bar: 10, gap: 8 };
/** What time and keys take at the left and right of the picture [pixel of the layout]. */
export const headingWidth = 96;
export const keysWidth = card.width + 14;

function drawKeys(pen: Pen, keys: readonly Key[], width: number): void {
  let top = 14;
  for (const key of keys) {
    const body = key.kind === 'scale' ? card.bar + 22 : swatchRow * swatchRows(key.entries.length);
    const height = card.pad * 2 + 16 + body + (key.note ? 17 : 0) - (body ? 0 : 6);
    const left = width - card.width - 14;
    const { paper, ink, faint, grid } = palette();
    pen.fillStyle = css(paper, 0.92);
    pen.strokeStyle = css(grid);
    pen.lineWidth = 1;
    pen.beginPath();
    pen.roundRect(left + 0.5, top + 0.5, card.width - 1, height - 1, 8);
    pen.fill();
    pen.stroke();
    const x = left + card.pad;
    let y = top + card.pad + 11;
    pen.fillStyle = css(ink);
    pen.font = `600 12px ${family}`;
    if (key.kind === 'scale') {
      const { divisor, unit } = scaleFor(key.unit, Math.max(Math.abs(key.range.low), Math.abs(key.range.high)));
      pen.fillText(key.title + (unit ? ` (${pretty(unit)})` : ''), x, y);
      drawScale(pen, key, divisor, x, y + 8);
      y += card.bar + 26;
    } else {
      pen.fillText(key.title, x, y);
      drawSwatches(pen, key.entries, x, y + 17);
      y += key.entries.length ? swatchRow * swatchRows(key.entries.length) + 4 : 2;
    }
    if (key.note) {
      pen.fillStyle = css(faint);
      pen.font = `11px ${family}`;
      pen.fillText(key.note, x, y + 13, card.width - 2 * card.pad);
    }
    top += height + card.gap;
  }
}

/** Two side by side. */
const swatchRow = 18;
const swatchRows = (count: number): number => Math.ceil(count / 2);

function drawSwatches(
  pen: Pen, entries: Extract<Key, { kind: 'swatches' }>['entries'], left: number, y: number,
): void {
  pen.font = `12px ${family}`;
  let x = left;
  entries.forEach(({ colour, text }, i) => {
    if (i > 0 && i % 2 === 0) {
      x = left;
      y += swatchRow;
    }
    pen.fillStyle = css(colour);
    pen.beginPath();
    pen.roundRect(x, y - 6, 16, 4, 2);
    pen.fill();
    pen.fillStyle = css(palette().ink);
    pen.fillText(text, x + 22, y);
    x += 22 + pen.measureText(text).width + 16;
  });
}

function drawScale(pen: Pen, key: Extract<Key, { kind: 'scale' }>, divisor: number, x: number, y: number): void {
  const width = card.width - 2 * card.pad;
  const gradient = pen.createLinearGradient(x, 0, x + width, 0);
  for (let i = 0; i <= 32; ++i) gradient.addColorStop(i / 32, key.map.css(i / 32));
  pen.fillStyle = gradient;
  pen.beginPath();
  pen.roundRect(x, y, width, card.bar, 2);
  pen.fill();
  pen.fillStyle = css(palette().ink);
  pen.strokeStyle = css(palette().faint);
  pen.font = `11px ${family}`;
  pen.lineWidth = 1;
  const low = key.range.low / divisor;
  const high = key.range.high / divisor;
  for (const tick of ticks(low, high, 4)) {
    const at = x + ((tick - low) / (high - low)) * width;
    pen.beginPath();
    pen.moveTo(at, y + card.bar);
    pen.lineTo(at, y + card.bar + 3);
    pen.stroke();
    const text = figure(tick, 6);
    const half = pen.measureText(text).width / 2;
    pen.fillText(text, Math.min(Math.max(at - half, x - 4), x + width + 4 - 2 * half), y + card.bar + 15);
  }
}

/** Round numbers from low to high, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  const raw = (high - low) / count;
  if (!(raw > 0) || !Number.isFinite(raw)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= raw * 0.999) ?? 10);
  const list: number[] = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + step * 1e-6; ++i)
    list.push(Number((i * step).toPrecision(12)));
  return list;
}
