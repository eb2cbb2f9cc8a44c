// Light, dark, or as the system is. Pictures of the server come in either, so pages listen for a
// change.

export type Theme = 'light' | 'dark';
const key = 'changeover-theme';
const system = window.matchMedia('(prefers-color-scheme: dark)');

export function theme(): Theme {
  const chosen = localStorage.getItem(key);
  return chosen === 'light' || chosen === 'dark' ? chosen : system.matches ? 'dark' : 'light';
}

function show(): void {
  document.documentElement.dataset['theme'] = theme();
  document.dispatchEvent(new Event('themechange'));
}

export function startTheme(): void {
  show();
  system.addEventListener('change', show);
}

/** Calls `draw` now and whenever the theme changes, until `signal` is aborted. */
export function withTheme(signal: AbortSignal, draw: (theme: Theme) => void): void {
  document.addEventListener('themechange', () => draw(theme()), { signal });
  draw(theme());
}

export function toggleTheme(): void {
  const next = theme() === 'dark' ? 'light' : 'dark';
  (next === 'dark') === system.matches
    ? localStorage.removeItem(key)
    : localStorage.setItem(key, next);
  show();
}
