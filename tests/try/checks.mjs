// node checks.mjs SITE NAME [WORD]...: one check of the page of docs/try; what is wrong goes to stderr.

import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {axe, differenceOf, pixelsOf, statisticsOf, wait} from '../browser/browser.mjs';
import {download, drop, dropBytes, measured, start, withSite} from './site.mjs';

const [site, name, ...words] = process.argv.slice(2);

const sizes = {
  phone: {width: 390, height: 844, touch: true}, laptop: {width: 1440, height: 900}, large: {width: 2560, height: 1440},
};
const textOf = (page, id) => page.$eval(`#${id}`, (element) => element.textContent.trim());

async function findNothing(page) {
  await page.evaluate(axe());
  const {violations, passes} = await page.evaluate('axe.run({preload: false})');
  assert(passes.length > 15, `${passes.length} rules pass`);
  assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes.map((node) => node.html).join(' ')}`), []);
  const [needed, given] = await page.evaluate('[document.documentElement.scrollWidth, innerWidth]');
  assert(needed <= given, `the page is ${needed} pixels wide in a window of ${given}`);
  const cut = await page.$$eval('.panel > section', (all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.innerText));
  assert.deepEqual(cut, []);
}

const commandOf = async (page) => `${await page.$eval('#commands code', (code) => code.textContent)}\n`;

const wipe = async (page, value) => {
  await page.$eval('#wipe', (slider, share) => {
    slider.value = share;
    slider.dispatchEvent(new Event('input', {bubbles: true}));
  }, value);
  await wait(700);
};

const checks = {
  // FOLDER KIND FIELDS FILE...: saves the result and the command line there.
  async task(folder, kind, fields, ...files) {
    await withSite(site, {}, async (page) => {
      await drop(page, ...files);
      await measured(page, files.length);
      await start(page, kind, JSON.parse(fields));
      await measured(page, files.length + 1);
      assert.equal(await page.$eval('#problem', (element) => element.hidden), true, await textOf(page, 'problem'));
      await download(page, folder);
      writeFileSync(join(folder, 'command.sh'), await commandOf(page));
    });
  },

  // FOLDER KIND FIELDS FILE...: pictures of the page with the result in three sizes, the last one dark.
  async pictures(folder, kind, fields, ...files) {
    for (const [size, options] of Object.entries(sizes)) {
      await withSite(site, {...options, dark: size === 'large'}, async (page) => {
        await drop(page, ...files);
        await measured(page, files.length);
        await start(page, kind, JSON.parse(fields));
        await measured(page, files.length + 1);
        await page.screenshot({path: join(folder, `picture-${size}.png`)});
      });
    }
  },

  // FILE TASK FIELDS TASK FIELDS: the second task is one on the result of the first.
  async chain(folder, file, first, second, format) {
    await withSite(site, {}, async (page) => {
      await drop(page, file);
      await measured(page, 1);
      await start(page, ...JSON.parse(first));
      await measured(page, 2);
      await start(page, ...JSON.parse(second));
      await measured(page, 3);
      await page.select('#format', format);
      await page.waitForFunction((end) => app.selected.name.endsWith(end) && app.job === undefined, {}, `.${format}`);
      await measured(page, 3);
      await download(page, folder);
      writeFileSync(join(folder, 'command.sh'), await commandOf(page));
    });
  },

  // FILE: prints the counts of what is wrong as JSON.
  async counts(file) {
    await withSite(site, {}, async (page) => {
      await drop(page, file);
      await measured(page, 1);
      console.log(JSON.stringify(await page.evaluate('({...app.selected.findings.counts, ...app.selected.findings.facts})')));
    });
  },

  // FILE with a hole and a flipped part: both are seen in their colors, and named.
  async highlights(file) {
    await withSite(site, {}, async (page, browser) => {
      await drop(page, file);
      await measured(page, 1);
      const isViolet = (red, green, blue) => blue > green + 50 && red > green + 10;
      const isOrange = (red, green, blue) => red > green + 50 && green > blue + 20;
      const shown = await pixelsOf(page, browser, '#stage');
      assert(statisticsOf(shown, isViolet).count > 500, 'the flipped part is not violet');
      await page.click('[aria-label="Show holes"]');
      await wait(700);
      assert(statisticsOf(await pixelsOf(page, browser, '#stage'), isOrange).count > 100, 'the hole is not orange');
      await page.click('#marks');
      await wait(700);
      const plain = await pixelsOf(page, browser, '#stage');
      assert.equal(statisticsOf(plain, isViolet).count + statisticsOf(plain, isOrange).count, 0);
      const rows = await page.$$eval('.findings tbody:first-of-type tr:not(.why)', (all) => all.map((row) => row.innerText.split('\t').map((cell) => cell.trim())));
      assert.deepEqual(rows.map(([title]) => title), ['Self-intersections', 'Holes', 'Flipped faces']);
      assert.deepEqual(rows[0][1], 'none');
      assert.equal(rows[1][1], '1');
      assert.match(await textOf(page, 'verdict'), /^Not a solid yet: 2 kinds of fault/);
      await start(page, 'repair');
      await measured(page, 2);
      assert.match(await textOf(page, 'verdict'), /^A solid: closed/);
    });
  },

  // FILE: on either side of the line is what the whole picture shows there.
  async compare(file) {
    await withSite(site, {}, async (page, browser) => {
      await drop(page, file);
      await measured(page, 1);
      await start(page, 'offset', {distance: '10%'});
      await measured(page, 2);
      const pictures = {};
      for (const share of [0, 100, 50]) {
        await wipe(page, share);
        pictures[share] = await pixelsOf(page, browser, '#stage');
      }
      assert(differenceOf(pictures[0], pictures[100]) > 0.03, 'before and after look alike');
      assert(differenceOf(pictures[50], pictures[100], 0.1, 0.47) < 0.002, 'the left half is not what was before');
      assert(differenceOf(pictures[50], pictures[0], 0.53, 0.9) < 0.002, 'the right half is not what is after');
      // The line is dragged on the mesh, too.
      const handle = await (await page.$('#handle')).boundingBox();
      await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
      await page.mouse.down();
      await page.mouse.move(handle.x - 200, handle.y, {steps: 5});
      await page.mouse.up();
      assert(Number(await page.$eval('#wipe', (slider) => slider.value)) < 40);
    });
  },

  // SOURCE TARGET FRAMES: the film has so many frames, which differ.
  async film(source, target, frames) {
    await withSite(site, {}, async (page, browser) => {
      await drop(page, source, target);
      await measured(page, 2);
      await start(page, 'morph', {every: '5'});
      await measured(page, 3);
      assert.equal(await page.$eval('#frame', (slider) => Number(slider.max) + 1), Number(frames));
      await page.waitForFunction("document.getElementById('play').getAttribute('aria-pressed') === 'false'");
      await wait(700);
      const last = await pixelsOf(page, browser, '#stage');
      await page.focus('#frame');
      await page.keyboard.press('Home');
      await wait(700);
      assert.equal(await textOf(page, 'now'), 'iteration 0');
      assert(differenceOf(last, await pixelsOf(page, browser, '#stage')) > 0.03, 'the first frame looks like the last');
      await page.focus('#play');
      await page.keyboard.press('Enter');
      await page.waitForFunction("Number(document.getElementById('frame').value) > 1");
    });
  },

  // FILE: nothing is asked for after loading, also not by new workers, and nobody else can be asked.
  async private(file) {
    await withSite(site, {}, async (page, _, asked) => {
      const atStart = asked.length;
      await drop(page, file);
      await measured(page, 1);
      await start(page, 'repair');
      await measured(page, 2);
      await start(page, 'offset', {distance: '1%'});
      await page.keyboard.press('Escape');
      await page.waitForFunction("document.getElementById('progress').textContent === 'Canceled.'");
      await start(page, 'decimate');
      await measured(page, 3);
      await wait(200);
      assert.deepEqual(asked.slice(atStart), []);
      assert.deepEqual([...asked].sort(), ['/', '/transformesh.wasm', '/try.css', '/try.js', '/worker.js']);
    });
    // The console names what the policy refuses.
    await withSite(site, {mayEnd: true}, async (page, _, asked) => {
      const elsewhere = (await page.evaluate('location.href')).replace('127.0.0.1', 'localhost');
      const refused = await page.evaluate(async (address) => {
        const inPage = await fetch(address).then(() => 'answered', (error) => error.name);
        const script = new Blob([`fetch('${address}').then(() => postMessage('answered'), (error) => postMessage(error.name))`], {type: 'text/javascript'});
        const worker = new Worker(URL.createObjectURL(script));
        const inWorker = await new Promise((done) => { worker.onmessage = ({data}) => done(data); });
        return [inPage, inWorker];
      }, elsewhere);
      await wait(200);
      assert.deepEqual(refused, ['TypeError', 'TypeError']);
      assert(!asked.some((one, i) => i > 0 && one === '/'), 'the other address was asked');
    });
  },

  // FILE: from the list of files to a repaired one, without a mouse.
  async keyboard(file) {
    await withSite(site, {}, async (page, browser) => {
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate('document.activeElement.textContent'), 'Choose files');
      await drop(page, file);
      await measured(page, 1);
      const reached = new Set();
      await page.focus('#stage');
      const before = await pixelsOf(page, browser, '#stage');
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('ArrowLeft');
      await wait(700);
      assert(differenceOf(before, await pixelsOf(page, browser, '#stage')) > 0.01, 'arrows do not turn the mesh');
      for (let i = 0; i < 40; ++i) {
        await page.keyboard.press('Tab');
        reached.add(await page.evaluate('document.activeElement.id || document.activeElement.name || document.activeElement.textContent'));
      }
      for (const wanted of ['marks', 'wireframe', 'flat', 'up', 'reset', 'Add files', 'shown', 'kind', 'keepOpen', 'go'])
        assert(reached.has(wanted), `the Tab key does not reach ${wanted}: ${[...reached].join(', ')}`);
      await page.focus('#task [value="repair"]');
      await page.keyboard.press('ArrowRight');
      assert.equal(await page.evaluate("document.querySelector('[name=kind]:checked').value"), 'combine');
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('Enter');
      await measured(page, 2);
      assert.match(await page.evaluate('app.selected.name'), /-repaired\./);
      await page.focus('#files input:checked');
      await page.keyboard.press('ArrowUp');
      await measured(page, 2);
      assert.doesNotMatch(await page.evaluate('app.selected.name'), /-repaired\./);
    });
  },

  // SIZE SOLID OTHER: axe-core finds nothing, and nothing is cut off, light or dark.
  async accessible(size, solid, other) {
    for (const dark of [false, true]) {
      await withSite(site, {...sizes[size], dark}, async (page) => {
        await findNothing(page);
        await drop(page, solid, other);
        await measured(page, 2);
        await findNothing(page);
        await start(page, 'repair');
        await measured(page, 3);
        await page.$$eval('details', (all) => all.forEach((one) => { one.open = true; }));
        await findNothing(page);
        await start(page, 'morph', {every: '10'});
        await measured(page, 4);
        await findNothing(page);
      });
    }
  },

  // What cannot be read or done is said, and the page goes on.
  async refusals(file) {
    await withSite(site, {}, async (page) => {
      await dropBytes(page, [{name: 'broken.off', bytes: 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n'}]);
      await measured(page, 1);
      assert.match(await textOf(page, 'problem'), /^broken\.off: .*vertex index 7/);
      await page.evaluate("app.open([new File([new Uint8Array(100000001)], 'huge.stl')])");
      await page.waitForFunction("document.getElementById('problem').textContent.startsWith('huge.stl has 101 MB')");
      await drop(page, file, file);
      await measured(page, 3);
      assert.match(await textOf(page, 'problem'), /already: this one is called .*-2\./);
      await start(page, 'offset', {distance: 'much'});
      assert.match(await textOf(page, 'problem'), /^'much' is not a length/);
      await start(page, 'offset', {distance: '0'});
      await page.waitForFunction("document.getElementById('problem').textContent.startsWith('tm-offset: ')");
      await start(page, 'decimate');
      await measured(page, 4);
      assert.equal(await page.$eval('#problem', (element) => element.hidden), true);
    });
  },

  // FILE: without WebGL all works but the view.
  async plain(folder, file) {
    await withSite(site, {mayEnd: true}, async (page) => {
      await page.evaluate('HTMLCanvasElement.prototype.getContext = () => null');
      await drop(page, file);
      await measured(page, 1);
      assert.match(await textOf(page, 'problem'), /WebGL/);
      await start(page, 'repair');
      await measured(page, 2);
      await download(page, folder);
    });
  },

  // Each example opens and is measured.
  async examples() {
    await withSite(site, {}, async (page) => {
      for (let i = 0; i < await page.$$eval('#examples button', (all) => all.length); ++i) {
        await page.reload();
        await page.waitForFunction('window.app');
        await page.click(`#examples button:nth-child(${i + 1})`);
        await measured(page, 1);
        assert.equal(await page.$eval('#problem', (element) => element.hidden), true, await textOf(page, 'problem'));
      }
    });
  },

  // FILE...: prints the seconds from the drop, with the repair asked for at once, to the download.
  async speed(...files) {
    for (const file of files) {
      await withSite(site, {}, async (page) => {
        await page.evaluate(() => {
          addEventListener('drop', async () => {
            window.dropped = performance.now();
            while (!app.selected) await new Promise((done) => setTimeout(done, 1));
            document.getElementById('task').requestSubmit();
            while (!app.selected?.made) await new Promise((done) => setTimeout(done, 1));
            window.repaired = performance.now();
          });
          const timer = setInterval(() => {
            if (!app.stage) return;
            window.seen = performance.now();
            clearInterval(timer);
          }, 1);
        });
        await drop(page, file);
        await page.waitForFunction('window.repaired && window.seen', {timeout: 120000});
        const [seen, repaired] = await page.evaluate('[seen - dropped, repaired - dropped].map((one) => (one / 1000).toFixed(2))');
        await measured(page, 2);
        const checked = await page.evaluate('((performance.now() - dropped) / 1000).toFixed(2)');
        console.log(`${file}: seen after ${seen} s, repaired after ${repaired} s, all checked and drawn after ${checked} s`);
      });
    }
  },
};

try {
  await checks[name](...words);
} catch (error) {
  console.error(error.stack ?? error.message);
  process.exitCode = 1;
}
await wait(0);
