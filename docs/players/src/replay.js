// Plays a recording: finds it in the page, builds the picture and the controls, and lets time run.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { decode } from './decode.js';
import { Stage } from './scene.js';
import { SoftwareRenderer } from './software.js';
import { Strips, short } from './strips.js';
import { watchTheme } from './theme.js';
import css from './style.css';

const element = (tag, className, text) => {
  const result = document.createElement(tag);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
};

// Drawn here, because not every font has these signs.
const icons = {
  start: 'M2 2h2.4v12H2zM14 2v12L5.5 8z', back: 'M11.5 3v10L4 8z', play: 'M3.5 1.5v13L14 8z',
  pause: 'M3 2h3.6v12H3zM9.4 2H13v12H9.4z', next: 'M4.5 3v10L12 8z',
};

function setIcon(place, name) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', icons[name]);
  svg.append(path);
  place.replaceChildren(svg);
}

const button = (icon, label, action) => {
  const result = element('button');
  setIcon(result, icon);
  result.type = 'button';
  result.title = label;
  result.setAttribute('aria-label', label);
  result.addEventListener('click', action);
  return result;
};

// WebGL where it works; otherwise the plain canvas. A canvas that has once been asked for WebGL can do nothing else, so the
// trial has its own.
function makeRenderer(canvas) {
  try {
    const trial = document.createElement('canvas').getContext('webgl2');
    if (!trial || new URLSearchParams(location.search).has('nowebgl')) throw new Error('no WebGL');
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFShadowMap;
    return { renderer, plain: false };
  } catch {
    return { renderer: new SoftwareRenderer(canvas), plain: true };
  }
}

class Player {
  constructor(root, header, cases) {
    this.header = header;
    this.cases = cases;
    this.frame = 0;
    this.part = 0;
    this.stage = new Stage(header, cases);
    this.build(root);
    this.setCase(0);
    this.setSpeed(this.naturalSpeed());
    this.resize();
    new ResizeObserver(() => this.resize()).observe(this.view);
    watchTheme(dark => {
      this.dark = dark;
      document.documentElement.classList.toggle('carom-dark', dark);
      this.stage.setTheme(dark);
      this.draw();
    });
    this.setPlaying(!window.matchMedia('(prefers-reduced-motion: reduce)').matches && cases[0].frames > 1);
    requestAnimationFrame(now => this.tick(now));
  }

  // Real time, unless the whole would be over in a blink or last for minutes.
  naturalSpeed() {
    const t = this.cases[0].times, span = t[t.length - 1] - t[0];
    return span > 0 && (span < 0.8 || span > 90) ? span / 8 : 1;
  }

  build(root) {
    const { header } = this;
    this.view = element('div', 'carom-stage');
    this.view.tabIndex = 0;
    this.view.setAttribute('role', 'group');
    this.view.setAttribute('aria-label', `${header.title}: moving picture. Space plays and pauses, arrow keys step.`);
    const canvas = element('canvas');
    canvas.setAttribute('role', 'img');
    const names = [...header.bodies.filter(b => !b.pose), ...(header.swarms ?? [])].map(b => b.name);
    canvas.setAttribute('aria-label', header.description || `${header.title}. Bodies: ${names.slice(0, 12).join(', ')}.`);
    const { renderer, plain } = makeRenderer(canvas);
    this.renderer = renderer;
    this.view.append(canvas);
    if (plain) this.view.append(element('div', 'carom-note', 'simple drawing: this browser has no WebGL'));
    this.controls = new OrbitControls(this.stage.camera, canvas);
    this.controls.target.copy(this.stage.target);
    this.controls.enableRotate = !this.stage.flat;
    if (this.stage.flat) this.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => { this.dirty = true; });
    this.controls.addEventListener('start', () => { this.stage.cameraMoved = true; });
    this.controls.update();
    this.view.append(this.nameList());

    this.playButton = button('play', 'Play (space)', () => this.setPlaying(!this.playing));
    this.playButton.className = 'carom-play';
    this.scrub = element('input', 'carom-scrub');
    Object.assign(this.scrub, { type: 'range', min: 0, step: 1, value: 0 });
    this.scrub.setAttribute('aria-label', 'Time');
    this.scrub.addEventListener('input', () => {
      this.setPlaying(false);
      this.seek(+this.scrub.value, 0);
    });
    this.speedMenu = element('select');
    this.speedMenu.setAttribute('aria-label', 'Speed');
    for (const [factor, text] of [[0.0625, '1/16 ×'], [0.125, '1/8 ×'], [0.25, '1/4 ×'], [0.5, '1/2 ×'], [1, '1 ×'], [2, '2 ×'], [4, '4 ×']]) {
      const option = element('option', '', text);
      option.value = factor;
      this.speedMenu.append(option);
    }
    this.speedMenu.value = '1';
    this.speedMenu.addEventListener('change', () => { this.factor = +this.speedMenu.value; });
    this.factor = 1;
    this.time = element('span', 'carom-time');
    const bar = element('div', 'carom-bar');
    bar.append(
      button('start', 'To the start (Home)', () => this.jump(0)),
      button('back', 'One step back (left arrow)', () => this.step(-1)),
      this.playButton,
      button('next', 'One step on (right arrow)', () => this.step(1)),
      this.scrub, this.time, this.speedMenu);

    this.strips = new Strips(header, part => {
      this.setPlaying(false);
      const t = this.cases[this.caseIndex].times;
      this.seekTime(t[0] + part * (t[t.length - 1] - t[0]), true);
    });
    this.more = element('details', 'carom-more');
    this.more.append(element('summary', '', 'Numbers'), element('div'));
    this.more.addEventListener('toggle', () => this.fillTable());

    root.append(this.view);
    if (this.cases.length > 1) root.append(this.caseSlider());
    root.append(bar);
    if (header.channels.length) root.append(this.strips.element);
    root.append(this.more);
    document.addEventListener('keydown', event => this.key(event));
  }

  nameList() {
    const list = element('ul', 'carom-names');
    const bodies = [...this.header.bodies.filter(body => body.type !== 'plane'), ...(this.header.swarms ?? [])];
    if (bodies.length <= 8) {
      for (const body of bodies) {
        const item = element('li'), dot = element('span');
        dot.style.background = body.color;
        item.append(dot, body.name);
        list.append(item);
      }
    }
    for (const arrow of this.header.arrows) {
      const item = element('li'), dash = element('span', 'carom-arrow');
      dash.style.borderTopColor = arrow.color;
      item.append(dash, arrow.name);
      list.append(item);
    }
    return list;
  }

  caseSlider() {
    const row = element('label', 'carom-case');
    this.caseInput = element('input');
    Object.assign(this.caseInput, { type: 'range', min: 0, max: this.cases.length - 1, step: 1, value: 0 });
    this.caseOutput = element('output');
    this.caseInput.addEventListener('input', () => this.setCase(+this.caseInput.value));
    row.append(element('span', '', this.header.parameter || 'case'), this.caseInput, this.caseOutput);
    return row;
  }

  setCase(index) {
    const old = this.cases[this.caseIndex];
    const now = old ? this.now() : null;
    this.caseIndex = index;
    const one = this.cases[index];
    this.stage.setCase(one);
    this.strips.setCase(one, this.cases);
    this.scrub.max = one.frames - 1;
    if (this.caseOutput) {
      this.caseOutput.textContent = one.label;
      this.caseInput.setAttribute('aria-valuetext', one.label);
    }
    if (now === null) this.seek(0, 0);
    else this.seekTime(now, !this.playing);
    this.fillTable();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.time.title = speed === 1 ? 'real time' : `1 s of the picture is ${short(speed)} s of the simulation`;
  }

  setPlaying(playing) {
    if (playing && this.frame >= this.cases[this.caseIndex].frames - 1) this.seek(0, 0);
    this.playing = playing;
    setIcon(this.playButton, playing ? 'pause' : 'play');
    const label = playing ? 'Pause (space)' : 'Play (space)';
    this.playButton.title = label;
    this.playButton.setAttribute('aria-label', label);
  }

  seek(frame, part) {
    const last = this.cases[this.caseIndex].frames - 1;
    this.frame = Math.min(Math.max(frame, 0), last);
    this.part = this.frame === last ? 0 : part;
    this.dirty = true;
  }

  // The frame at a time, found by halving; `whole` goes to the nearest frame.
  seekTime(time, whole) {
    const t = this.cases[this.caseIndex].times;
    let low = 0, high = t.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (t[middle] <= time) low = middle; else high = middle;
    }
    if (time >= t[high]) return this.seek(high, 0);
    const part = high > low ? Math.max(0, (time - t[low]) / (t[high] - t[low])) : 0;
    return whole ? this.seek(part > 0.5 ? high : low, 0) : this.seek(low, part);
  }

  jump(frame) {
    this.setPlaying(false);
    this.seek(frame, 0);
  }

  step(by) {
    this.jump(by < 0 && this.part > 0 ? this.frame : this.frame + by);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const tag = event.target.tagName;
    if (tag === 'INPUT' || tag === 'SELECT') return;
    const actions = {
      ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1), Home: () => this.jump(0),
      End: () => this.jump(Infinity), ' ': () => this.setPlaying(!this.playing),
    };
    // Space on a button or a summary presses it.
    if (event.key === ' ' && (tag === 'BUTTON' || tag === 'SUMMARY')) return;
    if (actions[event.key]) {
      actions[event.key]();
      event.preventDefault();
    }
  }

  now() {
    const t = this.cases[this.caseIndex].times;
    return this.part > 0 ? t[this.frame] + this.part * (t[this.frame + 1] - t[this.frame]) : t[this.frame];
  }

  tick(clock) {
    const passed = Math.min((clock - (this.clock ?? clock)) / 1000, 0.1);
    this.clock = clock;
    if (this.playing) {
      const t = this.cases[this.caseIndex].times;
      if (this.frame >= t.length - 1) {
        // A pause at the end, so that the last picture is seen, then once more.
        this.rest = (this.rest ?? 0) + passed;
        if (this.rest > 1.2) {
          this.rest = 0;
          this.seek(0, 0);
        }
      } else {
        this.seekTime(this.now() + passed * this.speed * this.factor, false);
      }
    }
    if (this.dirty) this.draw();
    requestAnimationFrame(later => this.tick(later));
  }

  resize() {
    const width = Math.max(1, this.view.clientWidth), height = Math.max(1, this.view.clientHeight);
    this.renderer.setSize(width, height, false);
    this.stage.resize(width, height);
    this.draw();
  }

  draw() {
    this.dirty = false;
    if (!this.stage.scene.background) return;
    this.stage.show(this.frame, this.part);
    this.renderer.render(this.stage.scene, this.stage.camera);
    this.strips.draw(this.frame, this.part, this.dark);
    const one = this.cases[this.caseIndex];
    this.scrub.value = this.frame;
    this.scrub.setAttribute('aria-valuetext', `${short(this.now())} seconds`);
    this.time.textContent = `t = ${short(this.now())} s · ${this.frame + 1}/${one.frames}`;
  }

  // The same numbers as text: every channel's start, end, least and greatest value.
  fillTable() {
    const place = this.more.lastChild;
    place.textContent = '';
    if (!this.more.open) return;
    const one = this.cases[this.caseIndex], t = one.times;
    place.append(element('p', '', `${one.frames} frames from ${short(t[0])} s to ${short(t[t.length - 1])} s.`));
    if (!this.header.channels.length) return;
    const table = element('table');
    const addRow = (tag, cells) => {
      const row = element('tr');
      cells.forEach((cell, i) => row.append(element(i === 0 ? 'th' : tag, '', cell)));
      table.append(row);
    };
    addRow('th', ['quantity', 'at the start', 'at the end', 'least', 'greatest']);
    this.header.channels.forEach((channel, c) => {
      const values = one.channels[c];
      let low = Infinity, high = -Infinity;
      for (const value of values) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
      const name = channel.unit ? `${channel.name} [${channel.unit}]` : channel.name;
      addRow('td', [name, ...[values[0], values[values.length - 1], low, high].map(short)]);
    });
    place.append(table);
  }
}

async function start() {
  const root = document.getElementById('carom-player');
  document.head.append(element('style', '', css));
  try {
    const header = JSON.parse(document.getElementById('carom-header').textContent);
    const cases = await decode(header, document.getElementById('carom-motion').textContent);
    window.caromPlayer = new Player(root, header, cases);
    document.documentElement.dataset.carom = 'ready';
  } catch (error) {
    root.append(element('p', '', `The moving picture cannot be shown: ${error.message}`));
    document.documentElement.dataset.carom = 'failed';
    throw error;
  }
}

start();
