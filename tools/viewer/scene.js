// The 3D view: one cell for each run. All cells have the same camera.

import {
  Color, FrontSide, LineBasicMaterial, MathUtils, MeshBasicMaterial, PerspectiveCamera, PointsMaterial, Scene,
  Spherical, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {Cell, extentOf} from './cell.js';
import {coloredGeometry, geometryOf} from './geometry.js';
import {aspectOf, cameraOf, placesIn} from './photographs.js';
import {setFlat, setTint, setVertexColors, surfaceMaterial} from './materials.js';

const halfFieldOfView = MathUtils.degToRad(15);
const mostPixels = 5e5;  // most pixels that software rendering draws while something moves
const home = new Spherical(1.02 / Math.sin(halfFieldOfView), MathUtils.degToRad(70), MathUtils.degToRad(30));

function materials() {
  return {
    wires: new MeshBasicMaterial({wireframe: true, transparent: true, opacity: 0.55}),
    points: new PointsMaterial({size: 3, sizeAttenuation: false}),
    // The target is shifted back in depth, because two triangulations of one surface would
    // otherwise show spots.
    ghost: surfaceMaterial({transparent: true, opacity: 0.3, polygonOffsetFactor: 2, polygonOffsetUnits: 500, depthWrite: false, side: FrontSide}),
    ghostPoints: new PointsMaterial({size: 2, sizeAttenuation: false, transparent: true, opacity: 0.6}),
    frusta: new LineBasicMaterial({transparent: true, opacity: 0.8}),
  };
}

// True if rendering uses the CPU, which is too slow for full resolution while something moves.
function isDrawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class View {
  // `picture` returns a promise of the image source for the name of a photograph.
  constructor(stage, canvas, cells, page, colors, picture) {
    this.stage = stage;
    this.picture = picture;
    this.canvas = canvas;
    this.colors = colors;
    this.looks = {wireframe: false, flat: false, ghost: true, cameras: false, marks: true};
    this.isSlow = isDrawnBySoftware();
    this.renderer = new WebGLRenderer({canvas, antialias: !this.isSlow, alpha: true});
    this.renderer.autoClear = false;
    this.shared = materials();
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 0.05, 500);

    const extents = page.runs.map(extentOf);
    const largest = Math.max(...extents.map((extent) => extent.radius));
    const areAlike = extents.every((extent) => extent.radius > largest / 3);
    this.cells = page.runs.map((run, i) => {
      const radius = areAlike ? largest : extents[i].radius;
      const cell = new Cell(run, extents[i], radius, page.up, this.shared);
      cells.append(cell.element);
      this.scene.add(cell.group);
      return cell;
    });
    this.cellsElement = cells;
    cells.classList.toggle('single', page.runs.length === 1);

    this.controls = new OrbitControls(this.camera, stage);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => this.lookFrom());
    this.controls.minDistance = 0.3;
    this.controls.maxDistance = 250;
    this.reset();
    this.setTheme();
    // draw() is called because software rendering changes to full resolution at rest.
    new ResizeObserver(() => {
      this.resize();
      this.draw();
    }).observe(stage);
  }

  // Takes default colors from the style sheet.
  setTheme() {
    const style = getComputedStyle(document.documentElement);
    const css = (name) => style.getPropertyValue(name).trim();
    this.surfaceColor = css('--surface');
    this.pointColor = css('--points');
    this.shared.wires.color = new Color(css('--wires'));
    setTint(this.shared.ghost, css('--ghost'));
    this.shared.ghostPoints.color = this.shared.frusta.color = new Color(css('--ghost'));
    for (const cell of this.cells) this.#setColor(cell);
    this.draw();
  }

  // Sets the axis of all cells that points up.
  setUp(up) {
    for (const cell of this.cells) cell.setUp(up);
    this.draw();
  }

  // Draws two cells in one place: the first cell in this fraction of the width from the left, the
  // second cell in the rest.
  setWipe(share) {
    this.cellsElement.classList.add('over');
    this.cells[0].part = [0, share];
    this.cells[1].part = [share, 1];
    this.draw();
  }

  // Sets the lines that mark edges of a cell's mesh, in the coordinates in which the mesh is drawn.
  setMarks(i, kinds) {
    this.cells[i].marks.set(kinds);
    this.draw();
  }

  // Uses the camera with this number if the run has it, or else the camera that the user moves.
  lookFrom(number) {
    this.from = number;
    for (const cell of this.cells) this.#lookFromCamera(cell);
    this.onLook?.(number);
    this.draw();
  }

  #lookFromCamera(cell) {
    const camera = cell.cameras[this.from];
    cell.seenFrom?.removeFromParent();
    cell.seenFrom = camera && cameraOf(camera, cell.extent);
    if (camera) cell.group.add(cell.seenFrom);
    this.#setPhotograph(cell, camera);
  }

  // Shows the photograph of a camera. The previous photograph stays until the new one is loaded.
  async #setPhotograph(cell, camera) {
    const name = camera?.photograph ?? '';
    if (name === '') cell.photograph.hidden = true;
    if (cell.pictured === name) return;
    cell.pictured = name;
    if (name === '') return;
    cell.photograph.alt = `Photograph ${camera.name}`;
    const source = await this.picture(name).catch(() => '');
    if (cell.pictured !== name) return;
    cell.photograph.src = source;
    cell.photograph.hidden = source === '';
  }

  setCameras(i, cameras) {
    const cell = this.cells[i];
    if (cell.cameras === cameras) return;
    cell.setCameras(cameras);
    if (this.from !== undefined) this.#lookFromCamera(cell);
    this.draw();
  }

  reset() {
    this.lookFrom();
    this.controls.target.set(0, 0, 0);
    this.camera.position.setFromSpherical(home);
    this.controls.update();
    this.draw();
  }

  // Moves the camera to a point of a run's mesh, at half the distance that reset() sets. The point is in
  // coordinates of the mesh, and becomes the center of rotation. The direction is that of reset(), or
  // points from outside at the mesh.
  lookAt(run, place, isFromOutside = false) {
    this.lookFrom();
    const {group, extent} = this.cells[run];
    group.updateMatrixWorld();
    const target = group.localToWorld(new Vector3(...place.map((x, axis) => (x - extent.middle[axis]) / extent.radius)));
    const offset = new Vector3().setFromSpherical(home).multiplyScalar(0.5);
    if (isFromOutside) {
      const distance = offset.length();
      // A point in the middle has no outside. The camera is moved a little to the side, so that
      // shading shows the shape of the surface.
      offset.setLength(0.3).add(target.clone().normalize()).setLength(distance);
    }
    this.controls.target.copy(target);
    this.camera.position.copy(offset).add(target);
    this.controls.update();
    this.draw();
  }

  // Rotates the camera by angles in degrees. A factor above 1 moves it closer.
  turn(azimuth, elevation, factor = 1) {
    this.lookFrom();
    const offset = new Vector3().subVectors(this.camera.position, this.controls.target);
    const place = new Spherical().setFromVector3(offset);
    place.theta += MathUtils.degToRad(azimuth);
    place.phi -= MathUtils.degToRad(elevation);
    place.radius /= factor;
    place.makeSafe();
    this.camera.position.setFromSpherical(place).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  setTarget(i, mesh) {
    const cell = this.cells[i];
    const shown = mesh.faces > 0 ? cell.ghost : cell.ghostPoints;
    shown.geometry = geometryOf(mesh);
    cell.hasTarget = shown;
    this.draw();
  }

  setMesh(i, mesh, colorBy, scale) {
    const cell = this.cells[i];
    const {geometry, isColored} = coloredGeometry(mesh, colorBy, scale, this.colors);
    cell.isColored = isColored;
    cell.isSurface = mesh.faces > 0;
    cell.surface.geometry = cell.wires.geometry = cell.points.geometry = geometry;
    this.#setColor(cell);
    this.draw();
  }

  #setColor(cell) {
    const color = cell.isColored ? '#ffffff' : this.surfaceColor;
    for (const {material} of [cell.surface, cell.points]) setVertexColors(material, Boolean(cell.isColored));
    setTint(cell.surface.material, color);
    cell.points.material.color = new Color(cell.isColored ? color : this.pointColor);
  }

  setLooks(looks) {
    Object.assign(this.looks, looks);
    if (looks.cameras) this.#goBackToSeeCameras();
    for (const {surface} of this.cells) setFlat(surface.material, this.looks.flat);
    this.draw();
  }

  #goBackToSeeCameras() {
    const farthest = Math.max(1, ...this.cells.map((cell) => cell.cameraDistance * cell.group.scale.x));
    const offset = this.camera.position.clone().sub(this.controls.target);
    const distance = Math.max(offset.length(), 1.05 * farthest / Math.sin(halfFieldOfView));
    this.camera.position.copy(this.controls.target).add(offset.setLength(distance));
    this.controls.update();
  }

  // Sets the resolution: software rendering uses a low resolution while something moves, and four
  // samples for each pixel at rest.
  resize(isAtRest = false) {
    const {clientWidth: width, clientHeight: height} = this.stage;
    const coarse = Math.min(1, Math.sqrt(mostPixels / (width * height)));
    this.isFine = isAtRest;
    this.renderer.setPixelRatio(this.isSlow ? (isAtRest ? 2 : coarse) : Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.isLaidOut = true;
    this.#render();
  }

  // Draws at most once per frame of the screen.
  draw() {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      if (this.isSlow && this.isFine) this.resize(); else this.#render();
      if (!this.isSlow) return;
      clearTimeout(this.rest);
      this.rest = setTimeout(() => this.resize(true), 250);
    });
  }

  #render() {
    if (!this.isLaidOut) return;
    const stage = this.stage.getBoundingClientRect();
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    for (const cell of this.cells) this.#renderCell(cell, stage);
    this.pictures = (this.pictures ?? 0) + 1;
  }

  #renderCell(cell, stage) {
    const box = cell.element.getBoundingClientRect();
    if (!(box.width > 0 && box.height > 0) || cell.part[0] >= cell.part[1]) return;
    for (const other of this.cells) other.group.visible = other === cell;
    const {wireframe, ghost, cameras, marks} = this.looks;
    cell.surface.visible = cell.isSurface === true;
    cell.wires.visible = cell.isSurface === true && wireframe;
    cell.points.visible = cell.isSurface === false;
    cell.ghost.visible = ghost && cell.hasTarget === cell.ghost;
    cell.ghostPoints.visible = ghost && cell.hasTarget === cell.ghostPoints;
    cell.frusta.visible = cameras;
    cell.marks.group.visible = marks;

    const place = [box.left - stage.left, stage.bottom - box.bottom];
    if (cell.seenFrom) return this.#renderBeside(cell, box, place);
    const aspect = box.width / box.height;
    this.camera.aspect = aspect;
    const half = aspect >= 1 ? halfFieldOfView : Math.atan(Math.tan(halfFieldOfView) / aspect);
    this.camera.fov = 2 * MathUtils.radToDeg(half);
    this.camera.updateProjectionMatrix();
    this.#renderInto([...place, box.width, box.height], this.camera, cell.part);
  }

  // Draws the mesh from the photograph's camera, beside the photograph.
  #renderBeside(cell, box, [left, bottom]) {
    cell.frusta.visible = false;
    const [photograph, render] = placesIn(box, aspectOf(cell.cameras[this.from]));
    for (const [name, value] of Object.entries(photograph)) cell.photograph.style[name] = `${value}px`;
    this.#renderInto([left + render.left, bottom + box.height - render.top - render.height, render.width, render.height], cell.seenFrom);
  }

  #renderInto(rectangle, camera, [from, to] = [0, 1]) {
    const [left, bottom, width, height] = rectangle;
    this.renderer.setViewport(...rectangle);
    this.renderer.setScissor(left + from * width, bottom, (to - from) * width, height);
    this.renderer.render(this.scene, camera);
  }
}
