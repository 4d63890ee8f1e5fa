// Small charts of the log's columns, with a mark at the current time. A click or a drag on a chart
// changes the time.

import {lastNotAbove, short} from './numbers.js';

const width = 320, height = 130;
const box = {left: 6, right: 314, top: 10, bottom: 120};
const shownAtFirst = [
  /^rms_distance_to_target$/, /^(max_|hausdorff_)distance_to_target$|^hausdorff_to_target$/, /^dissimilarity$/,
  /^coverage$/, /^max_displacement$/, /^rms_displacement$/, /^faces$/, /^components$/, /^genus$/, /^pairs$/,
  /^mean_edge$/, /^seconds$/,
];

// Titles of columns whose names do not say what they count.
const titles = new Map([['pairs', 'pairs of intersecting faces']]);
const titleOf = (name) => titles.get(name) ?? name.replaceAll('_', ' ');

function svg(name, attributes = {}) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

function endsOf(series) {
  const all = series.flatMap(({y}) => y.filter(Number.isFinite));
  return [Math.min(...all), Math.max(...all)];
}

class Chart {
  constructor(name, onTime) {
    this.name = name;
    this.onTime = onTime;
    this.element = document.createElement('figure');
    this.caption = document.createElement('figcaption');
    this.title = document.createElement('span');
    this.title.textContent = titleOf(name);
    this.value = document.createElement('span');
    this.value.className = 'value';
    this.caption.append(this.title, this.value);
    this.svg = svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', preserveAspectRatio: 'none'});
    this.high = document.createElement('span');
    this.low = document.createElement('span');
    this.high.className = 'high';
    this.low.className = 'low';
    const plot = document.createElement('div');
    plot.className = 'plot';
    // The mark is in a layer above the curves, so that these are not painted again when it moves.
    this.over = document.createElement('div');
    this.over.className = 'over';
    this.axis = ['span', 'span'].map((name) => document.createElement(name));
    const axis = Object.assign(document.createElement('div'), {className: 'axis'});
    axis.append(...this.axis);
    plot.append(this.high, this.low, this.svg, this.over, axis);
    this.element.append(this.caption, plot);
    this.#follow(this.svg);
  }

  #follow(target) {
    const go = (event) => {
      const area = target.getBoundingClientRect();
      const share = ((event.clientX - area.left) / area.width * width - box.left) / (box.right - box.left);
      this.onTime(this.first + Math.min(Math.max(share, 0), 1) * (this.last - this.first));
    };
    target.addEventListener('pointerdown', (event) => {
      target.setPointerCapture(event.pointerId);
      go(event);
    });
    target.addEventListener('pointermove', (event) => {
      if (target.hasPointerCapture(event.pointerId)) go(event);
    });
  }

  // Draws the curves from time `first` to time `last`. `series` has x, y, events and the number of the
  // color for each run; `counts` is what time counts, such as iterations.
  set(series, first, last, counts) {
    Object.assign(this, {series, first, last});
    this.axis[0].textContent = `${counts} ${short(first)}`;
    this.axis[1].textContent = short(last);
    const [low, high] = endsOf(series);
    this.isLogarithmic = low > 0 && high / low > 200;
    this.ends = this.isLogarithmic ? [Math.log(low), Math.log(high)] : [low, high];
    this.high.textContent = high > low ? short(high) : '';
    this.low.textContent = short(low);
    this.title.textContent = titleOf(this.name) + (this.isLogarithmic ? ' (log)' : '');
    this.low.className = high > low ? 'low' : 'only';
    this.svg.replaceChildren();
    for (const end of [box.top, box.bottom])
      this.svg.append(svg('line', {class: 'rule', x1: box.left, x2: box.right, y1: end, y2: end}));
    for (const one of series) this.#markEvents(one);
    for (const one of series) this.svg.append(svg('path', {class: `curve run-${one.run % 6}`, d: this.#pathOf(one)}));
    const mover = (className) => Object.assign(document.createElement('div'), {className});
    this.cursor = mover('cursor');
    this.marks = series.map(({run}) => mover(`mark run-${run % 6}`));
    this.over.replaceChildren(this.cursor, ...this.marks);
    this.svg.setAttribute('aria-label', `${this.title.textContent}: ${series.map(({x, y}) =>
      `from ${short(y[0])} at ${short(x[0])} to ${short(y.at(-1))} at ${short(x.at(-1))}`).join('; ')}`);
  }

  // Adds a vertical line per event, with its kind as tooltip.
  #markEvents({run, events}) {
    for (const {iteration, kind} of events) {
      const [x] = this.#place(Number(iteration), 1);
      const line = svg('line', {class: `event run-${run % 6}`, x1: x, x2: x, y1: box.top, y2: box.bottom});
      const tooltip = svg('title');
      tooltip.textContent = `${kind}, iteration ${iteration}`;
      line.append(tooltip);
      this.svg.append(line);
    }
  }

  #place(x, y) {
    const [low, high] = this.ends;
    const value = this.isLogarithmic ? Math.log(y) : y;
    const up = high > low ? (value - low) / (high - low) : 0.5;
    const along = this.last > this.first ? (x - this.first) / (this.last - this.first) : 0.5;
    return [box.left + along * (box.right - box.left), box.bottom - up * (box.bottom - box.top)];
  }

  #pathOf({x, y}) {
    let path = '', pen = 'M';
    for (let i = 0; i < x.length; ++i) {
      if (!Number.isFinite(y[i])) {
        pen = 'M';
        continue;
      }
      const [px, py] = this.#place(x[i], y[i]);
      path += `${pen}${px.toFixed(1)} ${py.toFixed(1)}`;
      pen = 'L';
    }
    return path;
  }

  setTime(time) {
    const move = (element, [x, y]) => {
      element.style.transform = `translate(${(100 * x / width).toFixed(2)}%, ${(100 * y / height).toFixed(2)}%)`;
    };
    move(this.cursor, [this.#place(time, 1)[0], 0]);
    const values = this.series.map((one, i) => {
      const row = lastNotAbove(one.x, time);
      const isThere = Number.isFinite(one.y[row]);
      if (isThere) move(this.marks[i], this.#place(one.x[row], one.y[row]));
      this.marks[i].style.display = isThere ? '' : 'none';
      return short(one.y[row]);
    });
    this.value.textContent = values.join(' / ');
  }
}

export class Charts {
  constructor(section, onTime) {
    this.section = section;
    this.onTime = onTime;
    this.charts = new Map();
    this.place = section.querySelector('#charts');
    this.columns = section.querySelector('#columns');
    this.boxes = new Map();
  }

  // Sets the logs (from parseLog) and the events (from parseEvents) of all runs.
  setLogs(logs, events, first, last) {
    Object.assign(this, {logs, events, first, last});
    const counts = new Set(logs.map((log) => log.counts));
    const names = [...new Set(logs.flatMap((log) => log.names))].filter((name) => !counts.has(name));
    this.section.hidden = names.length === 0;
    for (const name of names) if (!this.boxes.has(name)) this.#addBox(name);
    for (const [name, checkbox] of this.boxes) this.#show(name, checkbox.checked);
  }

  #addBox(name) {
    const label = document.createElement('label');
    const checkbox = document.createElement('input');
    checkbox.type = 'checkbox';
    checkbox.checked = shownAtFirst.some((pattern) => pattern.test(name));
    checkbox.addEventListener('change', () => {
      this.#show(name, checkbox.checked);
      this.setTime(this.time);
    });
    label.append(checkbox, titleOf(name));
    this.columns.append(label);
    this.boxes.set(name, checkbox);
  }

  #show(name, isShown) {
    if (!isShown) {
      this.charts.get(name)?.element.remove();
      this.charts.delete(name);
      return;
    }
    const series = this.logs.flatMap((log, run) =>
      log.columns.has(name) ? [{run, x: log.columns.get(log.counts), y: log.columns.get(name), events: this.events[run]}] : []);
    if (series.length === 0) return;
    if (!this.charts.has(name)) this.charts.set(name, new Chart(name, this.onTime));
    const chart = this.charts.get(name);
    chart.set(series, this.first, this.last, this.logs[0].counts ?? 'frame');
    // Charts have the order of the check boxes, not that in which they were added.
    const order = [...this.boxes.keys()];
    const after = order.slice(order.indexOf(name) + 1).map((one) => this.charts.get(one)).find(Boolean);
    this.place.insertBefore(chart.element, after?.element ?? null);
  }

  setTime(time) {
    this.time = time;
    for (const chart of this.charts.values()) chart.setTime(time);
  }
}
