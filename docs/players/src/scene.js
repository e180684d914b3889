// Bodies, light and camera.
import * as THREE from 'three';
import { poseAt, swarmAt } from './decode.js';

const edgeAngle = 20;  // degrees between two faces from which their common edge is drawn

// A billiard ball: a white band and a dot at each pole, so that turning about any axis is seen.
function ballTexture(color) {
  const canvas = document.createElement('canvas');
  canvas.width = 256;
  canvas.height = 128;
  const g = canvas.getContext('2d');
  g.fillStyle = color;
  g.fillRect(0, 0, 256, 128);
  g.fillStyle = '#fbfaf5';
  g.fillRect(0, 52, 256, 24);
  g.fillRect(0, 0, 256, 14);
  g.fillRect(0, 114, 256, 14);
  g.fillStyle = '#22262c';
  for (const x of [0, 128, 256]) {
    g.beginPath();
    g.arc(x, 64, 8, 0, 2 * Math.PI);
    g.fill();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}

function lines(points, color, opacity = 1) {
  const geometry = new THREE.BufferGeometry().setFromPoints(points);
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ color, transparent: opacity < 1, opacity }));
}

function gridLines(size, step) {
  const half = size / 2, points = [];
  for (let i = -Math.floor(half / step); i <= Math.floor(half / step); ++i) {
    points.push(-half, i * step, 0, half, i * step, 0, i * step, -half, 0, i * step, half, 0);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  return geometry;
}

function solidGeometry(body) {
  const alongZ = geometry => geometry.rotateX(Math.PI / 2);  // three.js builds along y
  switch (body.type) {
    case 'ball': return alongZ(new THREE.SphereGeometry(body.radius, 40, 24));
    case 'box': return new THREE.BoxGeometry(...body.size);
    case 'capsule': return alongZ(new THREE.CapsuleGeometry(body.radius, body.length, 12, 32));
    case 'cylinder': return alongZ(new THREE.CylinderGeometry(body.radius, body.radius, body.length, 48));
    case 'disc': return new THREE.CircleGeometry(body.radius, 64);
    case 'polygon': return new THREE.ShapeGeometry(new THREE.Shape(body.corners.map(c => new THREE.Vector2(...c))));
    case 'plane': return new THREE.PlaneGeometry(body.size, body.size);
    case 'mesh': {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(body.positions, 3));
      geometry.setIndex(new THREE.BufferAttribute(body.indices, 1));
      return geometry;
    }
  }
  return null;
}

function outlinePoints(body) {
  if (body.type === 'disc') {
    const points = [new THREE.Vector3()];
    for (let i = 0; i <= 64; ++i) {
      const angle = i * Math.PI / 32;
      points.push(new THREE.Vector3(body.radius * Math.cos(angle), body.radius * Math.sin(angle), 0));
    }
    return points;
  }
  if (body.type === 'polygon') {
    return [...body.corners, body.corners[0]].map(c => new THREE.Vector3(c[0], c[1], 0));
  }
  return null;
}

function bodyObject(body, flat) {
  const group = new THREE.Group();
  group.name = body.name;
  group.userData.color = body.color;
  const color = new THREE.Color(body.color);
  if (body.type === 'polyline') {
    group.add(lines(body.points.map(p => new THREE.Vector3(...p)), color, body.opacity));
    return group;
  }
  const geometry = solidGeometry(body);
  const seeThrough = body.opacity < 1;
  const dark = color.clone().multiplyScalar(0.35);
  if (body.type === 'plane') {
    const floor = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({
      color: 0xffffff, roughness: 1, side: THREE.DoubleSide, transparent: seeThrough, opacity: body.opacity,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
    floor.receiveShadow = true;
    floor.userData.role = 'floor';
    const grid = new THREE.LineSegments(gridLines(body.size, body.step), new THREE.LineBasicMaterial());
    grid.userData.role = 'grid';
    group.add(floor, grid);
    return group;
  }
  if (!body.wireframe) {
    const flatBody = body.type === 'disc' || body.type === 'polygon';
    const Material = flatBody && flat ? THREE.MeshBasicMaterial : THREE.MeshStandardMaterial;
    const material = new Material({
      color, transparent: seeThrough || (flatBody && flat), opacity: flatBody && flat ? 0.75 * body.opacity : body.opacity,
      side: flatBody || body.type === 'mesh' || seeThrough ? THREE.DoubleSide : THREE.FrontSide,
      depthWrite: !seeThrough });
    if (material.isMeshStandardMaterial) {
      material.roughness = body.type === 'ball' ? 0.28 : 0.55;
      material.flatShading = body.type === 'mesh';
    }
    if (body.type === 'ball' && !seeThrough) {
      material.map = ballTexture(body.color);
      material.color.set(0xffffff);
    }
    const mesh = new THREE.Mesh(geometry, material);
    mesh.castShadow = !seeThrough;
    mesh.receiveShadow = !seeThrough && !flatBody;
    group.add(mesh);
  }
  const outline = outlinePoints(body);
  if (outline) {
    const line = lines(outline, dark);
    line.userData = { role: 'edge', own: body.color };
    line.position.z = 1e-3;
    group.add(line);
  } else if (body.type === 'box' || body.type === 'mesh' || body.type === 'cylinder' || body.wireframe) {
    const many = body.type === 'mesh' && body.triangles > 20000;
    if (!many) {
      const edges = body.wireframe && body.type !== 'box' ? new THREE.WireframeGeometry(geometry)
                                                          : new THREE.EdgesGeometry(geometry, edgeAngle);
      const line = new THREE.LineSegments(edges, new THREE.LineBasicMaterial({
        color: body.wireframe ? color : dark, transparent: true, opacity: body.wireframe ? body.opacity : 0.55 }));
      line.userData = { role: 'edge', own: body.color, wire: body.wireframe };
      group.add(line);
    }
  }
  return group;
}

// All balls of a swarm in one object: for each a square that faces the eye, on which a ball is painted. Ten thousand balls
// of triangles would be a million of them, too many for a machine without a graphics processor.
function swarmObject(swarm, flat) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * swarm.count), 3).setUsage(THREE.DynamicDrawUsage));
  const material = new THREE.ShaderMaterial({
    uniforms: { color: { value: new THREE.Color(swarm.color) }, radius: { value: swarm.radius }, height: { value: 1 } },
    defines: flat ? { FLAT: 1 } : {},
    alphaToCoverage: true,
    // One pixel more on each side, for the soft edge.
    vertexShader: `
      uniform float radius, height;
      varying float pixels;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        pixels = radius * height * projectionMatrix[1][1] / gl_Position.w;
        gl_PointSize = pixels + 2.0;
      }`,
    fragmentShader: `
      uniform vec3 color;
      varying float pixels;
      void main() {
        float pixel = 2.0 / pixels;  // in radii
        vec2 p = vec2(1.0, -1.0) * (2.0 * gl_PointCoord - 1.0) * (1.0 + pixel);
        float edge = length(p);
        if (edge > 1.0 + pixel) discard;
        #ifdef FLAT
          float light = 1.0, rim = 0.3;
        #else
          float light = 0.35 + 0.75 * max(0.0, dot(vec3(p, sqrt(max(0.0, 1.0 - edge * edge))), vec3(0.32, 0.48, 0.82)));
          float rim = 0.5;
        #endif
        light *= 1.0 - rim * smoothstep(1.0 - 1.5 * pixel, 1.0, edge);
        gl_FragColor = vec4(color * light, 1.0 - smoothstep(1.0 - 0.5 * pixel, 1.0 + 0.5 * pixel, edge));
        #include <colorspace_fragment>
      }`,
  });
  const points = new THREE.Points(geometry, material);
  const size = new THREE.Vector2();
  points.onBeforeRender = renderer => { material.uniforms.height.value = renderer.getDrawingBufferSize(size).y; };
  points.name = swarm.name;
  points.frustumCulled = false;
  points.userData = { radius: swarm.radius, color: swarm.color };
  return points;
}

function boundingRadius(body) {
  switch (body.type) {
    case 'ball': case 'disc': return body.radius;
    case 'box': return Math.hypot(...body.size) / 2;
    case 'capsule': return body.radius + body.length / 2;
    case 'cylinder': return Math.hypot(body.radius, body.length / 2);
    case 'polygon': return Math.max(...body.corners.map(c => Math.hypot(...c)));
    case 'polyline': return Math.max(...body.points.map(p => Math.hypot(...p)));
    case 'plane': return Math.SQRT1_2 * body.size;
  }
  let largest = 0;
  for (let i = 0; i < body.positions.length; i += 3) {
    largest = Math.max(largest, Math.hypot(body.positions[i], body.positions[i + 1], body.positions[i + 2]));
  }
  return largest;
}

// An arrow of unit length along z, thick enough to be seen. Drawn over everything: arrows often start inside a body.
function solidArrow(color, thickness) {
  const group = new THREE.Group();
  const material = new THREE.MeshBasicMaterial({ color, depthTest: false, transparent: true });
  const shaft = new THREE.Mesh(new THREE.CylinderGeometry(1, 1, 1, 16).rotateX(Math.PI / 2).translate(0, 0, 0.5), material);
  const head = new THREE.Mesh(new THREE.ConeGeometry(1, 1, 24).rotateX(Math.PI / 2).translate(0, 0, 0.5), material);
  shaft.renderOrder = head.renderOrder = 2;
  group.add(shaft, head);
  group.stretch = length => {
    const headLength = Math.min(0.45 * length, 7 * thickness);
    const radius = Math.min(thickness, headLength / 5);
    shaft.scale.set(radius, radius, length - headLength);
    head.position.z = length - headLength;
    head.scale.set(2.6 * radius, 2.6 * radius, headLength);
  };
  return group;
}

function bodyAxes(length) {
  const group = new THREE.Group();
  const ends = [[1, 0, 0, 0xd0312d], [0, 1, 0, 0x2c9a3f], [0, 0, 1, 0x2f6fde]];
  for (const [x, y, z, color] of ends) {
    const arrow = solidArrow(color, 0.022 * length);
    arrow.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(x, y, z));
    arrow.stretch(length);
    group.add(arrow);
  }
  return group;
}

export class Stage {
  constructor(header, cases) {
    this.header = header;
    this.cases = cases;
    this.flat = header.view.flat;
    this.scene = new THREE.Scene();
    this.bodies = [];
    this.trails = [];
    this.moving = [];
    this.samples = [];  // balls that hold all that happens, for the camera
    const box = new THREE.Box3();
    const floorBox = new THREE.Box3();
    let moving = 0;
    for (const body of header.bodies) {
      const object = bodyObject(body, this.flat);
      const radius = boundingRadius(body);
      if (body.axes) object.add(bodyAxes(1.5 * radius));
      const reach = new THREE.Vector3(radius, radius, radius);
      if (body.pose) {
        object.position.fromArray(body.pose);
        object.quaternion.set(body.pose[4], body.pose[5], body.pose[6], body.pose[3]).normalize();
        // A floor is often much larger than what happens on it.
        const extent = new THREE.Box3().setFromObject(object);
        (body.type === 'plane' ? floorBox : box).union(extent);
        if (body.type !== 'plane') {
          for (let corner = 0; corner < 8; ++corner) {
            this.samples.push({ radius: 0, p: new THREE.Vector3((corner & 1 ? extent.max : extent.min).x,
              (corner & 2 ? extent.max : extent.min).y, (corner & 4 ? extent.max : extent.min).z) });
          }
        }
      } else {
        this.moving.push({ object, index: moving });
        for (const one of cases) {
          const n = one.frames;
          const at = moving * 7 * n;
          const every = Math.max(1, Math.floor(n * header.bodies.length * cases.length / 20000));
          for (let f = 0; f < n; ++f) {
            const p = new THREE.Vector3(one.poses[at + f], one.poses[at + n + f], one.poses[at + 2 * n + f]);
            box.expandByPoint(p.clone().add(reach));
            box.expandByPoint(p.clone().sub(reach));
            if (f % every === 0) this.samples.push({ p, radius });
          }
        }
        if (body.trail) this.trails.push({ index: moving, color: body.color, line: null });
        ++moving;
      }
      this.bodies.push(object);
      this.scene.add(object);
    }
    this.swarms = (header.swarms ?? []).map((swarm, s) => {
      const reach = new THREE.Vector3(swarm.radius, swarm.radius, swarm.radius), extent = new THREE.Box3();
      const p = new THREE.Vector3();
      for (const one of cases) {
        for (let i = 0; i < one.swarms[s].length; i += 3) extent.expandByPoint(p.fromArray(one.swarms[s], i));
      }
      for (let corner = 0; corner < 8; ++corner) {
        this.samples.push({ radius: swarm.radius, p: new THREE.Vector3((corner & 1 ? extent.max : extent.min).x,
          (corner & 2 ? extent.max : extent.min).y, (corner & 4 ? extent.max : extent.min).z) });
      }
      box.expandByPoint(extent.min.sub(reach)).expandByPoint(extent.max.add(reach));
      const points = swarmObject(swarm, this.flat);
      this.scene.add(points);
      return { swarm, place: points.geometry.getAttribute('position') };
    });
    if (box.isEmpty()) box.copy(floorBox);
    if (box.isEmpty()) box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    this.box = box;
    this.size = Math.max(box.getSize(new THREE.Vector3()).length(), 1e-9);

    this.arrows = header.arrows.map(arrow => {
      const object = solidArrow(arrow.color, 0.006 * this.size);
      this.scene.add(object);
      return object;
    });
    this.addLight();
    this.addCamera();
  }

  addLight() {
    const up = new THREE.Vector3(...this.header.view.up).normalize();
    if (this.flat) up.set(0, 0, 1);
    const sky = new THREE.HemisphereLight(0xffffff, 0x8f96a3, 1.7);
    sky.position.copy(up);
    const sun = new THREE.DirectionalLight(0xfff4e2, 2.2);
    const middle = this.box.getCenter(new THREE.Vector3());
    const aside = new THREE.Vector3(up.y, up.z, up.x).cross(up).normalize();
    const ahead = new THREE.Vector3().crossVectors(up, aside);
    sun.position.copy(middle).addScaledVector(up, this.size).addScaledVector(aside, 0.45 * this.size)
      .addScaledVector(ahead, 0.35 * this.size);
    sun.target.position.copy(middle);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    const half = 0.62 * this.size;
    Object.assign(sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.05 * this.size, far: 3 * this.size });
    sun.shadow.normalBias = 0.002 * this.size;
    sun.shadow.radius = 3;
    this.scene.add(sky, sun, sun.target);
  }

  addCamera() {
    const view = this.header.view;
    this.target = view.target ? new THREE.Vector3(...view.target) : this.box.getCenter(new THREE.Vector3());
    if (this.flat) {
      this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1e4 * this.size, 1e4 * this.size);
      this.camera.position.copy(this.target).add(new THREE.Vector3(0, 0, this.size));
    } else {
      this.camera = new THREE.PerspectiveCamera(38, 1, 0.01, 100);
      this.camera.up.set(...view.up).normalize();
      this.camera.position.copy(this.target).addScaledVector(new THREE.Vector3(...view.direction).normalize(), -1);
    }
    this.camera.lookAt(this.target);
  }

  resize(width, height) {
    const aspect = width / height;
    if (this.flat) {
      const size = this.box.getSize(new THREE.Vector3());
      const half = this.header.view.distance ?? 0.62 * Math.max(size.y, size.x / aspect, 1e-9);
      Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    } else {
      this.camera.aspect = aspect;
      if (!this.cameraMoved) this.fitCamera();
    }
    this.camera.updateProjectionMatrix();
  }

  // Moves the camera along its line of sight until all that happens just fits. A ball of radius r at (x, y, z) of the
  // camera's frame, seen from the target, touches the upper edge of the picture at the distance
  // (|y| + r / cos(angle)) / tan(angle) + z, where `angle` is half the angle of view; likewise the side.
  fitCamera() {
    const { camera, target, box } = this;
    const tan = Math.tan(camera.fov * Math.PI / 360);
    const needed = (offset, radius, slope) => (Math.abs(offset) + radius * Math.hypot(1, slope)) / slope;
    camera.lookAt(target);
    const inverse = camera.quaternion.clone().invert();
    const samples = this.samples.length ? this.samples
      : [{ p: box.getCenter(new THREE.Vector3()), radius: this.size / 2 }];
    let distance = 1e-6;
    const p = new THREE.Vector3();
    for (const sample of samples) {
      p.copy(sample.p).sub(target).applyQuaternion(inverse);
      distance = Math.max(distance, needed(p.y, sample.radius, tan) + p.z,
        needed(p.x, sample.radius, tan * camera.aspect) + p.z);
    }
    distance = this.header.view.distance ?? 1.08 * distance;
    const direction = camera.position.clone().sub(target).normalize();
    camera.position.copy(target).addScaledVector(direction, distance);
    camera.near = 0.005 * distance;
    camera.far = 60 * Math.max(distance, this.size);
  }

  setTheme(dark) {
    this.dark = dark;
    this.background = dark ? '#14181f' : '#f3f5f8';
    this.scene.background = new THREE.Color(this.background);
    this.paintTrails();
    for (const object of this.bodies) {
      for (const part of object.children) {
        const role = part.userData.role;
        if (role === 'floor') part.material.color.set(dark ? 0x2a303a : 0xe9ecf1);
        if (role === 'grid') part.material.color.set(dark ? 0x414a58 : 0xc3cad4);
        if (role === 'edge' && !part.userData.wire) {
          // Edges are darker than the body on a light ground, lighter on a dark one.
          part.material.color.set(part.userData.own).lerp(new THREE.Color(dark ? 0xffffff : 0x000000), 0.6);
        }
      }
    }
  }

  paintTrails() {
    for (const trail of this.trails) {
      trail.line?.material.color.set(trail.color).lerp(new THREE.Color(this.dark ? 0xffffff : 0x000000), 0.25);
    }
  }

  setCase(one) {
    this.case = one;
    for (const trail of this.trails) {
      if (trail.line) {
        this.scene.remove(trail.line);
        trail.line.geometry.dispose();
      }
      const n = one.frames, at = trail.index * 7 * n, points = [];
      for (let f = 0; f < n; ++f) {
        points.push(new THREE.Vector3(one.poses[at + f], one.poses[at + n + f], one.poses[at + 2 * n + f]));
      }
      trail.line = lines(points, trail.color, 0.8);
      trail.line.frustumCulled = false;
      this.scene.add(trail.line);
    }
    this.paintTrails();
  }

  // Puts everything where it is `part` of the way from frame f to the next.
  show(f, part) {
    for (const { object, index } of this.moving) {
      poseAt(this.case, index, f, part, object.position, object.quaternion);
    }
    this.swarms.forEach(({ swarm, place }, s) => {
      swarmAt(this.case, swarm, s, f, part, place.array);
      place.needsUpdate = true;
    });
    for (const trail of this.trails) trail.line.geometry.setDrawRange(0, f + 1);
    const n = this.case.frames, next = f + 1 < n ? 1 : 0;
    this.arrows.forEach((helper, a) => {
      const series = k => {
        const at = (a * 6 + k) * n + f;
        return this.case.arrows[at] + part * (this.case.arrows[at + next] - this.case.arrows[at]);
      };
      const vector = new THREE.Vector3(series(3), series(4), series(5));
      const length = vector.length() * this.header.arrows[a].scale;
      helper.visible = length > 1e-4 * this.size;
      if (!helper.visible) return;
      helper.position.set(series(0), series(1), series(2));
      helper.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), vector.normalize());
      helper.stretch(length);
    });
  }
}
