// The page of docs/try on a server of this machine, and what a person does on it.

import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import {basename, join} from 'node:path';
import {wait, withPage} from '../browser/browser.mjs';

// Serves a folder as a reader would, and notes what is asked for.
async function serve(folder) {
  const words = ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1', '--directory', folder];
  const server = spawn('python3', words, {stdio: ['ignore', 'pipe', 'pipe']});
  const asked = [];
  server.stderr.on('data', (text) => asked.push(...[...String(text).matchAll(/"GET (\S+)/g)].map(([, path]) => path)));
  let said = '';
  const port = await new Promise((done) => server.stdout.on('data', (text) => {
    said += text;
    const found = / port (\d+) /.exec(said);
    if (found) done(found[1]);
  }));
  return {asked, server, address: `http://127.0.0.1:${port}/`};
}

// Runs `check` on the loaded page; `asked` grows with what it asks its server for.
export async function withSite(folder, options, check) {
  const {asked, server, address} = await serve(folder);
  try {
    await withPage(address, {width: 1440, height: 900, isText: true, ...options}, async (page, browser) => {
      await page.evaluate('app.workers');
      await check(page, browser, asked);
    });
  } finally {
    server.kill();
  }
}

// Drops files that are given as {name, bytes}.
export async function dropBytes(page, files) {
  const data = files.map(({name, bytes}) => ({name, text: Buffer.from(bytes).toString('base64')}));
  await page.evaluate((all) => {
    const transfer = new DataTransfer();
    for (const {name, text} of all)
      transfer.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
    document.body.dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: transfer}));
  }, data);
}

export const drop = (page, ...paths) =>
  dropBytes(page, paths.map((path) => ({name: basename(path), bytes: readFileSync(path)})));

// Waits until `count` files are measured and drawn.
export async function measured(page, count) {
  await page.waitForFunction((least) => app.entries.length >= least && app.job === undefined &&
    app.entries.every((entry) => entry.findings || entry.problem), {timeout: 240000}, count);
  await page.waitForFunction('!app.stage || (!app.stage.view.isDue && (app.stage.view.isFine || !app.stage.view.isSlow))');
  await wait(350);
}

// Fills in the form as its fields are named, and starts the task.
export async function start(page, kind, fields = {}) {
  await page.click(`#task label:has([value="${kind}"])`);
  for (const [name, value] of Object.entries(fields)) {
    const selector = `#task [name="${name}"]`;
    const isChoice = await page.$eval(selector, (field) => field.localName === 'select');
    if (isChoice) {
      // Files are chosen by their names.
      const chosen = await page.$eval(selector, (field, text) =>
        [...field.options].find((option) => option.value === text || option.text === text)?.value, value);
      await page.select(selector, chosen);
    } else if (value === 'on') {
      await page.click(selector);
    } else {
      await page.$eval(selector, (field, text) => { field.value = text; }, value);
    }
  }
  await page.click('#go');
}

// Saves the shown result by its link, and returns its path.
export async function download(page, folder) {
  const session = await page.createCDPSession();
  await session.send('Page.setDownloadBehavior', {behavior: 'allow', downloadPath: folder});
  const name = await page.$eval('#download', (link) => link.download);
  await page.click('#download');
  for (let tries = 0; !existsSync(join(folder, name)); ++tries) {
    assert(tries < 200, `${name} is not downloaded`);
    await wait(50);
  }
  return join(folder, name);
}
