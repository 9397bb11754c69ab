// The list of layers at the left: each on or off, with what it is coloured by.
import { make } from './dom';
import { fieldsOf, viewsOf } from './fields';
import { Settings } from './paint';
import { Grid } from './server';

type LayerName = 'discs' | 'pores' | 'bonds' | 'cracks' | 'joints';

export class LayerList {
  private discSelect = make('select', { 'aria-label': 'Colour of discs', id: 'disc-colour' });
  private crackSelect: HTMLSelectElement;
  private jointSelect: HTMLSelectElement;
  private jointLayer: HTMLElement;
  private boxes: HTMLInputElement[] = [];
  private offered = '';

  constructor(container: HTMLElement, private settings: Settings, private changed: () => void) {
    this.crackSelect = this.select('crack-colour', 'Colour of cracks', 'crackColour', this.crackChoices());
    const widths = this.select('crack-width', 'Width of cracks', 'crackWidth', [
      ['even', 'even width'],
      ['aperture', 'width by aperture'],
    ]);
    this.jointSelect = this.select('joint-colour', 'Colour of joints', 'jointColour', this.jointChoices());
    this.discSelect.append(make('option', { value: 'plain' }, 'plain'));
    this.discSelect.addEventListener('change', () => this.colourDiscs(this.discSelect.value));
    container.append(
      this.layer('cracks', 'Cracks', this.crackSelect, widths),
      this.layer('pores', 'Fluid pressure'),
      this.layer('bonds', 'Forces across bonds'),
      this.layer('discs', 'Discs', this.discSelect),
      (this.jointLayer = this.layer('joints', 'Joints', this.jointSelect)),
    );
    this.jointLayer.hidden = true;
  }

  /** Offers the fields that the grid of the discs has, and joints if there are any. */
  offer(grid: Grid, joints: Grid | null): void {
    this.jointLayer.hidden = !joints;
    const fields = fieldsOf('discs', grid);
    const offered = fields.map(({ id }) => id).join();
    if (offered === this.offered) return;
    this.offered = offered;
    this.discSelect.replaceChildren(make('option', { value: 'plain' }, 'plain'));
    for (const { id, name } of fields) this.discSelect.append(make('option', { value: id }, name.toLowerCase()));
    if (!fields.some(({ id }) => id === this.settings.discColour)) this.settings.discColour = 'plain';
    this.discSelect.value = this.settings.discColour;
    this.crackSelect.replaceChildren(...this.crackChoices().map(([value, text]) => make('option', { value }, text)));
    this.crackSelect.value = this.settings.crackColour;
    this.jointSelect.replaceChildren(...this.jointChoices().map(([value, text]) => make('option', { value }, text)));
    this.jointSelect.value = this.settings.jointColour;
  }

  private jointChoices(): (readonly [string, string])[] {
    return viewsOf('joints').map(({ name, label, title }) => [name, `by ${label || title.toLowerCase()}`] as const);
  }

  private crackChoices(): (readonly [string, string])[] {
    return [
      ['mode', 'by mode'],
      ...viewsOf('cracks').map(({ name, label }) => [name, `by ${label}`] as const),
      ['fracture', 'by fracture'],
    ];
  }

  /** Turns the layer with this number, from above, on or off. */
  toggle(number: number): void {
    this.boxes[number]?.click();
  }

  private set<Name extends keyof Settings>(name: Name, value: Settings[Name]): void {
    this.settings[name] = value;
    this.changed();
  }

  /** Pores cover the discs, so choosing a field of the discs takes the pores away. */
  private colourDiscs(field: string): void {
    if (field !== 'plain') {
      this.leaveOutPores();
      this.settings.discs = this.boxOf('discs').checked = true;
    }
    this.set('discColour', field);
  }

  leaveOutPores(): void {
    this.settings.pores = this.boxOf('pores').checked = false;
  }

  private boxOf(name: string): HTMLInputElement {
    return this.boxes.find(({ dataset }) => dataset.layer === name) as HTMLInputElement;
  }

  private layer(name: LayerName, title: string, ...parts: HTMLElement[]): HTMLElement {
    const box = this.box(name, title);
    (box.firstChild as HTMLElement).dataset.layer = name;
    return make('div', { class: 'layer' }, box, ...parts);
  }

  private box(name: LayerName, title: string) {
    const box = make('input', { type: 'checkbox', id: `layer-${name}` });
    box.checked = this.settings[name];
    box.addEventListener('change', () => {
      // What pores cover needs no colour.
      if (name === 'pores' && box.checked) this.settings.discColour = this.discSelect.value = 'plain';
      this.set(name, box.checked);
    });
    this.boxes.push(box);
    return make('label', { class: 'check' }, box, make('span', {}, title));
  }

  private select(
    id: string, label: string, name: 'crackColour' | 'crackWidth' | 'jointColour', choices: readonly (readonly [string, string])[],
  ): HTMLSelectElement {
    const select = make('select', { id, 'aria-label': label });
    for (const [value, text] of choices) select.append(make('option', { value }, text));
    select.value = this.settings[name];
    select.addEventListener('change', () => this.set(name, select.value as never));
    return select;
  }
}
