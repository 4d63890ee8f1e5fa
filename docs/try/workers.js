// Two workers: a measurement in one does not wait for a task in the other.

export class Canceled extends Error {}

class Line {
  constructor(address, module) {
    this.start = () => {
      this.worker = new Worker(address, {type: 'module'});
      this.worker.onmessage = ({data}) => this.#receive(data);
      this.worker.onerror = (event) => this.#end(event.message || 'The worker has ended.');
      this.worker.postMessage({kind: 'module', data: module});
    };
    this.queue = [];
    this.start();
  }

  add(task) {
    this.queue.push(task);
    if (this.queue.length === 1) this.#send();
  }

  #send() {
    const {job, kind, data} = this.queue[0];
    this.worker.postMessage({job, kind, data});
  }

  #receive({job, type, value}) {
    const task = this.queue[0];
    if (task?.job !== job) return;
    if (type !== 'done' && type !== 'failed') return task.on[type]?.(value);
    this.queue.shift();
    if (type === 'done') task.resolve(value); else task.reject(new Error(value));
    if (this.queue.length > 0) this.#send();
  }

  #end(reason) {
    this.restart(this.queue[0]?.job, new Error(reason));
  }

  // Ends the job by ending its worker; the other jobs go on in a new one.
  restart(job, error) {
    const at = this.queue.findIndex((task) => task.job === job);
    if (at < 0) return;
    const [task] = this.queue.splice(at, 1);
    task.reject(error);
    if (at > 0) return;
    this.worker.terminate();
    this.start();
    if (this.queue.length > 0) this.#send();
  }
}

export class Workers {
  constructor(address, module) {
    this.lines = [new Line(address, module), new Line(address, module)];
    this.jobs = 0;
  }

  // Returns a promise of the result, with the number `job` for cancel(). Functions of `on` get what a job
  // sends before its result.
  run(kind, data, on = {}) {
    const job = ++this.jobs;
    const line = this.lines.reduce((one, other) => (other.queue.length < one.queue.length ? other : one));
    const promise = new Promise((resolve, reject) => line.add({job, kind, data, on, resolve, reject}));
    promise.job = job;
    return promise;
  }

  cancel(job) {
    for (const line of this.lines) line.restart(job, new Canceled());
  }
}

// Loads all that the page needs; later it requests nothing. A worker from a blob has the page's policy.
export async function startWorkers() {
  const [script, module] = await Promise.all([
    fetch('worker.js').then((answer) => answer.blob()),
    fetch('transformesh.wasm').then((answer) => answer.arrayBuffer()).then((bytes) => WebAssembly.compile(bytes)),
  ]);
  return new Workers(URL.createObjectURL(new Blob([script], {type: 'text/javascript'})), module);
}
