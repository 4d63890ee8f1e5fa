// Runs programs beside the page, which stays responsive. Messages of the page name a job.

import {load, run} from 'transformesh';
import {Refusal, inspect, read, sentenceOf} from './inspect.js';

// Messages of browsers and of Emscripten when memory ends.
const noneLeft = /out of memory|\bOOM\b|allocation failed|enlarge memory/i;

const buffersOf = (value) => {
  if (ArrayBuffer.isView(value)) return [value.buffer];
  return value && typeof value === 'object' ? Object.values(value).flatMap(buffersOf) : [];
};

const jobs = {
  // Sends the shape first: the page shows it while the rest is measured.
  async inspect({name, bytes}, send) {
    const mesh = await read(name, bytes);
    send('shape', {positions: mesh.positions.slice(), faces: mesh.faces.slice(), notes: mesh.notes});
    if (mesh.faces.length === 0) throw new Refusal('The file holds points and no faces.');
    return inspect(mesh);
  },

  // `files` by name; `frames` is the folder of a film.
  async run({program, words, output, frames, files}, send) {
    const result = await run(program, [...words, '--progress'], files, {message: (line) => send('progress', line)});
    if (result.code !== 0) throw new Refusal(sentenceOf(program, result));
    const film = Object.keys(result.files).filter((name) => frames && name.startsWith(`${frames}/`)).sort();
    const shapes = [];
    for (const name of film) {
      const {positions, faces} = await read('frame.ply', result.files[name]);
      shapes.push({number: Number(/(\d+)\.ply$/.exec(name)[1]), positions, faces});
    }
    return {
      bytes: result.files[output], film: shapes,
      messages: result.messages.map((line) => line.replace(`${program}: `, '')),
    };
  },

  // Makes the files of an example. A step may read files of earlier steps.
  async make({steps}) {
    const files = {};
    for (const {program, words, reads} of steps) {
      const result = await run(program, words, Object.fromEntries(reads.map((name) => [name, files[name]])));
      if (result.code !== 0) throw new Refusal(sentenceOf(program, result));
      Object.assign(files, result.files);
    }
    return {files};
  },
};

function sentenceOfError(error) {
  if (error instanceof Refusal) return error.message;
  if (noneLeft.test(error.message))
    return 'The browser has no memory left for this: close other pages, or use the programs on the command line.';
  return `Internal error: ${error.message}`;
}

addEventListener('message', async ({data: {job, kind, data}}) => {
  const send = (type, value) => postMessage({job, type, value}, [...new Set(buffersOf(value))]);
  try {
    if (kind === 'module') return void await load(data);
    send('done', await jobs[kind](data, send));
  } catch (error) {
    send('failed', sentenceOfError(error));
  }
});
