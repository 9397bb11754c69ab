// The page as a whole: what is shown, what happens when something is chosen, and how a run that goes on is
// followed.
import { Chart, Curve, curvesOf } from './chart';
import { palette } from './colours';
import { find, make } from './dom';
import { listDownloads, savePicture } from './downloads';
import { drawFurniture, headingWidth, keysWidth, Standing } from './furniture';
import { forgetGrids, grid } from './grids';
import { History } from './history';
import { LayerList } from './layers';
import { Key, Moment, Painter, Settings, usualSettings } from './paint';
import { showFigures, showFractures, showSelection } from './panels';
import { cornersOf, Pick, pick } from './pick';
import { Player } from './player';
import { timeText } from './quantities';
import { Scene } from './scene';
import { fetchRun, fetchValues, Grid, RunIndex, Series, Snapshot } from './server';
import { listen, View } from './view';
import { discFields } from './fields';

const pollSeconds = { running: 1, ended: 4 };
/** Above this many discs only the arrays that are shown are fetched, and pores only if asked for. */
const manyDiscs = 200000;
/** Silence after which a run that never ended is said to be silent [s]. */
const silence = 120;

const idOf: Record<Series, string> = { discs: 'disc_id', bonds: 'bond_id', cracks: 'crack_id', flow: 'domain_id' };
const oneOf: Record<Series, string> = { discs: 'Disc', bonds: 'Bond', cracks: 'Crack', flow: 'Pore' };

export class App {
  private settings: Settings = { ...usualSettings };
  private view = new View();
  private scene = new Scene(find('gl'), this.view);
  private painter = new Painter(this.scene);
  private layers = new LayerList(find('layers'), this.settings, () => void this.reshow());
  private player = new Player((index) => this.show(index));
  private history = new History();
  private charts = ['a', 'b'].map((name) => new Chart(find(`plot-${name}`), (time) => this.seek(time)));
  private curves: Curve[] = [];
  private index: RunIndex | null = null;
  private moment: Moment | null = null;
  private reference: Moment | null = null;
  private keys: Key[] = [];
  private selected: { series: Series; id: number } | null = null;
  private pointer: readonly [number, number] | null = null;
  private paintedAt = 0;
  private wish = 0;
  private framed = false;
  private drawing = false;

  constructor() {
    this.listenToPage();
    showSelection('', null);
    showFractures(null, () => undefined);
    void this.watch();
  }

  // --- the run -------------------------------------------------------------------------------------------

  /** Asks for news for as long as the page is open. */
  private async watch(): Promise<void> {
    for (;;) {
      const begin = performance.now();
      try {
        await this.update(await fetchRun());
        document.body.dataset.lost = '';
      } catch (error) {
        document.body.dataset.lost = 'yes';
        this.status('no answer', 'lost');
        if (!this.moment) this.notice('The server does not answer', `Is hfrac view still running? (${text(error)})`);
      }
      // A long list of snapshots takes time to read; do not keep the server busy with it.
      const took = (performance.now() - begin) / 1000;
      const over = this.index?.summary && !this.index.running;
      const pause = over ? pollSeconds.ended : pollSeconds.running;
      await new Promise((resolve) => setTimeout(resolve, 1000 * (pause + 4 * took)));
    }
  }

  private async update(index: RunIndex): Promise<void> {
    const old = this.index;
    const another = old !== null && old.identity !== index.identity;
    if (another) this.forget();
    const grown = another || !old || index.snapshots.length !== old.snapshots.length;
    this.index = index;
    const summary = index.summary;
    find('title').textContent = summary?.title || index.folder;
    find('folder').textContent = summary?.title ? index.folder : '';
    document.title = `${summary?.title || index.folder} · hfrac`;
    this.showStatus();
    if (await this.history.update()) this.drawCharts();
    if (!grown && old && JSON.stringify(old.summary) === JSON.stringify(summary)) return;

    if (!index.snapshots.length) {
      this.player.setCount(0);
      return this.notice('Nothing to show yet', 'The run has not written a snapshot. This page shows it as soon as there is one.');
    }
    const follow = find<HTMLInputElement>('follow');
    if (!old || another || !old.snapshots.length) {
      follow.checked = index.running;
      if (this.discCount() > manyDiscs) this.layers.leaveOutPores();
    }
    const toEnd = !this.moment || (follow.checked && grown);
    this.player.setCount(index.snapshots.length);
    showFractures(index, (fracture) => void this.goToFracture(fracture));
    if (toEnd) await this.player.go(index.snapshots.length - 1);
    else await this.reshow();
  }

  /** Another run has taken this one's place. */
  private forget(): void {
    forgetGrids();
    this.painter.forget();
    this.history.clear();
    this.moment = this.reference = null;
    this.selected = null;
    this.framed = false;
    showSelection('', null);
  }

  private showStatus(): void {
    const { summary, running, age_s } = this.index as RunIndex;
    if (!summary) return this.status('waiting', 'waiting');
    if (!running) {
      const failed = summary.ended?.startsWith('failed') || summary.ended === 'interrupted';
      return this.status(failed ? String(summary.ended) : 'finished', failed ? 'failed' : 'done', summary.ended);
    }
    if (age_s > silence) return this.status(`silent for ${Math.round(age_s / 60)} min`, 'failed', 'The run has not ended, but writes nothing. Was it killed?');
    this.status('running', 'running');
  }

  private status(words: string, kind: string, title = ''): void {
    const chip = find('status');
    chip.textContent = words.length > 40 ? `${words.slice(0, 38)}…` : words;
    chip.dataset.kind = kind;
    chip.title = title || words;
  }

  private notice(head: string, body: string): void {
    const notice = find('notice');
    notice.replaceChildren(make('strong', {}, head), make('span', {}, body));
    notice.hidden = false;
  }

  // --- moments -------------------------------------------------------------------------------------------

  private async show(number: number): Promise<void> {
    const snapshots = this.index?.snapshots ?? [];
    const snapshot = snapshots[number];
    if (!snapshot) return;
    const wish = ++this.wish;
    const busy = setTimeout(() => (find('busy').hidden = wish !== this.wish), 300);
    try {
      const last = snapshots[snapshots.length - 1];
      const reference = this.settings.range === 'last' && last !== snapshot ? this.load(last) : null;
      const moment = await this.load(snapshot);
      const referenceMoment = reference ? await reference : moment;
      if (wish !== this.wish) return;
      this.moment = moment;
      this.reference = referenceMoment;
      find('notice').hidden = true;
      this.layers.offer(moment.discs);
      if (!this.framed) this.frame();
      this.repaint();
      void this.refreshSelection();
      const next = snapshots[number + 1];
      if (next && moment.discs.points < manyDiscs) void this.load(next).catch(() => undefined);
    } catch (error) {
      if (wish === this.wish) this.notice('This moment cannot be shown', text(error));
    } finally {
      clearTimeout(busy);
      if (wish === this.wish) find('busy').hidden = true;
    }
  }

  private async reshow(): Promise<void> {
    await this.show(this.player.now);
  }

  private async load(snapshot: Snapshot): Promise<Moment> {
    const { files } = snapshot;
    const many = (this.moment?.discs.points ?? this.discCount()) > manyDiscs;
    const field = discFields.find(({ id }) => id === this.settings.discColour);
    const chosen = many ? ['radius_m', field?.array ?? this.settings.discColour] : [];
    const wanted = (file: string | undefined, on: boolean, arrays: string[] = []): Promise<Grid | null> =>
      file && on ? grid(file, arrays) : Promise.resolve(null);
    const [discs, cracks, flow, bonds] = await Promise.all([
      wanted(files.discs, true, chosen),
      wanted(files.cracks, true),
      wanted(files.flow, this.settings.pores, many ? ['pressure_Pa', 'domain_id'] : []),
      wanted(files.bonds, this.settings.bonds, many ? ['state', 'normal_force_N', 'bond_id'] : []),
    ]);
    const pressureNote = this.index?.summary?.reading === 'paper' ? 'above the formation’s' : undefined;
    return { snapshot, discs: discs as Grid, cracks, flow, bonds, pressureNote };
  }

  private discCount(): number {
    const state = this.index?.summary?.state as { disc_count?: number } | undefined;
    return state?.disc_count ?? 0;
  }

  private seek(time: number): void {
    const snapshots = this.index?.snapshots ?? [];
    let nearest = 0;
    snapshots.forEach(({ time_s }, i) => {
      if (Math.abs(time_s - time) < Math.abs(snapshots[nearest].time_s - time)) nearest = i;
    });
    this.player.pause();
    if (nearest !== this.player.now) void this.player.go(nearest);
  }

  // --- drawing -------------------------------------------------------------------------------------------

  private repaint(): void {
    if (!this.moment || !this.reference) return;
    this.keys = this.painter.paint(this.moment, this.reference, this.settings);
    this.paintedAt = this.view.metresPerPixel();
    const { snapshot } = this.moment;
    find('when').textContent = `${this.timeOf(snapshot)} · step ${snapshot.step}`;
    showFigures(this.history, snapshot.time_s);
    document.body.dataset.shown = String(snapshot.step);
    this.drawCharts();
    this.redraw();
  }

  /** Draws once before the next picture of the screen, however often it is asked. */
  private redraw(): void {
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => {
      this.drawing = false;
      // Cracks keep a least width in pixels, so they depend on the zoom.
      const zoomed = this.view.metresPerPixel() / this.paintedAt;
      if (this.moment && this.reference && (zoomed > 1.25 || zoomed < 0.8)) {
        this.keys = this.painter.paint(this.moment, this.reference, this.settings);
        this.paintedAt = this.view.metresPerPixel();
      }
      this.scene.draw();
      // Where the model is on the screen, for the page's tests.
      find('stage').dataset.view = `${this.view.x} ${this.view.y} ${this.view.metresPerPixel()}`;
      const overlay = find<HTMLCanvasElement>('overlay');
      const pen = overlay.getContext('2d') as CanvasRenderingContext2D;
      pen.clearRect(0, 0, overlay.width, overlay.height);
      if (this.moment) drawFurniture(pen, this.view, this.scene.pixelRatio, this.standing(''));
    });
  }

  private standing(title: string): Standing {
    const summary = this.index?.summary;
    const snapshot = this.moment?.snapshot as Snapshot;
    return {
      title,
      time: this.timeOf(snapshot),
      note: `step ${snapshot.step}`,
      keys: this.keys,
      wells: summary?.wells ?? [],
      model: summary?.model ?? null,
      selected: this.outline(),
      pointer: this.pointer,
    };
  }

  private timeOf(snapshot: Snapshot): string {
    const snapshots = this.index?.snapshots ?? [];
    const all = snapshots.length > 1 ? (snapshots[snapshots.length - 1].time_s - snapshots[0].time_s) / (snapshots.length - 1) : 0;
    return timeText(snapshot.time_s, all);
  }

  private drawCharts(): void {
    const curves = curvesOf(this.history);
    if (curves.map(({ id }) => id).join() !== this.curves.map(({ id }) => id).join()) {
      this.curves = curves;
      ['a', 'b'].forEach((name, i) => {
        const select = find<HTMLSelectElement>(`chart-${name}`);
        const before = select.value || (i === 0 ? curves[0]?.id : 'cracks');
        select.replaceChildren(...curves.map(({ id, name: title }) => make('option', { value: id }, title)));
        select.value = curves.some(({ id }) => id === before) ? before : (curves[0]?.id ?? '');
      });
    }
    ['a', 'b'].forEach((name, i) => {
      const chosen = find<HTMLSelectElement>(`chart-${name}`).value;
      const curve = this.curves.find(({ id }) => id === chosen);
      this.charts[i].draw(this.history, curve, this.moment?.snapshot.time_s ?? 0);
    });
  }

  // --- where to look -------------------------------------------------------------------------------------

  private frame(): void {
    const model = this.index?.summary?.model;
    const bounds = model ? [0, 0, model.width_m, model.height_m] : this.boundsOf(this.moment?.discs ?? null);
    this.view.setHome(bounds);
    this.view.fit();
    this.framed = true;
  }

  private boundsOf(one: Grid | null, cells?: readonly number[]): number[] {
    const bounds = [Infinity, Infinity, -Infinity, -Infinity];
    const add = (x: number, y: number) => {
      bounds[0] = Math.min(bounds[0], x);
      bounds[1] = Math.min(bounds[1], y);
      bounds[2] = Math.max(bounds[2], x);
      bounds[3] = Math.max(bounds[3], y);
    };
    if (one && cells) for (const cell of cells) for (let c = cornersOf(one, cell), j = 0; j < c.length; j += 2) add(c[j], c[j + 1]);
    else if (one) for (let i = 0; i < one.points; ++i) add(one.positions[2 * i], one.positions[2 * i + 1]);
    return bounds;
  }

  private look(bounds: readonly number[], margin = 0.08): void {
    if (!bounds.every(Number.isFinite)) return;
    this.view.fit(bounds, margin);
    this.redraw();
  }

  private lookAtCracks(cells?: readonly number[]): void {
    const cracks = this.moment?.cracks;
    if (!cracks?.cells) return this.lookAtWell();
    const all = cells ?? Array.from({ length: cracks.cells }, (_, i) => i);
    this.look(grown(this.boundsOf(cracks, all), 3 * this.painter.meanRadius));
  }

  private lookAtWell(): void {
    const well = this.index?.summary?.wells?.[0];
    if (!well) return;
    const reach = Math.max(3 * well.radius_m, 12 * this.painter.meanRadius);
    this.look([well.x_m - reach, well.y_m - reach, well.x_m + reach, well.y_m + reach], 0);
  }

  private lookAtTip(): void {
    const cracks = this.moment?.cracks;
    const well = this.index?.summary?.wells?.[0];
    if (!cracks?.cells || !well) return this.lookAtCracks();
    let [far, tip] = [-1, [0, 0]];
    for (let cell = 0; cell < cracks.cells; ++cell)
      for (let corners = cornersOf(cracks, cell), j = 0; j < corners.length; j += 2) {
        const distance = Math.hypot(corners[j] - well.x_m, corners[j + 1] - well.y_m);
        if (distance > far) [far, tip] = [distance, [corners[j], corners[j + 1]]];
      }
    const reach = 14 * this.painter.meanRadius;
    this.look([tip[0] - reach, tip[1] - reach, tip[0] + reach, tip[1] + reach], 0);
  }

  private async goToFracture(fracture: number): Promise<void> {
    this.player.pause();
    await this.player.go((this.index?.snapshots.length ?? 1) - 1);
    const cracks = this.moment?.cracks;
    if (!cracks) return;
    const numbers = cracks.values('fracture');
    const cells: number[] = [];
    for (let i = 0; i < cracks.cells; ++i) if (numbers[i] === fracture) cells.push(i);
    if (cells.length) this.lookAtCracks(cells);
  }

  // --- selection -----------------------------------------------------------------------------------------

  private gridOf(series: Series): Grid | null {
    return this.moment ? this.moment[series] : null;
  }

  private click(px: number, py: number): void {
    if (!this.moment) return;
    const reach = 7 * this.scene.pixelRatio * this.view.metresPerPixel();
    const found = pick(this.moment, this.settings, ...this.view.toModel(px, py), reach);
    this.select(found);
  }

  private select(found: Pick | null): void {
    if (found) {
      const ids = this.gridOf(found.series)?.values(idOf[found.series]);
      this.selected = { series: found.series, id: ids?.length ? ids[found.index] : found.index };
    } else {
      this.selected = null;
    }
    void this.refreshSelection();
    this.redraw();
  }

  /** Place of the selected item in the grid of this moment; -1: it is not there (yet). */
  private placeOfSelected(): number {
    if (!this.selected) return -1;
    const one = this.gridOf(this.selected.series);
    const ids = one?.values(idOf[this.selected.series]);
    if (!one || !ids) return -1;
    if (ids.length) return ids.indexOf(this.selected.id as never);
    return this.selected.id < Math.max(one.points, one.cells) ? this.selected.id : -1;
  }

  private async refreshSelection(): Promise<void> {
    const { selected, moment } = this;
    if (!selected || !moment) return showSelection('', null);
    const title = `${oneOf[selected.series]} ${selected.id}`;
    const file = moment.snapshot.files[selected.series];
    const place = this.placeOfSelected();
    if (place < 0 || !file) {
      const why = selected.series === 'cracks' ? 'Not broken yet at this moment.' : 'Its layer is off, or it is not in this moment.';
      return showSelection(title, [], why);
    }
    try {
      const values = await fetchValues(file, selected.series === 'discs' ? 'points' : 'cells', place);
      if (this.selected === selected && this.moment === moment)
        showSelection(title, values.filter(({ name }) => name !== idOf[selected.series]));
    } catch (error) {
      if (this.selected === selected) showSelection(title, [], text(error));
    }
  }

  private outline(): Standing['selected'] {
    const place = this.placeOfSelected();
    const one = this.selected && this.gridOf(this.selected.series);
    if (place < 0 || !one || !this.selected) return null;
    if (this.selected.series === 'discs') {
      const at = one.positions;
      return { circle: [at[2 * place], at[2 * place + 1], one.values('radius_m')[place]] };
    }
    const corners = cornersOf(one, place);
    return this.selected.series === 'flow' ? { polygon: corners } : { line: corners };
  }

  // --- the page ------------------------------------------------------------------------------------------

  private save(): void {
    if (!this.moment) return;
    const title = this.index?.summary?.title || this.index?.folder || '';
    savePicture(this.scene, this.standing(title), `${this.index?.folder}_${this.moment.snapshot.step}.png`);
  }

  private setTheme(theme: string): void {
    document.documentElement.dataset.theme = theme;
    try {
      localStorage.setItem('hfrac-theme', theme);
    } catch {
      // private windows may have no storage
    }
    find('stage').style.backgroundColor = `rgb(${palette().paper.join(' ')})`;
    this.repaint();
    this.drawCharts();
    this.redraw();
  }

  private toggleTheme(): void {
    this.setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark');
  }

  private listenToPage(): void {
    let theme: string | null = null;
    try {
      theme = localStorage.getItem('hfrac-theme');
    } catch {
      // as above
    }
    this.setTheme(theme ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));

    const stage = find('stage');
    const fit = () => {
      const ratio = window.devicePixelRatio || 1;
      const overlay = find<HTMLCanvasElement>('overlay');
      overlay.width = Math.max(1, Math.round(stage.clientWidth * ratio));
      overlay.height = Math.max(1, Math.round(stage.clientHeight * ratio));
      this.scene.pixelRatio = ratio;
      const wide = stage.clientWidth;
      this.view.setInset(wide > 820 ? headingWidth * ratio : 0, wide > 640 ? keysWidth * ratio : 0);
      this.scene.resize(overlay.width, overlay.height);
      this.drawCharts();
      this.redraw();
    };
    new ResizeObserver(fit).observe(stage);
    fit();
    listen(stage, this.view, () => this.scene.pixelRatio, {
      changed: () => this.redraw(),
      clicked: (x, y) => this.click(x, y),
      hovered: (x, y) => {
        this.pointer = this.view.toModel(x, y);
        this.redraw();
      },
      left: () => {
        this.pointer = null;
        this.redraw();
      },
    });

    const range = find<HTMLSelectElement>('range');
    range.addEventListener('change', () => {
      this.settings.range = range.value as Settings['range'];
      void this.reshow();
    });
    for (const name of ['a', 'b']) find(`chart-${name}`).addEventListener('change', () => this.drawCharts());
    find('view-all').addEventListener('click', () => this.lookAtAll());
    find('view-cracks').addEventListener('click', () => this.lookAtCracks());
    find('view-well').addEventListener('click', () => this.lookAtWell());
    find('view-tip').addEventListener('click', () => this.lookAtTip());
    find('theme').addEventListener('click', () => this.toggleTheme());
    find('follow').addEventListener('change', () => this.followNow());
    find('help').addEventListener('click', () => find<HTMLDialogElement>('keys').showModal());
    this.listenToMenu();
    window.addEventListener('keydown', (event) => this.key(event));
  }

  private lookAtAll(): void {
    this.view.fit();
    this.redraw();
  }

  private followNow(): void {
    if (find<HTMLInputElement>('follow').checked) this.player.step(Infinity);
  }

  private listenToMenu(): void {
    const button = find('download');
    const sheet = find('downloads');
    const open = (on: boolean) => {
      sheet.hidden = !on;
      button.setAttribute('aria-expanded', String(on));
    };
    button.addEventListener('click', () => {
      if (this.index) listDownloads(this.index, this.moment?.snapshot, () => this.save());
      open(sheet.hidden);
    });
    document.addEventListener('pointerdown', (event) => {
      if (!(event.target as Element).closest('.menu')) open(false);
    });
    sheet.addEventListener('click', () => open(false));
    sheet.addEventListener('keydown', (event) => event.key === 'Escape' && open(false));
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.tagName === 'SELECT') return;
    if (find<HTMLDialogElement>('keys').open) return;
    const by = event.shiftKey ? 10 : 1;
    const actions: Record<string, () => void> = {
      ' ': () => this.player.toggle(),
      ArrowLeft: () => this.player.step(-by),
      ArrowRight: () => this.player.step(by),
      Home: () => this.player.step(-Infinity),
      End: () => this.player.step(Infinity),
      '0': () => this.lookAtAll(),
      f: () => this.lookAtCracks(),
      w: () => this.lookAtWell(),
      t: () => this.lookAtTip(),
      d: () => this.toggleTheme(),
      s: () => this.save(),
      l: () => find('follow').click(),
      '?': () => find('help').click(),
      Escape: () => this.select(null),
      '+': () => this.zoom(1.4),
      '=': () => this.zoom(1.4),
      '-': () => this.zoom(1 / 1.4),
    };
    for (let i = 1; i <= 4; ++i) actions[i] = () => this.layers.toggle(i - 1);
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    // A button that has the focus is pressed by space as anywhere else.
    if (!action || (event.key === ' ' && (target.tagName === 'BUTTON' || target.tagName === 'INPUT'))) return;
    event.preventDefault();
    action();
  }

  private zoom(factor: number): void {
    this.view.zoom(factor);
    this.redraw();
  }
}

function text(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function grown(bounds: readonly number[], by: number): number[] {
  return [bounds[0] - by, bounds[1] - by, bounds[2] + by, bounds[3] + by];
}
