// What each task runs: a program, its words, and the name of the result. The page shows the same words as a
// command line.

const formats = ['stl', 'ply', 'obj', 'off'];

export const extensionOf = (name) => /\.([^.]+)$/.exec(name)?.[1].toLowerCase() ?? '';
export const formatOf = (name) => (formats.includes(extensionOf(name)) ? extensionOf(name) : 'ply');
export const stemOf = (name) => name.replace(/\.[^.]*$/, '').replace(/^\.+/, '') || 'mesh';

// A name as a word of a command line: programs take what begins with a dash for an option.
export const argumentOf = (name) => (name.startsWith('-') ? `./${name}` : name);

// A name that is not taken yet, with a number before its extension where it needs one.
export function freeName(name, isTaken) {
  if (!isTaken(name)) return name;
  const dot = name.lastIndexOf('.');
  const [stem, end] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ''];
  for (let number = 2; ; ++number)
    if (!isTaken(`${stem}-${number}${end}`)) return `${stem}-${number}${end}`;
}

// One word in single quotes, where a POSIX shell would change it otherwise.
export const quoted = (word) =>
  (/^[\w%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// Lines of a command are no longer than this where words allow it, as a phone shows them.
const mostLetters = 34;

// Words of a command; an option is followed by its value.
function groupsOf(words) {
  const groups = [];
  for (const [i, word] of words.entries()) {
    if (/^(-o|--target|--frames)$/.test(words[i - 1])) groups.push(`${groups.pop()} ${quoted(word)}`);
    else groups.push(quoted(word));
  }
  return groups;
}

export function shellOf({program, words}) {
  const lines = [program];
  for (const group of groupsOf(words)) {
    const longer = `${lines.at(-1)} ${group}`;
    if (longer.length <= mostLetters) lines[lines.length - 1] = longer; else lines.push(`  ${group}`);
  }
  return lines.join(' \\\n');
}

// A length as the programs read it: a number, in % of the diagonal if it ends with that sign.
export const isLength = (text) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?%?$/i.test(text.trim());

const lengthOf = (text) => text.trim();

const operations = {union: 'with', difference: 'without', intersection: 'in'};

// Each task: its program, what is added to the name of the first file, and its words before the file names.
const tasks = {
  repair: {
    program: 'tm-repair', suffix: () => 'repaired',
    words: ({keepOpen}) => (keepOpen ? ['--keep-open'] : []),
  },
  combine: {
    program: 'tm-boolean', takesTwo: true,
    suffix: ({operation, other}) => `${operations[operation]}-${stemOf(other)}`,
    words: ({operation}) => [operation],
  },
  offset: {
    program: 'tm-offset', suffix: () => 'offset',
    words: ({distance}) => [`--distance=${lengthOf(distance)}`],
  },
  decimate: {
    program: 'tm-remesh', suffix: () => 'decimated',
    words: ({error}) => [`--error=${lengthOf(error)}`],
  },
  morph: {
    program: 'tm-morph', takesTwo: true, makesFilm: true,
    suffix: ({other}) => `to-${stemOf(other)}`,
    words: ({every}) => [`--every=${every}`],
  },
};

export const takesTwo = (kind) => tasks[kind].takesTwo === true;

function filesOf(kind, input, other) {
  if (kind === 'morph') return [argumentOf(input), '--target', argumentOf(other)];
  return takesTwo(kind) ? [argumentOf(input), argumentOf(other)] : [argumentOf(input)];
}

// Returns program, words, output and folder of frames. `options.format` is the extension of the result.
export function commandOf(kind, input, options, isTaken) {
  const {program, suffix, words, makesFilm} = tasks[kind];
  const output = freeName(`${stemOf(input)}-${suffix(options)}.${options.format}`, isTaken);
  const frames = makesFilm ? `${stemOf(output)}-frames` : undefined;
  return {
    program, output, frames,
    words: [
      ...words(options), ...filesOf(kind, input, options.other), ...(frames ? ['--frames', frames] : []),
      '-o', output,
    ],
  };
}
