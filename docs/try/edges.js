// Finds edges of a triangle soup by position. A border edge has one face; the faces of a branching edge do
// not pair up; the two faces of a disagreeing edge run along it in the same direction. Sheets may touch
// at an edge: as many faces run along it in one direction as in the other.

const bitsOf = (positions) => new Uint32Array(positions.buffer, positions.byteOffset, 2 * positions.length);

// FNV-1a over the six words of a point; multiplication by Math.imul wraps as 32-bit arithmetic does.
function hashOf(bits, v) {
  let hash = 0x811c9dc5;
  for (let i = 6 * v; i < 6 * v + 6; ++i) hash = Math.imul(hash ^ bits[i], 0x01000193);
  return (hash ^ (hash >>> 15)) >>> 0;
}

const isSamePoint = (positions, a, b) => positions[3 * a] === positions[3 * b] &&
  positions[3 * a + 1] === positions[3 * b + 1] && positions[3 * a + 2] === positions[3 * b + 2];

// Returns for each vertex the first vertex at the same position.
export function firstAtPlace(positions) {
  const count = positions.length / 3;
  // Zeros of both signs are one position: adding 0 makes them equal.
  const plain = positions.map((x) => x + 0);
  const bits = bitsOf(plain);
  let size = 16;
  while (size < 2 * count) size *= 2;
  const table = new Int32Array(size).fill(-1);
  const first = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    let slot = hashOf(bits, v) & (size - 1);
    while (table[slot] >= 0 && !isSamePoint(plain, table[slot], v)) slot = (slot + 1) & (size - 1);
    if (table[slot] < 0) table[slot] = v;
    first[v] = table[slot];
  }
  return first;
}

// Returns a number per halfedge: the smaller end, the larger end, and the direction in the lowest bit.
// A double holds it exactly for up to 2^26 vertices, more than a file of 100 MB has.
function sortedHalfedges(faces, first, count) {
  const keys = new Float64Array(faces.length);
  let used = 0;
  for (let h = 0; h < faces.length; ++h) {
    const next = h % 3 === 2 ? h - 2 : h + 1;
    const a = first[faces[h]], b = first[faces[next]];
    if (a !== b) keys[used++] = (Math.min(a, b) * count + Math.max(a, b)) * 2 + (a < b ? 0 : 1);
  }
  return keys.subarray(0, used).sort();
}

// Disjoint sets: vertices that border edges connect have one root.
class Sets {
  constructor() {
    this.parents = new Map();
  }

  root(v) {
    let root = v;
    for (let up; (up = this.parents.get(root)) !== undefined && up !== root;) root = up;
    this.parents.set(v, root);
    return root;
  }

  join(a, b) {
    this.parents.set(this.root(a), this.root(b));
  }

  count() {
    return [...this.parents.keys()].filter((v) => this.root(v) === v).length;
  }
}

function segmentsOf(positions, edges) {
  const segments = new Float64Array(6 * edges.length);
  edges.forEach(([a, b], i) => {
    segments.set(positions.subarray(3 * a, 3 * a + 3), 6 * i);
    segments.set(positions.subarray(3 * b, 3 * b + 3), 6 * i + 3);
  });
  return segments;
}

// True if as many of the halfedges run in one direction as in the other.
function areBalanced(keys) {
  let forward = 0;
  for (const key of keys) forward += key % 2 === 0 ? 1 : -1;
  return forward === 0;
}

// Returns the segments of each kind of edge, and the number of holes: connected sets of border edges.
export function edgesOf({positions, faces}) {
  const count = positions.length / 3;
  const keys = sortedHalfedges(faces, firstAtPlace(positions), count);
  const borders = [], branching = [], disagreeing = [];
  const holes = new Sets();
  for (let i = 0, end; i < keys.length; i = end) {
    const edge = Math.floor(keys[i] / 2);
    for (end = i + 1; end < keys.length && Math.floor(keys[end] / 2) === edge;) ++end;
    const ends = [Math.floor(edge / count), edge % count];
    if (end - i === 1) {
      borders.push(ends);
      holes.join(...ends);
    } else if (end - i > 2 && !areBalanced(keys.subarray(i, end))) {
      branching.push(ends);
    } else if (end - i === 2 && keys[i] === keys[i + 1]) {
      disagreeing.push(ends);
    }
  }
  return {
    holes: holes.count(), borders: segmentsOf(positions, borders),
    branching: segmentsOf(positions, branching), disagreeing: segmentsOf(positions, disagreeing),
  };
}
