// Runs a program of the suite on the words, files and streams of this process.
import { instantiate } from './module.mjs';
import { useFilesOfNode } from './node_files.mjs';

const exitOfInternalError = 4;

export async function runProgram(name) {
  const module = await instantiate({
    preRun: [({ ENV }) => ENV && Object.assign(ENV, process.env)],
  });
  useFilesOfNode(module);
  try {
    process.exitCode = module.callMain([name, ...process.argv.slice(2)]);
  } catch (error) {
    process.stderr.write(`${name}: internal error: ${error.message ?? error}\n`);
    process.exitCode = exitOfInternalError;
  }
}
