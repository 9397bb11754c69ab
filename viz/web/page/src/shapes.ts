// Flat shapes for vtk.js: lines as quads of a width in metres (a line of OpenGL is one pixel wide), and
// polygons cut into triangles. Each shape has one colour.
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import earcut from 'earcut';

export interface Mesh {
  /** x y z of each corner; z is the height of the layer. */
  points: Float32Array;
  /** 3 a b c, 3 a b c, ... as vtk.js has it. */
  triangles: Uint32Array;
  /** Red, green, blue, opacity of each corner. */
  colours: Uint8Array;
}

/** One quad per segment; `half` gives half its width in metres, 0 for none. */
export function quads(
  count: number,
  ends: (i: number) => readonly [number, number, number, number],
  half: (i: number) => number,
  colours: Uint8Array,
): Mesh {
  const points = new Float32Array(12 * count);
  const triangles = new Uint32Array(8 * count);
  const shades = new Uint8Array(16 * count);
  let shown = 0;
  for (let i = 0; i < count; ++i) {
    const width = half(i);
    if (!(width > 0)) continue;
    const [x0, y0, x1, y1] = ends(i);
    const length = Math.hypot(x1 - x0, y1 - y0) || 1;
    const across = (-(y1 - y0) / length) * width;
    const along = ((x1 - x0) / length) * width;
    points.set([x0 + across, y0 + along, 0, x0 - across, y0 - along, 0], 12 * shown);
    points.set([x1 - across, y1 - along, 0, x1 + across, y1 + along, 0], 12 * shown + 6);
    const first = 4 * shown;
    triangles.set([3, first, first + 1, first + 2, 3, first, first + 2, first + 3], 8 * shown);
    for (let corner = 0; corner < 4; ++corner)
      shades.set(colours.subarray(4 * i, 4 * i + 4), 16 * shown + 4 * corner);
    ++shown;
  }
  return {
    points: points.subarray(0, 12 * shown),
    triangles: triangles.subarray(0, 8 * shown),
    colours: shades.subarray(0, 16 * shown),
  };
}

/** Polygons given by `first` and `corner` as in a grid; those with opacity 0 are left out. Pores are nearly
 * convex, but those around a well have many corners and are not. */
export function polygons(
  position: ArrayLike<number>, first: ArrayLike<number>, corner: ArrayLike<number>, colours: Uint8Array,
): Mesh {
  const shown = (i: number) => colours[4 * i + 3] > 0 && first[i + 1] - first[i] > 2;
  let corners = 0;
  let pieces = 0;
  for (let i = 0; i + 1 < first.length; ++i) {
    if (!shown(i)) continue;
    corners += first[i + 1] - first[i];
    pieces += first[i + 1] - first[i] - 2;
  }
  const points = new Float32Array(3 * corners);
  const shades = new Uint8Array(4 * corners);
  const triangles = new Uint32Array(4 * pieces);
  let base = 0;
  let filled = 0;
  for (let i = 0; i + 1 < first.length; ++i) {
    if (!shown(i)) continue;
    const count = first[i + 1] - first[i];
    for (let j = 0; j < count; ++j) {
      const at = 2 * corner[first[i] + j];
      points[3 * (base + j)] = position[at];
      points[3 * (base + j) + 1] = position[at + 1];
      for (let c = 0; c < 4; ++c) shades[4 * (base + j) + c] = colours[4 * i + c];
    }
    if (count === 3) {
      triangles.set([3, base, base + 1, base + 2], filled);
      filled += 4;
    } else {
      const outline: number[] = [];
      for (let j = base; j < base + count; ++j) outline.push(points[3 * j], points[3 * j + 1]);
      const ears = earcut(outline);
      // Corners that coincide or lie on a line give fewer triangles than there is room for.
      for (let j = 0; j + 2 < ears.length && filled < triangles.length; j += 3, filled += 4) {
        triangles[filled] = 3;
        for (let c = 0; c < 3; ++c) triangles[filled + 1 + c] = base + ears[j + c];
      }
    }
    base += count;
  }
  return { points, triangles: triangles.subarray(0, filled), colours: shades };
}

/** Colours are taken as they are: no light, no table. */
export function plain(actor: vtkActor, height: number): void {
  actor.getProperty().setLighting(false);
  actor.setForceOpaque(true);
  actor.setPosition(0, 0, height);
  actor.setPickable(false);
}

export function colourArray(colours: Uint8Array): vtkDataArray {
  return vtkDataArray.newInstance({ name: 'colour', numberOfComponents: 4, values: colours });
}

/** An actor that shows one mesh after another. */
export class MeshLayer {
  readonly actor = vtkActor.newInstance();
  private mapper = vtkMapper.newInstance();

  constructor(height: number) {
    this.mapper.setColorModeToDirectScalars();
    this.mapper.setScalarModeToUsePointData();
    this.actor.setMapper(this.mapper);
    plain(this.actor, height);
    this.actor.setVisibility(false);
  }

  show(mesh: Mesh | null): void {
    const filled = mesh !== null && mesh.triangles.length > 0;
    this.actor.setVisibility(filled);
    if (!filled) return;
    const data = vtkPolyData.newInstance();
    data.getPoints().setData(mesh.points, 3);
    data.getPolys().setData(mesh.triangles);
    data.getPointData().setScalars(colourArray(mesh.colours));
    this.mapper.setInputData(data);
  }
}
