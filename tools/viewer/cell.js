// A cell of the 3D view draws one run, scaled to a ball of radius 1 around 0.

import {BufferAttribute, BufferGeometry, Group, LineSegments, Mesh, Points} from 'three';
import {Marks} from './marks.js';
import {surfaceMaterial} from './materials.js';

// Returns center and radius of a ball around all meshes and targets of a run.
export function extentOf(run) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const meshes = [...run.meshes, ...run.targets];
  for (const mesh of meshes) {
    for (let axis = 0; axis < 3; ++axis) {
      low[axis] = Math.min(low[axis], mesh.low[axis]);
      high[axis] = Math.max(high[axis], mesh.high[axis]);
    }
  }
  const middle = low.map((end, axis) => end / 2 + high[axis] / 2);
  const radius = Math.max(...meshes.map((mesh) =>
    mesh.radius + Math.hypot(...middle.map((x, axis) => mesh.low[axis] / 2 + mesh.high[axis] / 2 - x))));
  return {middle, radius: radius > 0 ? radius : 1};
}

// Returns a pyramid for each camera, with the camera center as apex and the image as base.
function frustaOf(cameras, {middle, radius}) {
  const points = [];
  for (const {center, corners} of cameras) {
    const eye = center.map((x, axis) => (x - middle[axis]) / radius);
    const depth = 0.12 * Math.hypot(...eye);
    const ends = corners.map((ray) => ray.map((x, axis) => eye[axis] + depth * x));
    ends.forEach((end, i) => points.push(...eye, ...end, ...end, ...ends[(i + 1) % 4]));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
  return geometry;
}

export class Cell {
  constructor(run, extent, radius, up, shared) {
    this.extent = extent;
    this.cameras = [];
    this.photograph = document.createElement('img');
    this.photograph.hidden = true;
    this.element = document.createElement('div');
    this.element.className = 'cell';
    this.label = document.createElement('span');
    this.element.append(this.photograph, this.label);
    this.label.textContent = run.name;

    this.group = new Group();
    this.scale = extent.radius / radius;
    this.group.scale.setScalar(this.scale);
    this.setUp(up);
    this.part = [0, 1];
    this.surface = new Mesh(new BufferGeometry(), surfaceMaterial());
    this.wires = new Mesh(new BufferGeometry(), shared.wires);
    this.points = new Points(new BufferGeometry(), shared.points.clone());
    this.ghost = new Mesh(new BufferGeometry(), shared.ghost);
    this.ghost.renderOrder = 1;
    this.ghostPoints = new Points(new BufferGeometry(), shared.ghostPoints);
    this.frusta = new LineSegments(new BufferGeometry(), shared.frusta);
    this.marks = new Marks();
    this.group.add(this.marks.group);
    for (const object of this.objects()) {
      object.frustumCulled = false;
      this.group.add(object);
    }
  }

  // Sets the axis that points up: x, y or z, with or without a minus.
  setUp(up) {
    const turns = {'x': [0, 1], '-x': [0, -1], '-y': [2, 0], 'z': [-1, 0], '-z': [1, 0]};
    const [aboutX, aboutZ] = turns[up] ?? [0, 0];
    this.group.rotation.set(aboutX * Math.PI / 2, 0, aboutZ * Math.PI / 2);
  }

  // Scales the cell down if the run has grown beyond its initial extent.
  fit(run) {
    const {middle, radius} = extentOf(run);
    const away = Math.hypot(...middle.map((x, axis) => x - this.extent.middle[axis]));
    this.group.scale.setScalar(this.scale / Math.max(1, (away + radius) / this.extent.radius));
  }

  setCameras(cameras) {
    this.cameras = cameras;
    const {middle, radius} = this.extent;
    this.frusta.geometry.dispose();
    this.frusta.geometry = frustaOf(cameras, this.extent);
    this.cameraDistance = Math.max(0, ...cameras.map(({center}) =>
      Math.hypot(...center.map((x, axis) => (x - middle[axis]) / radius))));
  }

  objects() {
    return [this.surface, this.wires, this.points, this.ghost, this.ghostPoints, this.frusta];
  }
}
