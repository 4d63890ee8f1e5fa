// The 3D part of the page, on the view of tm-view: one mesh, a mesh before and after with a line between
// them, or a film.

import {Colors} from '../../tools/viewer/colors.js';
import {dispose} from '../../tools/viewer/geometry.js';
import {keysOfView} from '../../tools/viewer/keys.js';
import {bytesOfColor} from '../../tools/viewer/materials.js';
import {View} from '../../tools/viewer/scene.js';
import {byId} from './elements.js';

// All meshes are scaled into a ball of radius 1 around 0.
const unit = {name: '', targets: [], meshes: [{low: [-1, -1, -1], high: [1, 1, 1], radius: 1}]};
const nothing = {positions: new Float64Array(0), faces: new Uint32Array(0)};
const colorOfKind = {intersections: '--crossing', holes: '--hole', branching: '--branch', turned: '--turned'};
const secondsOfFilm = 6;

const cssColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// Returns the center of the box of several meshes, and the radius of a ball around it that contains them.
function ballOf(meshes) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const {positions} of meshes) {
    for (let i = 0; i < positions.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
  }
  const middle = low.map((x, axis) => (x <= high[axis] ? x / 2 + high[axis] / 2 : 0));
  let square = 0;
  for (const {positions} of meshes) {
    for (let i = 0; i < positions.length; i += 3) {
      const x = positions[i] - middle[0], y = positions[i + 1] - middle[1], z = positions[i + 2] - middle[2];
      square = Math.max(square, x * x + y * y + z * z);
    }
  }
  const radius = Math.sqrt(square);
  return {middle, radius: radius > 0 && Number.isFinite(radius) ? radius : 1};
}

// A loop takes a tenth of the time of Float32Array.from with a function.
function scaled(positions, {middle, radius}) {
  const result = new Float32Array(positions.length);
  for (let i = 0; i < result.length; ++i) result[i] = (positions[i] - middle[i % 3]) / radius;
  return result;
}

// Returns the colors of faces as a column of the viewer, or no column if no face has a mark.
function columnsOf(marks) {
  if (!marks?.some((mark) => mark !== 0)) return [];
  const [plain, crossing, turned] = ['--surface', '--crossing', '--turned'].map((name) => bytesOfColor(cssColor(name)));
  const channels = [0, 1, 2].map((c) => {
    // The index is the mark: none, intersecting, turned, both.
    const bytes = [plain[c], crossing[c], turned[c], crossing[c]];
    return marks.map((mark) => bytes[mark]);
  });
  return [{name: 'marks', of: 'face', channels}];
}

function drawable({positions, faces, marks}, ball) {
  return {
    vertices: positions.length / 3, faces: faces.length / 3, indices: faces, positions: scaled(positions, ball),
    columns: columnsOf(marks),
  };
}

export class Stage {
  constructor() {
    this.view = new View(byId('stage'), byId('canvas'), byId('cells'), {runs: [unit, unit], up: 'y'}, new Colors({}));
    this.drawn = [];
    this.wipe = 1;
    this.#listen();
    this.view.setLooks({flat: true});
  }

  // `after` and `film` may be missing. Meshes have positions and faces; marks and segments if they are
  // measured. The camera stays if `staysPut`.
  show({name, before, after, film, up}, staysPut) {
    this.#play(false);
    this.shown = {name, before, after, film};
    this.drawn.forEach(dispose);
    this.drawn = [];
    this.ball = ballOf([before, after ?? nothing, ...(film ?? [])]);
    this.view.setUp(up);
    if (!staysPut) this.view.reset();
    this.#setCell(0, before);
    this.#setCell(1, after ?? nothing);
    byId('compare').hidden = !after || Boolean(film);
    byId('film').hidden = !film;
    if (film) this.#startFilm();
    this.#setWipe(film ? 0 : after ? this.chosenWipe ?? 0.5 : 1);
    byId('stage').setAttribute('aria-label', after ? `${name} in 3D, before and after` : `${name} in 3D`);
  }

  #setCell(i, mesh) {
    const shape = drawable(mesh, this.ball);
    this.drawn.push(shape);
    this.view.setMesh(i, shape, byId('marks').checked ? 'marks' : '', {low: 0, high: 1});
    const kinds = Object.entries(mesh.segments ?? {}).map(([kind, segments]) =>
      ({color: cssColor(colorOfKind[kind]), segments: scaled(segments, this.ball)}));
    this.view.setMarks(i, kinds);
  }

  // Draws the first cell to the left of the line and the second one to the right; both fill the stage.
  #setWipe(share) {
    this.view.setWipe(share);
    const isSplit = share > 0 && share < 1 && !byId('compare').hidden;
    byId('split').hidden = !isSplit;
    byId('split').style.left = `${100 * share}%`;
    const texts = byId('compare').hidden ? ['', ''] : ['Before', 'After'];
    this.view.cells.forEach((cell, i) => {
      cell.label.textContent = (i === 0 ? share > 0 : share < 1) ? texts[i] : '';
    });
    byId('wipe').value = Math.round(100 * share);
    byId('wipe').setAttribute('aria-valuetext', `${Math.round(100 * share)} % before, the rest after`);
  }

  #chooseWipe(share) {
    this.chosenWipe = Math.min(Math.max(share, 0), 1);
    this.#setWipe(this.chosenWipe);
  }

  // Lets the user drag the line on the mesh itself.
  #listenToHandle() {
    const handle = byId('handle');
    handle.addEventListener('pointerdown', (event) => {
      event.stopPropagation();
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const {left, width} = byId('stage').getBoundingClientRect();
      this.#chooseWipe(Math.min(Math.max((event.clientX - left) / width, 0.01), 0.99));
    });
  }

  #startFilm() {
    const last = this.shown.film.length - 1;
    byId('frame').max = last;
    this.#goTo(0);
    this.#play(!matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  #goTo(place) {
    const frame = this.shown.film[place];
    byId('frame').value = place;
    byId('now').textContent = `iteration ${frame.number}`;
    byId('frame').setAttribute('aria-valuetext', `iteration ${frame.number}`);
    dispose(this.drawn[1]);
    this.drawn.length = 1;
    this.#setCell(1, frame);
  }

  #play(isPlaying) {
    clearInterval(this.timer);
    const film = this.shown?.film;
    this.isPlaying = isPlaying && film?.length > 1;
    byId('play').setAttribute('aria-pressed', this.isPlaying);
    byId('play').setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
    if (!this.isPlaying) return;
    if (Number(byId('frame').value) === film.length - 1) this.#goTo(0);
    this.timer = setInterval(() => {
      const next = Number(byId('frame').value) + 1;
      this.#goTo(next);
      if (next === film.length - 1) this.#play(false);
    }, Math.min(Math.max(1000 * secondsOfFilm / film.length, 50), 400));
  }

  // Moves the camera to a point of the first mesh.
  lookAt(place) {
    this.view.lookAt(0, Array.from(place, (x, axis) => (x - this.ball.middle[axis]) / this.ball.radius), true);
  }

  #redraw() {
    if (!this.shown) return;
    this.view.setTheme();
    const {before, after, film} = this.shown;
    this.drawn.forEach(dispose);
    this.drawn = [];
    this.#setCell(0, before);
    this.#setCell(1, film ? film[Number(byId('frame').value)] : after ?? nothing);
  }

  #listen() {
    byId('wipe').addEventListener('input', () => this.#chooseWipe(Number(byId('wipe').value) / 100));
    this.#listenToHandle();
    byId('frame').addEventListener('input', () => {
      this.#play(false);
      this.#goTo(Number(byId('frame').value));
    });
    byId('play').addEventListener('click', () => this.#play(!this.isPlaying));
    byId('reset').addEventListener('click', () => this.view.reset());
    for (const look of ['wireframe', 'flat'])
      byId(look).addEventListener('change', () => this.view.setLooks({[look]: byId(look).checked}));
    byId('marks').addEventListener('change', () => {
      this.view.setLooks({marks: byId('marks').checked});
      this.#redraw();
    });
    byId('up').addEventListener('change', () => this.view.setUp(byId('up').value));
    byId('stage').addEventListener('keydown', (event) => this.#onKey(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#redraw());
  }

  #onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const key = {...keysOfView(this.view), ' ': () => this.#play(!this.isPlaying)}[event.key];
    if (!key) return;
    event.preventDefault();
    key();
  }
}
