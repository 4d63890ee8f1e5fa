import type {
  BooleanOptions, CheckmanifoldOptions, CleanOptions, FillOptions, InfoOptions, MorphOptions, OffsetOptions,
  RemeshOptions, RepairOptions, StitchOptions } from './options.js';

export * from './options.js';

/** Units of the mesh, or text: '1%' of its bounding box's diagonal, '0.7x' of the reference edge. */
export type Length = number | string;
export type Format =
  'ply' | 'ply-ascii' | 'ply-be' | 'off' | 'obj' | 'stl' | 'glb' | 'vtp' | '3mf' | 'xyz';
export type Operation = 'union' | 'intersection' | 'difference' | 'xor' | 'cut';

export interface Control {
  /**
   * Called about 20 times a second with the phase of the run and the fraction of the phase that is done.
   * An exception ends the run, and the call is rejected with it.
   */
  progress?: (phase: string, fraction: number) => void;
  /** Called with each line of stderr while the program runs; an exception acts as one of `progress`. */
  message?: (line: string) => void;
  /** The run takes place in a worker, which ends when the signal is aborted. */
  signal?: AbortSignal;
}

export class Mesh {
  constructor(positions: ArrayLike<number>, faces: ArrayLike<number>);
  static fromPly(bytes: Uint8Array): Mesh;
  /** x, y and z of each vertex: a copy, as are the faces. Changed arrays need a new mesh. */
  readonly positions: Float64Array;
  /** Three indices of vertices per face. */
  readonly faces: Uint32Array;
  /** Binary PLY, as the programs exchange it. */
  readonly ply: Uint8Array;
  /** The report that the program writes with --report, of results of a program. */
  report?: Record<string, unknown>;
  /** Lines that the program prints on stderr. */
  messages?: string[];
}

export class TransforMeshError extends Error {
  /** Exit code of the program: 2 usage, 3 input, 4 goal not reached, 5 output, 6 memory. */
  readonly code: number;
  /** Lines that the program printed on stderr; the last one is the error. */
  readonly messages: string[];
}

export interface RunResult {
  code: number;
  /** Standard output, which is text: meshes are files. */
  printed: string;
  messages: string[];
  /** Written files, also those in folders, by path. */
  files: Record<string, Uint8Array>;
}

/** What tm-info reports; lengths in units of the mesh, angles in degrees. */
export interface Info {
  vertices: number;
  faces: number;
  edges: number;
  components: number;
  genus: number | null;
  boundary_loops: number;
  area: number;
  volume: number;
  bbox_min: [number, number, number];
  bbox_max: [number, number, number];
  edge_mean: number;
  edge_min: number;
  edge_max: number;
  angle_min: number;
  angle_min_mean: number;
  valence6: number;
  [key: string]: unknown;
}

/** What tm-checkmanifold reports. */
export interface ManifoldReport {
  manifold: boolean;
  oriented: boolean;
  closed: boolean;
  /** The first reason for a no, with a remedy. There is none for a yes. */
  problem?: string;
  [key: string]: unknown;
}

/** Compiles the module; later calls return the first result. */
export function load(source?: URL | BufferSource | WebAssembly.Module): Promise<WebAssembly.Module>;
export function read(bytes: Uint8Array, name?: string, control?: Control): Promise<Mesh>;
export function write(mesh: Mesh, format: Format, control?: Control): Promise<Uint8Array>;
export function clean(mesh: Mesh, options?: CleanOptions): Promise<Mesh>;
export function repair(mesh: Mesh, options?: RepairOptions): Promise<Mesh>;
export function remesh(mesh: Mesh, options?: RemeshOptions): Promise<Mesh>;
export function stitch(mesh: Mesh, options?: StitchOptions): Promise<Mesh>;
export function fill(mesh: Mesh, options?: FillOptions): Promise<Mesh>;
export function boolean(operation: Operation, meshes: Mesh[], options?: BooleanOptions): Promise<Mesh>;
export function offset(mesh: Mesh, distance: Length | undefined, options?: OffsetOptions): Promise<Mesh>;
export function morph(mesh: Mesh, target: Mesh, options?: MorphOptions): Promise<Mesh>;
export function info(mesh: Mesh, options?: InfoOptions): Promise<Info>;
export function checkmanifold(mesh: Mesh, options?: CheckmanifoldOptions): Promise<ManifoldReport>;
export function countIntersections(mesh: Mesh, control?: Control): Promise<number>;
/** Runs any program on files in memory, given by name and returned by path. */
export function run(
  program: string, words: string[], files?: Record<string, Uint8Array>, control?: Control): Promise<RunResult>;
