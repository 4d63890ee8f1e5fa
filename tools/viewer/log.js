// Parses the CSV files of a run.

function fieldsOf(line) {
  return [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) =>
    quoted === undefined ? plain : quoted.replaceAll('""', '"'));
}

// Returns the names of the frames or time steps of a movie, by number.
function stepNamesOf(header, rows) {
  const place = header.indexOf('name');
  return new Map(place < 0 ? [] : rows.map((row) => [Number(row[0]), row[place]]));
}

// Returns the complete lines. A last line without line end is left out, because it is still being
// written.
function linesOf(text) {
  return text.slice(0, text.lastIndexOf('\n') + 1).split('\n').filter((line) => line !== '');
}

// Returns an object for each event, with the columns of the CSV file as text.
export function parseEvents(text) {
  const [header, ...rows] = linesOf(text).map(fieldsOf);
  return rows.filter((row) => row.length >= header.length)
    .map((row) => Object.fromEntries(header.map((name, i) => [name, row[i]])));
}

export function parseLog(text) {
  const lines = linesOf(text);
  if (lines.length < 2) return {names: [], columns: new Map(), rows: 0, stepNames: new Map()};
  const header = fieldsOf(lines[0]);
  const rows = lines.slice(1).map(fieldsOf).filter((row) => row.length >= header.length);
  const columns = new Map();
  header.forEach((name, i) => {
    const numbers = rows.map((row) => (row[i].trim() === '' ? NaN : Number(row[i])));
    if (numbers.some((number) => !Number.isNaN(number))) columns.set(name, numbers);
  });
  return {names: [...columns.keys()], columns, rows: rows.length, counts: header[0], stepNames: stepNamesOf(header, rows)};
}
