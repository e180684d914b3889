// The channels over time, under the scene: one strip per unit, a line at the current moment.

const ink = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9'];
const inkOnDark = ['#4aa8e0', '#f08a3c', '#2fc196', '#e3a3c6', '#f2bf4a', '#8fd0f5'];
const dashes = [[], [7, 3], [2, 2], [7, 2, 2, 2], [11, 4], [4, 6]];

export const short = value => {
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(+value.toPrecision(5));
};

export class Strips {
  constructor(header, seek) {
    this.element = document.createElement('div');
    this.element.className = 'carom-strips';
    const byUnit = new Map();
    header.channels.forEach((channel, index) => {
      if (!byUnit.has(channel.unit)) byUnit.set(channel.unit, []);
      byUnit.get(channel.unit).push({ ...channel, index });
    });
    this.strips = [...byUnit.entries()].map(([unit, channels]) => {
      const row = document.createElement('div');
      row.className = 'carom-strip';
      const legend = document.createElement('div');
      legend.className = 'carom-legend';
      const values = channels.map((channel, i) => {
        const item = document.createElement('div');
        const key = document.createElement('span');
        key.className = 'carom-key';
        key.style.setProperty('--key', ink[i % ink.length]);
        key.style.setProperty('--key-dark', inkOnDark[i % ink.length]);
        key.style.borderTopStyle = i % 3 === 0 ? 'solid' : i % 3 === 1 ? 'dashed' : 'dotted';
        const value = document.createElement('b');
        item.append(key, ` ${channel.name} `, value);
        legend.append(item);
        return value;
      });
      const canvas = document.createElement('canvas');
      canvas.setAttribute('aria-hidden', 'true');  // the table under the picture says the same
      row.append(legend, canvas);
      this.element.append(row);
      const strip = { unit, channels, values, canvas };
      const seekAt = event => {
        const box = canvas.getBoundingClientRect();
        seek(Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)));
      };
      canvas.addEventListener('pointerdown', event => {
        canvas.setPointerCapture(event.pointerId);
        seekAt(event);
      });
      canvas.addEventListener('pointermove', event => event.buttons && seekAt(event));
      return strip;
    });
  }

  setCase(one, allCases) {
    this.case = one;
    // One scale for all cases, so that moving the slider shows what changes.
    for (const strip of this.strips) {
      let low = Infinity, high = -Infinity;
      for (const each of allCases) {
        for (const channel of strip.channels) {
          for (const value of each.channels[channel.index]) {
            low = Math.min(low, value);
            high = Math.max(high, value);
          }
        }
      }
      strip.least = low;
      strip.most = high;
      const margin = high > low ? 0.08 * (high - low) : Math.abs(high) * 0.1 || 1;
      strip.low = low - margin;
      strip.high = high + margin;
    }
  }

  draw(f, part, dark) {
    const one = this.case, n = one.frames, t = one.times;
    const span = t[n - 1] - t[0] || 1;
    const now = t[f] + part * ((f + 1 < n ? t[f + 1] : t[f]) - t[f]);
    for (const strip of this.strips) {
      const { canvas } = strip;
      const ratio = window.devicePixelRatio || 1;
      const width = canvas.clientWidth, height = canvas.clientHeight;
      if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
      if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
      const g = canvas.getContext('2d');
      g.setTransform(ratio, 0, 0, ratio, 0, 0);
      g.clearRect(0, 0, width, height);
      const x = time => (time - t[0]) / span * (width - 1);
      const y = value => (strip.high - value) / (strip.high - strip.low) * height;
      if (strip.low < 0 && strip.high > 0) {
        g.strokeStyle = dark ? '#414a58' : '#d0d7de';
        g.lineWidth = 1;
        g.beginPath();
        g.moveTo(0, y(0));
        g.lineTo(width, y(0));
        g.stroke();
      }
      strip.channels.forEach((channel, i) => {
        const values = one.channels[channel.index];
        g.strokeStyle = (dark ? inkOnDark : ink)[i % ink.length];
        g.lineWidth = 1.8;
        g.setLineDash(dashes[i % dashes.length]);
        g.beginPath();
        const every = Math.max(1, Math.floor(n / (4 * width)));
        for (let k = 0; k < n; k += every) g.lineTo(x(t[k]), y(values[k]));
        g.lineTo(x(t[n - 1]), y(values[n - 1]));
        g.stroke();
        strip.values[i].textContent = `${short(values[part > 0.5 && f + 1 < n ? f + 1 : f])} ${strip.unit}`;
      });
      g.setLineDash([]);
      g.strokeStyle = dark ? '#e6edf3' : '#1f2328';
      g.lineWidth = 1;
      g.beginPath();
      g.moveTo(x(now), 0);
      g.lineTo(x(now), height);
      g.stroke();
      g.fillStyle = dark ? '#9aa4b2' : '#57606a';
      g.font = '10px system-ui, sans-serif';
      g.textAlign = 'right';
      g.fillText(short(strip.most), width - 3, 11);
      if (strip.most > strip.least) g.fillText(short(strip.least), width - 3, height - 4);
    }
  }
}
