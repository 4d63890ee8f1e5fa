// The state of the page: files, findings in them, tasks and results.

import {byId, button, make} from './elements.js';
import {examples} from './examples.js';
import {listenForFiles, mostBytes, showFiles} from './files.js';
import {findingsTable, verdictOf} from './findings.js';
import {Form} from './form.js';
import {Result} from './result.js';
import {joined} from './shapes.js';
import {Stage} from './stage.js';
import {commandOf, extensionOf, formatOf, freeName, shellOf} from './tasks.js';
import {Canceled, startWorkers} from './workers.js';

function problem(text) {
  byId('problem').textContent = text;
  byId('problem').hidden = text === '';
}

class App {
  constructor() {
    this.entries = [];
    this.ids = 0;
    this.workers = startWorkers();
    this.form = new Form((task) => this.#start(task));
    this.result = new Result();
    listenForFiles((files) => this.open(files));
    byId('cancel').addEventListener('click', () => this.#cancel());
    byId('format').addEventListener('change', () => this.#remake(byId('format').value));
    addEventListener('keydown', (event) => event.key === 'Escape' && this.#cancel());
    byId('examples').append(...examples.map((example) => button(
      [make('strong', {}, example.title), make('span', {}, example.text)], {}, () => this.#openExample(example))));
    this.workers.catch((error) => problem(`The programs cannot be loaded: ${error.message}`));
  }

  // Reads and measures files, and shows the first one.
  async open(files) {
    problem('');
    const added = [];
    for (const file of files) {
      if (file.size > mostBytes) problem(`${file.name} has ${Math.ceil(file.size / 1e6)} MB; 100 MB are the most here. The programs on the command line take more.`);
      else added.push(this.#add(file.name, new Uint8Array(await file.arrayBuffer())));
    }
    if (added.length > 0) this.select(added[0]);
  }

  async #openExample({steps, opens}) {
    problem('');
    try {
      const {files} = await (await this.workers).run('make', {steps});
      const added = opens.map((name) => this.#add(name, files[name]));
      this.select(added[0]);
    } catch (error) {
      problem(error.message);
    }
  }

  #isTaken(name) {
    return this.entries.some((entry) => entry.name === name || entry.made?.frames === name);
  }

  #add(name, bytes, made) {
    const free = freeName(name, (one) => this.#isTaken(one));
    if (free !== name) problem(`There is a ${name} already: this one is called ${free} here and in command lines.`);
    const entry = {id: ++this.ids, name: free, bytes, made};
    this.entries.push(entry);
    this.#measure(entry);
    return entry;
  }

  // Sets mesh and findings of a file when they arrive, and updates the page.
  async #measure(entry) {
    const {name, bytes} = entry;
    const isCurrent = () => entry.bytes === bytes && this.entries.includes(entry);
    try {
      const findings = await (await this.workers).run('inspect', {name, bytes}, {
        shape: (mesh) => isCurrent() && this.#setMesh(entry, mesh),
      });
      if (!isCurrent()) return;
      entry.findings = findings;
      Object.assign(entry.mesh, {marks: findings.marks, segments: findings.segments});
    } catch (error) {
      entry.problem = error.message;
      if (isCurrent()) problem(`${name}: ${error.message}`);
    }
    this.#showIfSelected(entry);
  }

  #setMesh(entry, mesh) {
    entry.mesh = mesh;
    this.#showIfSelected(entry);
  }

  #showIfSelected(entry) {
    if (this.selected === entry || this.selected?.made?.sources.includes(entry)) this.#show(true);
    else this.#showTexts();
  }

  select(entry) {
    this.selected = entry;
    this.#show(false);
  }

  #remove(entry) {
    const at = this.entries.indexOf(entry);
    this.entries.splice(at, 1);
    if (this.entries.length > 0 && this.selected !== entry) return this.#showTexts();
    this.select(this.entries[Math.min(at, this.entries.length - 1)]);
    byId('files').querySelector('input:checked')?.focus();
  }

  #show(staysPut) {
    this.#showTexts();
    const entry = this.selected;
    if (!entry?.mesh) return;
    if (!this.#canDraw()) return;
    const {made, mesh, name} = entry;
    const isCompared = made?.sources.every((source) => source.mesh);
    if (this.shownEntry !== entry) byId('up').value = extensionOf((made?.sources[0] ?? entry).name) === 'stl' ? 'z' : 'y';
    const wasThere = staysPut && this.shownEntry === entry;
    this.shownEntry = entry;
    this.stage.show({
      name, up: byId('up').value, film: made?.film.length > 0 ? made.film : undefined,
      before: isCompared ? joined(made.sources.map((source) => source.mesh)) : mesh,
      after: isCompared ? mesh : undefined,
    }, wasThere);
  }

  // False without WebGL; all but the view works then.
  #canDraw() {
    if (this.stage !== undefined) return this.stage !== null;
    try {
      this.stage = new Stage();
    } catch (error) {
      this.stage = null;
      problem(`This browser cannot draw meshes, which takes WebGL: ${error.message}`);
    }
    return this.stage !== null;
  }

  #showTexts() {
    const entry = this.selected;
    document.body.classList.toggle('empty', this.entries.length === 0);
    byId('welcome').hidden = this.entries.length > 0;
    byId('work').hidden = this.entries.length === 0;
    if (!entry) return;
    showFiles(this.entries, entry, {
      select: (one) => {
        byId('progress').textContent = '';
        this.select(one);
      },
      remove: (one) => this.#remove(one),
    });
    this.form.setOthers(this.entries.filter((one) => one !== entry && one.mesh?.faces.length > 0));
    this.result.show(entry);
    this.#showFindings(entry);
  }

  #showFindings(entry) {
    const source = entry.made?.sources[0];
    const isMeasured = entry.findings !== undefined;
    byId('verdict').className = '';
    byId('verdict').textContent = entry.problem ?? (isMeasured ? verdictOf(entry.findings) : 'Checking …');
    if (isMeasured) byId('verdict').className = verdictOf(entry.findings).startsWith('A solid') ? 'good' : 'bad';
    if (entry.problem) byId('verdict').className = 'bad';
    const columns = source ? [{title: 'Before', findings: source.findings}, {title: 'After', findings: entry.findings}]
      : [{title: 'Count', findings: entry.findings}];
    const table = findingsTable(columns, (kind) => this.#lookAt(kind, (source ?? entry).findings.segments[kind]));
    byId('findings').replaceChildren(...(entry.problem ? [] : [table]));
    byId('remarks').replaceChildren(...(entry.mesh?.notes ?? []).map((note) => make('li', {}, note)));
  }

  // Moves the view to the next place of a kind at each call.
  #lookAt(kind, segments) {
    this.looks = (this.looks ?? -1) + 1;
    const count = segments.length / 6;
    // Neighbors in the list are neighbors in space. A stride that is a prime visits all places, unless
    // their number is a multiple of it.
    const at = 6 * ((this.looks * 7919) % count);
    this.stage?.lookAt(segments.subarray(at, at + 3));
  }

  async #start({problem: missing, kind, other, options}) {
    problem(missing ?? '');
    if (missing) return;
    const sources = [this.selected, ...this.entries.filter((entry) => String(entry.id) === other)];
    const command = commandOf(kind, sources[0].name, {
      ...options, other: sources[1]?.name, format: formatOf(sources[0].name),
    }, (name) => this.#isTaken(name));
    const made = await this.#run(command, {kind, sources, options});
    if (!made) return;
    this.select(this.#add(command.output, made.bytes, made));
    document.querySelector('.panel').scrollTop = 0;
    document.querySelector('.player').scrollIntoView({block: 'nearest'});
  }

  // Runs the task of the selected result again, for another format.
  async #remake(format) {
    const entry = this.selected;
    const {kind, sources, options} = entry.made;
    const command = commandOf(kind, sources[0].name, {...options, other: sources[1]?.name, format},
      (name) => name !== entry.name && this.#isTaken(name));
    const made = await this.#run(command, {kind, sources, options});
    if (!made) return void (byId('format').value = formatOf(entry.name));
    Object.assign(entry, {name: command.output, bytes: made.bytes, made, findings: undefined});
    this.#measure(entry);
    this.#showTexts();
  }

  // Returns a promise of a result and how it was made, or of undefined if there is no result.
  async #run(command, {kind, sources, options}) {
    const began = performance.now();
    this.form.setBusy(true);
    byId('progress').textContent = 'Working …';
    try {
      const files = Object.fromEntries(sources.map(({name, bytes}) => [name, bytes]));
      const workers = await this.workers;
      const running = workers.run('run', {...command, files}, {
        progress: (line) => { byId('progress').textContent = line.replace(/^[a-z-]+: /, ''); },
      });
      this.job = running.job;
      const {bytes, film, messages} = await running;
      const commands = [...new Set([...sources.flatMap((source) => source.made?.commands ?? []), shellOf(command)])];
      byId('progress').textContent = 'Done.';
      return {kind, sources, options, bytes, film, frames: command.frames, messages, commands, seconds: (performance.now() - began) / 1000};
    } catch (error) {
      byId('progress').textContent = error instanceof Canceled ? 'Canceled.' : '';
      if (!(error instanceof Canceled)) problem(`${command.program}: ${error.message}`);
      return undefined;
    } finally {
      this.job = undefined;
      this.form.setBusy(false);
    }
  }

  async #cancel() {
    if (this.job !== undefined) (await this.workers).cancel(this.job);
  }
}

window.app = new App();
