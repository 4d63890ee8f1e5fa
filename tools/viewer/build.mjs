// Puts the viewer into one HTML file: node build.mjs FILE. Beside it goes the licence of three.js.

import {readFile, writeFile} from 'node:fs/promises';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {build, transform} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
const text = (name) => readFile(join(here, name), 'utf8');

const bundle = await build({
  entryPoints: [join(here, 'main.js')], bundle: true, minify: true, format: 'iife', target: 'es2022',
  legalComments: 'none', write: false,
});
const style = await transform(await text('page.css'), {loader: 'css', minify: true});
const licence = await text('node_modules/three/LICENSE');
const script = `/* with three.js:\n\n${licence}*/\n${bundle.outputFiles[0].text}`;

// Functions, as texts would have $ replaced.
const page = (await text('page.html'))
  .replace('/*tm:style*/', () => style.code.trim())
  .replace('/*tm:script*/', () => script);
await writeFile(output, page);
await writeFile(join(dirname(output), 'viewer-three.LICENSE'), licence);
