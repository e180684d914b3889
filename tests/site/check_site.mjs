// Opens every page of the site in headless Chromium and names what is broken.
//
//     node check_site.mjs CHROMIUM FOLDER                   fails if any page has a fault
//     node check_site.mjs CHROMIUM FOLDER --expect FILE     fails unless the faults are exactly those of FILE
//     node check_site.mjs CHROMIUM FOLDER --look OUT PAGE.. takes pictures of pages: light, dark, small screen
//
// Faults: script-error, external-request, missing-file, broken-formula, unrendered-formula, undrawn-image,
// no-alt, undrawn-player, no-title (a frame without one), no-language, dead-link, too-wide (on a small screen).
// The pages are opened from the disk, as a reader without a web server opens them.

import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { Browser } from './browser.mjs';
import { countColors, readPng } from './png.mjs';

const kTabs = 3;
const kPageSeconds = 120;  // a chapter with many players, beside two others on a machine without a graphics card
const kPieceHeight = 1600;  // pixels: tall pages are pictured in pieces
const kSmallScreen = 390;  // pixels: a telephone held upright

// Runs in the page, after its scripts: waits for the formulas, then says what is there.
async function inspect() {
  if (window.MathJax || document.querySelector('script[src*="mathjax"]')) {
    for (let i = 0; i < 400 && !window.MathJax?.startup?.promise; ++i) {
      await new Promise(done => setTimeout(done, 25));
    }
    await window.MathJax?.startup?.promise;
  }
  // Pictures that scripts put in after the page was loaded get a second to arrive.
  for (let i = 0; i < 40 && [...document.images].some(image => !image.complete); ++i) {
    await new Promise(done => setTimeout(done, 25));
  }
  const outerText = element => (element.outerHTML ?? '').slice(0, 120);
  const visibleText = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode;
    if (!node.parentElement.closest('script, style, pre, code, .fragment, mjx-container')) {
      visibleText.push(node.data);
    }
  }
  const frames = [...document.querySelectorAll('iframe')].filter(frame => frame.id !== 'MSearchResults');
  return {
    language: document.documentElement.lang,
    formulaErrors: [...document.querySelectorAll('[data-mjx-error], mjx-merror')].map(
        node => node.getAttribute('data-mjx-error') ?? node.textContent),
    unrendered: visibleText.filter(text => /\\\(|\\\[/.test(text)).map(text => text.trim().slice(0, 80)),
    images: [...document.images].map(
        image => ({ text: outerText(image), alt: image.hasAttribute('alt'),
                    drawn: image.complete && image.naturalWidth > 0 })),
    frames: frames.map(frame => {
      frame.scrollIntoView({ block: 'center' });
      const box = frame.getBoundingClientRect();
      return { text: outerText(frame), title: frame.title, x: box.x + scrollX, y: box.y + scrollY,
               width: box.width, height: box.height };
    }),
    width: Math.max(document.documentElement.scrollWidth,
                    document.getElementById('doc-content')?.scrollWidth ?? 0),
    links: [...document.querySelectorAll('a[href], area[href]')].map(link => link.href),
    anchors: [...document.querySelectorAll('[id], a[name]')].flatMap(
        node => [node.id, node.getAttribute('name')].filter(Boolean)),
  };
}

const delay = milliseconds => new Promise(done => setTimeout(done, milliseconds));

function pagesBelow(folder) {
  const own = readdirSync(folder).filter(name => name.endsWith('.html')).map(name => join(folder, name));
  const programs = join(folder, 'programs');
  const below = existsSync(programs) ? readdirSync(programs, { recursive: true }) : [];
  return [...own, ...below.filter(name => name.endsWith('.html')).map(name => join(programs, name))]
      .filter(path => statSync(path).isFile()).sort();
}

class Visitor {
  async start(browser) {
    this.tab = await browser.openTab((method, params) => this.hear(method, params));
  }

  hear(method, params) {
    if (method === 'Page.loadEventFired') {
      this.loaded?.();
    } else if (method === 'Runtime.exceptionThrown') {
      const details = params.exceptionDetails;
      this.fault('script-error', details.exception?.description ?? details.text);
    } else if (method === 'Runtime.consoleAPICalled' && params.type === 'error') {
      this.fault('script-error', params.args.map(arg => arg.value ?? arg.description).join(' '));
    } else if (method === 'Log.entryAdded' && params.entry.level === 'error' && params.entry.source !== 'network') {
      this.fault('script-error', params.entry.text);
    } else if (method === 'Network.requestWillBeSent') {
      this.urls.set(params.requestId, params.request.url);
      if (!/^(file|data|blob|about|chrome|javascript):/.test(params.request.url)) {
        this.fault('external-request', params.request.url);
      }
    } else if (method === 'Network.loadingFailed' && !params.canceled) {
      const url = this.urls.get(params.requestId) ?? '';
      if (url.startsWith('file:')) {
        this.fault('missing-file', url);
      }
    }
  }

  fault(kind, text) {
    this.faults.push({ kind, text: String(text).split('\n')[0] });
  }

  async open(path) {
    this.faults = [];
    this.urls = new Map();
    const loaded = new Promise(done => { this.loaded = () => done(true); });
    await this.tab('Page.navigate', { url: pathToFileURL(path).href });
    const patience = new Promise(done => setTimeout(() => done(false), kPageSeconds * 1000).unref());
    if (!await Promise.race([loaded, patience])) {
      this.fault('script-error', `not loaded within ${kPageSeconds} s`);
    }
  }

  async evaluate(call) {
    const answer = await this.tab('Runtime.evaluate',
                                  { expression: call, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails) {
      throw new Error(answer.exceptionDetails.exception?.description ?? answer.exceptionDetails.text);
    }
    return answer.result.value;
  }

  async screenshot(clip) {
    const { data } = await this.tab('Page.captureScreenshot',
                                    { format: 'png', captureBeyondViewport: true, ...(clip && { clip }) });
    return Buffer.from(data, 'base64');
  }

  // Faults of a page, its links and its anchors.
  async check(path) {
    await this.open(path);
    const seen = await this.evaluate(`(${inspect})()`);
    if (!seen.language) {
      this.fault('no-language', 'the <html> element has no lang');
    }
    seen.formulaErrors.forEach(text => this.fault('broken-formula', text));
    seen.unrendered.forEach(text => this.fault('unrendered-formula', text));
    for (const image of seen.images) {
      if (!image.alt) this.fault('no-alt', image.text);
      if (!image.drawn) this.fault('undrawn-image', image.text);
    }
    for (const frame of seen.frames) {
      if (!frame.title) this.fault('no-title', frame.text);
      // The middle of a player shows bodies on a background: more than two colours, each over some area.
      const clip = { x: frame.x + 0.1 * frame.width, y: frame.y + 0.2 * frame.height, width: 0.8 * frame.width,
                     height: 0.5 * frame.height, scale: 1 };
      let colors = 0;
      for (let tries = 0; tries < 40 && colors < 3; ++tries) {
        await delay(250);
        colors = countColors(readPng(await this.screenshot(clip)), 12);
      }
      if (colors < 3) this.fault('undrawn-player', frame.text);
    }
    // A page that scrolls sideways on a telephone hides its text. Doxygen's lists of source lines may.
    if (!/_source\.html$/.test(path) && seen.width > kSmallScreen + 1) {
      this.fault('too-wide', `${seen.width} pixels on a screen of ${kSmallScreen}`);
    }
    return { path, faults: this.faults, links: seen.links, anchors: new Set(seen.anchors) };
  }
}

// Lists that Doxygen writes without a word of ours: source lines, members, indexes. They are two thirds of the
// site; one in ten is opened, of the others the links and anchors are read from the text.
function isListing(path) {
  return /(_source|-members)\.html$|\/(functions|globals|namespacemembers|dir)_[^/]*\.html$/.test(path);
}

function read(path) {
  const text = readFileSync(path, 'utf8');
  const values = pattern => [...text.matchAll(pattern)].map(match => match[1].replaceAll('&amp;', '&'));
  const links = values(/<a[^>]* href="([^"]*)"/g).concat(values(/<area[^>]* href="([^"]*)"/g));
  return { path, faults: [], links: links.map(link => new URL(link, pathToFileURL(path)).href),
           anchors: new Set(values(/ id="([^"]*)"/g).concat(values(/<a[^>]* name="([^"]*)"/g))) };
}

function findDeadLinks(visits) {
  const byPath = new Map(visits.map(visit => [visit.path, visit]));
  for (const visit of visits) {
    for (const link of new Set(visit.links)) {
      if (!link.startsWith('file:')) continue;
      const url = new URL(link);
      const target = fileURLToPath(url.origin === 'null' ? `file://${url.pathname}` : url);
      const anchor = decodeURIComponent(url.hash.slice(1));
      const known = byPath.get(target);
      if (!existsSync(target) || (anchor && known && !known.anchors.has(anchor))) {
        visit.faults.push({ kind: 'dead-link', text: link.replace(/^.*\//, '') });
      }
    }
  }
}

async function checkAll(browser, pages) {
  const listings = pages.filter(isListing);
  const onlyRead = new Set(listings.filter((_, i) => i % 10 !== 0));
  const visits = [...onlyRead].map(read);
  const waiting = pages.filter(page => !onlyRead.has(page));
  await Promise.all(Array.from({ length: kTabs }, async () => {
    const visitor = new Visitor();
    await visitor.start(browser);
    await visitor.tab('Emulation.setDeviceMetricsOverride',
                      { width: kSmallScreen, height: 800, deviceScaleFactor: 1, mobile: false });
    while (waiting.length > 0) {
      visits.push(await visitor.check(waiting.shift()));
    }
  }));
  visits.sort((a, b) => (a.path < b.path ? -1 : 1));
  findDeadLinks(visits);
  return visits;
}

async function takePictures(browser, folder, out, names) {
  mkdirSync(out, { recursive: true });
  const visitor = new Visitor();
  await visitor.start(browser);
  for (const name of names) {
    for (const [label, width, dark] of [['light', 1300, false], ['dark', 1300, true], ['small', kSmallScreen, false]]) {
      await visitor.tab('Emulation.setDeviceMetricsOverride',
                        { width, height: 1000, deviceScaleFactor: 1, mobile: false });
      await visitor.tab('Emulation.setEmulatedMedia',
                        { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
      await visitor.open(join(folder, name));
      await visitor.evaluate(`(${inspect})()`);
      const height = Math.min(14000, await visitor.evaluate(
          '(document.getElementById("doc-content") ?? document.documentElement).scrollHeight + 200'));
      await visitor.tab('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
      await delay(1500);
      for (let y = 0, piece = 1; y < height; y += kPieceHeight, ++piece) {
        const clip = { x: 0, y, width, height: Math.min(kPieceHeight, height - y), scale: 1 };
        writeFileSync(join(out, `${basename(name, '.html')}_${label}_${piece}.png`), await visitor.screenshot(clip));
      }
    }
  }
}

const [chromium, folderName, option, file, ...names] = process.argv.slice(2);
if (!folderName) {
  console.error('usage: node check_site.mjs CHROMIUM FOLDER [--expect FILE | --look OUT PAGE...]');
  process.exit(64);
}
const folder = resolve(folderName);
const browser = new Browser(chromium);
let failed = false;
try {
  if (option === '--look') {
    await takePictures(browser, folder, file, names);
  } else {
    const pages = pagesBelow(folder);
    const visits = await checkAll(browser, pages);
    const found = Object.fromEntries(visits.map(
        visit => [relative(folder, visit.path), [...new Set(visit.faults.map(fault => fault.kind))].sort()]));
    if (option === '--expect') {
      const expected = JSON.parse(readFileSync(file, 'utf8'));
      for (const name of new Set([...Object.keys(expected), ...Object.keys(found)])) {
        const same = JSON.stringify(expected[name]) === JSON.stringify(found[name]);
        failed ||= !same;
        console.log(`${same ? 'as expected' : 'WRONG'}: ${name}: expected ${JSON.stringify(expected[name])}, ` +
                    `found ${JSON.stringify(found[name])}`);
      }
    } else {
      for (const visit of visits) {
        for (const fault of visit.faults) {
          failed = true;
          console.log(`${relative(folder, visit.path)}: ${fault.kind}: ${fault.text}`);
        }
      }
      if (pages.length === 0) {
        failed = true;
        console.log(`${folder} holds no pages`);
      }
      console.log(`${pages.length} pages, ${visits.reduce((sum, visit) => sum + visit.faults.length, 0)} faults`);
    }
  }
} finally {
  await browser.close();
}
process.exit(failed ? 1 : 0);
