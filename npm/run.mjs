// Runs one program in this thread.
import { instantiate } from './module.mjs';

// Milliseconds between two calls of `progress`: pages draw at most so often, and a call per step of a
// program would take longer than the step.
const progressInterval = 50;

/** What a program refused: its exit code (man page tm(7)), its sentence, and all lines of its stderr. */
export class TransforMeshError extends Error {
  constructor(message, code, messages = [message]) {
    super(message);
    this.name = 'TransforMeshError';
    this.code = code;
    this.messages = messages;
  }
}

/** An observer that calls `progress`, and ends the run at its first exception, which is kept. */
function observerOf(progress) {
  let next = 0;
  const observer = {
    observe(phase, fraction) {
      const now = performance.now();
      if (now < next) return true;
      next = now + progressInterval;
      try {
        progress(phase, fraction);
        return true;
      } catch (error) {
        observer.thrown = { error };
        return false;
      }
    },
  };
  return observer;
}

/**
 * Runs a program on files in memory and returns its exit code, files and messages.
 * @param {{ program: string, words: string[], files: Record<string, Uint8Array> }} job
 * @param {(phase: string, fraction: number) => void} [progress]
 */
export async function runHere({ program, words, files }, progress) {
  const messages = [], printed = [];
  const observer = progress ? observerOf(progress) : {};
  const module = await instantiate({
    print: (line) => printed.push(line),
    printErr: (line) => messages.push(line),
    stdin: () => null,
    observe: observer.observe,
  });
  const { FS } = module;
  FS.mkdir('/work');
  FS.chdir('/work');
  for (const [name, bytes] of Object.entries(files)) FS.writeFile(name, bytes);
  const code = module.callMain([program, ...words]);
  if (observer.thrown) throw observer.thrown.error;
  // Of a loop also the folder with its state is there.
  const isResult = (name) => FS.isFile(FS.stat(name).mode) && !name.startsWith('.') && !(name in files);
  const written = FS.readdir('/work').filter(isResult);
  const results = Object.fromEntries(written.map((name) => [name, FS.readFile(name)]));
  return { code, printed: printed.join('\n'), messages, files: results };
}
