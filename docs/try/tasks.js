// Tasks: the program of each one, its words, and the name of the result. The page shows the same words as
// a command line.

const formats = ['stl', 'ply', 'obj', 'off'];

export const extensionOf = (name) => /\.([^.]+)$/.exec(name)?.[1].toLowerCase() ?? '';
export const formatOf = (name) => (formats.includes(extensionOf(name)) ? extensionOf(name) : 'ply');
export const stemOf = (name) => name.replace(/\.[^.]*$/, '').replace(/^\.+/, '') || 'mesh';

// Returns a name as a word of a command line, where a word with a dash in front is an option.
export const argumentOf = (name) => (name.startsWith('-') ? `./${name}` : name);

// Returns the name, with a number before the extension if the name is taken.
export function freeName(name, isTaken) {
  if (!isTaken(name)) return name;
  const dot = name.lastIndexOf('.');
  const [stem, end] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ''];
  for (let number = 2; ; ++number)
    if (!isTaken(`${stem}-${number}${end}`)) return `${stem}-${number}${end}`;
}

// Returns the word, in single quotes if a POSIX shell would change it otherwise.
export const quoted = (word) =>
  (/^[\w%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// Most letters of a line of a command, as a phone shows them. A longer word has a line of its own.
const mostLetters = 34;

// Returns the words of a command, with options and their values as one.
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

// True for a length as the programs read it: a number, in % of the box's diagonal if it ends with %.
export const isLength = (text) => /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?%?$/i.test(text.trim());

const lengthOf = (text) => text.trim();

const operations = {union: 'with', difference: 'without', intersection: 'in'};

// Each task has a program, a suffix for the name of the first file, and words before the file names.
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
