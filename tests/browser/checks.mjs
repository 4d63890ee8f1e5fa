// node checks.mjs NAME ADDRESS...: runs a check of a page in a browser. Failures are printed on stderr.

import assert from 'node:assert/strict';
import {axe, differenceOf, pixelsOf, setSlider, settled, statisticsOf, valueOf, wait, withPage} from './browser.mjs';

const widths = [{width: 800, height: 1000}, {width: 2000, height: 1200}];

// Fails if axe-core finds accessibility problems. On pages of the site, only the article is tested,
// and not the theme around it.
async function findNothing(page, leastPasses) {
  await page.evaluate(axe());
  const {violations, passes} = await page.evaluate("axe.run(document.querySelector('article[role=main]') ?? document, {preload: false})");
  assert(passes.length > leastPasses);
  assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes.map((node) => node.html).join(' ')}`), []);
}

const checks = {
  // Checks the page of a run.
  async opens(address) {
    for (const size of widths) {
      await withPage(address, size, async (page, browser) => {
        await settled(page);
        // Pixels of the mesh are darker than the background.
        const {count} = statisticsOf(await pixelsOf(page, browser, '#stage'), (red) => red < 0xd0);
        assert(count > 0.05 * size.width * size.height * 0.5, `the picture is empty: ${count} pixels`);
        assert.equal(await page.evaluate('document.documentElement.scrollWidth'), size.width, 'wider than the window');
        assert.equal(await page.$eval('#problem', (element) => element.hidden), true);
      });
    }
  },

  async slider(address) {
    await withPage(address, {}, async (page, browser) => {
      await settled(page);
      const end = await pixelsOf(page, browser, '#stage');
      await setSlider(page, 0);
      assert.match(await valueOf(page, 'now'), /^iteration 0$/);
      const start = await pixelsOf(page, browser, '#stage');
      assert(differenceOf(start, end) > 0.05, 'start and end look alike');
      const last = Number(await page.$eval('#slider', (slider) => slider.max));
      await setSlider(page, last);
      assert(differenceOf(end, await pixelsOf(page, browser, '#stage')) < 0.001, 'the end looks otherwise the second time');
      // Drags the slider as a user would; the last position counts.
      const box = await (await page.$('#slider')).boundingBox();
      await page.mouse.move(box.x + box.width - 8, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, {steps: 30});
      await page.mouse.up();
      await settled(page);
      const middle = Number(await valueOf(page, 'slider'));
      assert(Math.abs(middle - last / 2) <= 1, `at ${middle} of ${last}`);
    });
  },

  // Checks the page of a run with one event: two balls that grow and merge near (1.15, 0, 0).
  async events(address) {
    await withPage(address, {}, async (page, browser) => {
      await settled(page);
      const [event] = await page.evaluate('viewer.charts.events[0]');
      assert.equal(event.kind, 'merge');
      const marks = await page.$$eval('#charts .event title', (all) => all.map((one) => one.textContent));
      assert(marks.length > 3, `${marks.length} marks`);
      assert(marks.every((text) => text === `merge, iteration ${event.iteration}`), marks[0]);
      const cells = await page.$$eval('#event-tables tbody tr > *', (all) => all.map((one) => one.textContent));
      assert.equal(cells[0], 'merge');
      assert.equal(cells[5], '1 2 → 1');
      const before = await pixelsOf(page, browser, '#stage');
      await page.click('#event-tables button');
      await settled(page);
      const shown = await page.evaluate('viewer.times[viewer.place]');
      assert(Math.abs(shown - Number(event.iteration)) <= 1, `the frame of ${shown} is shown`);
      // The view must be centered at the event, in the coordinates of the mesh.
      const place = await page.evaluate(`(() => {
        const {group, extent} = viewer.view.cells[0];
        const {x, y, z} = group.worldToLocal(viewer.view.controls.target.clone());
        return [x, y, z].map((one, axis) => one * extent.radius + extent.middle[axis]);
      })()`);
      [event.x, event.y, event.z].forEach((x, axis) => assert(Math.abs(place[axis] - Number(x)) < 1e-6, `at ${place}`));
      assert(differenceOf(before, await pixelsOf(page, browser, '#stage')) > 0.05, 'the view has not moved');
    });
  },

  async curves(address) {
    for (const size of widths) {
      await withPage(address, size, async (page) => {
        const names = await page.$$eval('figcaption', (all) => all.map((one) => one.firstChild.textContent));
        for (const name of ['faces', 'components', 'genus', 'seconds']) assert(names.includes(name), `${name} is missing`);
        const chart = (await page.$$('#charts figure'))[names.indexOf('faces')];
        await chart.scrollIntoView();
        const box = await (await chart.$('svg')).boundingBox();
        const times = await page.evaluate('viewer.times');
        for (const place of [0, 2, times.length - 1]) {
          // Position of this time on the curve; the plot extends from 6 to 314 of 320 units.
          const share = (6 + 308 * (times[place] - times[0]) / (times.at(-1) - times[0])) / 320;
          await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
          await settled(page);
          assert.equal(Number(await valueOf(page, 'slider')), place);
          const faces = await page.evaluate((at) => viewer.page.runs[0].meshes[at].faces, place);
          if (place > 0) {
            const said = await chart.$eval('.value', (element) => element.textContent.replaceAll(',', ''));
            assert.equal(Number(said), faces, 'the curve says another number of faces');
          }
        }
        // The mark must be at the pointer.
        const mark = await chart.$eval('.cursor', (element) => element.getBoundingClientRect().left);
        assert(Math.abs(mark - (box.x + 314 / 320 * box.width)) < 2, 'the cursor is elsewhere');
      });
    }
  },

  async keyboard(address) {
    await withPage(address, {}, async (page, browser) => {
      const reached = [];
      for (let i = 0; i < 12; ++i) {
        await page.keyboard.press('Tab');
        reached.push(await page.evaluate('document.activeElement.id'));
      }
      for (const id of ['stage', 'play', 'slider', 'color', 'wireframe', 'reset']) assert(reached.includes(id), `Tab never comes to ${id}`);
      await page.focus('#stage');
      await settled(page);
      // A busy machine may draw in full resolution after settled() has returned.
      const steady = async () => {
        let pixels = await pixelsOf(page, browser, '#canvas');
        for (let i = 0; i < 20; ++i) {
          await settled(page);
          const next = await pixelsOf(page, browser, '#canvas');
          if (differenceOf(pixels, next) === 0) break;
          pixels = next;
        }
        return pixels;
      };
      const before = await steady();
      const turned = async (...keys) => {
        for (const key of keys) await page.keyboard.press(key);
        await settled(page);
        return differenceOf(before, await steady());
      };
      assert(await turned('ArrowRight', 'ArrowRight', 'ArrowUp') > 0.01, 'arrows turn nothing');
      assert(await turned('0') < 0.001, '0 does not reset the view');
      assert(await turned('-', '-') > 0.01, '- does not zoom');
      await page.keyboard.press('0');
      const place = async () => Number(await valueOf(page, 'slider'));
      const last = await place();
      await page.keyboard.press(',');
      assert.equal(await place(), last - 1);
      await page.keyboard.press('.');
      assert.equal(await place(), last);
      await page.keyboard.press('Space');
      assert.equal(await page.$eval('#play', (button) => button.getAttribute('aria-pressed')), 'true');
      await page.waitForFunction((end) => document.getElementById('play').getAttribute('aria-pressed') === 'false' && Number(document.getElementById('slider').value) === end, {}, last);
      await page.focus('#slider');
      await page.keyboard.press('Home');
      assert.equal(await place(), 0);
      await page.keyboard.press('ArrowRight');
      assert.equal(await place(), 1);
      assert.match(await page.$eval('#slider', (slider) => slider.getAttribute('aria-valuetext')), /^iteration \d+, [\d,]+ faces$/);
    });
  },

  async touch(address) {
    await withPage(address, {width: 400, height: 800, touch: true}, async (page, browser) => {
      await settled(page);
      const before = await pixelsOf(page, browser, '#canvas');
      const box = await (await page.$('#stage')).boundingBox();
      await page.touchscreen.touchStart(box.x + 100, box.y + 100);
      for (let i = 1; i <= 10; ++i) await page.touchscreen.touchMove(box.x + 100 + 10 * i, box.y + 100);
      await page.touchscreen.touchEnd();
      await settled(page);
      assert(differenceOf(before, await pixelsOf(page, browser, '#canvas')) > 0.01, 'a finger turns nothing');
      assert.equal(await page.evaluate('document.documentElement.scrollWidth'), 400, 'wider than the window');
    });
  },

  async colors(address) {
    await withPage(address, {}, async (page, browser) => {
      await settled(page);
      const plain = await pixelsOf(page, browser, '#canvas');
      assert.equal(await page.$eval('#legend', (element) => element.hidden), true);
      await setSlider(page, 0);
      await page.select('#color', 'distance');
      await settled(page);
      const [low, high] = [await valueOf(page, 'legend-low'), await valueOf(page, 'legend-high')].map(Number);
      assert(low >= 0 && high > 0.1, `the legend is from ${low} to ${high}`);
      const colored = await pixelsOf(page, browser, '#canvas');
      const isViridis = (red, green, blue) => Math.max(red, green, blue) - Math.min(red, green, blue) > 40;
      assert.equal(statisticsOf(plain, isViridis).count > 0.02 * plain.width * plain.height, false);
      assert(statisticsOf(colored, isViridis).count > 0.1 * colored.width * colored.height, 'nothing has colors');
      await page.click('#range');
      await settled(page);
      assert(Number(await valueOf(page, 'legend-low')) > low, 'the ends are not those of the frame');
      await page.click('#wireframe');
      await settled(page);
      assert(differenceOf(colored, await pixelsOf(page, browser, '#canvas')) > 0.05, 'no wires');
    });
  },

  // Checks that, in the middle of a morph, the target is visible outside of the surface.
  async ghost(address) {
    await withPage(address, {}, async (page, browser) => {
      await setSlider(page, Math.floor(0.6 * Number(await page.$eval('#slider', (slider) => slider.max))));
      const isOrange = (red, green, blue) => red - blue > 12;
      const withGhost = statisticsOf(await pixelsOf(page, browser, '#stage'), isOrange).count;
      await page.click('#ghost');
      await settled(page);
      const without = statisticsOf(await pixelsOf(page, browser, '#stage'), isOrange).count;
      assert(withGhost > 500 && without < 50, `${withGhost} orange pixels with it, ${without} without`);
    });
  },

  // Checks the page of a single box: its sides are flat, and no key plays.
  async creases(address) {
    await withPage(address, {}, async (page, browser) => {
      await settled(page);
      const {bytes} = await pixelsOf(page, browser, '#canvas');
      const counts = new Map();
      for (let at = 0; at < bytes.length; at += 4)
        if (bytes[at] < 0xd0) counts.set(bytes.readUIntBE(at, 3), (counts.get(bytes.readUIntBE(at, 3)) ?? 0) + 1);
      const sorted = [...counts.values()].sort((a, b) => b - a);
      const all = sorted.reduce((sum, count) => sum + count, 0);
      assert(all > 10000, `${all} pixels`);
      const sides = sorted.slice(0, 3);
      assert(sides[2] > 0.05 * all, `sides of ${sides} pixels`);
      assert(sides.reduce((sum, count) => sum + count, 0) > 0.95 * all, `${sides} of ${all} pixels in three colors`);
      assert.doesNotMatch(await page.$eval('#keys', (element) => element.innerText), /plays|two fingers/);
    });
  },

  // Checks that a red ball is drawn as a disc of the right size.
  async silhouette(address) {
    for (const size of [...widths, {...widths[0], dark: true}]) {
      await withPage(address, size, async (page, browser) => {
        await settled(page);
        const pixels = await pixelsOf(page, browser, '#stage');
        const disc = statisticsOf(pixels, (red, green, blue) => red > 60 && red > 2 * green && red > 2 * blue);
        // The camera is at distance 1.02 / sin(15 degrees) from a ball of radius 1, and its field of view
        // is 30 degrees.
        const distance = 1.02 / Math.sin(Math.PI / 12);
        const radius = Math.tan(Math.asin(1 / distance)) / Math.tan(Math.PI / 12) * Math.min(pixels.width, pixels.height) / 2;
        const near = (value, expected, most, what) => assert(Math.abs(value - expected) < most, `${what} ${value} instead of ${expected}`);
        near(disc.count, Math.PI * radius * radius, 0.03 * Math.PI * radius * radius, 'pixels of the disc');
        near(disc.x, pixels.width / 2, 3, 'middle');
        near(disc.y, pixels.height / 2, 3, 'middle');
        near(disc.right - disc.left, 2 * radius, 0.02 * radius + 3, 'width');
        near(disc.bottom - disc.top, 2 * radius, 0.02 * radius + 3, 'height');
        assert(disc.color[0] > 110 && disc.color[1] < 10 && disc.color[2] < 10, `color ${disc.color}`);
      });
    }
  },

  // Checks that the silhouette of a reconstruction agrees with that of the photograph beside it.
  async photographs(address) {
    for (const size of widths) {
      await withPage(address, size, async (page, browser) => {
        await settled(page);
        const numbers = await page.$$eval('#from option', (all) => all.length - 1);
        for (const number of [0, numbers - 1]) {
          await page.select('#from', String(number));
          await page.waitForFunction("document.querySelector('.cell img').complete && !document.querySelector('.cell img').hidden");
          await settled(page);
          const photograph = await page.$eval('.cell img', (image) => {
            const {left, top, width, height} = image.getBoundingClientRect();
            const stage = image.closest('#stage').getBoundingClientRect();
            return {left: left - stage.left, top: top - stage.top, width, height};
          });
          const pixels = await pixelsOf(page, browser, '#stage');
          const isBeside = pixels.width > pixels.height;
          const inPane = (shift) => {
            const extent = {left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity};
            for (let y = 0; y < photograph.height; ++y) {
              for (let x = 0; x < photograph.width; ++x) {
                const at = 4 * (Math.round(photograph.top + y + (isBeside ? 0 : shift)) * pixels.width + Math.round(photograph.left + x + (isBeside ? shift : 0)));
                const [red, , blue] = pixels.bytes.subarray(at, at + 3);
                // The background of the photograph is light; the surface in the render is bluish.
                if (shift === 0 ? red > 206 : blue - red < 13) continue;
                extent.left = Math.min(extent.left, x);
                extent.right = Math.max(extent.right, x);
                extent.top = Math.min(extent.top, y);
                extent.bottom = Math.max(extent.bottom, y);
              }
            }
            return extent;
          };
          const seen = inPane(0), rendered = inPane(isBeside ? pixels.width / 2 : pixels.height / 2);
          const words = `photograph ${JSON.stringify(seen)}, render ${JSON.stringify(rendered)}`;
          for (const side of Object.keys(seen)) assert(Math.abs(seen[side] - rendered[side]) < 0.03 * photograph.width, words);
        }
        await page.click('#reset');
        assert.equal(await page.$eval('#from', (select) => select.value), '');
        assert.equal(await page.$eval('.cell img', (image) => image.hidden), true);
        await page.click('#cameras');
        await settled(page);
        const isOrange = (red, green, blue) => red - blue > 40;
        assert(statisticsOf(await pixelsOf(page, browser, '#stage'), isOrange).count > 100, 'no cameras');
      });
    }
  },

  // Checks that a reconstructed movie shows the cameras and photographs of the current time step.
  async film(address) {
    for (const size of widths) {
      await withPage(address, size, async (page, browser) => {
        await setSlider(page, 0);
        await page.select('#from', '1');
        await page.waitForFunction("document.querySelector('.cell img').complete && !document.querySelector('.cell img').hidden");
        const look = async (place) => {
          await setSlider(page, place);
          assert.equal(await valueOf(page, 'from'), '1', 'another camera looks');
          return {photograph: await page.$eval('.cell img', (image) => image.src), stage: await pixelsOf(page, browser, '#stage')};
        };
        const last = Number(await page.$eval('#slider', (slider) => slider.max));
        const [first, end, again] = [await look(0), await look(last), await look(0)];
        assert.notEqual(first.photograph, end.photograph);
        assert(differenceOf(first.stage, end.stage) > 0.01, 'the time steps look alike');
        assert.equal(first.photograph, again.photograph);
        assert(differenceOf(first.stage, again.stage) < 0.001, 'the first looks otherwise the second time');
        assert.match(await valueOf(page, 'now'), /^step 1 · \w+$/);
      });
    }
  },

  // Checks that a tracked movie shows the target of the current frame.
  async targets(address) {
    await withPage(address, {}, async (page) => {
      const shown = [];
      for (let place = 0; place <= Number(await page.$eval('#slider', (slider) => slider.max)); ++place) {
        await setSlider(page, place);
        shown.push(await page.evaluate('viewer.view.cells[0].ghost.geometry.attributes.position.count'));
      }
      const vertices = await page.evaluate('viewer.page.runs[0].targets.map((target) => target.vertices)');
      assert(new Set(vertices).size > 1);
      assert.deepEqual(shown, [vertices[0], ...vertices]);
    });
  },

  // Checks that two runs have the same camera.
  async linked(address) {
    for (const size of widths) {
      await withPage(address, size, async (page, browser) => {
        await settled(page);
        const before = await pixelsOf(page, browser, '#canvas');
        const box = await (await page.$('#stage')).boundingBox();
        await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2);
        await page.mouse.down();
        await page.mouse.move(box.x + box.width / 4 + 80, box.y + box.height / 2 + 120, {steps: 5});
        await page.mouse.up();
        await settled(page);
        const after = await pixelsOf(page, browser, '#canvas');
        for (const [from, to] of [[0, 0.5], [0.5, 1]]) assert(differenceOf(before, after, from, to) > 0.005, 'one half does not turn');
        const labels = await page.$$eval('.cell span', (all) => all.map((one) => one.textContent));
        assert.equal(labels.length, 2);
        labels.forEach((label) => assert.match(label, / · [\d,]+ faces$/));
        assert.match(await page.$eval('figure .value', (element) => element.textContent), / \/ /);
      });
    }
  },

  async accessible(...addresses) {
    for (const address of addresses) {
      for (const options of [{}, {dark: true}, {width: 2000, height: 1200}]) {
        await withPage(address, options, async (page) => {
          await page.$$eval('details', (all) => all.forEach((one) => { one.open = true; }));
          await settled(page);
          await findNothing(page, 10);
        });
      }
    }
  },

  // Checks pages without a viewer: of batches, the gallery, the site.
  async texts(...addresses) {
    for (const address of addresses) {
      for (const options of [{}, {dark: true}, {width: 2000, height: 1200}]) {
        await withPage(address, {...options, isText: true}, async (page) => {
          await findNothing(page, 5);
          assert.equal(await page.evaluate('document.documentElement.scrollWidth'), options.width ?? 800, `${address} is wider than the window`);
          const broken = await page.$$eval('img', (all) => all.filter((one) => one.loading !== 'lazy' && one.naturalWidth === 0).map((one) => one.src));
          assert.deepEqual(broken, []);
        });
      }
    }
  },

  async dark(address) {
    const lightness = async (dark) => {
      let paper;
      await withPage(address, {dark}, async (page, browser) => {
        paper = statisticsOf(await pixelsOf(page, browser, 'header'), () => true).color[1];
      });
      return paper;
    };
    assert(await lightness(false) > 200 && await lightness(true) < 80);
  },

  // Checks the page of a served run, which continues when `goFile` is made. Then ends the server.
  async live(address, goFile, server) {
    const {writeFile} = await import('node:fs/promises');
    await withPage(address, {mayEnd: true}, async (page) => {
      const count = () => page.evaluate('viewer.times.length');
      const before = await count();
      await writeFile(goFile, '');
      await page.waitForFunction((old) => viewer.times.length > old, {}, before);
      await settled(page);
      assert.equal(Number(await valueOf(page, 'slider')), await count() - 1, 'the slider does not follow');
      // The surface has grown and must still be completely visible.
      const farthest = await page.evaluate(() => {
        const {cells: [{surface}], camera} = viewer.view;
        const {position} = surface.geometry.attributes;
        const place = camera.position.clone();
        let result = 0;
        for (let i = 0; i < position.count; ++i) {
          place.fromBufferAttribute(position, i).applyMatrix4(surface.matrixWorld).project(camera);
          result = Math.max(result, Math.abs(place.x), Math.abs(place.y));
        }
        return result;
      });
      assert(farthest > 0.5 && farthest < 1, `as far as ${farthest} of the picture`);
      // A user who views an early frame must stay there.
      await setSlider(page, 0);
      process.kill(Number(server), 'SIGINT');
      await page.waitForFunction("!document.getElementById('problem').hidden");
      assert.match(await valueOf(page, 'problem'), /tm-view has ended/);
      assert.equal(await valueOf(page, 'slider'), '0');
      await setSlider(page, await count() - 1);
    });
  },

  // Prints measured speeds; nothing is checked.
  async speed(address) {
    for (const size of widths) {
      await withPage(address, size, async (page) => {
        const first = await page.evaluate('firstPicture');
        const perSecond = await page.evaluate(async () => {
          const slider = document.getElementById('slider');
          const begin = performance.now();
          let shown = 0, place = 0, by = 1, last;
          while (performance.now() - begin < 5000) {
            place += by;
            if (place <= 0 || place >= Number(slider.max)) by = -by;
            slider.value = place;
            slider.dispatchEvent(new Event('input'));
            await new Promise((done) => requestAnimationFrame(done));
            shown += document.body.dataset.shown === last ? 0 : 1;
            last = document.body.dataset.shown;
          }
          return 1000 * shown / (performance.now() - begin);
        });
        console.log(`${size.width} pixels: first picture after ${(first / 1000).toFixed(2)} s, ${perSecond.toFixed(1)} frames per second while sliding`);
      });
    }
  },
};

const [name, ...words] = process.argv.slice(2);
try {
  await checks[name](...words);
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
}
await wait(0);
