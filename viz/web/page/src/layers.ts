// The list of layers at the left: each on or off, with what it is coloured by.
import { make } from './dom';
import { fieldsOf, viewsOf } from './fields';
import { Settings } from './paint';
import { Grid } from './server';

export class LayerList {
  private discSelect = make('select', { 'aria-label': 'Colour of discs', id: 'disc-colour' });
  private crackSelect: HTMLSelectElement;
  private boxes: HTMLInputElement[] = [];
  private offered = '';

  constructor(container: HTMLElement, private settings: Settings, private changed: () => void) {
    this.crackSelect = this.select('crack-colour', 'Colour of cracks', 'crackColour', this.crackChoices());
    const widths = this.select('crack-width', 'Width of cracks', 'crackWidth', [
      ['even', 'even width'],
      ['aperture', 'width by aperture'],
    ]);
    this.discSelect.append(make('option', { value: 'plain' }, 'plain'));
    this.discSelect.addEventListener('change', () => this.colourDiscs(this.discSelect.value));
    container.append(
      this.layer('cracks', 'Cracks', this.crackSelect, widths),
      this.layer('pores', 'Fluid pressure'),
      this.layer('bonds', 'Forces across bonds'),
      this.layer('discs', 'Discs', this.discSelect),
    );
  }

  /** Offers the fields that this grid has. */
  offer(grid: Grid): void {
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

  private layer(name: 'discs' | 'pores' | 'bonds' | 'cracks', title: string, ...parts: HTMLElement[]): HTMLElement {
    const box = this.box(name, title);
    (box.firstChild as HTMLElement).dataset.layer = name;
    return make('div', { class: 'layer' }, box, ...parts);
  }

  private box(name: 'discs' | 'pores' | 'bonds' | 'cracks' , title: string) {
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
    id: string, label: string, name: 'crackColour' | 'crackWidth', choices: readonly (readonly [string, string])[],
  ): HTMLSelectElement {
    const select = make('select', { id, 'aria-label': label });
    for (const [value, text] of choices) select.append(make('option', { value }, text));
    select.value = this.settings[name];
    select.addEventListener('change', () => this.set(name, select.value as never));
    return select;
  }
}
