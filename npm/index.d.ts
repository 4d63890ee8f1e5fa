/** A value of an option: `true` for a flag, text for lengths such as '1%' or '0.7x'. */
export type OptionValue = string | number | boolean | undefined;
/** Options of the command line in camel case: `{ mergeFlat: true }` is `--merge-flat`. */
export type Options = Record<string, OptionValue>;
export type Format =
  'ply' | 'ply-ascii' | 'ply-be' | 'off' | 'obj' | 'stl' | 'glb' | 'vtp' | '3mf' | 'xyz';
export type Operation = 'union' | 'intersection' | 'difference' | 'xor';

export class Mesh {
  constructor(positions: ArrayLike<number>, faces: ArrayLike<number>);
  static fromPly(bytes: Uint8Array): Mesh;
  readonly positions: Float64Array;
  readonly faces: Uint32Array;
  readonly ply: Uint8Array;
  /** What the program reports with --report, for results of a program. */
  report?: Record<string, unknown>;
  /** Lines that the program would print on stderr. */
  messages?: string[];
}

export class TransforMeshError extends Error {
  /** Exit code of the program: 2 usage, 3 input, 4 goal not reached, 5 output, 6 memory. */
  readonly code: number;
}

export interface RunResult {
  code: number;
  printed: string;
  messages: string[];
  files: Record<string, Uint8Array>;
}

export function load(source?: URL | BufferSource | WebAssembly.Module): Promise<WebAssembly.Module>;
export function read(bytes: Uint8Array, name?: string): Promise<Mesh>;
export function write(mesh: Mesh, format: Format): Promise<Uint8Array>;
export function clean(mesh: Mesh, options?: Options): Promise<Mesh>;
export function repair(mesh: Mesh, options?: Options): Promise<Mesh>;
export function remesh(mesh: Mesh, options?: Options): Promise<Mesh>;
export function stitch(mesh: Mesh, options?: Options): Promise<Mesh>;
export function fill(mesh: Mesh, options?: Options): Promise<Mesh>;
export function boolean(operation: Operation, meshes: Mesh[], options?: Options): Promise<Mesh>;
export function offset(mesh: Mesh, distance: number | string, options?: Options): Promise<Mesh>;
export function info(mesh: Mesh, options?: Options): Promise<Record<string, unknown>>;
export function countIntersections(mesh: Mesh): Promise<number>;
export function run(
  program: string, words: string[], files?: Record<string, Uint8Array>,
  onMessage?: (line: string) => void): Promise<RunResult>;
