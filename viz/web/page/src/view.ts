// The camera over the plane: what part of the model is in view, and how gestures move it. Projection is
// parallel, so a view is a centre and the metres that a pixel shows.

export class View {
  x = 0;
  y = 0;
  /** [pixel] of the screen, not of the layout. */
  width = 1;
  height = 1;
  private metres = 1; // per pixel
  private nearest = 1e-9;
  private farthest = 1e9;
  private home: readonly number[] = [0, 0, 1, 1];
  private inset: readonly [number, number] = [0, 0];
  /** What was fitted and not moved since; it stays fitted when the window changes. */
  private fitted: readonly [readonly number[], number] | null = null;

  metresPerPixel(): number {
    return this.metres;
  }

  /** Left, bottom, right, top [m]. */
  bounds(): [number, number, number, number] {
    const [w, h] = [(this.width * this.metres) / 2, (this.height * this.metres) / 2];
    return [this.x - w, this.y - h, this.x + w, this.y + h];
  }

  /** The model: what `fit` without bounds shows, and what zooming is limited by. */
  setHome(bounds: readonly number[]): void {
    this.home = bounds;
    const size = Math.max(bounds[2] - bounds[0], bounds[3] - bounds[1]);
    this.nearest = size * 1e-7;
    this.farthest = size / 20;
  }

  /** Pixels at the left and right that `fit` leaves free, for time and keys. */
  setInset(left: number, right: number): void {
    this.inset = [left, right];
  }

  /** Shows `bounds` with a margin, given as a share of the picture. */
  fit(bounds: readonly number[] = this.home, margin = 0.03): void {
    this.fitted = [bounds, margin];
    const room = 1 - 2 * margin;
    const free = this.width - this.inset[0] - this.inset[1];
    const least = Math.max(this.home[2] - this.home[0], 1e-12) * 1e-4;
    this.setMetres(
      Math.max(
        Math.max(bounds[2] - bounds[0], least) / (free * room),
        Math.max(bounds[3] - bounds[1], least) / (this.height * room),
      ),
    );
    this.x = (bounds[0] + bounds[2]) / 2 + this.shift();
    this.y = (bounds[1] + bounds[3]) / 2;
  }

  resize(width: number, height: number): void {
    const before = Math.min(this.width, this.height);
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    if (this.fitted) this.fit(...this.fitted);
    else if (before > 1) this.setMetres((this.metres * before) / Math.min(this.width, this.height));
  }

  toModel(px: number, py: number): [number, number] {
    return [this.x + (px - this.width / 2) * this.metres, this.y - (py - this.height / 2) * this.metres];
  }

  toScreen(x: number, y: number): [number, number] {
    return [this.width / 2 + (x - this.x) / this.metres, this.height / 2 - (y - this.y) / this.metres];
  }

  move(dx: number, dy: number): void {
    this.fitted = null;
    this.x -= dx * this.metres;
    this.y += dy * this.metres;
    this.stayNear();
  }

  /** The point under (px, py) stays where it is. */
  zoom(factor: number, px = this.width / 2, py = this.height / 2): void {
    this.fitted = null;
    const [x, y] = this.toModel(px, py);
    this.setMetres(this.metres / factor);
    const [nx, ny] = this.toModel(px, py);
    this.x += x - nx;
    this.y += y - ny;
    this.stayNear();
  }

  /** How far the centre of a fitted picture lies beside that of what it shows [m]. */
  private shift(): number {
    return ((this.inset[1] - this.inset[0]) / 2) * this.metres;
  }

  private setMetres(metres: number): void {
    this.metres = Math.min(this.farthest, Math.max(this.nearest, metres));
  }

  /** The centre stays over the model, so that nobody gets lost. */
  private stayNear(): void {
    const right = this.home[2] + this.shift();
    this.x = Math.min(right, Math.max(this.home[0], this.x));
    this.y = Math.min(this.home[3], Math.max(this.home[1], this.y));
  }
}

export interface Gestures {
  changed(): void;
  clicked(px: number, py: number): void;
  hovered(px: number, py: number): void;
  left(): void;
}

/** Mouse, pen and fingers: drag moves, wheel and pinch zoom, a short press is a click. */
export function listen(stage: HTMLElement, view: View, scale: () => number, gestures: Gestures): void {
  const fingers = new Map<number, [number, number]>();
  let travelled = 0;
  const place = (event: MouseEvent): [number, number] => {
    const box = stage.getBoundingClientRect();
    return [(event.clientX - box.left) * scale(), (event.clientY - box.top) * scale()];
  };
  stage.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    stage.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    if (fingers.size === 1) travelled = 0;
  });
  stage.addEventListener('pointermove', (event) => {
    const [x, y] = place(event);
    const before = fingers.get(event.pointerId);
    if (!before) return gestures.hovered(x, y);
    const others = [...fingers].filter(([id]) => id !== event.pointerId);
    if (others.length === 1) {
      const [ox, oy] = others[0][1];
      const [was, is] = [Math.hypot(before[0] - ox, before[1] - oy), Math.hypot(x - ox, y - oy)];
      if (was > 0 && is > 0) view.zoom(is / was, (x + ox) / 2, (y + oy) / 2);
    }
    const share = others.length ? 0.5 : 1;
    view.move((x - before[0]) * share, (y - before[1]) * share);
    travelled += Math.hypot(x - before[0], y - before[1]) / scale();
    fingers.set(event.pointerId, [x, y]);
    gestures.changed();
  });
  const release = (event: PointerEvent) => {
    if (!fingers.delete(event.pointerId) || fingers.size) return;
    if (event.type === 'pointerup' && travelled < 4) gestures.clicked(...place(event));
  };
  stage.addEventListener('pointerup', release);
  stage.addEventListener('pointercancel', release);
  stage.addEventListener('pointerleave', () => gestures.left());
  stage.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1;
      view.zoom(Math.exp(-Math.max(-300, Math.min(300, event.deltaY * lines)) * 0.0016), ...place(event));
      gestures.changed();
    },
    { passive: false },
  );
  stage.addEventListener('dblclick', (event) => {
    view.zoom(event.shiftKey ? 0.5 : 2, ...place(event));
    gestures.changed();
  });
}
