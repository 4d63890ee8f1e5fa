// Finds defects of a file, and where they are, by programs of the suite.

import {Mesh, run} from 'transformesh';
import {edgesOf, firstAtPlace} from './edges.js';
import {isIntersecting, isTurned} from './marks.js';
import {argumentOf} from './tasks.js';

const decoder = new TextDecoder();

export class Refusal extends Error {}

// Returns the last line of a program without the name of the program.
export const sentenceOf = (program, {code, messages}) =>
  (messages.at(-1) ?? `ended with exit code ${code}`).replace(`${program}: `, '');

async function runOrRefuse(program, words, files, most = 0) {
  const result = await run(program, words, files);
  if (result.code > most) throw new Refusal(sentenceOf(program, result));
  return result;
}

const arraysOf = (bytes) => {
  const {positions, faces} = Mesh.fromPly(bytes);
  return {positions, faces};
};

const notesOf = (messages) => messages.map((line) => line.replace(/^tm-[a-z-]+: /, '')).filter(
  // Every STL file is a soup, which the page joins itself.
  (line) => !/read as a soup of separate triangles/.test(line));

// Reads a file of any format. Returns it as binary PLY, positions and faces, and remarks of the reader.
export async function read(name, bytes) {
  // The name is longer than that of the input, hence different.
  const output = `x-${name}.ply`;
  const words = [argumentOf(name), '-o', output, '--format=ply'];
  const {files, messages} = await runOrRefuse('tm-convert', words, {[argumentOf(name)]: bytes});
  const ply = files[output];
  return {ply, ...arraysOf(ply), notes: notesOf(messages)};
}

// Returns the number of pairs and the segments in which their faces meet, and marks these faces.
async function intersectionsOf(ply, marks) {
  const words = ['in.ply', '--check', '--quiet', '--pairs=pairs.txt', '--segments=segments.ply'];
  const {files} = await runOrRefuse('tm-intersect', words, {'in.ply': ply}, 1);
  const numbers = decoder.decode(files['pairs.txt']).split(/\s+/);
  numbers.pop();
  for (const number of numbers) marks[number] |= isIntersecting;
  return {pairs: numbers.length / 2, segments: Mesh.fromPly(files['segments.ply']).positions};
}

// Returns 1 if two triangles have the same corners in the same cyclic order, -1 if reversed, else 0.
function turnBetween(one, face, other, otherFace) {
  const at = (mesh, f, k) => 3 * mesh.faces[3 * f + k];
  const isSame = (i, j) => [0, 1, 2].every((axis) =>
    one.positions[at(one, face, i) + axis] === other.positions[at(other, otherFace, j) + axis]);
  const start = [0, 1, 2].find((j) => isSame(0, j));
  if (start === undefined) return 0;
  const next = (start + 1) % 3, last = (start + 2) % 3;
  if (isSame(1, next) && isSame(2, last)) return 1;
  return isSame(1, last) && isSame(2, next) ? -1 : 0;
}

// Marks faces that tm-stitch has turned. It keeps the order of faces, and drops faces that lose a corner.
function markTurned(mesh, turned, marks) {
  const first = firstAtPlace(mesh.positions);
  for (let face = 0, other = 0; face < marks.length && other < turned.faces.length / 3; ++face) {
    const [a, b, c] = [0, 1, 2].map((k) => first[mesh.faces[3 * face + k]]);
    if (a === b || b === c || c === a) continue;
    if (turnBetween(mesh, face, turned, other) < 0) marks[face] |= isTurned;
    ++other;
  }
}

// Returns the mesh with joined vertices and consistent faces, or as it is if its surface is one-sided.
async function orientedOf(mesh, marks) {
  const words = ['in.ply', '--orient', '--outwards', '-o', 'out.ply', '--report=report.json'];
  const {code, files} = await run('tm-stitch', words, {'in.ply': mesh.ply});
  if (code !== 0) return {oneSided: true, turned: 0, ply: mesh.ply};
  const {result} = JSON.parse(decoder.decode(files['report.json']));
  const ply = files['out.ply'];
  if (result.turned_faces > 0) markTurned(mesh, arraysOf(ply), marks);
  return {oneSided: false, turned: result.turned_faces, ply};
}

async function reportOf(program, ply) {
  const {printed} = await runOrRefuse(program, ['in.ply', '--json', '--quiet'], {'in.ply': ply}, 1);
  return JSON.parse(printed);
}

const roomOf = (low, high) => low.map((x, axis) => high[axis] - x);

// Returns counts, facts, a mark per face, and segments to draw, for a mesh that read() has returned.
export async function inspect(mesh) {
  const marks = new Uint8Array(mesh.faces.length / 3);
  const {holes, borders, branching, disagreeing} = edgesOf(mesh);
  const {pairs, segments} = await intersectionsOf(mesh.ply, marks);
  const {turned, oneSided, ply} = await orientedOf(mesh, marks);
  const flat = (await reportOf('tm-checkmanifold', mesh.ply)).degenerate_faces;
  const info = await reportOf('tm-info', ply);
  return {
    counts: {intersections: pairs, holes, turned, branching: branching.length / 6, flat, oneSided: oneSided ? 1 : 0},
    facts: {
      faces: marks.length, parts: info.components, size: roomOf(info.bbox_min, info.bbox_max), area: info.area,
      volume: info.volume,
    },
    marks, segments: {intersections: segments, holes: borders, branching, turned: disagreeing},
  };
}
