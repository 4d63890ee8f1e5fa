// Makes geometries of three.js from unpacked meshes. A geometry is made once per mesh; its colors are
// updated on request.

import {BufferAttribute, BufferGeometry} from 'three';
import {lightOfChannels} from './colors.js';

// Returns area-weighted vertex normals. The function of three.js gives the same and takes ten times as
// long.
function normalsOf({indices, positions}) {
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < indices.length; i += 3) {
    const a = 3 * indices[i], b = 3 * indices[i + 1], c = 3 * indices[i + 2];
    const ux = positions[b] - positions[a], vx = positions[c] - positions[a];
    const uy = positions[b + 1] - positions[a + 1], vy = positions[c + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2], vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const corner of [a, b, c]) {
      normals[corner] += x;
      normals[corner + 1] += y;
      normals[corner + 2] += z;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    normals[i] /= length;
    normals[i + 1] /= length;
    normals[i + 2] /= length;
  }
  return normals;
}

export function geometryOf(mesh) {
  if (mesh.geometry) return mesh.geometry;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  if (mesh.faces > 0) {
    const indices = mesh.vertices <= 65535 ? new Uint16Array(mesh.indices) : mesh.indices;
    geometry.setIndex(new BufferAttribute(indices, 1));
    geometry.setAttribute('normal', new BufferAttribute(normalsOf(mesh), 3));
  }
  mesh.geometry = geometry;
  return geometry;
}

// Returns a geometry without shared vertices, as colors per face require.
function geometryOfFaces(mesh) {
  if (!mesh.geometryOfFaces) mesh.geometryOfFaces = geometryOf(mesh).toNonIndexed();
  return mesh.geometryOfFaces;
}

export function dispose(mesh) {
  mesh.geometry?.dispose();
  mesh.geometryOfFaces?.dispose();
}

function setColors(geometry, light, key) {
  geometry.setAttribute('color', new BufferAttribute(light, 3));
  geometry.userData.colors = key;
}

const repeated = (light) => {
  const corners = new Float32Array(3 * light.length);
  for (let i = 0; i < light.length; i += 3)
    for (let k = 0; k < 3; ++k)
      for (let c = 0; c < 3; ++c) corners[3 * i + 3 * k + c] = light[i + c];
  return corners;
};

// Returns the geometry with the colors of a column. `isColored` is false if the mesh lacks the column.
export function coloredGeometry(mesh, name, scale, colors) {
  const column = mesh.columns.find((one) => one.name === name);
  if (!column) return {geometry: geometryOf(mesh), isColored: false};
  const isOfFaces = column.of === 'face';
  const geometry = isOfFaces ? geometryOfFaces(mesh) : geometryOf(mesh);
  const key = column.channels ? name : `${name} ${scale.low} ${scale.high}`;
  if (geometry.userData.colors !== key) {
    const light = column.channels ? lightOfChannels(column.channels) : colors.light(column.values, scale);
    setColors(geometry, isOfFaces ? repeated(light) : light, key);
  }
  return {geometry, isColored: true};
}
