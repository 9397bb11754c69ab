// The page in headless Chromium, on a real run: what is on the screen, what controls do, what can be read and saved,
// and a run that grows while it is watched. Screenshots stay in HFRAC_WEB/screens.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';

import { cropped, decoded } from './png.mjs';

const { HFRAC_COMMAND, HFRAC_CHROMIUM, HFRAC_CASE, HFRAC_WEB } = process.env;
if (!fs.existsSync(path.join(HFRAC_WEB, 'page', 'fetched.json'))) {
  console.log('page_test: playwright-core is not there (web.packages), so the page is not tested in a browser');
  process.exit(77);
}
const { chromium } = createRequire(path.join(HFRAC_WEB, 'page', 'x'))('playwright-core');
const run = path.join(HFRAC_WEB, 'run');
const screens = path.join(HFRAC_WEB, 'screens');
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'hfrac-page-'));
fs.rmSync(screens, { recursive: true, force: true });
fs.mkdirSync(screens, { recursive: true });

const children = [];
const start = (...args) => {
  const child = spawn(HFRAC_COMMAND, args, { stdio: ['ignore', 'pipe', 'inherit'] });
  children.push(child);
  return child;
};
const ended = (child) => new Promise((resolve) => (child.exitCode !== null ? resolve(child.exitCode) : child.once('exit', resolve)));
/** Starts `hfrac view`; gives the process and the address it prints. */
async function view(folder, ...more) {
  const child = start('view', folder, ...more, '--port', '0', '--no-open');
  let text = '';
  for await (const piece of child.stdout) {
    text += piece;
    if (text.includes('\n')) break;
  }
  return { child, address: text.trim() };
}

const browser = await chromium.launchPersistentContext(path.join(scratch, 'profile'), {
  executablePath: HFRAC_CHROMIUM,
  headless: true,
  viewport: { width: 1280, height: 800 },
  colorScheme: 'light',
  acceptDownloads: true,
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage', '--use-gl=angle',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
// The page asks for news every second or every four: here its timers are ten times as fast, so that nothing is waited for.
await browser.addInitScript(() => {
  const usual = window.setTimeout;
  window.setTimeout = (work, milliseconds, ...rest) => usual(work, (milliseconds ?? 0) / 10, ...rest);
});
const page = browser.pages()[0];
const complaints = [];
page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
page.on('pageerror', (error) => complaints.push(String(error)));
page.on('request', (request) => {
  const { protocol, hostname } = new URL(request.url());
  if (!['data:', 'blob:'].includes(protocol) && hostname !== '127.0.0.1') complaints.push(`asked ${request.url()}`);
});

const pixel = ({ width, data }, x, y) => [...data.subarray(4 * (Math.round(y) * width + Math.round(x)), 4 * (Math.round(y) * width + Math.round(x)) + 3)];
const stage = page.locator('#stage');
const settle = () => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
/** The stage as it is; the whole page is kept under that name. */
async function picture(name) {
  await settle();
  const png = await page.screenshot(name ? { path: path.join(screens, `${name}.png`) } : {});
  return cropped(decoded(png), await stage.boundingBox());
}
const shown = (step) => page.waitForFunction((wanted) => document.body.dataset.shown === wanted, String(step), { timeout: 30000 });
/** Where a place of the model is on the stage [pixel]. */
async function onStage(x, y) {
  const [cx, cy, metres] = (await stage.getAttribute('data-view')).split(' ').map(Number);
  const { width, height } = await stage.boundingBox();
  return [width / 2 + (x - cx) / metres, height / 2 - (y - cy) / metres];
}
async function clickModel(x, y) {
  const [px, py] = await onStage(x, y);
  await stage.click({ position: { x: px, y: py } });
}
const table = (file) => {
  const [head, ...rows] = fs.readFileSync(file, 'utf8').trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
};
const differing = (a, b) => {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) if (Math.abs(a.data[i] - b.data[i]) + Math.abs(a.data[i + 1] - b.data[i + 1]) > 24) ++count;
  return count / (a.data.length / 4);
};
const isDark = ([r, g, b]) => r + g + b < 120;
/** Share of the cracks at whose middle there is ink within two pixels. */
async function cracksInInk(image, cracks) {
  let hits = 0;
  for (const { x_m, y_m } of cracks) {
    const [x, y] = await onStage(Number(x_m), Number(y_m));
    let ink = false;
    for (let dx = -2; dx <= 2; ++dx) for (let dy = -2; dy <= 2; ++dy) ink ||= isDark(pixel(image, x + dx, y + dy));
    if (ink) ++hits;
  }
  return hits / cracks.length;
}
async function saved(click) {
  const [download] = await Promise.all([page.waitForEvent('download'), click()]);
  return { name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) };
}

const tests = [];
const test = (name, body) => tests.push([name, body]);
const cracks = table(path.join(run, 'cracks.csv'));
const liveSteps = 10; // of the run that is made meanwhile
const lastStep = Number(table(path.join(run, 'history.csv')).at(-1).step);
let whole; // picture of the last moment
let server;

test('shows the last moment with the fracture where the cracks are', async () => {
  server = await view(run);
  await page.goto(server.address);
  await shown(lastStep);
  assert.match(await page.textContent('#title'), /45 MPa/);
  assert.equal(await page.textContent('#status'), 'finished');
  await page.locator('#layer-pores').uncheck();
  whole = await picture('plain');
  const tensile = cracks.filter(({ mode }) => mode === 'tension');
  assert.ok(tensile.length > 5, 'the run has too few cracks to look at');
  assert.ok((await cracksInInk(whole, tensile)) > 0.9, 'cracks are not drawn where they are');
  // Discs are round: the grey of faces and the paper between them are both there.
  const colours = new Set();
  for (let i = 0; i < whole.data.length; i += 4) colours.add(whole.data.readUInt32LE(i));
  assert.ok(colours.size > 50);
});

test('goes through time with the slider', async () => {
  await page.locator('#slider').fill('0');
  await shown(0);
  const first = await picture('start');
  assert.equal(await cracksInInk(first, cracks), 0, 'there are cracks before the first broke');
  assert.ok(differing(first, whole) > 0.0005);
  assert.match(await page.textContent('#when'), /step 0/);
  await page.locator('body').press('End');
  await shown(lastStep);
  assert.ok(differing(await picture(), whole) < 0.0005, 'the same moment looks different');
});

test('plays', async () => {
  await page.locator('#slider').fill('0');
  await page.selectOption('#speed', '20');
  await page.locator('#play').click();
  await shown(lastStep);
  await page.waitForSelector('#play:not(.playing)');
});

test('shows pressure, displacement and bonds in colours with a key', async () => {
  await page.locator('#layer-pores').check();
  await shown(lastStep);
  const pressure = await picture('pressure');
  const { wells } = JSON.parse(fs.readFileSync(path.join(run, 'summary.json'), 'utf8'));
  const [r, g, b] = pixel(pressure, ...(await onStage(wells[0].x_m, wells[0].y_m)));
  assert.ok(r > 200 && g > 200 && b < 120, `the well is not in the colour of the highest pressure: ${[r, g, b]}`);
  // Its ring is the hole that was asked for.
  const [middle, edge] = [await onStage(wells[0].x_m, wells[0].y_m), await onStage(wells[0].x_m + wells[0].asked_radius_m, wells[0].y_m)];
  let red = 0;
  for (let k = 0; k < 64; ++k) {
    const [x, y] = [Math.cos((Math.PI * k) / 32), Math.sin((Math.PI * k) / 32)].map((part, i) => middle[i] + part * (edge[0] - middle[0]));
    const around = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => pixel(pressure, x + dx, y + dy)));
    if (around.some(([r, g, b]) => r > 170 && g < 110 && b < 110)) ++red;
  }
  assert.ok(red > 58, `the ring of the well is not where it was asked for: ${red} of 64 places`);
  await page.selectOption('#disc-colour', 'displacement');
  await settle();
  await page.waitForFunction(() => !document.querySelector('#layer-pores').checked);
  await page.waitForTimeout(200);
  assert.ok(differing(await picture('displacement'), pressure) > 0.2);
  await page.locator('#layer-pores').check();
  assert.equal(await page.inputValue('#disc-colour'), 'plain', 'a field that pores cover is still chosen');
  await page.locator('#layer-pores').uncheck();
  await page.locator('#layer-bonds').check();
  await page.waitForTimeout(400);
  assert.ok(differing(await picture('bonds'), whole) > 0.1);
  await page.locator('#layer-bonds').uncheck();
});

test('tells the values of a crack, and follows it through time', async () => {
  const crack = cracks[0];
  await page.locator('#view-cracks').click();
  await settle();
  await clickModel(Number(crack.x_m), Number(crack.y_m));
  await page.waitForSelector('#selection h3:text-matches("^Crack ")');
  const picked = cracks[Number((await page.textContent('#selection h3')).replace('Crack ', ''))];
  const exact = await page.getAttribute('#selection dt:text-is("Aperture") + dd', 'title');
  const [value, unit] = exact.split(' ');
  assert.equal(unit, 'm');
  assert.ok(Math.abs(Number(value) - Number(picked.aperture_m)) <= 1e-6 * Math.abs(Number(picked.aperture_m)), `${value}, not ${picked.aperture_m}`);
  assert.equal(await page.textContent('#selection dt:text-is("Mode") + dd'), picked.mode);
  await picture('crack');
  await page.locator('#slider').fill('0');
  await shown(0);
  await page.waitForSelector('#selection p:text-matches("Not broken yet")');
  await page.locator('body').press('End');
  await shown(lastStep);
});

test('tells the values of a disc and of a pore', async () => {
  await page.locator('#view-all').click();
  await settle();
  const file = `discs_${String(lastStep).padStart(5, '0')}.vtu`;
  const values = await page.evaluate(async (name) => (await fetch(`api/values?file=${name}&of=points&index=17`)).json(), file);
  const value = (name) => values.find((one) => one.name === name).values;
  await clickModel(...value('position'));
  await page.waitForSelector('#selection h3:text-is("Disc 17")');
  const radius = await page.getAttribute('#selection dt:text-is("Radius") + dd', 'title');
  assert.equal(radius, `${value('radius_m')[0]} m`);
  const { wells } = JSON.parse(fs.readFileSync(path.join(run, 'summary.json'), 'utf8'));
  await page.locator('#layer-pores').check();
  await page.waitForTimeout(300);
  await clickModel(wells[0].x_m, wells[0].y_m);
  await page.waitForSelector('#selection h3:text-matches("^Pore ")');
  assert.equal(await page.textContent('#selection dt:text-is("Kind") + dd'), 'well');
  assert.match(await page.textContent('#selection dt:text-is("Pressure") + dd'), /^45 MPa$/);
  await page.locator('body').press('Escape');
  await page.waitForSelector('#selection p:text-matches("Click a crack")');
});

test('lists the fractures and goes to one', async () => {
  const fractures = table(path.join(run, 'fractures.csv'));
  assert.equal(await page.locator('#fractures tbody tr').count(), Math.min(fractures.length, 12));
  const before = await stage.getAttribute('data-view');
  await page.locator('#fractures tbody tr').first().click();
  await page.waitForFunction((old) => document.querySelector('#stage').dataset.view !== old, before);
});

test('zooms, moves, and comes back', async () => {
  await page.locator('body').press('0');
  await settle();
  const home = await stage.getAttribute('data-view');
  await stage.hover({ position: { x: 300, y: 200 } });
  await page.mouse.wheel(0, -600);
  await page.waitForFunction((old) => document.querySelector('#stage').dataset.view !== old, home);
  const near = await stage.getAttribute('data-view');
  assert.ok(Number(near.split(' ')[2]) < 0.7 * Number(home.split(' ')[2]));
  await page.mouse.down();
  await page.mouse.move(420, 320, { steps: 4 });
  await page.mouse.up();
  await settle();
  assert.notEqual(await stage.getAttribute('data-view'), near);
  assert.equal(await page.locator('#selection h3').count(), 0, 'a drag is not a click');
  for (const key of ['w', 't', 'f', '0']) {
    await page.locator('body').press(key);
    await settle();
  }
  assert.equal(await stage.getAttribute('data-view'), home);
});

test('saves the picture, the tables and the VTU files', async () => {
  await page.locator('#download').click();
  await picture('downloads');
  const png = await saved(() => page.locator('#save-picture').click());
  assert.equal(png.name, `run_${lastStep}.png`);
  const image = decoded(png.bytes);
  assert.ok(image.width > 500 && isDark(pixel(image, ...(await onStage(Number(cracks[0].x_m), Number(cracks[0].y_m))))) !== undefined);
  assert.ok((await cracksInInk(image, cracks.filter(({ mode }) => mode === 'tension'))) > 0.9, 'the saved picture shows no cracks');
  fs.writeFileSync(path.join(screens, 'saved.png'), png.bytes);
  for (const name of ['history.csv', 'cracks.csv', `flow_${String(lastStep).padStart(5, '0')}.vtu`]) {
    await page.locator('#download').click();
    const file = await saved(() => page.locator(`#downloads a:has-text("${name}")`).click());
    assert.equal(file.name, name);
    assert.deepEqual(file.bytes, fs.readFileSync(path.join(run, name)));
  }
});

test('is dark if wanted', async () => {
  await page.locator('body').press('0');
  await page.locator('body').press('d');
  await settle();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await page.locator('#layer-pores').uncheck();
  await page.waitForTimeout(200);
  const image = await picture('dark');
  assert.ok(isDark(pixel(image, 4, 200)));
  await page.locator('body').press('d');
});

test('fits a small window', async () => {
  await page.setViewportSize({ width: 480, height: 800 });
  await settle();
  await picture('small');
  const box = await stage.boundingBox();
  assert.ok(box.width > 400 && box.height > 200);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth + 1), 'it is wider than the window');
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('shows every control whole in a window of 800 x 600', async () => {
  await page.setViewportSize({ width: 800, height: 600 });
  await settle();
  await picture('low');
  const clipped = await page.evaluate(() => {
    const panel = document.querySelector('#controls');
    const right = panel.getBoundingClientRect().left + panel.clientWidth;
    return [...panel.querySelectorAll('select, button, label')]
      .filter((one) => one.getBoundingClientRect().right > right - 8).map((one) => one.id || one.textContent);
  });
  assert.deepEqual(clipped, []);
  const follow = await page.locator('.toggle').boundingBox();
  assert.ok(follow.x + follow.width <= 796, 'Follow is cut off');
  assert.ok(await page.evaluate(() => {
    const panel = document.querySelector('#controls');
    return panel.scrollWidth <= panel.clientWidth;
  }), 'the panel is wider than its window');
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('closes the sheet of downloads by Escape, wherever the focus is', async () => {
  for (const leave of [false, true]) {
    await page.locator('#download').click();
    await page.waitForSelector('#downloads:not([hidden])');
    if (leave) await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press('Escape');
    await page.waitForSelector('#downloads', { state: 'hidden', timeout: 2000 });
    assert.equal(await page.getAttribute('#download', 'aria-expanded'), 'false');
  }
});

test('is found without the last slash of its address', async () => {
  const answer = await page.request.get(server.address.replace(/\/$/, ''));
  assert.equal(answer.status(), 200);
  assert.equal(answer.url(), server.address);
});

test('shows smooth joints by their state and tells the values of a contact', async () => {
  assert.equal(await page.locator('#layer-joints').isVisible(), false, 'a run without joints offers their layer');
  const file = path.join(scratch, 'jointed.toml');
  const joint = "\n[[joint]]\nx1 = 15\ny1 = 65\nx2 = 85\ny2 = 80\nstate = 'smooth-broken'\nfriction = 0.1\naperture = 1e-3\n";
  fs.writeFileSync(file, fs.readFileSync(HFRAC_CASE, 'utf8') + joint);
  const folder = path.join(scratch, 'jointed');
  assert.equal(await ended(start('run', file, '-o', folder, '--steps', '1', '--quiet')), 0);
  const jointed = await view(folder);
  await page.goto(jointed.address);
  await shown(1);
  await page.locator('#layer-pores').uncheck();
  await page.locator('#layer-cracks').uncheck(); // cracks beside the joint have the colour of one of its states
  const byAperture = await picture('joints-aperture');
  await page.selectOption('#joint-colour', 'joint-state');
  await page.waitForTimeout(300);
  const byState = await picture('joints-state');
  assert.ok(differing(byAperture, byState) > 0.002, 'the colour does not change with the quantity');
  // The states' colours are found along the joint, all the way.
  const signs = [[110, 112, 120], [28, 92, 170], [200, 20, 140], [12, 12, 16]];
  let found = 0;
  for (let share = 0.05; share < 1; share += 0.1) {
    const [x, y] = await onStage(15 + 70 * share, 65 + 15 * share);
    // Where two contacts meet a pixel has a bit of both.
    const near = [-1, 0, 1].map((up) => pixel(byState, x, y + up));
    if (near.some((colour) => signs.some((sign) => sign.every((part, i) => Math.abs(part - colour[i]) < 30)))) ++found;
  }
  assert.ok(found >= 9, `the joint is drawn at ${found} of 10 places`);
  await clickModel(50, 72.5);
  await page.waitForSelector('#selection h3:text-matches("^Contact of a joint ")');
  assert.match(await page.getAttribute('#selection dt:text-is("Slip") + dd', 'title'), / m$/);
  await page.locator('#layer-joints').uncheck();
  await page.waitForTimeout(200);
  assert.ok(differing(await picture(), byState) > 0.002, 'the layer cannot be switched off');
  await page.goto(server.address); // a page whose server goes complains
  await shown(lastStep);
  jointed.child.kill('SIGINT');
  await ended(jointed.child);
});

test('shows the measured pressure beside the computed one', async () => {
  // The run's own pressures, lower by a tenth, at half of its times and beyond its end.
  const rows = table(path.join(run, 'history.csv'));
  const end = Number(rows[rows.length - 1].time_s);
  const record = path.join(scratch, 'measured.csv');
  const lines = rows.filter((_, i) => i % 2 === 0).map((row) => `${row.time_s},${0.9e-6 * Number(row.well_pressure_Pa)}`);
  fs.writeFileSync(record, ['time_s,pressure_MPa', ...lines, `${2 * end},500`, ''].join('\n'));
  const measuredIn = async () => {
    const chart = decoded(await page.locator('#plot-a').screenshot());
    let count = 0;
    for (let y = 22; y < chart.height - 24; ++y) // between its texts
      for (let x = 0; x < chart.width; ++x)
        if (pixel(chart, x, y).every((part, i) => Math.abs(part - [206, 74, 32][i]) < 12)) ++count;
    return count;
  };
  await page.selectOption('#chart-a', 'well_pressure_Pa');
  assert.equal(await measuredIn(), 0, 'a run without a record has a measured curve');
  const measured = await view(run, '--record', record);
  await page.goto(measured.address);
  await shown(lastStep);
  await page.waitForFunction(() => document.querySelector('#chart-a').value === 'well_pressure_Pa');
  await picture('measured');
  const { width } = await page.locator('#plot-a').boundingBox();
  assert.ok((await measuredIn()) > 0.5 * width, `the measured curve has ${await measuredIn()} pixels of its colour in a chart ${width} wide`);
  await page.goto(server.address);
  await shown(lastStep);
  measured.child.kill('SIGINT');
  await ended(measured.child);
});

test('has not complained, nor asked anybody else', async () => {
  assert.deepEqual(complaints, []);
});

test('follows a run, snapshot by snapshot', async () => {
  server.child.kill('SIGINT');
  assert.equal(await ended(server.child), 0);
  await page.waitForFunction(() => document.querySelector('#status').textContent === 'no answer');
  const growing = path.join(scratch, 'growing');
  fs.mkdirSync(growing);
  server = await view(growing);
  await page.goto(server.address);
  await page.waitForSelector('#notice:has-text("Nothing to show yet")');
  await picture('waiting');
  complaints.length = 0;

  const summary = JSON.parse(fs.readFileSync(path.join(run, 'summary.json'), 'utf8'));
  const put = (name, text) => {
    fs.writeFileSync(path.join(growing, `.${name}.tmp`), text);
    fs.renameSync(path.join(growing, `.${name}.tmp`), path.join(growing, name));
  };
  for (const name of fs.readdirSync(run)) if (/\.(vtu|toml)$/.test(name)) fs.copyFileSync(path.join(run, name), path.join(growing, name));
  const history = fs.readFileSync(path.join(run, 'history.csv'), 'utf8').split('\n');
  const grow = (snapshots, step) => {
    put('history.csv', `${history.slice(0, step + 2).join('\n')}\n`);
    for (const series of ['bonds', 'cracks', 'flow', 'discs']) {
      const entries = fs.readFileSync(path.join(run, `${series}.pvd`), 'utf8').match(/<DataSet[^>]*>/g).slice(0, snapshots);
      put(`${series}.pvd`, `<VTKFile type="Collection"><Collection>${entries.join('')}</Collection></VTKFile>`);
    }
    put('summary.json', JSON.stringify({ ...summary, ended: 'running' }));
  };
  for (const [snapshots, step] of [[1, 0], [2, 5], [4, 15]]) {
    grow(snapshots, step);
    await shown(step);
    assert.equal(await page.textContent('#status'), 'running');
  }
  // Whoever looks at an earlier moment is left in peace.
  await page.locator('#follow').uncheck();
  await page.locator('#slider').fill('1');
  await shown(5);
  grow(6, 25);
  await page.waitForFunction(() => document.querySelector('#slider').max === '5');
  assert.equal(await page.evaluate(() => document.body.dataset.shown), '5');
  assert.deepEqual(complaints, []);
});

test('shows a run made while it is watched', async () => {
  server.child.kill('SIGINT');
  await ended(server.child);
  const live = path.join(scratch, 'live');
  fs.mkdirSync(live);
  server = await view(live);
  await page.goto(server.address);
  complaints.length = 0;
  const running = start('run', HFRAC_CASE, '-o', live, '--steps', String(liveSteps), '--quiet');
  await page.waitForFunction(() => document.querySelector('#status').textContent === 'finished', null, { timeout: 90000 });
  assert.equal(await ended(running), 0);
  await shown(liveSteps);
  await picture('live');
  assert.deepEqual(complaints, []);
});

test('says what is wrong with a damaged file, and goes on', async () => {
  const live = path.join(scratch, 'live');
  const file = path.join(live, 'discs_00000.vtu');
  const text = fs.readFileSync(file);
  fs.writeFileSync(file, text.subarray(0, text.length / 2));
  await page.reload();
  await shown(liveSteps);
  await page.locator('#slider').fill('0');
  await page.waitForSelector('#notice:has-text("discs_00000.vtu")');
  await picture('damaged');
  await page.locator('body').press('End');
  await page.waitForSelector('#notice', { state: 'hidden' });
});

test('says that the folder is gone, shows nothing old, and finds it again', async () => {
  const live = path.join(scratch, 'live');
  const moved = path.join(scratch, 'moved');
  complaints.length = 0;
  await shown(liveSteps);
  const before = await picture();
  fs.renameSync(live, moved);
  await page.waitForSelector('#notice:has-text("The folder is gone")');
  assert.equal(await page.textContent('#status'), 'folder is gone');
  assert.equal(await page.textContent('#when'), '');
  const inked = (gone) => { // beside the notice, in the middle
    const paper = pixel(gone, 4, 200);
    let count = 0;
    for (let y = 10; y < gone.height - 10; y += 3)
      for (let x = 10; x < gone.width * 0.2; x += 3) count += pixel(gone, x, y).some((part, k) => Math.abs(part - paper[k]) > 8) ? 1 : 0;
    return count;
  };
  let left = inked(await picture('gone'));
  // The page is laid out anew without its curves, which on a busy machine takes its time.
  for (const end = Date.now() + 15000; left > 0 && Date.now() < end;) left = inked(await picture('gone'));
  assert.equal(left, 0, 'the old picture is still there');
  fs.renameSync(moved, live);
  await shown(liveSteps);
  await page.waitForSelector('#notice', { state: 'hidden' });
  assert.ok(differing(await picture(), before) < 0.01);
  assert.deepEqual(complaints, []);
});

let failed = 0;
for (const [name, body] of tests) {
  const begin = Date.now();
  try {
    await body();
    console.log(`ok      ${name} (${Date.now() - begin} ms)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
    await page.screenshot({ path: path.join(screens, `failed-${failed}.png`) }).catch(() => undefined);
  }
}
await browser.close();
for (const child of children) if (child.exitCode === null) child.kill('SIGKILL');
fs.rmSync(scratch, { recursive: true, force: true });
process.exit(failed ? 1 : 0);
