// Unpacks a recording. The order and the packing are those of lib/carom_io/recorder.cpp.

async function inflate(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Takes numbers that lie byte plane by byte plane, lowest byte first.
class Planes {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  take(Type, count) {
    const size = Type.BYTES_PER_ELEMENT;
    const result = new Type(count);
    const view = new DataView(result.buffer);
    for (let plane = 0; plane < size; ++plane) {
      for (let i = 0; i < count; ++i) view.setUint8(i * size + plane, this.bytes[this.at++]);
    }
    return result;  // right on little-endian machines, which all that run browsers are
  }
}

export async function decode(header, base64) {
  const planes = new Planes(await inflate(base64));
  for (const body of header.bodies) {
    if (body.type !== 'mesh') continue;
    body.positions = planes.take(Float32Array, 3 * body.vertices);
    body.indices = planes.take(Uint32Array, 3 * body.triangles);
  }
  const moving = header.bodies.filter(body => !body.pose).length;
  return header.cases.map(one => {
    const n = one.frames;
    const times = planes.take(Float64Array, n);
    const channels = header.channels.map(() => null);
    const allChannels = planes.take(Float64Array, header.channels.length * n);
    for (let c = 0; c < channels.length; ++c) channels[c] = allChannels.subarray(c * n, (c + 1) * n);
    const arrows = planes.take(Float32Array, header.arrows.length * 6 * n);
    const stored = planes.take(Int16Array, moving * 7 * n);
    const poses = new Float32Array(moving * 7 * n);
    for (let series = 0; series < moving * 7; ++series) {
      const body = Math.floor(series / 7), part = series % 7;
      const grid = one.grids[body];
      let last = 0, before = 0;
      for (let f = 0; f < n; ++f) {
        const expected = f >= 2 ? 2 * last - before : f === 1 ? last : 0;
        const number = ((stored[series * n + f] + expected) << 16) >> 16;
        before = last;
        last = number;
        poses[series * n + f] = part < 3 ? grid[part] + number * grid[3] : number / 8191;
      }
    }
    const swarms = (header.swarms ?? []).map((swarm, s) => {
      // In the file ball by ball, here frame by frame: x, y, z of all balls side by side, as they are drawn.
      const { count } = swarm, [grid, step] = [one.swarmGrids[s], one.swarmGrids[s][3]];
      return { count, grid, step, positions: new Float32Array(3 * count * n) };
    });
    const differences = planes.take(Uint16Array, 3 * n * swarms.reduce((sum, swarm) => sum + swarm.count, 0));
    let at = 0;
    for (const { count, grid, step, positions } of swarms) {
      for (let axis = 0; axis < 3; ++axis) {
        for (let ball = 0; ball < count; ++ball) {
          let last = 0, before = 0;
          for (let f = 0; f < n; ++f) {
            const packed = differences[at++];
            const expected = f >= 2 ? 2 * last - before : last;
            const number = (((packed >>> 1) ^ -(packed & 1)) + expected) << 16 >> 16;
            before = last;
            last = number;
            positions[3 * (f * count + ball) + axis] = grid[axis] + number * step;
          }
        }
      }
    }
    return { label: one.label, frames: n, times, channels, arrows, poses, swarms: swarms.map(swarm => swarm.positions) };
  });
}

// A pose between frames f and f+1: positions on the straight line, quaternions on the chord, the short way round.
export function poseAt(one, body, f, part, position, quaternion) {
  const n = one.frames, p = one.poses, at = body * 7 * n + f, next = f + 1 < n ? 1 : 0;
  const mix = k => p[at + k * n] + part * (p[at + k * n + next] - p[at + k * n]);
  position.set(mix(0), mix(1), mix(2));
  let dot = 0;
  for (let k = 3; k < 7; ++k) dot += p[at + k * n] * p[at + k * n + next];
  const sign = dot < 0 ? -1 : 1;
  const q = k => (1 - part) * p[at + k * n] + part * sign * p[at + k * n + next];
  quaternion.set(q(4), q(5), q(6), q(3)).normalize();
}

// The positions of a swarm between frames f and f+1, on straight lines; through the sides of a periodic box the short way.
export function swarmAt(one, swarm, s, f, part, place) {
  const { count, period } = swarm, positions = one.swarms[s];
  const now = 3 * count * f, next = f + 1 < one.frames ? now + 3 * count : now;
  for (let i = 0; i < 3 * count; ++i) {
    const here = positions[now + i], edge = period[i % 3];
    let step = positions[next + i] - here;
    if (edge > 0) step -= edge * Math.round(step / edge);
    place[i] = here + part * step;
  }
}
