// Shows the view of a photograph's camera with the photograph beside it.

import {Matrix4, PerspectiveCamera, Vector3} from 'three';

const cornersOf = (camera) => camera.corners.map((corner) => new Vector3(...corner));

// Returns a camera of three.js in drawing coordinates, in which meshes lie in a unit ball around 0.
export function cameraOf(camera, {middle, radius}) {
  const eye = new Vector3(...camera.center.map((x, axis) => (x - middle[axis]) / radius));
  const corners = cornersOf(camera);
  const right = corners[1].clone().sub(corners[0]).normalize();
  const down = corners[3].clone().sub(corners[0]).normalize();
  const forward = new Vector3().crossVectors(right, down);
  const near = Math.max(0.01, eye.length() - 1.2), far = eye.length() + 1.2;
  // Returns a coordinate of the point at which the ray of a corner meets the plane at depth `near`.
  const at = (corner, axis) => near * corner.dot(axis) / corner.dot(forward);

  const result = new PerspectiveCamera();
  result.matrixAutoUpdate = false;
  result.matrix.copy(new Matrix4().makeBasis(right, down.clone().negate(), forward.clone().negate())).setPosition(eye);
  result.projectionMatrix.makePerspective(
    at(corners[0], right), at(corners[1], right), -at(corners[0], down), -at(corners[3], down), near, far);
  result.projectionMatrixInverse.copy(result.projectionMatrix).invert();
  return result;
}

export function aspectOf(camera) {
  const corners = cornersOf(camera);
  return corners[1].distanceTo(corners[0]) / corners[3].distanceTo(corners[0]);
}

// Returns two rectangles of this aspect ratio in a box, side by side or one above the other. Each has
// left, top, width and height, relative to the corner of the box.
export function placesIn({width, height}, aspect) {
  const isBeside = width > height;
  const pane = isBeside ? [width / 2, height] : [width, height / 2];
  const size = Math.min((pane[0] - 16) / aspect, pane[1] - 56);
  const [wide, high] = [size * aspect, size];
  const left = (pane[0] - wide) / 2, top = (pane[1] - high) / 2 + 8;
  return [{left, top, width: wide, height: high},
    {left: left + (isBeside ? pane[0] : 0), top: top + (isBeside ? 0 : pane[1]), width: wide, height: high}];
}
