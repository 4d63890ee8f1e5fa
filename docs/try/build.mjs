// Bundles the page's script, its worker and its style: node build.mjs MODULE FOLDER.

import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const {build} = createRequire(join(here, '../../tools/viewer/package.json'))('esbuild');
const [module, folder] = process.argv.slice(2);

const options = {
  bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning',
  // Emscripten's script also looks for the exports of CommonJS.
  logOverride: {'commonjs-variable-in-esm': 'silent'},
  // A script from a blob has no folder; the page gives it the compiled module instead.
  define: {'import.meta.url': 'undefined'}, external: ['node:*'],
  alias: {transformesh: join(resolve(module), 'index.mjs')},
};
await Promise.all([
  build({...options, entryPoints: [join(here, 'main.js')], outfile: join(folder, 'try.js')}),
  build({...options, entryPoints: [join(here, 'worker.js')], outfile: join(folder, 'worker.js')}),
  build({...options, entryPoints: [join(here, 'try.css')], outfile: join(folder, 'try.css')}),
]);
