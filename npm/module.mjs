// One run of one program is one instance of the module: the programs keep state until they end.
import createTransforMesh from './transformesh.mjs';

const isNode = typeof process === 'object' && typeof process.versions?.node === 'string';

let compiled;

async function bytesOf(location) {
  if (isNode && location.protocol === 'file:') {
    const { readFile } = await import('node:fs/promises');
    return readFile(location);
  }
  return (await fetch(location)).arrayBuffer();
}

/**
 * Compiles the module; later calls return the first result.
 * @param {URL | BufferSource | WebAssembly.Module} [source] default: transformesh.wasm beside this file
 */
export function load(source) {
  compiled ??= (async () => {
    if (source instanceof WebAssembly.Module) return source;
    source ??= new URL('./transformesh.wasm', import.meta.url);
    return WebAssembly.compile(source instanceof URL ? await bytesOf(source) : source);
  })();
  return compiled;
}

/** Returns an instance that has run no program yet. `hooks` are those of Emscripten. */
export async function instantiate(hooks) {
  const module = await load();
  return createTransforMesh({
    ...hooks,
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module));
      return {};
    },
    quit(status, error) {
      throw error;
    },
  });
}
