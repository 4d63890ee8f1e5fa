// Shows the events of a run as a table. A button in each row goes to the event.

import {short} from './numbers.js';

const make = (name, text) => {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  return element;
};

const shortened = (text) => text.split(' ').map((word) => (word === '' ? '–' : short(Number(word)))).join(' ');

// Columns of the table: name, and function that returns the text of an event.
const columns = [
  ['iteration', ({iteration}) => iteration],
  ['time', ({time}) => short(Number(time))],
  ['place', ({x, y, z}) => [x, y, z].map((one) => short(Number(one))).join(', ')],
  ['size', ({size}) => short(Number(size))],
  ['components', ({labels_before: before, labels_after: after}) => `${before || '–'} → ${after || '–'}`],
  ['volumes', ({volumes_before: before, volumes_after: after}) => `${shortened(before)} → ${shortened(after)}`],
];

function rowOf(event, onClick) {
  const row = make('tr');
  const head = make('th');
  head.scope = 'row';
  const button = make('button', event.kind);
  button.type = 'button';
  button.addEventListener('click', () => onClick(event));
  head.append(button);
  row.append(head, ...columns.map(([, textOf]) => make('td', textOf(event))));
  return row;
}

export function eventTable(name, run, events, onClick) {
  const table = make('table');
  const caption = make('caption');
  const swatch = make('span');
  swatch.className = `swatch run-${run % 6}`;
  caption.append(swatch, ` ${name}`);
  const head = make('thead'), body = make('tbody'), titles = make('tr');
  for (const title of ['event', ...columns.map(([one]) => one)]) {
    const cell = make('th', title);
    cell.scope = 'col';
    titles.append(cell);
  }
  head.append(titles);
  body.append(...events.map((event) => rowOf(event, onClick)));
  table.append(caption, head, body);
  return table;
}
