// The package has no types of its own.
declare module 'earcut' {
  export default function earcut(vertices: ArrayLike<number>, holes?: number[], dimensions?: number): number[];
}
