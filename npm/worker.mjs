// A worker that runs one program for run_in_worker.mjs.
import { load } from './module.mjs';
import { runHere } from './run.mjs';

const isNode = typeof process === 'object' && typeof process.versions?.node === 'string';
const port = isNode ? (await import('node:worker_threads')).parentPort : globalThis;

async function answer({ module, job, hasProgress, hasMessage }) {
  await load(module);
  const result = await runHere(job, {
    progress: hasProgress ? (...words) => port.postMessage({ progress: words }) : undefined,
    message: hasMessage ? (line) => port.postMessage({ message: line }) : undefined,
  });
  port.postMessage({ result }, Object.values(result.files).map((bytes) => bytes.buffer));
}

port.addEventListener('message', ({ data }) => {
  answer(data).catch((error) => port.postMessage({ failure: String(error?.message ?? error) }));
});
port.postMessage({ isReady: true });
