// The time line: slider, steps, playing. Playing waits for each picture, so a slow machine shows every moment
// slowly instead of skipping some.
import { find } from './dom';

export class Player {
  private slider = find<HTMLInputElement>('slider');
  private speed = find<HTMLSelectElement>('speed');
  private playing = false;
  private count = 0;
  now = 0;

  constructor(private show: (index: number) => Promise<void>) {
    this.slider.addEventListener('input', () => {
      this.pause();
      void this.go(Number(this.slider.value));
    });
    find('play').addEventListener('click', () => this.toggle());
    find('first').addEventListener('click', () => this.step(-Infinity));
    find('last').addEventListener('click', () => this.step(Infinity));
    find('back').addEventListener('click', () => this.step(-1));
    find('forth').addEventListener('click', () => this.step(1));
    this.mark();
  }

  setCount(count: number): void {
    this.count = count;
    this.slider.max = String(Math.max(0, count - 1));
    this.slider.disabled = count < 2;
    for (const id of ['play', 'first', 'last', 'back', 'forth']) find<HTMLButtonElement>(id).disabled = count < 2;
    if (this.now >= count) this.now = Math.max(0, count - 1);
    this.slider.value = String(this.now);
  }

  atEnd(): boolean {
    return this.now >= this.count - 1;
  }

  async go(index: number): Promise<void> {
    this.now = Math.min(Math.max(0, index), Math.max(0, this.count - 1));
    this.slider.value = String(this.now);
    await this.show(this.now);
  }

  step(by: number): void {
    this.pause();
    void this.go(this.now + by);
  }

  pause(): void {
    this.playing = false;
    this.mark();
  }

  toggle(): void {
    if (this.playing) return this.pause();
    if (this.count < 2) return;
    this.playing = true;
    this.mark();
    void this.play();
  }

  private async play(): Promise<void> {
    if (this.atEnd()) await this.go(0);
    while (this.playing && !this.atEnd()) {
      const begin = performance.now();
      await this.go(this.now + 1);
      const left = 1000 / Number(this.speed.value) - (performance.now() - begin);
      await new Promise((resolve) => setTimeout(resolve, Math.max(0, left)));
    }
    this.pause();
  }

  private mark(): void {
    const button = find('play');
    button.classList.toggle('playing', this.playing);
    button.setAttribute('aria-label', this.playing ? 'Pause' : 'Play');
  }
}
