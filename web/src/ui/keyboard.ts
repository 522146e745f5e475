/** One key, one action; not while something is being typed or a dialog is open. */
export function listenForKeys(actions: Record<string, () => void>): void {
  window.addEventListener('keydown', (event) => {
    const typing = event.target instanceof HTMLInputElement && event.target.type !== 'checkbox';
    if (document.querySelector('dialog[open]')) return;
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
