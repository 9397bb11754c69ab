// The picture of one moment: discs, pores, bonds, cracks and joints as layers of vtk.js, one above the other.
import vtkOpenGLRenderWindow from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';
import vtkRenderer from '@kitware/vtk.js/Rendering/Core/Renderer';
import vtkRenderWindow from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import '@kitware/vtk.js/Rendering/OpenGL/Actor';
import '@kitware/vtk.js/Rendering/OpenGL/Camera';
import '@kitware/vtk.js/Rendering/OpenGL/PolyDataMapper';
import '@kitware/vtk.js/Rendering/OpenGL/Renderer';
import { palette, Rgb } from './colours';
import { DiscLayer } from './discs';
import { MeshLayer } from './shapes';
import { View } from './view';

/** Of the layers, one above the other. */
export const height = { discs: 0, pores: 1, outlines: 2, bonds: 3, halo: 4, cracks: 5, joints: 6, camera: 10 };

export class Scene {
  readonly discs = new DiscLayer(height.discs);
  readonly pores = new MeshLayer(height.pores);
  readonly bonds = new MeshLayer(height.bonds);
  /** Paper around the cracks, so that they stand out from whatever lies below. */
  readonly halo = new MeshLayer(height.halo);
  readonly cracks = new MeshLayer(height.cracks);
  readonly joints = new MeshLayer(height.joints);
  /** Pixels of the screen per pixel of the layout. */
  pixelRatio = 1;
  private window = vtkRenderWindow.newInstance();
  private renderer = vtkRenderer.newInstance();
  private surface = vtkOpenGLRenderWindow.newInstance();

  /** Throws if the browser cannot draw. */
  constructor(container: HTMLElement, readonly view: View) {
    if (!document.createElement('canvas').getContext('webgl2'))
      throw new Error('This browser cannot draw with WebGL 2. Switch on hardware acceleration, or try another one.');
    this.window.addRenderer(this.renderer);
    this.surface.setContainer(container);
    this.window.addView(this.surface);
    // In the order of height: what is soft at its edge must find below it what it lies on.
    const meshes = [this.bonds, this.halo, this.cracks, this.joints].map(({ actor }) => actor);
    for (const actor of [this.pores.actor, ...this.discs.actors, ...meshes]) this.renderer.addActor(actor);
    const camera = this.renderer.getActiveCamera();
    camera.setParallelProjection(true);
    camera.setViewUp(0, 1, 0);
  }

  /** [pixel] of the screen. */
  resize(width: number, heightInPixels: number): void {
    this.surface.setSize(width, heightInPixels);
    this.view.resize(width, heightInPixels);
  }

  draw(): void {
    const { x, y } = this.view;
    this.discs.adapt(this.view);
    this.renderer.setBackground(palette().paper.map((c) => c / 255) as [number, number, number]);
    this.discs.setRim(palette().rim);
    const camera = this.renderer.getActiveCamera();
    camera.setFocalPoint(x, y, 0);
    camera.setPosition(x, y, height.camera);
    camera.setParallelScale((this.view.height * this.view.metresPerPixel()) / 2);
    camera.setClippingRange(1, 2 * height.camera);
    this.window.render();
  }

  /** The picture as it is, to be copied at once: it is gone when the browser has shown it. */
  canvas(): HTMLCanvasElement {
    this.draw();
    return this.surface.getCanvas() as HTMLCanvasElement;
  }
}

export function paint(colours: Uint8Array, i: number, colour: Rgb, opacity = 255): void {
  colours[4 * i] = colour[0];
  colours[4 * i + 1] = colour[1];
  colours[4 * i + 2] = colour[2];
  colours[4 * i + 3] = opacity;
}

