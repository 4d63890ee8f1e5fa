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

/** Calls the caller's functions during a run. The first exception of them ends the run, and is kept. */
function observerOf({ progress, message }) {
  let next = 0;
  const callOrKeep = (call) => {
    if (observer.thrown) return;
    try {
      call();
    } catch (error) {
      observer.thrown = { error };
    }
  };
  const observer = {
    observe(phase, fraction) {
      const now = performance.now();
      if (progress && now >= next) {
        next = now + progressInterval;
        callOrKeep(() => progress(phase, fraction));
      }
      return !observer.thrown;
    },
    hear(line) {
      if (message) callOrKeep(() => message(line));
    },
  };
  return observer;
}

/** Paths of the files below a folder. Temporary files and the folder of a loop's state are left out. */
function filesIn(FS, program, folder = '') {
  const isResult = (name) => !name.startsWith('.') && !name.endsWith(`.${program}`);
  const paths = FS.readdir(`./${folder}`).filter(isResult).map((name) => folder + name);
  return paths.flatMap((path) => (FS.isDir(FS.stat(path).mode) ? filesIn(FS, program, `${path}/`) : [path]));
}

/**
 * Runs a program on files in memory and returns its exit code, files and messages.
 * @param {{ program: string, words: string[], files: Record<string, Uint8Array> }} job
 * @param {{ progress?: (phase: string, fraction: number) => void, message?: (line: string) => void }} [control]
 */
export async function runHere({ program, words, files }, control = {}) {
  const messages = [], printed = [];
  const observer = observerOf(control);
  const module = await instantiate({
    print: (line) => printed.push(line),
    printErr(line) {
      messages.push(line);
      observer.hear(line);
    },
    stdin: () => null,
    observe: observer.observe,
  });
  const { FS } = module;
  FS.mkdir('/work');
  FS.chdir('/work');
  for (const [name, bytes] of Object.entries(files)) FS.writeFile(name, bytes);
  const code = module.callMain([program, ...words]);
  if (observer.thrown) throw observer.thrown.error;
  const written = filesIn(FS, program).filter((path) => !(path in files));
  const results = Object.fromEntries(written.map((path) => [path, FS.readFile(path)]));
  return { code, printed: printed.join('\n'), messages, files: results };
}
