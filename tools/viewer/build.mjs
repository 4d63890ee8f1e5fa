// node build.mjs FILE: bundles the viewer to one HTML file, and writes the license of three.js beside
// it.

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

// Replacements are functions, because `$` has a meaning in replacement strings.
const page = (await text('page.html'))
  .replace('/*tm:style*/', () => style.code.trim())
  .replace('/*tm:script*/', () => script);
await writeFile(output, page);
await writeFile(join(dirname(output), 'viewer-three.LICENSE'), licence);
