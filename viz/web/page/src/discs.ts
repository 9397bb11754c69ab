// Discs that are round at any zoom: each is a triangle that faces the camera, and a few lines of shader cut the
// circle out of it, one pixel soft, with a darker rim where there is room for one. A face of opacity 0 leaves the
// rim alone. Models of more discs than
// that can draw smoothly are drawn as points from afar, and as discs as soon as few enough are in view.
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkSphereMapper from '@kitware/vtk.js/Rendering/Core/SphereMapper';
import '@kitware/vtk.js/Rendering/OpenGL/SphereMapper';
import { colourArray, plain } from './shapes';
import { View } from './view';

/** More discs than this are drawn as points from afar. */
const manyDiscs = 150000;

// Camera coordinates are metres, as the projection is parallel: a pixel is how far they change across one.
const circle = `
  float discPixel = fwidth(vertexVC.x);
  float discDistance = length(vertexVC.xy - centerVCVSOutput.xy);
  float discCover = clamp((radiusVCVSOutput - discDistance) / discPixel + 0.5, 0.0, 1.0);
  if (discCover <= 0.0) { discard; }
`;
const rim = (shade: number) => `
  float discRoom = clamp((radiusVCVSOutput / discPixel - 3.0) / 5.0, 0.0, 1.0);
  float discInner = radiusVCVSOutput - max(0.08 * radiusVCVSOutput, discPixel);
  float discRim = discRoom * clamp((discDistance - discInner) / discPixel + 0.5, 0.0, 1.0);
  gl_FragData[0].rgb *= mix(1.0, ${shade.toFixed(3)}, discRim);
  gl_FragData[0].a = discCover * max(opacity, 0.3 * discRim);
`;

export class DiscLayer {
  readonly actors: vtkActor[];
  private discs = vtkActor.newInstance();
  private dots = vtkActor.newInstance();
  private discMapper = vtkSphereMapper.newInstance();
  private dotMapper = vtkMapper.newInstance();
  private positions: ArrayLike<number> = [];
  private radii: ArrayLike<number> = [];
  private colours: Uint8Array = new Uint8Array(0);
  private meanRadius = 0;
  private shown = false;
  private cut: readonly number[] | null = null;
  private rimShade = 0;
  private dotsStale = true;

  constructor(height: number) {
    this.discMapper.setScaleArray('radius');
    this.discMapper.setScaleFactor(1);
    for (const mapper of [this.discMapper, this.dotMapper]) {
      mapper.setColorModeToDirectScalars();
      mapper.setScalarModeToUsePointData();
    }
    this.discs.setMapper(this.discMapper);
    this.dots.setMapper(this.dotMapper);
    this.actors = [this.discs, this.dots];
    for (const actor of this.actors) plain(actor, height);
    this.hide();
  }

  /** Factor by which rims differ from faces. */
  setRim(shade: number): void {
    if (shade === this.rimShade) return;
    this.rimShade = shade;
    const replace = (originalValue: string, replacementValue: string, replaceFirst: boolean) => ({
      shaderType: 'Fragment', originalValue, replaceFirst, replacementValue, replaceAll: false,
    });
    this.discMapper.setViewSpecificProperties({
      OpenGL: {
        ShaderReplacements: [
          replace('//VTK::Depth::Impl', circle, true),
          replace('//VTK::Light::Impl', rim(shade), false),
        ],
      },
    });
  }

  setHeight(height: number): void {
    for (const actor of this.actors) actor.setPosition(0, 0, height);
  }

  hide(): void {
    this.shown = false;
    for (const actor of this.actors) actor.setVisibility(false);
  }

  show(positions: ArrayLike<number>, radii: ArrayLike<number>, colours: Uint8Array, view: View): void {
    this.positions = positions;
    this.radii = radii;
    this.colours = colours;
    let sum = 0;
    for (let i = 0; i < radii.length; ++i) sum += radii[i];
    this.meanRadius = radii.length ? sum / radii.length : 0;
    this.shown = radii.length > 0;
    this.cut = null;
    this.dotsStale = true;
    this.adapt(view);
  }

  /** Chooses what to draw for this view; call it when the view has changed. */
  adapt(view: View): void {
    if (!this.shown) return this.hide();
    const count = this.radii.length;
    if (count <= manyDiscs) {
      if (!this.cut) this.drawDiscs(null);
      this.cut = [];
      this.turnOn(this.discs);
      return;
    }
    const [left, bottom, right, top] = view.bounds();
    const old = this.cut;
    if (old && old.length && left >= old[0] && bottom >= old[1] && right <= old[2] && top <= old[3]) {
      this.turnOn(this.discs);
      return;
    }
    // A margin of half a view, so that small moves need no new choice.
    const margin = [(right - left) / 2, (top - bottom) / 2];
    const wanted = [left - margin[0], bottom - margin[1], right + margin[0], top + margin[1]];
    const chosen: number[] = [];
    const positions = this.positions;
    for (let i = 0; i < count && chosen.length <= manyDiscs; ++i) {
      const x = positions[2 * i];
      const y = positions[2 * i + 1];
      if (x >= wanted[0] && x <= wanted[2] && y >= wanted[1] && y <= wanted[3]) chosen.push(i);
    }
    if (chosen.length <= manyDiscs) {
      this.drawDiscs(chosen);
      this.cut = wanted;
      this.turnOn(this.discs);
    } else {
      this.drawDots(view);
      this.turnOn(this.dots);
    }
  }

  private turnOn(actor: vtkActor): void {
    for (const one of this.actors) one.setVisibility(one === actor);
  }

  private drawDiscs(chosen: readonly number[] | null): void {
    const count = chosen ? chosen.length : this.radii.length;
    const points = new Float32Array(3 * count);
    const radii = new Float32Array(count);
    const colours = chosen ? new Uint8Array(4 * count) : this.colours;
    for (let k = 0; k < count; ++k) {
      const i = chosen ? chosen[k] : k;
      points[3 * k] = this.positions[2 * i];
      points[3 * k + 1] = this.positions[2 * i + 1];
      radii[k] = this.radii[i];
      if (chosen) colours.set(this.colours.subarray(4 * i, 4 * i + 4), 4 * k);
    }
    const data = vtkPolyData.newInstance();
    data.getPoints().setData(points, 3);
    data.getPointData().setScalars(colourArray(colours));
    data.getPointData().addArray(vtkDataArray.newInstance({ name: 'radius', values: radii }));
    this.discMapper.setInputData(data);
  }

  private drawDots(view: View): void {
    const size = Math.max(1, Math.round((1.8 * this.meanRadius) / view.metresPerPixel()));
    this.dots.getProperty().setPointSize(size);
    if (!this.dotsStale) return;
    this.dotsStale = false;
    const count = this.radii.length;
    const points = new Float32Array(3 * count);
    const vertices = new Uint32Array(2 * count);
    for (let i = 0; i < count; ++i) {
      points[3 * i] = this.positions[2 * i];
      points[3 * i + 1] = this.positions[2 * i + 1];
      vertices[2 * i] = 1;
      vertices[2 * i + 1] = i;
    }
    const data = vtkPolyData.newInstance();
    data.getPoints().setData(points, 3);
    data.getVerts().setData(vertices);
    data.getPointData().setScalars(colourArray(this.colours));
    this.dotMapper.setInputData(data);
  }
}
