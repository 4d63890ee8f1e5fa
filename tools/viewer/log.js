// The CSV of a run: columns of numbers by name.

function fieldsOf(line) {
  return [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) =>
    quoted === undefined ? plain : quoted.replaceAll('""', '"'));
}

// A last line without its end is still being written.
export function parseLog(text) {
  const lines = text.slice(0, text.lastIndexOf('\n') + 1).split('\n').filter((line) => line !== '');
  if (lines.length < 2) return {names: [], columns: new Map(), rows: 0};
  const header = fieldsOf(lines[0]);
  const rows = lines.slice(1).map(fieldsOf).filter((row) => row.length >= header.length);
  const columns = new Map();
  header.forEach((name, i) => {
    const numbers = rows.map((row) => (row[i].trim() === '' ? NaN : Number(row[i])));
    if (numbers.some((number) => !Number.isNaN(number))) columns.set(name, numbers);
  });
  return {names: [...columns.keys()], columns, rows: rows.length, counts: header[0]};
}
