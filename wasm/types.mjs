// Prints TypeScript's types of the options of npm/index.d.ts, from the help texts of the programs:
//   node wasm/types.mjs PACKAGE > options.d.ts
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const programs = ['clean', 'boolean', 'repair', 'stitch', 'fill', 'remesh', 'offset', 'morph', 'info', 'checkmanifold'];
const commonOptions = ['float', 'double', 'no-provenance', 'reference-edge', 'strict', 'verbose', 'quiet'];
// Options that are arguments of the functions, or that write no mesh or other files.
const otherOptions = ['morph target', 'offset distance', 'boolean script', 'info get', 'info per-vertex',
  'checkmanifold pass', 'checkmanifold float', 'checkmanifold double', 'checkmanifold no-provenance',
  'checkmanifold reference-edge', 'morph sequence', 'morph resume', 'morph restart', 'morph every', 'morph csv',
  'morph print-pipeline', 'repair print-pipeline', 'repair dry-run'];

const { runHere } = await import(pathToFileURL(path.resolve(process.argv[2], 'run.mjs')));

const camelCase = (name) => name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

function typeOf(placeholder) {
  if (!placeholder) return 'boolean';
  const types = placeholder.split('|').map((word) => {
    if (/^(N|NUMBER)$/.test(word)) return 'number';
    if (word === 'LENGTH') return 'Length';
    if (word === 'FILE') return 'Mesh';
    return /^[A-Z]/.test(word) ? 'string' : `'${word}'`;
  });
  // Operators have a number as their only word, or a word and a number.
  return placeholder === 'KIND' ? 'number | string' : types.join(' | ');
}

/** Options of a section of a help text: name, placeholder, and help in one line. */
function optionsOf(section) {
  const options = [];
  for (const line of section.split('\n')) {
    const begun = line.match(/^ {2}(?:-\w, )?--([\w-]+)(?: (\S+))?(?: {2,}(.*))?$/);
    if (begun) options.push({ name: begun[1], placeholder: begun[2], help: begun[3] ?? '' });
    else if (/^ {20,}\S/.test(line)) options.at(-1).help = `${options.at(-1).help} ${line.trim()}`.trim();
  }
  return options;
}

const isIncluded = (program, { name, placeholder }) =>
  !otherOptions.includes(`${program} ${name}`) && placeholder !== 'FOLDER';

console.log('// Made by wasm/types.mjs from the help texts of the programs.');
console.log("import type { Control, Length, Mesh } from './index.js';");
for (const program of programs) {
  const { printed } = await runHere({ program: `tm-${program}`, words: ['--help'], files: {} });
  const [own, common] = ['Options', 'Common options'].map((title) =>
    optionsOf(printed.match(new RegExp(`^${title}:\n((?: .*\n)*)`, 'm'))[1]));
  console.log(`\nexport interface ${program[0].toUpperCase()}${program.slice(1)}Options extends Control {`);
  for (const option of [...own, ...common.filter(({ name }) => commonOptions.includes(name))])
    if (isIncluded(program, option))
      console.log(`  /** ${option.help} */\n  ${camelCase(option.name)}?: ${typeOf(option.placeholder)};`);
  console.log('}');
}
