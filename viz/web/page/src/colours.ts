// Colours: the palettes and scales of viz/render/colour.cpp, so that page, pictures and movie look alike. What
// must be told apart differs in lightness too, and all scales are even in lightness.

export type Rgb = readonly [number, number, number];

/** A colour scale: control points at equal distances, straight lines between, sampled at 256 places. */
export class ColourMap {
  readonly table: Uint8Array;

  constructor(points: readonly Rgb[]) {
    this.table = new Uint8Array(256 * 3);
    for (let i = 0; i < 256; ++i) {
      const place = (i / 255) * (points.length - 1);
      const below = Math.min(Math.floor(place), points.length - 2);
      for (let c = 0; c < 3; ++c)
        this.table[3 * i + c] = Math.round(
          points[below][c] + (points[below + 1][c] - points[below][c]) * (place - below),
        );
    }
  }

  /** Index into the table for a share in [0, 1]; outside: the nearest end. */
  static slot(share: number): number {
    return share > 0 ? Math.min(255, Math.round(share * 255)) : 0;
  }

  css(share: number): string {
    const i = 3 * ColourMap.slot(share);
    return css([this.table[i], this.table[i + 1], this.table[i + 2]]);
  }
}

export function css(colour: Rgb, opacity = 1): string {
  return opacity === 1 ? `rgb(${colour.join(' ')})` : `rgb(${colour.join(' ')} / ${opacity})`;
}

const blueToYellow = new ColourMap([
  [54, 36, 98], [58, 68, 128], [50, 98, 140], [40, 126, 142], [36, 152, 136],
  [62, 180, 116], [122, 202, 84], [190, 220, 60], [250, 232, 60],
]);
const amberToBlack = new ColourMap([
  [250, 178, 60], [242, 136, 44], [222, 92, 52], [188, 54, 84], [140, 34, 104], [84, 18, 100], [22, 10, 50],
]);
const violetToWhite = new ColourMap([
  [126, 60, 170], [170, 62, 160], [210, 72, 130], [238, 100, 92], [250, 146, 70], [253, 196, 96], [255, 244, 190],
]);
const indigoToCream = new ColourMap([
  [38, 26, 86], [84, 38, 126], [136, 50, 132], [188, 66, 116], [230, 100, 88], [250, 156, 90], [254, 226, 150],
]);
const blueGreyRed = new ColourMap([
  [16, 66, 150], [66, 124, 196], [150, 186, 222], [232, 232, 232], [240, 176, 140], [212, 100, 68], [142, 20, 36],
]);
const blueDarkRed = new ColourMap([
  [150, 206, 255], [80, 150, 230], [46, 92, 150], [58, 60, 66], [160, 70, 52], [236, 116, 76], [255, 198, 150],
]);

export interface Palette {
  paper: Rgb;
  ink: Rgb;
  faint: Rgb;
  frame: Rgb;
  grid: Rgb;
  disc: Rgb;
  /** Factor by which the rim of a disc is darker (below 1) or lighter than its face. */
  rim: number;
  tension: Rgb;
  shear: Rgb;
  well: Rgb;
  water: Rgb;
  pull: Rgb;
  push: Rgb;
  mark: Rgb;
  /** Quantities without a sign, on discs. */
  magnitude: ColourMap;
  /** Along cracks: stands out from plain discs at both ends. */
  narrow: ColourMap;
  pressure: ColourMap;
  /** Quantities with a sign, grey in the middle. */
  twoWays: ColourMap;
  /** Fractures in turn. */
  series: readonly Rgb[];
}

const light: Palette = {
  paper: [255, 255, 255], ink: [28, 28, 32], faint: [110, 112, 120], frame: [150, 152, 160], grid: [228, 229, 233],
  disc: [229, 230, 233], rim: 0.8,
  tension: [12, 12, 16], shear: [200, 20, 140], well: [214, 32, 38], water: [20, 110, 180],
  pull: [206, 74, 32], push: [28, 92, 170], mark: [255, 120, 0],
  magnitude: indigoToCream, narrow: amberToBlack, pressure: blueToYellow, twoWays: blueGreyRed,
  series: [[20, 84, 184], [213, 94, 0], [0, 120, 90], [170, 60, 150], [120, 90, 20], [70, 130, 200]],
};

const dark: Palette = {
  paper: [16, 18, 22], ink: [236, 237, 240], faint: [158, 162, 172], frame: [88, 92, 102], grid: [46, 49, 57],
  disc: [48, 51, 59], rim: 1.45,
  tension: [255, 255, 250], shear: [255, 92, 200], well: [255, 96, 84], water: [88, 178, 255],
  pull: [255, 150, 88], push: [96, 170, 255], mark: [255, 170, 40],
  magnitude: indigoToCream, narrow: violetToWhite, pressure: blueToYellow, twoWays: blueDarkRed,
  series: [[92, 156, 255], [255, 150, 60], [60, 200, 150], [230, 120, 210], [210, 180, 90], [150, 200, 250]],
};

export function palette(): Palette {
  return document.documentElement.dataset.theme === 'dark' ? dark : light;
}
