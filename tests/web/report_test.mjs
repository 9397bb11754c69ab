// The report in headless Chromium, opened from its file: nothing overlaps or sticks out at any width, on light and on dark
// paper, every picture is decoded, and nobody is asked for anything. Screenshots stay in HFRAC_WEB/screens.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const { HFRAC_COMMAND, HFRAC_CHROMIUM, HFRAC_WEB } = process.env;
if (!fs.existsSync(path.join(HFRAC_WEB, 'page', 'fetched.json'))) {
  console.log('report_test: playwright-core is not there (web.packages), so the report is not tested in a browser');
  process.exit(77);
}
const { chromium } = createRequire(path.join(HFRAC_WEB, 'page', 'x'))('playwright-core');
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'hfrac-report-'));
const screens = path.join(HFRAC_WEB, 'screens');
fs.mkdirSync(screens, { recursive: true });
const report = path.join(scratch, 'report.html');
execFileSync(HFRAC_COMMAND, ['report', path.join(HFRAC_WEB, 'run'), '--no-movie', '--quiet', '-o', report], { stdio: 'inherit' });

/** In the page: lines of text and figures that lie on each other, or beyond the window. */
function faults() {
  const found = [];
  const boxes = [];
  // Wide tables may be moved to and fro in their frame.
  const scrolls = (element) => element && (['auto', 'scroll'].includes(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (!node.data.trim() || node.parentElement.closest('svg, style, pre')) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    const scrolled = scrolls(node.parentElement);
    for (const box of range.getClientRects()) boxes.push({ box, scrolled, what: node.data.trim().slice(0, 40) });
  }
  for (const one of document.querySelectorAll('figure > img, figure > svg, figure > video, pre'))
    boxes.push({ box: one.getBoundingClientRect(), what: one.getAttribute('alt') ?? one.tagName });
  boxes.forEach(({ box, scrolled, what }, i) => {
    if (!scrolled && (box.left < -1 || box.right > window.innerWidth + 1)) found.push(`'${what}' sticks out`);
    for (const { box: other, what: that } of boxes.slice(0, i)) {
      const apart = box.left >= other.right - 1 || other.left >= box.right - 1 || box.top >= other.bottom - 4 || other.top >= box.bottom - 4;
      if (!apart) found.push(`'${what}' lies on '${that}'`);
    }
  });
  if (document.documentElement.scrollWidth > window.innerWidth + 1) found.push('it is wider than the window');
  for (const image of document.images) if (!image.complete || !image.naturalWidth) found.push(`'${image.alt}' is no picture`);
  return { found, texts: boxes.length, pictures: document.images.length, charts: document.querySelectorAll('figure > svg').length };
}

const browser = await chromium.launchPersistentContext(path.join(scratch, 'profile'), {
  executablePath: HFRAC_CHROMIUM, headless: true, viewport: { width: 1280, height: 900 },
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage'],
});
let failed = 0;
try {
  const page = browser.pages()[0];
  const asked = [];
  page.on('request', (request) => !/^(file|data):/.test(request.url()) && asked.push(request.url()));
  await page.goto(pathToFileURL(report).href);
  for (const colorScheme of ['light', 'dark'])
    for (const width of [360, 800, 1280, 1920]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 900 });
      const { found, texts, pictures, charts } = await page.evaluate(faults);
      await page.screenshot({ path: path.join(screens, `report-${colorScheme}-${width}.png`), fullPage: width === 1280 });
      console.log(`${found.length ? 'FAILED' : 'ok    '}  ${width} pixels, ${colorScheme}: ${texts} boxes`);
      for (const fault of found.slice(0, 20)) console.log(`        ${fault}`);
      failed += found.length;
      assert.ok(texts > 40 && pictures >= 5 && charts >= 4, `only ${texts} texts, ${pictures} pictures, ${charts} charts`);
    }
  assert.deepEqual(asked, []);
} finally {
  await browser.close();
  fs.rmSync(scratch, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
