// Uses the installed package: node module.mjs SELF-INTERSECTING BALL. Writes clean.ply and union.faces.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import * as tm from 'transformesh';

const [folded, ball] = await Promise.all(
  process.argv.slice(2).map((name) => tm.read(readFileSync(name), name)));

assert.ok((await tm.countIntersections(folded)) > 0);
const clean = await tm.clean(folded);
assert.equal(await tm.countIntersections(clean), 0);
const info = await tm.info(clean);
assert.equal(info.vertices, clean.positions.length / 3);
assert.equal(info.faces, clean.faces.length / 3);
assert.equal(clean.report.tool, 'tm-clean');

// The bytes of the command line: those of the file that the mesh was read from.
const { files } = await tm.run('tm-clean', ['-q', 'in.stl', '-o', 'out'],
  { 'in.stl': readFileSync(process.argv[2]) });
writeFileSync('clean.ply', files.out);

const union = await tm.boolean('union', [clean, ball]);
writeFileSync('union.faces', String(union.faces.length / 3));

// Positions and faces become the same mesh again.
const copy = new tm.Mesh(ball.positions, ball.faces);
assert.equal((await tm.info(copy)).volume, (await tm.info(ball)).volume);
const again = await tm.read(await tm.write(copy, 'obj'), 'copy.obj');
assert.deepEqual(again.positions, copy.positions);

const coarse = await tm.remesh(ball, { faces: 500 });
assert.ok(coarse.faces.length / 3 < 600);

const isUsageError = (error) => error instanceof tm.TransforMeshError && error.code === 2;
await assert.rejects(tm.clean(ball, { colour: true }), isUsageError);
await assert.rejects(tm.read(new Uint8Array(0), 'empty.ply'), (error) => error.code === 3);

// Files in folders have their paths, and messages come while the program runs.
const heard = [];
const morph = await tm.run('tm-morph', ['ball.ply', '--target', 'ring.ply', '--iterations=3', '--every=1', '--frames=film', '--progress', '-o', 'end.ply'],
  { 'ball.ply': ball.ply, 'ring.ply': clean.ply }, (line) => heard.push(line));
assert.equal(morph.code, 0);
const film = Object.keys(morph.files).filter((name) => name.startsWith('film/')).sort();
assert.deepEqual(film, [0, 1, 2, 3].map((i) => `film/frame-0000${i}.ply`));
assert.deepEqual(heard, morph.messages);
assert.ok(heard.some((line) => line.includes('iteration 1:')));
