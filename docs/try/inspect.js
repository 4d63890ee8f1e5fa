// Measures by the suite's programs what is wrong with a file, and where.

import {Mesh, run} from 'transformesh';
import {edgesOf, firstAtPlace} from './edges.js';
import {isIntersecting, isTurned} from './marks.js';
import {argumentOf} from './tasks.js';

const decoder = new TextDecoder();

export class Refusal extends Error {}

// A program's last line without its name.
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

// A file of any format as binary PLY, its positions and faces, and what its reader remarks.
export async function read(name, bytes) {
  // Longer than the name of the input, hence another one.
  const output = `x-${name}.ply`;
  const words = [argumentOf(name), '-o', output, '--format=ply'];
  const {files, messages} = await runOrRefuse('tm-convert', words, {[argumentOf(name)]: bytes});
  const ply = files[output];
  return {ply, ...arraysOf(ply), notes: notesOf(messages)};
}

// The pairs as text, and the segments in which the faces of pairs meet.
async function intersectionsOf(ply, marks) {
  const words = ['in.ply', '--check', '--quiet', '--pairs=pairs.txt', '--segments=segments.ply'];
  const {files} = await runOrRefuse('tm-intersect', words, {'in.ply': ply}, 1);
  const numbers = decoder.decode(files['pairs.txt']).split(/\s+/);
  numbers.pop();
  for (const number of numbers) marks[number] |= isIntersecting;
  return {pairs: numbers.length / 2, segments: Mesh.fromPly(files['segments.ply']).positions};
}

// 1 if two triangles have the same corners, in the same order up to rotation, -1 if reversed, else 0.
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

// Faces keep their order when tm-stitch turns them; those that lose a corner are dropped.
function markTurned(mesh, turned, marks) {
  const first = firstAtPlace(mesh.positions);
  for (let face = 0, other = 0; face < marks.length && other < turned.faces.length / 3; ++face) {
    const [a, b, c] = [0, 1, 2].map((k) => first[mesh.faces[3 * face + k]]);
    if (a === b || b === c || c === a) continue;
    if (turnBetween(mesh, face, turned, other) < 0) marks[face] |= isTurned;
    ++other;
  }
}

// The mesh with joined places and faces that agree, or undefined if its surface has one side only.
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

// Counts, facts, a mark for each face, and segments to draw, of a mesh that read() has returned.
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
