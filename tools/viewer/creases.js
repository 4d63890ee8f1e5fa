// Vertex normals for shading: smooth, except at creases, as those of tm-render. A vertex at a crease
// becomes one vertex per corner.

const cosineOf = (degrees) => Math.cos(degrees * Math.PI / 180);

// Faces that bend more than this from each other do not share a normal. It is the crease angle of
// tm-render.
const leastCosineOfFaces = cosineOf(40);

// A vertex is at a crease if one of its faces bends more than this from their mean normal. It is half of
// the crease angle, since the mean of two faces is in their middle.
const leastCosineOfMean = cosineOf(20);

// Vertices with more corners have one normal, since the cost is quadratic in the number of corners. A
// thousand corners take a few milliseconds. Corners of merged flat regions have up to some hundreds.
const mostCorners = 1000;

// Returns the sums of face normals at the vertices, and the face normals, both weighted by area.
function sumsOf({indices, positions}) {
  const sums = new Float32Array(positions.length), faces = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const a = 3 * indices[i], b = 3 * indices[i + 1], c = 3 * indices[i + 2];
    const ux = positions[b] - positions[a], vx = positions[c] - positions[a];
    const uy = positions[b + 1] - positions[a + 1], vy = positions[c + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2], vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    faces[i] = x;
    faces[i + 1] = y;
    faces[i + 2] = z;
    for (const corner of [a, b, c]) {
      sums[corner] += x;
      sums[corner + 1] += y;
      sums[corner + 2] += z;
    }
  }
  return {sums, faces};
}

// Returns true if two vectors form at most the angle with this cosine, or if one of them is 0.
function areNear(one, i, other, j, leastCosine) {
  const dot = one[i] * other[j] + one[i + 1] * other[j + 1] + one[i + 2] * other[j + 2];
  const lengths = Math.hypot(one[i], one[i + 1], one[i + 2]) * Math.hypot(other[j], other[j + 1], other[j + 2]);
  return dot >= leastCosine * lengths;
}

// Returns a map from the vertices at creases to their corners.
function cornersAtCreases({indices}, {sums, faces}) {
  const corners = new Map();
  for (let corner = 0; corner < indices.length; ++corner)
    if (!areNear(sums, 3 * indices[corner], faces, corner - corner % 3, leastCosineOfMean)) corners.set(indices[corner], []);
  if (corners.size > 0)
    for (let corner = 0; corner < indices.length; ++corner) corners.get(indices[corner])?.push(corner);
  for (const [vertex, some] of corners) if (some.length > mostCorners) corners.delete(vertex);
  return corners;
}

// Returns the sum of those normals of faces at some corners that are near that of one corner.
function sumNear(corner, corners, faces) {
  const face = corner - corner % 3, sum = [0, 0, 0];
  for (const other of corners) {
    const from = other - other % 3;
    if (!areNear(faces, face, faces, from, leastCosineOfFaces)) continue;
    for (let axis = 0; axis < 3; ++axis) sum[axis] += faces[from + axis];
  }
  return sum;
}

function normalize(vectors) {
  for (let i = 0; i < vectors.length; i += 3) {
    const length = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]) || 1;
    for (let axis = 0; axis < 3; ++axis) vectors[i + axis] /= length;
  }
}

// Returns an array of triples to which those of the sources are appended.
export function withCopies(triples, sources) {
  if (sources.length === 0) return triples;
  const all = new triples.constructor(triples.length + 3 * sources.length);
  all.set(triples);
  sources.forEach((source, i) => all.set(triples.subarray(3 * source, 3 * source + 3), triples.length + 3 * i));
  return all;
}

// Returns normals, positions and indices. Appended vertices are copies of the vertices in `sources`.
export function withCreases(mesh) {
  const found = sumsOf(mesh);
  const indices = mesh.indices.slice(), sources = [], added = [];
  for (const [vertex, corners] of cornersAtCreases(mesh, found)) {
    for (const corner of corners) {
      indices[corner] = mesh.positions.length / 3 + sources.length;
      sources.push(vertex);
      added.push(...sumNear(corner, corners, found.faces));
    }
  }
  const normals = withCopies(found.sums, sources);
  normals.set(added, found.sums.length);
  normalize(normals);
  return {normals, indices, sources, positions: withCopies(mesh.positions, sources)};
}
