/** What a page may ask of the program (docs/viewer-protocol.md). Models by id. */
export type Command =
  | { do: 'pause' }
  | { do: 'resume' }
  | { do: 'step' }
  | { do: 'speed'; times_real_time: number }
  | { do: 'rewind'; tick: number }
  | { do: 'drag'; model: number; x: number; y: number; a: number }
  | { do: 'drive'; model: number; forward: number; sideways: number; turn: number; input?: number }
  | { do: 'copy'; model: number; x: number; y: number; a: number }
  | { do: 'add'; robot: number; x: number; y: number; a: number } // place in scene.addable
  | { do: 'join'; name: string; x: number; y: number; a: number }
  | { do: 'say'; text: string }
  | { do: 'remove'; model: number }
  | { do: 'mute'; viewer: number; on: boolean }
  | { do: 'kick'; viewer: number }
  | { do: 'save' }
  | { do: 'physics' }
  | { do: 'select'; model: number | null }
  | { do: 'look'; x_min: number; y_min: number; x_max: number; y_max: number; sensors: boolean }
  | { do: 'ack'; frame: number };
