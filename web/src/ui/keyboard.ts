import type { HeldKeys } from '../drive/hands';

const kSliderKeys = ['Home', 'End', 'PageUp', 'PageDown'];

/** Whether another element handles the key: text input, a select, a slider, an open dialog. */
function isTaken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (document.querySelector('dialog[open]') || event.ctrlKey || event.metaKey || event.altKey) return true;
  if (target instanceof HTMLSelectElement) return key.startsWith('Arrow');
  if (target instanceof HTMLInputElement && target.type === 'range') return key.startsWith('Arrow') || kSliderKeys.includes(key);
  return target instanceof HTMLInputElement && target.type !== 'checkbox';
}

/** Binds keys to actions. */
export function listenForKeys(actions: Record<string, () => void>): void {
  window.addEventListener('keydown', (event) => {
    if (isTaken(event)) return;
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/**
 * Tracks the pressed keys. Releases all of them on any event that could hide a keyup (loss
 * of focus, a text field, a dialog, a system shortcut). `changed`: whether Shift is down.
 */
export function listenForHeldKeys(keys: HeldKeys, changed: (fast: boolean) => void): void {
  const letGo = () => {
    keys.clear();
    changed(false);
  };
  window.addEventListener('keydown', (event) => {
    if (isTaken(event)) return letGo();
    // Key repeat after a forced release does not count: the key must be pressed anew.
    if (!event.repeat) keys.press(event.code, event.key);
    changed(event.shiftKey);
    if (event.key.startsWith('Arrow')) event.preventDefault();
  });
  window.addEventListener('keyup', (event) => {
    keys.release(event.code);
    changed(event.shiftKey);
  });
  window.addEventListener('blur', letGo);
  window.addEventListener('focusin', (event) => {
    if (event.target instanceof Element && event.target.closest('input, dialog')) letGo();
  });
  document.addEventListener('visibilitychange', letGo);
}
