// Runs one program in a worker of its own, which a signal ends at once.
import { load } from './module.mjs';

const isNode = typeof process === 'object' && typeof process.versions?.node === 'string';
const threads = isNode ? await import('node:worker_threads') : undefined;

// Bundlers look for these very words of the second worker.
const startWorker = () => (isNode
  ? new threads.Worker(new URL('./worker.mjs', import.meta.url))
  : new Worker(new URL('./worker.mjs', import.meta.url), { type: 'module' }));

function listen(worker, event, call) {
  if (isNode) worker.on(event, call);
  else worker.addEventListener(event, (given) => call(event === 'message' ? given.data : given));
}

/** As `runHere`, until `signal` is aborted; then the promise is rejected with the signal's reason. */
export async function runInWorker(job, { progress, message }, signal) {
  signal.throwIfAborted();
  const module = await load();
  signal.throwIfAborted();
  const worker = startWorker();
  let stop;
  try {
    return await new Promise((resolve, reject) => {
      stop = () => reject(signal.reason);
      signal.addEventListener('abort', stop);
      listen(worker, 'error', (error) => reject(new Error(`the worker failed: ${error.message}`)));
      listen(worker, 'message', (sent) => {
        if (sent.isReady) worker.postMessage({ module, job, hasProgress: !!progress, hasMessage: !!message });
        else if (sent.result) resolve(sent.result);
        else if (sent.failure) reject(new Error(sent.failure));
        else if (sent.progress) callOrReject(() => progress(...sent.progress), reject);
        else callOrReject(() => message(sent.message), reject);
      });
    });
  } finally {
    signal.removeEventListener('abort', stop);
    worker.terminate();
  }
}

function callOrReject(call, reject) {
  try {
    call();
  } catch (error) {
    reject(error);
  }
}
