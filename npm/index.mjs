// The programs of TransforMesh as functions on meshes in memory. Each call runs a program, so results
// and errors are those of the command line.
import { instantiate, load } from './module.mjs';
import { arraysOf, plyOf } from './ply.mjs';

export { load };

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

/** What a program refused, with its exit code (man page tm(7)) and its sentence. */
export class TransforMeshError extends Error {
  constructor(message, code) {
    super(message);
    this.name = 'TransforMeshError';
    this.code = code;
  }
}

const optionOf = (name) => '--' + name.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());

function wordsOf(options) {
  return Object.entries(options).flatMap(([name, value]) => {
    if (value === undefined || value === false) return [];
    return value === true ? [optionOf(name)] : [`${optionOf(name)}=${value}`];
  });
}

/**
 * Runs a program on files in memory and returns its exit code, files and messages. Files that it writes
 * into a folder are named by their path.
 * @param {string} program such as 'tm-clean'
 * @param {string[]} words of the command line
 * @param {Record<string, Uint8Array>} [files] by name, for the program to read
 * @param {(line: string) => void} [onMessage] called for each message while the program runs
 */
export async function run(program, words, files = {}, onMessage = undefined) {
  const messages = [], printed = [];
  const module = await instantiate({
    print: (line) => printed.push(line),
    printErr: (line) => {
      messages.push(line);
      onMessage?.(line);
    },
    stdin: () => null,
  });
  const { FS } = module;
  FS.mkdir('/work');
  FS.chdir('/work');
  for (const [name, bytes] of Object.entries(files)) FS.writeFile(name, bytes);
  const code = module.callMain([program, ...words]);
  const written = filesIn(FS, '').filter((name) => !(name in files));
  const results = Object.fromEntries(written.map((name) => [name, FS.readFile(name)]));
  return { code, printed: printed.join('\n'), messages, files: results };
}

/** Paths of the files in a folder below /work, and in those within it; names with a dot are temporary. */
function filesIn(FS, folder) {
  const names = FS.readdir(`/work/${folder}`).filter((name) => !name.startsWith('.'));
  return names.map((name) => folder + name).flatMap((path) =>
    FS.isDir(FS.stat(`/work/${path}`).mode) ? filesIn(FS, `${path}/`) : [path]);
}

async function runOrThrow(program, words, files, most = 0) {
  const result = await run(program, words, files);
  if (result.code > most) {
    const text = result.messages.at(-1) ?? `ended with exit code ${result.code}`;
    throw new TransforMeshError(text.replace(`${program}: `, ''), result.code);
  }
  return result;
}

/** Runs a program that makes one mesh of meshes. The report, if there is one, is a property of it. */
async function filter(program, meshes, options = {}, first = []) {
  const files = Object.fromEntries(meshes.map((mesh, i) => [`${i}.ply`, mesh.ply]));
  const words = [...first, ...Object.keys(files), ...wordsOf(options)];
  const result = await runOrThrow(
    program, [...words, '-o', 'result.ply', '--report', 'report.json', '--format=ply'], files);
  const mesh = Mesh.fromPly(result.files['result.ply']);
  mesh.report = JSON.parse(new TextDecoder().decode(result.files['report.json']));
  mesh.messages = result.messages;
  return mesh;
}

/** Reads any format of the suite; the name's ending says which one, where the bytes do not. */
export async function read(bytes, name = 'mesh') {
  const file = `input-${name.replace(/[^\w.-]/g, '_')}`;
  const words = [file, '-o', 'result.ply', '--format=ply'];
  const result = await runOrThrow('tm-convert', words, { [file]: bytes });
  const mesh = Mesh.fromPly(result.files['result.ply']);
  mesh.messages = result.messages;
  return mesh;
}

/** Returns the bytes of a file: ply, ply-ascii, ply-be, off, obj, stl, glb, vtp, 3mf or xyz. */
export async function write(mesh, format) {
  const words = ['0.ply', '-o', 'result', `--format=${format}`];
  const result = await runOrThrow('tm-convert', words, { '0.ply': mesh.ply });
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

/** Counts and measures, with the keys of tm-info. */
export async function info(mesh, options = {}) {
  const words = ['0.ply', '--json', ...wordsOf(options)];
  return JSON.parse((await runOrThrow('tm-info', words, { '0.ply': mesh.ply })).printed);
}

/** Number of pairs of faces that intersect each other. */
export async function countIntersections(mesh) {
  const words = ['0.ply', '--check', '--get=pairs'];
  return Number((await runOrThrow('tm-intersect', words, { '0.ply': mesh.ply }, 1)).printed);
}
