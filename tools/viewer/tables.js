// Tables about a run: its result, options, versions and commands.

const make = (name, text, className) => {
  const element = document.createElement(name);
  if (text !== undefined) element.textContent = text;
  if (className) element.className = className;
  return element;
};

const rounded = (value) => (Number.isInteger(value) ? value : Number(value.toPrecision(6)));
const textOf = (value) => {
  if (typeof value === 'string') return value;
  return JSON.stringify(value, (_, one) => (typeof one === 'number' ? rounded(one) : one));
};

function tableOf(title, entries) {
  const shown = Object.entries(entries ?? {}).filter(([, value]) => value !== '' && value !== null);
  if (shown.length === 0) return [];
  const table = make('table');
  table.append(make('caption', title));
  const body = make('tbody');
  for (const [name, value] of shown) {
    const row = make('tr');
    const head = make('th', name.replaceAll('_', ' '));
    head.scope = 'row';
    row.append(head, make('td', textOf(value)));
    body.append(row);
  }
  table.append(body);
  return [table];
}

export function copyButton(text) {
  const button = make('button', 'Copy');
  button.type = 'button';
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = 'Copied';
    } catch {
      button.textContent = 'Select and copy';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 2000);
  });
  return button;
}

export function runElement(run, number) {
  const article = make('article');
  const title = make('h3');
  title.append(make('span', undefined, `swatch run-${number % 6}`), run.name);
  article.append(title);
  const state = run.report ? '' : ', still running or interrupted';
  article.append(make('p', `${run.tool} ${run.version}${state}`, 'by'));
  if (run.commands.length > 0) {
    const text = run.commands.join('\n');
    const commands = make('div', undefined, 'commands');
    const code = make('pre');
    code.tabIndex = 0;
    code.setAttribute('aria-label', 'Commands that make this run');
    code.append(make('code', text));
    commands.append(code, copyButton(text));
    article.append(commands);
  }
  const {result, options, input, output, timings, peak_memory_bytes: memory} = run.report ?? {};
  const tables = make('div', undefined, 'tables');
  tables.append(
    ...tableOf('Result', result), ...tableOf('Options', without(options, false)),
    ...tableOf('Sizes', {...prefixed('input ', input), ...prefixed('output ', output), peak_memory: memory && `${Math.round(memory / 1e5) / 10} MB`}),
    ...tableOf('Seconds', timings && Object.fromEntries(Object.entries(timings).map(([name, value]) => [name, Number(value.toFixed(3))]))));
  article.append(tables);
  return article;
}

function without(entries, value) {
  return Object.fromEntries(Object.entries(entries ?? {}).filter(([, one]) => one !== value));
}

function prefixed(prefix, entries) {
  return Object.fromEntries(Object.entries(entries ?? {}).map(([name, value]) => [prefix + name, value]));
}
