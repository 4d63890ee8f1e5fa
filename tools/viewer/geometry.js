// Makes geometries of three.js from unpacked meshes. A geometry is made once per mesh; its colors are
// updated on request.

import {BufferAttribute, BufferGeometry} from 'three';
import {lightOfChannels} from './colors.js';
import {withCopies, withCreases} from './creases.js';

export function geometryOf(mesh) {
  if (mesh.geometry) return mesh.geometry;
  const geometry = new BufferGeometry();
  if (mesh.faces > 0) {
    const {positions, normals, indices, sources} = withCreases(mesh);
    const isSmall = positions.length <= 3 * 65535;
    geometry.setIndex(new BufferAttribute(isSmall ? new Uint16Array(indices) : indices, 1));
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.userData.sources = sources;
  } else {
    geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
    geometry.userData.sources = [];
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
    setColors(geometry, isOfFaces ? repeated(light) : withCopies(light, geometry.userData.sources), key);
  }
  return {geometry, isColored: true};
}
