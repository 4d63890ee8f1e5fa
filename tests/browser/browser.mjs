// Opens pages in headless Chromium, and measures screenshots of them.

import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const viewer = join(dirname(fileURLToPath(import.meta.url)), '../../tools/viewer/package.json');
const require = createRequire(viewer);
const puppeteer = require('puppeteer-core');
export const axe = () => require('axe-core').source;

// Flags for software rendering, as on a machine without a graphics card.
const flags = ['--disable-gpu', '--enable-unsafe-swiftshader', '--no-sandbox', '--hide-scrollbars'];

export const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

// Opens a page and runs `check` on it. Fails if the console shows an error, or if the page requests
// anything from another origin. A page of text has no viewer, and may request files beside it.
export async function withPage(address, {width = 800, height = 1000, dark = false, touch = false, mayEnd = false, isText = false}, check) {
  const browser = await puppeteer.launch({executablePath: process.env.TM_CHROMIUM, headless: true, args: flags});
  try {
    const page = await browser.newPage();
    const faults = [];
    page.on('console', (message) => message.type() === 'error' && !mayEnd && faults.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
    page.on('request', (request) => {
      const asked = request.url();
      if (asked !== address && !asked.startsWith('blob:') && !(address.startsWith('http') && asked.startsWith(address)) && !asked.startsWith('data:') &&
          !(isText && asked.startsWith('file:')))
        faults.push(`request: ${asked}`);
    });
    await page.setViewport({width, height, hasTouch: touch});
    if (dark) await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}]);
    // Records the time of the first picture in the page.
    await page.evaluateOnNewDocument(() => {
      const timer = setInterval(() => {
        if (document.body?.dataset.shown === undefined || !(window.viewer?.view.pictures > 1)) return;
        window.firstPicture = performance.now();
        clearInterval(timer);
      }, 5);
    });
    await page.goto(address);
    if (!isText) await page.waitForFunction('window.firstPicture');
    await check(page, browser);
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
  }
}

// Waits until the mesh at the position of the slider is shown, in full resolution.
export async function settled(page) {
  await page.waitForFunction("document.body.dataset.shown === document.getElementById('slider').value");
  // The picture in full resolution is drawn a quarter of a second after the last movement.
  await wait(300);
  await page.waitForFunction('!viewer.isUnpacking && !viewer.view.isDue && (viewer.view.isFine || !viewer.view.isSlow)');
  await wait(100);
}

export const valueOf = (page, id) => page.$eval(`#${id}`, (element) => element.value || element.textContent);

export async function setSlider(page, place) {
  await page.$eval('#slider', (slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event('input', {bubbles: true}));
  }, place);
  await settled(page);
}

// Returns a screenshot of an element: width, height, and four bytes per pixel.
export async function pixelsOf(page, browser, selector) {
  const picture = await (await page.$(selector)).screenshot({encoding: 'base64'});
  const reader = await browser.newPage();
  const result = await reader.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const bytes = context.getImageData(0, 0, image.width, image.height).data;
    let text = '';
    for (let i = 0; i < bytes.length; i += 30000) text += String.fromCharCode(...bytes.subarray(i, i + 30000));
    return {width: image.width, height: image.height, text: btoa(text)};
  }, picture);
  await reader.close();
  await page.bringToFront();
  return {width: result.width, height: result.height, bytes: Buffer.from(result.text, 'base64')};
}

// Returns the share of pixels that differ clearly. `from` and `to` limit the columns, as shares of the
// width.
export function differenceOf(one, other, from = 0, to = 1) {
  assert.deepEqual([one.width, one.height], [other.width, other.height]);
  let count = 0, all = 0;
  for (let y = 0; y < one.height; ++y) {
    for (let x = Math.floor(from * one.width); x < Math.floor(to * one.width); ++x) {
      const at = 4 * (y * one.width + x);
      const difference = Math.max(...[0, 1, 2].map((c) => Math.abs(one.bytes[at + c] - other.bytes[at + c])));
      count += difference > 12 ? 1 : 0;
      ++all;
    }
  }
  return count / all;
}

// Returns number, center, extent and mean color of the pixels for which `isOf(red, green, blue)` holds.
export function statisticsOf({width, height, bytes}, isOf) {
  const result = {count: 0, x: 0, y: 0, left: width, right: 0, top: height, bottom: 0, color: [0, 0, 0]};
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const color = bytes.subarray(4 * (y * width + x), 4 * (y * width + x) + 3);
      if (!isOf(...color)) continue;
      ++result.count;
      result.x += x;
      result.y += y;
      result.left = Math.min(result.left, x);
      result.right = Math.max(result.right, x);
      result.top = Math.min(result.top, y);
      result.bottom = Math.max(result.bottom, y);
      color.forEach((byte, c) => { result.color[c] += byte; });
    }
  }
  result.x /= result.count;
  result.y /= result.count;
  result.color = result.color.map((sum) => sum / result.count);
  return result;
}
