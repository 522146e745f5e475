// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.

/** Commands of a page to the program (docs/viewer-commands.md). Models by id. */
export type Command =
  | { do: 'ack'; frame: number }
  | { do: 'look'; x_min: number; y_min: number; x_max: number; y_max: number; sensors: boolean }
  | { do: 'select'; model: number | null }
  | { do: 'physics' }
  | { do: 'drive'; model: number; forward: number; sideways: number; turn: number; input?: number }
  | { do: 'join'; name: string; x: number; y: number; a: number }
  | { do: 'say'; text: string }
  | { do: 'pause' }
  | { do: 'resume' }
  | { do: 'step' }
  | { do: 'speed'; times_real_time: number }
  | { do: 'rewind'; tick: number }
  | { do: 'drag'; model: number; x: number; y: number; a: number }
  | { do: 'add'; robot: number; x: number; y: number; a: number }
  | { do: 'copy'; model: number; x: number; y: number; a: number }
  | { do: 'remove'; model: number }
  | { do: 'mute'; viewer: number; on: boolean }
  | { do: 'kick'; viewer: number }
  | { do: 'save' };

/** The name of a person: maximum length, pattern, and the rule in words. */
export const kNameLetters = 24;
export const kNamePattern = '[A-Za-z][A-Za-z0-9_\\-]*';
export const kNameRule = 'letters, digits, - and _, the first one a letter';
/** Text that makes a person wave. */
export const kWave = '*waves*';
