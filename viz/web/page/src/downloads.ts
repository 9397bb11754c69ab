// What can be saved: the picture as it stands, the tables, the VTU files of the moment.
import { css, palette } from './colours';
import { find, make } from './dom';
import { drawAnnotations, Standing } from './annotations';
import { bytesText } from './quantities';
import { Scene } from './scene';
import { RunIndex, Snapshot } from './server';

/** The model as drawn now with its keys, at the resolution of the screen. */
export function pictureOf(scene: Scene, standing: Standing): HTMLCanvasElement {
  const picture = document.createElement('canvas');
  picture.width = scene.view.width;
  picture.height = scene.view.height;
  const pen = picture.getContext('2d') as CanvasRenderingContext2D;
  pen.fillStyle = css(palette().paper);
  pen.fillRect(0, 0, picture.width, picture.height);
  pen.drawImage(scene.canvas(), 0, 0, picture.width, picture.height);
  drawAnnotations(pen, scene.view, scene.pixelRatio, { ...standing, pointer: null });
  return picture;
}

export function savePicture(scene: Scene, standing: Standing, name: string): void {
  pictureOf(scene, standing).toBlob((blob) => {
    if (!blob) return;
    const address = URL.createObjectURL(blob);
    make('a', { href: address, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }, 'image/png');
}

/** Fills the sheet below the button Download. */
export function listDownloads(index: RunIndex, snapshot: Snapshot | undefined, save: () => void): void {
  const sheet = find('downloads');
  const link = (name: string, size = '') =>
    make(
      'a', { href: `files/${name.split('/').map(encodeURIComponent).join('/')}`, download: name.split('/').pop() ?? name },
      make('span', {}, name.replace('pictures/', '')), make('span', { class: 'faint' }, size),
    );
  const picture = make('button', { id: 'save-picture', click: save }, make('span', {}, 'Picture'), make('span', { class: 'faint' }, 'PNG'));
  const tables = index.files.filter(({ name }) => !name.startsWith('pictures/'));
  const pictures = index.files.filter(({ name }) => name.startsWith('pictures/'));
  const group = (title: string, items: HTMLElement[]) =>
    items.length ? [make('h3', {}, title), ...items] : [];
  sheet.replaceChildren(
    ...group('As shown', [picture]),
    ...group('This moment, for ParaView', Object.values(snapshot?.files ?? {}).map((file) => link(file))),
    ...group('Tables', tables.map(({ name, bytes }) => link(name, bytesText(bytes)))),
    ...group('Drawn by hfrac', pictures.map(({ name, bytes }) => link(name, bytesText(bytes)))),
  );
}

/** The button Download and its sheet, which `fill` fills whenever it opens. */
export function listenToDownloads(fill: () => void): void {
  const button = find('download');
  const sheet = find('downloads');
  const open = (on: boolean) => {
    sheet.hidden = !on;
    button.setAttribute('aria-expanded', String(on));
  };
  button.addEventListener('click', () => {
    fill();
    open(sheet.hidden);
  });
  document.addEventListener('pointerdown', (event) => {
    if (!(event.target as Element).closest('.menu')) open(false);
  });
  sheet.addEventListener('click', () => open(false));
  // Wherever the focus is, and before the page's own Escape, which clears the selection.
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || sheet.hidden) return;
    event.stopPropagation();
    open(false);
    button.focus();
  }, true);
}
