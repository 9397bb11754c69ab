// Light or dark paper: as chosen last in this browser, else as the system has it.
const key = 'hfrac-theme';

type Name = 'light' | 'dark';

/** Windows without storage keep it until they are closed. */
function stored(): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export class Theme {
  constructor(private changed: () => void) {
    const before = stored();
    const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
    document.documentElement.dataset.theme = before === 'dark' || before === 'light' ? before : system;
  }

  toggle(): void {
    const name: Name = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    document.documentElement.dataset.theme = name;
    try {
      localStorage.setItem(key, name);
    } catch {
      // as above
    }
    this.changed();
  }
}
