// The table of defects of a mesh: a number and a sentence for each kind, before and after.

import {short} from '../../tools/viewer/numbers.js';
import {button, make} from './elements.js';

// Kind, title, and a sentence on what is counted and why it matters.
const kinds = [
  ['intersections', 'Self-intersections',
    'Pairs of faces that run through each other: inside and outside are not clear there.'],
  ['holes', 'Holes', 'Borders of the surface. A solid has none.'],
  ['turned', 'Flipped faces', 'Faces whose outside is inside.'],
  ['branching', 'Branching edges', 'Edges at which three faces or more meet, and do not pair up.'],
  ['oneSided', 'One-sided surface', 'The surface has one side only, like a Moebius strip.'],
  ['flat', 'Faces without area', 'Their corners lie on one line. They do no harm to a solid.'],
];
// Kinds that a solid may have.
const harmless = ['flat'];
// Kinds that have a row only if there are any.
const rare = ['oneSided', 'flat', 'branching'];

export const isSolid = ({counts}) =>
  Object.entries(counts).every(([kind, count]) => count === 0 || harmless.includes(kind));

export function verdictOf(findings) {
  if (isSolid(findings)) return 'A solid: closed, oriented, and free of self-intersections.';
  const count = kinds.filter(([kind]) => findings.counts[kind] > 0 && !harmless.includes(kind)).length;
  return `Not a solid yet: ${count === 1 ? 'one kind' : `${count} kinds`} of fault.`;
}

function cellOf(findings, kind) {
  if (!findings) return make('td', {class: 'waiting'}, '…');
  const count = findings.counts[kind];
  if (count === 0) return make('td', {class: 'good'}, 'none');
  return make('td', {class: harmless.includes(kind) ? '' : 'bad'}, short(count));
}

// `show` takes the name of a kind, and moves the view to its next place.
function rowsOf([kind, title, sentence], all, show) {
  const counts = all.map((findings) => findings?.counts[kind]);
  const isThere = counts.some((count) => count > 0);
  const isShown = counts[0] > 0 && all[0].segments[kind]?.length > 0;
  const head = make('th', {scope: 'row'}, make('span', {class: `swatch ${kind}`, 'aria-hidden': 'true'}), title);
  const showing = button('Show', {class: 'link', 'aria-label': `Show ${title.toLowerCase()}`}, () => show(kind));
  const why = make('tr', {class: 'why'}, make('td', {colspan: 1 + all.length}, sentence, ...(isShown ? [showing] : [])));
  return [make('tr', {}, head, ...all.map((findings) => cellOf(findings, kind))), ...(isThere ? [why] : [])];
}

const factRows = [
  ['Faces', ({faces}) => short(faces)],
  ['Parts', ({parts}) => short(parts)],
  ['Size', ({size}) => size.map(short).join(' × ')],
  ['Area', ({area}) => short(area)],
  ['Volume', ({volume}) => short(volume)],
];

// Long texts that are equal before and after are written once.
function factRow([title, textOf], all) {
  const texts = all.map((findings) => (findings ? textOf(findings.facts) : '…'));
  const isOnce = texts.every((text) => text === texts[0] && text.includes('×'));
  const cells = isOnce ? [make('td', {colspan: all.length}, texts[0])] : texts.map((text) => make('td', {}, text));
  return make('tr', {}, make('th', {scope: 'row'}, title), ...cells);
}

// `columns` are titles with findings, which are undefined while they are measured.
export function findingsTable(columns, show) {
  const all = columns.map(({findings}) => findings);
  const titles = make('tr', {}, make('th', {scope: 'col'}, 'What is wrong'),
    ...columns.map(({title}) => make('th', {scope: 'col'}, title)));
  const isWanted = ([kind]) => !rare.includes(kind) || all.some((findings) => findings?.counts[kind] > 0);
  return make('table', {class: 'findings'},
    make('colgroup', {}, make('col', {class: 'kind'}), ...all.map(() => make('col'))),
    make('thead', {}, titles),
    make('tbody', {}, ...kinds.filter(isWanted).flatMap((kind) => rowsOf(kind, all, show))),
    make('tbody', {class: 'facts'}, ...factRows.map((row) => factRow(row, all))));
}
