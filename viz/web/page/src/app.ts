// The page as a whole: which part is told what when something is chosen, the moment changes or the run goes on.
import { palette } from './colours';
import { Curves } from './curves';
import { find } from './dom';
import { listDownloads, listenToDownloads, savePicture } from './downloads';
import { setViews } from './fields';
import { drawAnnotations, headingWidth, keysWidth, Standing } from './annotations';
import { History } from './history';
import { listenToKeys } from './keyboard';
import { LayerList } from './layers';
import { Camera } from './camera';
import { Moments } from './moments';
import { Key, Moment, Painter, Settings, usualSettings } from './paint';
import { showFigures, showFractures } from './panels';
import { pick } from './pick';
import { Player } from './player';
import { timeText } from './quantities';
import { Scene } from './scene';
import { Selection } from './selection';
import { RunIndex, Snapshot } from './server';
import { showNotice, showStateOf } from './status';
import { Theme } from './theme';
import { listen, View } from './view';
import { watch } from './watch';

export class App {
  private settings: Settings = { ...usualSettings };
  private view = new View();
  private scene = new Scene(find('gl'), this.view);
  private painter = new Painter(this.scene);
  private moments = new Moments(this.settings, () => this.index, (moment) => this.shown(moment));
  private player = new Player((number) => this.moments.show(number));
  private layers = new LayerList(find('layers'), this.settings, () => void this.reshow());
  private history = new History();
  private curves = new Curves(this.history, () => this.moments.now?.snapshot.time_s ?? 0, (time) => this.seek(time));
  private selection = new Selection(() => this.moments.now);
  private camera = new Camera(this.view, () => this.sight(), () => this.redraw());
  private theme = new Theme(() => this.applyTheme());
  private index: RunIndex | null = null;
  private keys: Key[] = [];
  private pointer: readonly [number, number] | null = null;
  private paintedAt = 0;
  private drawing = false;

  constructor() {
    this.applyTheme();
    this.listenToStage();
    this.listenToControls();
    showFractures(null, () => undefined);
    void watch((index) => this.update(index), () => this.moments.now === null);
  }

  // --- the run -------------------------------------------------------------------------------------------

  private async update(index: RunIndex): Promise<void> {
    const old = this.index;
    const another = old !== null && old.identity !== index.identity;
    const emptied = !!old?.snapshots.length && !index.snapshots.length;
    if (another || emptied) this.forget();
    const grown = another || !old || index.snapshots.length !== old.snapshots.length;
    this.index = index;
    setViews(index.views);
    const summary = index.summary;
    find('title').textContent = summary?.title || index.folder;
    find('folder').textContent = summary?.title ? index.folder : '';
    document.title = `${summary?.title || index.folder} · hfrac`;
    showStateOf(index);
    if (await this.history.update()) this.curves.draw();
    if (!grown && old && old.there === index.there && JSON.stringify(old.summary) === JSON.stringify(summary)) return;

    if (!index.snapshots.length) {
      this.player.setCount(0);
      showFractures(null, () => undefined);
      if (!index.there)
        return showNotice('The folder is gone', `${index.folder} is not there any more. This page shows the run as soon as it is back.`);
      return showNotice('Nothing to show yet', 'The run has not written a snapshot. This page shows it as soon as there is one.');
    }
    const follow = find<HTMLInputElement>('follow');
    if (!old || another || !old.snapshots.length) {
      // The first snapshot may be there before the summary, which says that the run goes on.
      follow.checked = index.running || !index.summary;
      if (this.moments.many()) this.layers.leaveOutPores();
    }
    const toEnd = !this.moments.now || (follow.checked && grown);
    this.player.setCount(index.snapshots.length);
    showFractures(index, (fracture) => void this.goToFracture(fracture));
    if (toEnd) await this.player.go(index.snapshots.length - 1);
    else await this.reshow();
  }

  /** Another run has taken this one's place. */
  private forget(): void {
    this.moments.clear();
    this.painter.forget();
    this.history.clear();
    this.selection.clear();
    this.camera.clear();
    find('when').textContent = '';
    document.body.dataset.shown = '';
    find('figures-section').hidden = true;
    this.curves.draw();
    this.redraw();
  }

  // --- moments -------------------------------------------------------------------------------------------

  private async reshow(): Promise<void> {
    await this.moments.show(this.player.now);
  }

  private shown(moment: Moment): void {
    this.layers.offer(moment.discs, moment.joints);
    this.camera.frame();
    this.repaint();
    void this.selection.refresh();
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

  private async goToFracture(fracture: number): Promise<void> {
    this.player.pause();
    await this.player.go((this.index?.snapshots.length ?? 1) - 1);
    this.camera.atFracture(fracture);
  }

  // --- drawing -------------------------------------------------------------------------------------------

  private paint(): void {
    const { now, reference } = this.moments;
    if (!now || !reference) return;
    this.keys = this.painter.paint(now, reference, this.settings);
    this.paintedAt = this.view.metresPerPixel();
  }

  private repaint(): void {
    const snapshot = this.moments.now?.snapshot;
    if (!snapshot) return;
    this.paint();
    find('when').textContent = `${this.timeOf(snapshot)} · step ${snapshot.step}`;
    showFigures(this.history, snapshot.time_s);
    document.body.dataset.shown = String(snapshot.step);
    this.curves.draw();
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
      if (zoomed > 1.25 || zoomed < 0.8) this.paint();
      // Without a moment what is drawn there is of a run that is gone; the renderer fails where it has no size.
      find('gl').hidden = !this.moments.now;
      if (this.moments.now) this.scene.draw();
      // Where the model is on the screen, for the page's tests.
      find('stage').dataset.view = `${this.view.x} ${this.view.y} ${this.view.metresPerPixel()}`;
      const overlay = find<HTMLCanvasElement>('overlay');
      const pen = overlay.getContext('2d') as CanvasRenderingContext2D;
      pen.clearRect(0, 0, overlay.width, overlay.height);
      const snapshot = this.moments.now?.snapshot;
      overlay.hidden = !snapshot; // a busy browser may go on showing what was on a canvas that was only cleared
      if (snapshot) drawAnnotations(pen, this.view, this.scene.pixelRatio, this.standing(snapshot, ''));
    });
  }

  private standing(snapshot: Snapshot, title: string): Standing {
    const summary = this.index?.summary;
    return {
      title,
      time: this.timeOf(snapshot),
      note: `step ${snapshot.step}`,
      keys: this.keys,
      wells: summary?.wells ?? [],
      model: summary?.model ?? null,
      selected: this.selection.outline(),
      pointer: this.pointer,
    };
  }

  private timeOf(snapshot: Snapshot): string {
    const snapshots = this.index?.snapshots ?? [];
    const all = snapshots.length > 1 ? (snapshots[snapshots.length - 1].time_s - snapshots[0].time_s) / (snapshots.length - 1) : 0;
    return timeText(snapshot.time_s, all);
  }

  private sight() {
    return { index: this.index, moment: this.moments.now, meanRadius: this.painter.meanRadius };
  }

  private applyTheme(): void {
    find('stage').style.backgroundColor = `rgb(${palette().paper.join(' ')})`;
    this.repaint();
    this.curves.draw();
    this.redraw();
  }

  // --- what the reader does --------------------------------------------------------------------------------

  private click(px: number, py: number): void {
    const { now } = this.moments;
    if (!now) return;
    const reach = 7 * this.scene.pixelRatio * this.view.metresPerPixel();
    this.selection.select(pick(now, this.settings, ...this.view.toModel(px, py), reach));
    this.redraw();
  }

  private point(at: readonly [number, number] | null): void {
    this.pointer = at && this.view.toModel(...at);
    this.redraw();
  }

  private zoom(factor: number): void {
    this.view.zoom(factor);
    this.redraw();
  }

  private save(): void {
    const snapshot = this.moments.now?.snapshot;
    if (!snapshot || !this.index) return;
    const title = this.index.summary?.title || this.index.folder;
    savePicture(this.scene, this.standing(snapshot, title), `${this.index.folder}_${snapshot.step}.png`);
  }

  private fitWindow(stage: HTMLElement): void {
    const ratio = window.devicePixelRatio || 1;
    const overlay = find<HTMLCanvasElement>('overlay');
    overlay.width = Math.max(1, Math.round(stage.clientWidth * ratio));
    overlay.height = Math.max(1, Math.round(stage.clientHeight * ratio));
    this.scene.pixelRatio = ratio;
    const wide = stage.clientWidth;
    this.view.setInset(wide > 820 ? headingWidth * ratio : 0, wide > 640 ? keysWidth * ratio : 0);
    this.scene.resize(overlay.width, overlay.height);
    this.curves.draw();
    this.redraw();
  }

  private listenToStage(): void {
    const stage = find('stage');
    new ResizeObserver(() => this.fitWindow(stage)).observe(stage);
    this.fitWindow(stage);
    listen(stage, this.view, () => this.scene.pixelRatio, {
      changed: () => this.redraw(),
      clicked: (x, y) => this.click(x, y),
      hovered: (x, y) => this.point([x, y]),
      left: () => this.point(null),
    });
  }

  private listenToControls(): void {
    const { camera, player, theme } = this;
    const follow = find<HTMLInputElement>('follow');
    const range = find<HTMLSelectElement>('range');
    range.addEventListener('change', () => {
      this.settings.range = range.value as Settings['range'];
      void this.reshow();
    });
    follow.addEventListener('change', () => follow.checked && player.step(Infinity));
    find('view-all').addEventListener('click', () => camera.atAll());
    find('view-cracks').addEventListener('click', () => camera.atCracks());
    find('view-well').addEventListener('click', () => camera.atWell());
    find('view-tip').addEventListener('click', () => camera.atTip());
    find('theme').addEventListener('click', () => theme.toggle());
    find('help').addEventListener('click', () => find<HTMLDialogElement>('keys').showModal());
    listenToDownloads(() => this.index && listDownloads(this.index, this.moments.now?.snapshot, () => this.save()));
    listenToKeys({
      ' ': () => player.toggle(),
      ArrowLeft: (by) => player.step(-by),
      ArrowRight: (by) => player.step(by),
      Home: () => player.step(-Infinity),
      End: () => player.step(Infinity),
      '0': () => camera.atAll(),
      f: () => camera.atCracks(),
      w: () => camera.atWell(),
      t: () => camera.atTip(),
      d: () => theme.toggle(),
      s: () => this.save(),
      l: () => follow.click(),
      '?': () => find('help').click(),
      Escape: () => {
        this.selection.clear();
        this.redraw();
      },
      '+': () => this.zoom(1.4),
      '=': () => this.zoom(1.4),
      '-': () => this.zoom(1 / 1.4),
      ...Object.fromEntries([1, 2, 3, 4, 5].map((number) => [number, () => this.layers.toggle(number - 1)])),
    });
  }
}
