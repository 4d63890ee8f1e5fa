// Assembles the page from the data in the element `page`.

import {Charts} from './charts.js';
import {Colors, scaleOf} from './colors.js';
import {eventTable} from './events.js';
import {dispose} from './geometry.js';
import {keysOfView} from './keys.js';
import {watch} from './live.js';
import {parseEvents, parseLog} from './log.js';
import {lastNotAbove, nearest, short, shownWith} from './numbers.js';
import {View} from './scene.js';
import {Store} from './store.js';
import {runElement} from './tables.js';

const noCameras = [];

const $ = (id) => document.getElementById(id);

class Viewer {
  constructor(page) {
    this.colors = new Colors(page.colors);
    this.store = new Store(page.live, dispose);
    this.place = 0;
    this.view = new View($('stage'), $('canvas'), $('cells'), page, this.colors, (name) => this.store.picture(name));
    this.charts = new Charts($('curves'), (time) => this.goTo(nearest(this.times, time)));
    this.colorBy = page.color_by;
    this.#listen();
    this.setPage(page);
    if (page.live) watch((next) => this.setPage(next), () => this.#sayEnded());
  }

  setPage(page) {
    const wasAtEnd = this.times === undefined || this.place === this.times.length - 1;
    const isFirst = this.page === undefined;
    this.page = page;
    this.times = [...new Set(page.runs.flatMap((run) => run.meshes.map((mesh) => mesh.number)))].sort((a, b) => a - b);
    this.#setTexts();
    this.#setColumns();
    $('slider').max = this.times.length - 1;
    $('time').hidden = $('keys-of-time').hidden = this.times.length < 2;
    $('ghost-label').hidden = !page.runs.some((run) => run.targets.length > 0);
    const logs = page.runs.map((run) => parseLog(run.log));
    const ends = [this.times[0], this.times.at(-1), ...logs.flatMap((log) => log.columns.get(log.counts) ?? [])];
    const events = page.runs.map((run) => parseEvents(run.events));
    this.charts.setLogs(logs, events, Math.min(...ends), Math.max(...ends));
    this.#setEvents(events);
    page.runs.forEach((run, i) => this.view.cells[i].fit(run));
    this.goTo(isFirst && !page.live ? this.times.length - 1 : wasAtEnd ? this.times.length - 1 : Math.min(this.place, this.times.length - 1));
  }

  #setTexts() {
    const {title, version, runs} = this.page;
    document.title = title;
    $('title').textContent = title;
    const meshes = runs.reduce((sum, run) => sum + run.meshes.length, 0);
    const counted = (count, noun) => `${count} ${noun}${count === 1 ? '' : noun.endsWith('h') ? 'es' : 's'}`;
    const isOfRuns = runs.some((run) => run.tool !== '');
    $('summary').textContent = `${isOfRuns ? `${counted(runs.length, 'run')}, ` : ''}${counted(meshes, 'mesh')} · ${version}`;
    $('details').hidden = !isOfRuns;
    document.body.classList.toggle('alone', !isOfRuns);
    $('tables').replaceChildren(...runs.filter((run) => run.tool !== '').map(runElement));
  }

  #setEvents(events) {
    $('events').hidden = events.every((some) => some.length === 0);
    const show = (run, event) => {
      this.play(false);
      this.goTo(nearest(this.times, Number(event.iteration)));
      this.view.lookAt(run, [event.x, event.y, event.z].map(Number));
    };
    $('event-tables').replaceChildren(...events.flatMap((some, run) =>
      some.length === 0 ? [] : [eventTable(this.page.runs[run].name, run, some, (event) => show(run, event))]));
  }

  #setColumns() {
    const columns = new Map();
    for (const column of this.page.runs.flatMap((run) => run.columns)) {
      const known = columns.get(column.name);
      columns.set(column.name, {
        low: Math.min(known?.low ?? Infinity, column.low), high: Math.max(known?.high ?? -Infinity, column.high)});
    }
    this.columns = columns;
    if (!columns.has(this.colorBy)) this.colorBy = columns.has('color') ? 'color' : '';
    const option = (value, text) => Object.assign(document.createElement('option'), {value, textContent: text});
    $('color').replaceChildren(option('', 'plain'), ...[...columns.keys()].map((name) => option(name, name.replaceAll('_', ' '))));
    $('color').value = this.colorBy;
    $('color-label').hidden = columns.size === 0;
  }

  // Sets the cameras of the current time steps. The menu lists those of the first run that has any.
  #setCameras(cameras) {
    cameras.forEach((some, i) => this.view.setCameras(i, some));
    const names = (cameras.find((some) => some.length > 0) ?? []).map((camera) => camera.name);
    $('cameras-label').hidden = $('from-label').hidden = names.length === 0;
    const from = $('from');
    if (from.options.length === names.length + 1 && names.every((name, i) => from.options[i + 1].text === name)) return;
    const chosen = from.value;
    from.replaceChildren(new Option('anywhere', ''), ...names.map((name, i) => new Option(name, i)));
    from.value = Number(chosen) < names.length ? chosen : '';
  }

  goTo(place) {
    this.place = place;
    const time = this.times[place];
    $('slider').value = place;
    const shown = this.page.runs.map((run) => run.meshes[lastNotAbove(run.meshes.map((mesh) => mesh.number), time)]);
    this.#setNow(time, shown);
    this.#setCameras(this.page.runs.map((run, i) => shownWith(run.views, shown[i].number)?.cameras ?? noCameras));
    this.charts.setTime(time);
    this.#showMeshes(shown, place);
  }

  #setNow(time, shown) {
    const {counts, stepNames} = this.charts.logs[0];
    const name = stepNames.get(time);
    const label = shown.length === 1 && shown[0].label !== '' ? shown[0].label : `${counts ?? 'frame'} ${time}${name ? ` · ${name}` : ''}`;
    $('now').textContent = label;
    // The slider keeps its length while the label changes.
    this.widest = Math.max(this.widest ?? 0, label.length);
    $('now').style.minWidth = `${this.widest}ch`;
    const faces = shown.map((mesh) => (mesh.faces > 0 ? `${short(mesh.faces)} faces` : `${short(mesh.vertices)} points`));
    $('slider').setAttribute('aria-valuetext', `${label}, ${faces.join(', ')}`);
    $('stage').setAttribute('aria-label', `Meshes in 3D: ${label}, ${faces.join(', ')}`);
    this.view.cells.forEach((cell, i) => {
      cell.label.textContent = `${this.page.runs[i].name} · ${faces[i]}`;
    });
  }

  // Shows meshes after unpacking them. Requests during unpacking wait; only the last of them is served.
  async #showMeshes(shown, place) {
    this.waiting = {shown, place};
    if (this.isUnpacking) return;
    this.isUnpacking = true;
    $('stage').setAttribute('aria-busy', 'true');
    while (this.waiting) {
      const now = this.waiting;
      this.waiting = undefined;
      try {
        await this.#unpackAndShow(now);
      } catch (error) {
        problem(`A mesh cannot be shown: ${error.message}`);
      }
    }
    this.isUnpacking = false;
    $('stage').setAttribute('aria-busy', 'false');
    this.#prepareNext();
  }

  async #unpackAndShow({shown, place}) {
    const get = (mesh, i) => mesh && this.store.get(mesh.block, this.view.cells[i].extent);
    const [meshes, targets] = await Promise.all([
      Promise.all(shown.map(get)),
      Promise.all(shown.map((mesh, i) => get(shownWith(this.page.runs[i].targets, mesh.number), i))),
    ]);
    const scale = this.#scaleFor(meshes);
    meshes.forEach((mesh, i) => this.view.setMesh(i, mesh, this.colorBy, scale));
    targets.forEach((target, i) => target && this.view.setTarget(i, target));
    this.#setLegend(scale);
    document.body.dataset.shown = place;
  }

  #scaleFor(meshes) {
    let ends = this.columns.get(this.colorBy);
    if (!ends || this.colorBy === 'color') return {low: 0, high: 1, isDiverging: false};
    if ($('range').checked) {
      const columns = meshes.flatMap((mesh) => mesh.columns.filter((column) => column.name === this.colorBy));
      ends = {low: Math.min(...columns.map((column) => column.low)), high: Math.max(...columns.map((column) => column.high))};
    }
    return scaleOf(ends.low, ends.high);
  }

  #setLegend(scale) {
    const isShown = this.colorBy !== '' && this.colorBy !== 'color';
    $('legend').hidden = $('range-label').hidden = !isShown;
    if (!isShown) return;
    $('legend-name').textContent = this.colorBy.replaceAll('_', ' ');
    $('legend-low').textContent = short(scale.low);
    $('legend-high').textContent = short(scale.high);
    $('legend-bar').hidden = $('legend-high').hidden = scale.low === scale.high;
    $('legend-bar').style.background = this.colors.gradient(scale);
  }

  #prepareNext() {
    const time = this.times[this.place + 1];
    if (time === undefined || this.page.live) return;
    this.page.runs.forEach((run, i) => {
      const mesh = run.meshes[lastNotAbove(run.meshes.map((one) => one.number), time)];
      this.store.get(mesh.block, this.view.cells[i].extent);
    });
  }

  step(by) {
    this.goTo(Math.min(Math.max(this.place + by, 0), this.times.length - 1));
  }

  play(isPlaying) {
    clearInterval(this.timer);
    this.isPlaying = isPlaying && this.times.length > 1;
    $('play').setAttribute('aria-pressed', this.isPlaying);
    $('play').setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
    if (!this.isPlaying) return;
    if (this.place === this.times.length - 1) this.goTo(0);
    // All frames take ten seconds, but a frame takes at least 50 ms and at most a second.
    this.timer = setInterval(() => {
      this.step(1);
      if (this.place === this.times.length - 1) this.play(false);
    }, Math.min(Math.max(10000 / this.times.length, 50), 1000));
  }

  #listen() {
    $('slider').addEventListener('input', () => {
      this.play(false);
      this.goTo(Number($('slider').value));
    });
    $('play').addEventListener('click', () => this.play(!this.isPlaying));
    $('reset').addEventListener('click', () => this.view.reset());
    $('color').addEventListener('change', () => {
      this.colorBy = $('color').value;
      this.goTo(this.place);
    });
    $('range').addEventListener('change', () => this.goTo(this.place));
    for (const look of ['wireframe', 'flat', 'ghost', 'cameras'])
      $(look).addEventListener('change', () => this.view.setLooks({[look]: $(look).checked}));
    $('from').addEventListener('change', () => {
      const number = $('from').value === '' ? undefined : Number($('from').value);
      this.view.lookFrom(number);
    });
    this.view.onLook = (number) => { $('from').value = number ?? ''; };
    $('stage').addEventListener('keydown', (event) => this.#onKey(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.view.setTheme());
  }

  #onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const keys = {
      ...keysOfView(this.view), ' ': () => this.play(!this.isPlaying),
      ',': () => this.step(-1), '.': () => this.step(1),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }

  #sayEnded() {
    problem('tm-view has ended: this page shows what it has, and nothing new.');
  }
}

function problem(text) {
  $('problem').textContent = text;
  $('problem').hidden = false;
}

function start() {
  if (!('DecompressionStream' in window))
    return problem('This browser is too old: it cannot unpack the meshes (DecompressionStream).');
  try {
    window.viewer = new Viewer(JSON.parse($('page').textContent));
  } catch (error) {
    problem(/WebGL/.test(error.message) ? 'This browser draws no WebGL, which the meshes need.' : `The page cannot be shown: ${error.message}`);
    throw error;
  }
}

start();
