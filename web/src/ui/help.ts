import { el } from './dom';

const kKeys: [string[], string][] = [
  [['W', 'A', 'S', 'D'], 'drive the selected robot, while held; arrows and a gamepad do, too'],
  [['Q', 'E'], 'sideways, for robots that can'],
  [['Shift'], 'twice as fast'],
  [['Space'], 'pause or go on'],
  [['.'], 'one tick, then paused'],
  [['<', '>'], 'slower, faster'],
  [['T'], 'from above, with north up, or tilted'],
  [['F'], 'everything on the screen'],
  [['L'], 'follow the selected robot'],
  [['V', 'M', 'R', 'N', 'B', 'G', 'J', 'X'], 'sensors, markers, trails, names, speech and flags, grid, drawings of clients, physics shapes'],
  [['I'], 'through the eyes of the selected person, the lens of the selected robot; a click lets the mouse look around, Esc ends it'],
  [['O'], 'fly: W A S D, Q and E up and down, Shift and wheel for speed, mouse to look around; O or Esc ends it'],
  [['Enter'], 'say something, where you have joined'],
  [['H'], 'wave, where you have joined'],
  [['K'], 'what was said, beside the picture'],
  [['P'], 'what is on the screen, as a picture'],
  [['/'], 'find a robot'],
  [['C'], 'another robot like the selected one, beside it'],
  [['Delete'], 'remove the selected robot'],
  [['Esc'], 'select nothing'],
];

const kHands: [string, string][] = [
  ['Drag', 'move the view; on a robot: carry it (turn the wheel to turn it)'],
  ['Wheel, pinch', 'zoom'],
  ['Right drag, Shift drag', 'turn and tilt'],
  ['Click', 'select a robot: its devices are shown live'],
  ['Double click', 'go there'],
  ['Slider beside the time', 'back to a moment of the last minutes, and on from there'],
];

/** Opens it at its top: the browser scrolls to the button that it focuses. */
export function openHelp(dialog: HTMLDialogElement): void {
  dialog.showModal();
  dialog.scrollTop = 0;
}

export function fillHelp(dialog: HTMLDialogElement): void {
  const close = el('button', { class: 'main', value: 'close' }, 'Close');
  dialog.append(
    el('h2', {}, 'Looking at the world'),
    el('dl', {}, ...kHands.flatMap(([what, does]) => [el('dt', {}, what), el('dd', {}, does)])),
    el('dl', {}, ...kKeys.flatMap(([keys, does]) => [el('dt', {}, ...keys.map((key) => el('kbd', {}, key))), el('dd', {}, does)])),
    el('form', { method: 'dialog' }, close),
  );
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
}
