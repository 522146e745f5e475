/** Colours of the map view, for light and dark pages. */
export interface Theme {
  floor: number;
  sky: number;
  grid: number;
  axis: number;
  edge: number;
  text: string;
  halo: string;
  bubble: string;
  bubbleEdge: string;
  flag: string;
  select: number;
  dark: boolean;
}

const kLight: Theme = {
  floor: 0xf4f5f7,
  sky: 0xbcd6ee,
  grid: 0xdfe3e8,
  axis: 0xc2c9d2,
  edge: 0x23282f,
  text: '#1d2430',
  halo: 'rgba(255,255,255,0.85)',
  bubble: '#ffffff',
  bubbleEdge: '#8b95a3',
  flag: '#f2c200',
  select: 0x2f6fed,
  dark: false,
};

const kDark: Theme = {
  floor: 0x171b21,
  sky: 0x0f1a2b,
  grid: 0x242a33,
  axis: 0x3a434f,
  edge: 0x0a0c0f,
  text: '#e6eaf0',
  halo: 'rgba(13,16,20,0.8)',
  bubble: '#2a313b',
  bubbleEdge: '#6b7685',
  flag: '#f2c200',
  select: 0x6ea0ff,
  dark: true,
};

export const kDarkPage = window.matchMedia('(prefers-color-scheme: dark)');

export function themeNow(): Theme {
  return kDarkPage.matches ? kDark : kLight;
}
