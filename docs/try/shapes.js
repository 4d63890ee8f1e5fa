// Joins several measured meshes into one, which is drawn as the state before a task.

function joinedArrays(arrays) {
  const result = new arrays[0].constructor(arrays.reduce((sum, one) => sum + one.length, 0));
  let at = 0;
  for (const one of arrays) {
    result.set(one, at);
    at += one.length;
  }
  return result;
}

// Meshes that are not yet measured have neither marks nor segments.
export function joined(meshes) {
  if (meshes.length === 1) return meshes[0];
  let vertices = 0;
  const faces = meshes.map((mesh) => {
    const moved = mesh.faces.map((v) => v + vertices);
    vertices += mesh.positions.length / 3;
    return moved;
  });
  const result = {positions: joinedArrays(meshes.map((mesh) => mesh.positions)), faces: joinedArrays(faces)};
  if (!meshes.every((mesh) => mesh.marks)) return result;
  const kinds = Object.keys(meshes[0].segments);
  return {
    ...result, marks: joinedArrays(meshes.map((mesh) => mesh.marks)),
    segments: Object.fromEntries(kinds.map((kind) => [kind, joinedArrays(meshes.map((mesh) => mesh.segments[kind]))])),
  };
}
