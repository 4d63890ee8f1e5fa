// The programs of TransforMesh as functions on meshes in memory. Each call runs a program, so results
// and errors are those of the command line.
import { load } from './module.mjs';
import { arraysOf, plyOf } from './ply.mjs';
import { runHere, TransforMeshError } from './run.mjs';
import { runInWorker } from './run_in_worker.mjs';

export { load, TransforMeshError };

/** A triangle mesh. It keeps columns, comments and precision of the file that it was read from. */
export class Mesh {
  #ply;
  #arrays;

  /** @param {ArrayLike<number>} positions x y z of each vertex @param {ArrayLike<number>} faces */
  constructor(positions, faces) {
    if (positions.length % 3 !== 0 || faces.length % 3 !== 0)
      throw new RangeError('positions and faces need three numbers each');
    this.#arrays = { positions: Float64Array.from(positions), faces: Uint32Array.from(faces) };
  }

  static fromPly(bytes) {
    const mesh = new Mesh([], []);
    mesh.#arrays = undefined;
    mesh.#ply = bytes;
    return mesh;
  }

  get positions() { return this.#known().positions; }
  get faces() { return this.#known().faces; }
  /** Binary PLY, as the programs exchange it. */
  get ply() { return (this.#ply ??= plyOf(this.#arrays.positions, this.#arrays.faces)); }

  #known() { return (this.#arrays ??= arraysOf(this.#ply)); }
}

const optionOf = (name) => '--' + name.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());

/** Words of the command line for options. A mesh becomes one of the files, which the word names. */
function wordsOf(options, files) {
  return Object.entries(options).flatMap(([name, value]) => {
    if (value === undefined || value === false) return [];
    if (value === true) return [optionOf(name)];
    if (!(value instanceof Mesh)) return [`${optionOf(name)}=${value}`];
    files[`${name}.ply`] = value.ply;
    return [`${optionOf(name)}=${name}.ply`];
  });
}

/**
 * Runs a program on files in memory and returns its exit code, files and messages. Files that it writes
 * into a folder are named by their path.
 * @param {string} program such as 'tm-clean'
 * @param {string[]} words of the command line
 * @param {Record<string, Uint8Array>} [files] by name, for the program to read
 * @param {{ progress?: (phase: string, fraction: number) => void, message?: (line: string) => void,
 *   signal?: AbortSignal }} [control] with a signal the program runs in a worker, else in this thread
 */
export async function run(program, words, files = {}, { progress, message, signal } = {}) {
  const job = { program, words, files };
  const control = { progress, message };
  return signal ? runInWorker(job, control, signal) : runHere(job, control);
}

async function runOrThrow(program, words, files, control, most = 0) {
  const result = await run(program, words, files, control);
  if (result.code > most) {
    const text = result.messages.at(-1) ?? `ended with exit code ${result.code}`;
    throw new TransforMeshError(text.replace(`${program}: `, ''), result.code, result.messages);
  }
  return result;
}

/** Runs a program that makes one mesh of meshes. The report, if there is one, is a property of it. */
async function filter(program, meshes, { progress, message, signal, ...options } = {}, first = []) {
  const files = Object.fromEntries(meshes.map((mesh, i) => [`${i}.ply`, mesh.ply]));
  const words = [...first, ...Object.keys(files), ...wordsOf(options, files)];
  const result = await runOrThrow(
    program, [...words, '-o', 'result.ply', '--report', 'report.json', '--format=ply'], files,
    { progress, message, signal });
  const ply = result.files['result.ply'];
  if (!ply) throw new TransforMeshError('no mesh was written', result.code, result.messages);
  const mesh = Mesh.fromPly(ply);
  mesh.report = JSON.parse(new TextDecoder().decode(result.files['report.json']));
  mesh.messages = result.messages;
  return mesh;
}

/** Runs a program that measures a mesh. */
async function measure(program, mesh, { progress, message, signal, ...options } = {}, most = 0) {
  const files = { '0.ply': mesh.ply };
  const words = ['0.ply', '--json', ...wordsOf(options, files)];
  const control = { progress, message, signal };
  return JSON.parse((await runOrThrow(program, words, files, control, most)).printed);
}

/** Reads any format of the suite; the name's ending says which one, where the bytes do not. */
export async function read(bytes, name = 'mesh', control = {}) {
  const file = `input-${name.replace(/[^\w.-]/g, '_')}`;
  const words = [file, '-o', 'result.ply', '--format=ply'];
  const result = await runOrThrow('tm-convert', words, { [file]: bytes }, control);
  const mesh = Mesh.fromPly(result.files['result.ply']);
  mesh.messages = result.messages;
  return mesh;
}

/** Returns the bytes of a file: ply, ply-ascii, ply-be, off, obj, stl, glb, vtp, 3mf or xyz. */
export async function write(mesh, format, control = {}) {
  const words = ['0.ply', '-o', 'result', `--format=${format}`];
  const result = await runOrThrow('tm-convert', words, { '0.ply': mesh.ply }, control);
  return result.files.result;
}

export const clean = (mesh, options) => filter('tm-clean', [mesh], options);
export const repair = (mesh, options) => filter('tm-repair', [mesh], options);
export const remesh = (mesh, options) => filter('tm-remesh', [mesh], options);
export const stitch = (mesh, options) => filter('tm-stitch', [mesh], options);
export const fill = (mesh, options) => filter('tm-fill', [mesh], options);
export const boolean = (operation, meshes, options) =>
  filter('tm-boolean', meshes, options, [operation]);
export const offset = (mesh, distance, options) =>
  filter('tm-offset', [mesh], { ...options, distance });

/** Evolves a mesh until it lies on the target. */
export const morph = (mesh, target, options) => filter('tm-morph', [mesh], { ...options, target });

/** Counts and measures, with the keys of tm-info. */
export const info = (mesh, options) => measure('tm-info', mesh, options);

/** Whether a mesh is an oriented manifold, with the keys of tm-checkmanifold; `problem` says where not. */
export const checkmanifold = (mesh, options) => measure('tm-checkmanifold', mesh, options, 1);

/** Number of pairs of faces that intersect each other. */
export async function countIntersections(mesh, control = {}) {
  const words = ['0.ply', '--check', '--get=pairs'];
  const files = { '0.ply': mesh.ply };
  return Number((await runOrThrow('tm-intersect', words, files, control, 1)).printed);
}
