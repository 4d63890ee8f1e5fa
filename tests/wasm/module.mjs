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

const near = { iterations: 2, quiet: true };
const morphed = await tm.morph(ball, folded, near);
assert.equal(morphed.report.result.iterations, 2);
const outer = await tm.offset(ball, '5%');
assert.ok((await tm.info(outer)).volume > (await tm.info(ball)).volume);
const holed = await tm.stitch(new tm.Mesh(ball.positions, ball.faces.slice(9)));
assert.equal((await tm.checkmanifold(holed)).closed, false);
assert.equal((await tm.checkmanifold(await tm.fill(holed), { closed: true })).problem, undefined);
const report = await tm.checkmanifold(folded, { intersections: true });
assert.match(report.problem, /faces intersect/);
// A mesh is the value of an option.
assert.equal((await tm.checkmanifold(clean, { certify: folded })).problem, undefined);

// The caller sees progress, and its exception ends the run.
const seen = [];
await tm.repair(folded, { progress: (phase, fraction) => seen.push([phase, fraction]) });
assert.ok(seen.length > 0);
assert.ok(seen.every(([phase, fraction]) => phase.length > 0 && fraction >= 0 && fraction <= 1));
const stop = () => { throw new RangeError('enough'); };
await assert.rejects(tm.repair(folded, { progress: stop }), RangeError);

// With a signal a worker computes the same, tells its progress, and ends in the middle of a run.
const { signal } = new AbortController();
const inWorker = await tm.clean(folded, { signal });
assert.deepEqual(inWorker.ply, clean.ply);
await assert.rejects(tm.clean(folded, { signal, colour: true }), (error) => error.code === 2);
await assert.rejects(tm.repair(folded, { signal, progress: stop }), RangeError);
const controller = new AbortController();
const endless = tm.remesh(folded, {
  edge: '0.1%', signal: controller.signal, progress: () => controller.abort() });
await assert.rejects(endless, (error) => error.name === 'AbortError');
await assert.rejects(tm.clean(folded, { signal: AbortSignal.abort() }), (error) => error.name === 'AbortError');

// Errors have the exit code and the words of the program.
const isUsageError = (error) => error instanceof tm.TransforMeshError && error.code === 2;
await assert.rejects(tm.clean(ball, { colour: true }), isUsageError);
await assert.rejects(tm.read(new Uint8Array(0), 'empty.ply'), (error) => error.code === 3);
await assert.rejects(tm.boolean('union', []), (error) => error.code === 3);
// The message is the reason, although a loop also says which mesh it keeps.
const far = new tm.Mesh(ball.positions.map((x) => x / 10 + 9), ball.faces);
await assert.rejects(tm.morph(far, ball), /shrinks to nothing/);
const refused = await tm.clean(folded, { refuse: true }).catch((error) => error);
assert.equal(refused.code, 4);
assert.deepEqual(refused.messages.at(-1), `tm-clean: ${refused.message}`);
await assert.rejects(tm.repair(folded, { dryRun: true }), /no mesh/);

// Files in folders have their paths, without the state of the loop. Messages come while the program runs.
for (const control of [{}, { signal }]) {
  const heard = [];
  const words = ['ball.ply', '--target', 'ring.ply', '--iterations=3', '--every=1', '--frames=film', '--progress'];
  const result = await tm.run('tm-morph', [...words, '-o', 'end.ply'],
    { 'ball.ply': ball.ply, 'ring.ply': clean.ply }, { ...control, message: (line) => heard.push(line) });
  assert.equal(result.code, 0);
  assert.deepEqual(Object.keys(result.files).sort(), ['end.ply', ...[0, 1, 2, 3].map((i) => `film/frame-0000${i}.ply`)]);
  assert.deepEqual(heard, result.messages);
  assert.ok(heard.some((line) => line.includes('iteration 1:')));
  await assert.rejects(tm.clean(folded, { ...control, colour: true, message: stop }), RangeError);
}
