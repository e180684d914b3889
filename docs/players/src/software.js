// Draws the scene on a plain canvas, for browsers without WebGL: triangles from back to front, each in one shade.
// No shadows and no textures, but the same bodies, camera and controls.
import * as THREE from 'three';

const mostTriangles = 60000;

// A picture of a ball, or of a disc: copying it ten thousand times is faster than drawing as many circles.
function ballPicture(color, flat) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const g = canvas.getContext('2d');
  g.beginPath();
  g.arc(16, 16, 14.5, 0, 2 * Math.PI);
  g.fillStyle = color;
  g.fill();
  if (!flat) {
    g.fillStyle = g.createRadialGradient(11, 9, 1, 16, 16, 16);
    g.fillStyle.addColorStop(0, '#ffffff50');
    g.fillStyle.addColorStop(0.5, '#00000000');
    g.fillStyle.addColorStop(1, '#00000080');
    g.fill();
  }
  g.lineWidth = 2;
  g.strokeStyle = '#00000060';
  g.stroke();
  return canvas;
}

// The part of a polygon or line in front of the eye, in clip coordinates: where w is at least a little.
function inFront(corners) {
  const least = 1e-6;
  if (corners.every(c => c.w >= least)) return corners;
  const kept = [];
  const pairs = corners.length === 2 ? 1 : corners.length;
  for (let i = 0; i < pairs; ++i) {
    const a = corners[i], b = corners[(i + 1) % corners.length];
    if (a.w >= least) kept.push(a);
    if ((a.w >= least) !== (b.w >= least)) kept.push(a.clone().lerp(b, (least - a.w) / (b.w - a.w)));
    if (pairs === 1 && b.w >= least) kept.push(b);
  }
  return kept;
}

export class SoftwareRenderer {
  constructor(canvas) {
    this.domElement = canvas;
    this.g = canvas.getContext('2d');
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
  }

  setSize(width, height) {
    this.domElement.width = width * this.ratio;
    this.domElement.height = height * this.ratio;
  }

  render(scene, camera) {
    const { g } = this, { width, height } = this.domElement;
    scene.updateMatrixWorld();
    camera.updateMatrixWorld();
    g.fillStyle = '#' + scene.background.getHexString();
    g.fillRect(0, 0, width, height);
    const toClip = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const light = new THREE.Vector3(0.3, 0.2, 1).normalize().transformDirection(camera.matrixWorld);
    const pieces = [];
    scene.traverseVisible(object => {
      if (object.isPoints) this.collectSwarm(object, camera, toClip, pieces);
      else if ((object.isMesh || object.isLine) && pieces.length < mostTriangles) {
        this.collect(object, camera, toClip, light, pieces);
      }
    });
    // Floors first, then by depth, lines a little before the faces that they lie on.
    pieces.sort((a, b) => b.floor - a.floor || a.order - b.order || b.depth - a.depth);
    for (const piece of pieces) {
      g.globalAlpha = piece.opacity;
      g.beginPath();
      if (piece.ball) {
        const [{ x, y }] = piece.points, r = piece.radius;
        g.drawImage(piece.ball, x - r, y - r, 2 * r, 2 * r);
        continue;
      }
      piece.points.forEach((p, i) => (i ? g.lineTo(p.x, p.y) : g.moveTo(p.x, p.y)));
      if (piece.points.length > 2) {
        g.closePath();
        g.fillStyle = g.strokeStyle = piece.color;
        g.lineWidth = 0.7;
        g.fill();
        g.stroke();
      } else {
        g.strokeStyle = piece.color;
        g.lineWidth = 1.2 * this.ratio;
        g.stroke();
      }
    }
    g.globalAlpha = 1;
  }

  // Balls that do not turn are circles, as large as they are far away.
  collectSwarm(swarm, camera, toClip, pieces) {
    const { width, height } = this.domElement, { radius, color } = swarm.userData;
    const ball = swarm.userData.ball ??= ballPicture(color, camera.isOrthographicCamera);
    const position = swarm.geometry.getAttribute('position'), scale = camera.projectionMatrix.elements[5] * height / 2;
    const c = new THREE.Vector4();
    for (let i = 0; i < position.count; ++i) {
      c.set(position.getX(i), position.getY(i), position.getZ(i), 1).applyMatrix4(toClip);
      if (c.w <= 0) continue;
      const point = { x: (c.x / c.w + 1) / 2 * width, y: (1 - c.y / c.w) / 2 * height };
      pieces.push({ points: [point], ball, radius: radius * scale / c.w, depth: c.z / c.w, opacity: 1, floor: 0, order: 0 });
    }
  }

  collect(object, camera, toClip, light, pieces) {
    const { width, height } = this.domElement;
    const position = object.geometry.getAttribute('position');
    const uv = object.geometry.getAttribute('uv');
    const { index } = object.geometry;
    const material = object.material;
    const base = material.map && object.parent?.userData.color ? object.parent.userData.color : '#' + material.color.getHexString();
    const floor = object.userData.role === 'floor' || object.userData.role === 'grid' ? 1 : 0;
    const world = [], clip = [];
    for (let i = 0; i < position.count; ++i) {
      const p = new THREE.Vector3().fromBufferAttribute(position, i).applyMatrix4(object.matrixWorld);
      world.push(p);
      clip.push(new THREE.Vector4(p.x, p.y, p.z, 1).applyMatrix4(toClip));
    }
    const onScreen = c => ({ x: (c.x / c.w + 1) / 2 * width, y: (1 - c.y / c.w) / 2 * height, depth: c.z / c.w });
    const range = object.geometry.drawRange;
    const total = Math.min(index ? index.count : position.count, range.start + range.count);
    const at = i => (index ? index.getX(i) : i);
    const order = object.renderOrder + (object.userData.role === 'grid' ? 0.5 : 0);
    const add = (ids, color, bias) => {
      const points = inFront(ids.map(i => clip[i])).map(onScreen);
      if (points.length < 2) return;
      const depth = points.reduce((sum, p) => sum + p.depth, 0) / points.length - bias;
      pieces.push({ points, depth, color, opacity: material.opacity, floor, order });
    };
    if (object.isMesh) {
      const color = new THREE.Color(), normal = new THREE.Vector3(), edge = new THREE.Vector3();
      for (let i = 0; i + 2 < total; i += 3) {
        const [a, b, c] = [at(i), at(i + 1), at(i + 2)];
        normal.subVectors(world[b], world[a]).cross(edge.subVectors(world[c], world[a])).normalize();
        const sight = camera.isOrthographicCamera ? camera.getWorldDirection(edge) : edge.subVectors(world[a], camera.position);
        if (normal.dot(sight) >= 0 && material.side === THREE.FrontSide) continue;
        const shade = material.isMeshBasicMaterial ? 1 : 0.55 + 0.45 * Math.abs(normal.dot(light));
        // The white band and caps of a ball, which its texture would show.
        const v = material.map ? (uv.getY(a) + uv.getY(b) + uv.getY(c)) / 3 : 0.25;
        const white = Math.abs(v - 0.5) < 0.1 || Math.abs(v - 0.5) > 0.4;
        color.set(material.map && white ? '#fbfaf5' : base).multiplyScalar(shade * shade);
        add([a, b, c], '#' + color.getHexString(), 0);
      }
    } else {
      const step = object.isLineSegments ? 2 : 1;
      for (let i = range.start; i + 1 < total; i += step) add([at(i), at(i + 1)], base, 1e-4);
    }
  }
}
