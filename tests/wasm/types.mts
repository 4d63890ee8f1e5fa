// Compiled and never run: what npm/index.d.ts allows and refuses.
import * as tm from 'transformesh';

export async function everyFunction(bytes: Uint8Array, signal: AbortSignal): Promise<number> {
  await tm.load();
  const mesh: tm.Mesh = await tm.read(bytes, 'part.stl', { signal });
  const progress = (phase: string, fraction: number) => console.log(phase.length + fraction);
  const results: tm.Mesh[] = [
    await tm.clean(mesh, { mergeFlat: true, method: 'static', progress }),
    await tm.boolean('difference', [mesh, new tm.Mesh([0, 0, 0], [0, 0, 0])], { noMergeFlat: true }),
    await tm.repair(mesh, { maxChange: '1%', signal }),
    await tm.stitch(mesh, { tolerance: 0.01, orient: true }),
    await tm.fill(mesh, { maxEdges: 10 }),
    await tm.remesh(mesh, { edge: '0.7x', align: mesh }),
    await tm.offset(mesh, -0.1, { miter: true }),
    await tm.offset(mesh, undefined, { thicken: 0.1 }),
    await tm.morph(mesh, mesh, { iterations: 3, features: 'off' }),
  ];
  const info: tm.Info = await tm.info(mesh);
  const report: tm.ManifoldReport = await tm.checkmanifold(mesh, { closed: true, certify: mesh });
  const file: Uint8Array = await tm.write(results[0], '3mf');
  const run: tm.RunResult = await tm.run('tm-sample', ['a.ply', '--count=10'], { 'a.ply': mesh.ply }, { signal, message: (line) => line.length });
  return info.volume + file.length + run.code + (report.problem ?? '').length + (await tm.countIntersections(mesh));
}

export async function mistakes(mesh: tm.Mesh): Promise<void> {
  // @ts-expect-error an option of another program
  await tm.clean(mesh, { mergeFlats: true });
  // @ts-expect-error a flag that is text
  await tm.stitch(mesh, { orient: 'yes' });
  // @ts-expect-error no operation
  await tm.boolean('unite', [mesh]);
  // @ts-expect-error no format
  await tm.write(mesh, 'dae');
  // @ts-expect-error lines are text
  await tm.fill(mesh, { message: (line: number) => line });
  // @ts-expect-error a result is a promise
  tm.clean(mesh).faces.length;
}
