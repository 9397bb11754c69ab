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
  const points: number[] = [];
  const triangles: number[] = [];
  const shades: number[] = [];
  for (let i = 0; i + 1 < first.length; ++i) {
    if (colours[4 * i + 3] === 0) continue;
    const begin = first[i];
    const count = first[i + 1] - begin;
    if (count < 3) continue;
    const base = points.length / 3;
    const outline: number[] = [];
    for (let j = 0; j < count; ++j) {
      const at = 2 * corner[begin + j];
      points.push(position[at], position[at + 1], 0);
      shades.push(colours[4 * i], colours[4 * i + 1], colours[4 * i + 2], colours[4 * i + 3]);
      outline.push(position[at], position[at + 1]);
    }
    const ears = count === 3 ? [0, 1, 2] : earcut(outline);
    for (let j = 0; j < ears.length; j += 3)
      triangles.push(3, base + ears[j], base + ears[j + 1], base + ears[j + 2]);
  }
  return {
    points: new Float32Array(points),
    triangles: new Uint32Array(triangles),
    colours: new Uint8Array(shades),
  };
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
