import type { HeldKeys } from '../drive/hands';

const kSliderKeys = ['Home', 'End', 'PageUp', 'PageDown'];

/** Whether keys are somebody else's: text is typed, a choice is made, a dialog is open. */
function isTaken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (document.querySelector('dialog[open]') || event.ctrlKey || event.metaKey || event.altKey) return true;
  if (target instanceof HTMLSelectElement) return key.startsWith('Arrow');
  if (target instanceof HTMLInputElement && target.type === 'range') return key.startsWith('Arrow') || kSliderKeys.includes(key);
  return target instanceof HTMLInputElement && target.type !== 'checkbox';
}

/** One key, one action. */
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
 * Tells which keys are down, for as long as they are. Whatever could hide that a key goes up (another window, a field to
 * type in, a dialog, a chord of the system's) lets go of all of them. `changed` says whether Shift is down.
 */
export function listenForHeldKeys(keys: HeldKeys, changed: (fast: boolean) => void): void {
  const letGo = () => {
    keys.clear();
    changed(false);
  };
  window.addEventListener('keydown', (event) => {
    if (isTaken(event)) return letGo();
    // A key that still repeats after it was let go of must be pressed anew.
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
