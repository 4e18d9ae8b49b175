// Draws stems and a thinned cloud with WebGL: one program for points, one for surfaces and lines; drawn only when
// something changed. boleView3d(data, pick) fills #view and returns {select(id)}; null without WebGL.
window.boleView3d = (data, pick) => {
  'use strict';
  const canvas = document.getElementById('view');
  const gl = canvas.getContext('webgl', {antialias: true, preserveDrawingBuffer: true});
  if (!gl) {
    canvas.hidden = true;
    document.getElementById('view-trouble').hidden = false;
    for (const e of document.querySelectorAll('#view3d .screen')) e.hidden = true;
    return null;
  }

  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
  function program(vertex, fragment) {
    const p = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(p, shader);
    }
    gl.linkProgram(p);
    return p;
  }
  function buffer(values) {
    const b = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, b);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    return b;
  }
  function attribute(p, name, b, size, type, normalized) {
    const at = gl.getAttribLocation(p, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, b);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, type, normalized, 0, 0);
  }

  const paper = 'precision mediump float; varying vec3 tint; void main() { gl_FragColor = vec4(tint, 1.0); }';
  const pointProgram = program(`attribute vec3 place; attribute vec3 color; attribute float height;
    uniform mat4 view; uniform vec3 lo, size; uniform float cut, dot; varying vec3 tint;
    void main() {
      gl_Position = height > cut ? vec4(2.0, 2.0, 2.0, 1.0) : view * vec4(lo + place * size, 1.0);
      gl_PointSize = clamp(dot / gl_Position.w, 1.0, 8.0);
      tint = color;
    }`, paper);
  const solidProgram = program(`attribute vec3 place; attribute vec3 color; uniform mat4 view; varying vec3 tint;
    void main() { gl_Position = view * vec4(place, 1.0); tint = color; }`, paper);

  // Colours
  const viridis = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44], [253, 231, 37]];
  function ramp(t) {
    const at = Math.min(Math.max(t, 0), 1) * (viridis.length - 1), i = Math.min(Math.floor(at), viridis.length - 2), f = at - i;
    return viridis[i].map((v, k) => v + f * (viridis[i + 1][k] - v));
  }
  function treeColor(tree) {
    if (tree === 0) return [185, 177, 164];
    const hue = tree * 0.618034 % 1 * 6, part = k => 60 + 160 * Math.min(Math.max(Math.abs((hue + k) % 6 - 3) - 1, 0), 1);
    return [part(0), part(4), part(2)];
  }
  const inks = {good: [43, 122, 75], fair: [208, 138, 29], poor: [185, 58, 50]};

  // The cloud
  const cloud = data.cloud;
  let points = null;
  if (cloud) {
    const heights = bytes(cloud.heights), trees = bytes(cloud.trees), colors = new Uint8Array(3 * cloud.count);
    points = {place: buffer(new Uint16Array(bytes(cloud.positions).buffer)), height: buffer(heights), color: buffer(colors)};
    points.paint = by => {
      for (let i = 0; i < cloud.count; ++i) {
        const h = heights[i] / 255 * cloud.top;
        const c = by === 'tree' ? treeColor(trees[i]) : h < 0.15 ? [185, 177, 164] : ramp(heights[i] / 255);
        colors.set(c, 3 * i);
      }
      gl.bindBuffer(gl.ARRAY_BUFFER, points.color);
      gl.bufferData(gl.ARRAY_BUFFER, colors, gl.STATIC_DRAW);
    };
    points.paint('height');
  }

  // The stems of the plot as tubes of ten sides
  const inPlot = new Set(data.stems.filter(stem => stem.inside).map(stem => stem.id));
  const sides = 10, shapes = (data.shapes || []).filter(shape => inPlot.has(shape.id)), place = [], shade = [], owner = [];
  shapes.forEach((shape, index) => {
    const ring = k => {
      const r = shape.radius[k], c = shape.axis.slice(3 * k, 3 * k + 3);
      return Array.from({length: sides + 1}, (_, s) => {
        const a = 2 * Math.PI * s / sides;
        return [c[0] + r * Math.cos(a), c[1] + r * Math.sin(a), c[2]];
      });
    };
    for (let k = 0; k + 1 < shape.radius.length; ++k) {
      const a = ring(k), b = ring(k + 1);
      for (let s = 0; s < sides; ++s)
        for (const [from, side] of [[a, s], [a, s + 1], [b, s + 1], [a, s], [b, s + 1], [b, s]]) {
          place.push(...from[side]);
          shade.push(0.72 + 0.38 * Math.max(0, Math.cos(2 * Math.PI * side / sides - 4.1)));
          owner.push(index);
        }
    }
  });
  const stems = {place: buffer(new Float32Array(place)), colors: new Uint8Array(3 * owner.length), count: owner.length};
  stems.color = buffer(stems.colors);
  function paintStems(selected) {
    owner.forEach((index, i) => {
      const shape = shapes[index], ink = shape.id === selected ? [0, 115, 230] : inks[shape.quality] || [107, 74, 47];
      for (let k = 0; k < 3; ++k) stems.colors[3 * i + k] = Math.min(255, ink[k] * shade[i]);
    });
    gl.bindBuffer(gl.ARRAY_BUFFER, stems.color);
    gl.bufferData(gl.ARRAY_BUFFER, stems.colors, gl.STATIC_DRAW);
  }
  paintStems(null);

  function lineOf(corners, ink, close) {
    const ends = close ? [...corners, corners[0]] : corners;
    return {count: ends.length, place: buffer(new Float32Array(ends.flat())),
            color: buffer(new Uint8Array(ends.flatMap(() => ink)))};
  }
  // Where everything is: the box of the stems, else of the cloud.
  const box = {lo: [Infinity, Infinity, Infinity], hi: [-Infinity, -Infinity, -Infinity]};
  const include = p => p.forEach((v, k) => { if (v !== null) { box.lo[k] = Math.min(box.lo[k], v); box.hi[k] = Math.max(box.hi[k], v); } });
  for (const shape of shapes) for (let k = 0; k < shape.axis.length; k += 3) include(shape.axis.slice(k, k + 3));
  if (cloud) { include(cloud.lo); include(cloud.lo.map((v, k) => v + cloud.size[k])); }
  if (!isFinite(box.lo[0])) { include([-5, -5, 0]); include([5, 5, 5]); }
  const lines = [];
  const outline = (data.outline || []).map(p => [p[0], p[1], p[2] === null ? box.lo[2] : p[2]]);
  if (outline.length > 2) lines.push(lineOf(outline, [58, 68, 75], true));
  if (data.walk && data.walk.length > 1) lines.push(lineOf(data.walk, [74, 144, 184], false));

  // The camera turns about a target; angles in radians, lengths in metres.
  const span = Math.max(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], 2);
  const start = () => ({azimuth: 3.58, rise: 0.3, distance: 1.45 * span,
    target: [(box.lo[0] + box.hi[0]) / 2, (box.lo[1] + box.hi[1]) / 2, box.lo[2] + Math.min(3, (box.hi[2] - box.lo[2]) / 2)]});
  let camera = start(), cut = Infinity, withPoints = true, queued = false, matrix = null;

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  function axesOf() {
    const back = [Math.sin(camera.azimuth) * Math.cos(camera.rise), Math.cos(camera.azimuth) * Math.cos(camera.rise), Math.sin(camera.rise)];
    const right = [-Math.cos(camera.azimuth), Math.sin(camera.azimuth), 0];
    const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
    return {back, right, up};
  }
  function viewMatrix(aspect) {
    const {back, right, up} = axesOf();
    const eye = camera.target.map((v, k) => v + camera.distance * back[k]);
    const near = Math.max(0.05, camera.distance - 2 * span - 40), far = camera.distance + 2 * span + 60, f = 1 / Math.tan(0.35);
    const rows = [[...right.map(v => v * f / aspect), -dot(right, eye) * f / aspect], [...up.map(v => v * f), -dot(up, eye) * f],
      [...back.map(v => v * (far + near) / (near - far)), -dot(back, eye) * (far + near) / (near - far) + 2 * far * near / (near - far)],
      [...back.map(v => -v), dot(back, eye)]];
    return new Float32Array([0, 1, 2, 3].flatMap(column => rows.map(row => row[column])));
  }

  function draw() {
    queued = false;
    const scale = Math.min(devicePixelRatio || 1, 2), width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale);
    if (!width || !height) return;
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    gl.viewport(0, 0, width, height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    matrix = viewMatrix(width / height);
    gl.useProgram(solidProgram);
    gl.uniformMatrix4fv(gl.getUniformLocation(solidProgram, 'view'), false, matrix);
    for (const [mesh, mode] of [[stems, gl.TRIANGLES], ...lines.map(line => [line, gl.LINE_STRIP])]) {
      if (!mesh.count) continue;
      attribute(solidProgram, 'place', mesh.place, 3, gl.FLOAT, false);
      attribute(solidProgram, 'color', mesh.color, 3, gl.UNSIGNED_BYTE, true);
      gl.drawArrays(mode, 0, mesh.count);
    }
    if (!points || !withPoints) return;
    gl.useProgram(pointProgram);
    const uniform = name => gl.getUniformLocation(pointProgram, name);
    gl.uniformMatrix4fv(uniform('view'), false, matrix);
    gl.uniform3fv(uniform('lo'), cloud.lo);
    gl.uniform3fv(uniform('size'), cloud.size);
    gl.uniform1f(uniform('cut'), cut / cloud.top);
    gl.uniform1f(uniform('dot'), 0.0045 * span * height);
    attribute(pointProgram, 'place', points.place, 3, gl.UNSIGNED_SHORT, true);
    attribute(pointProgram, 'color', points.color, 3, gl.UNSIGNED_BYTE, true);
    attribute(pointProgram, 'height', points.height, 1, gl.UNSIGNED_BYTE, true);
    gl.drawArrays(gl.POINTS, 0, cloud.count);
  }
  const redraw = () => { if (!queued) { queued = true; requestAnimationFrame(draw); } };

  function onCanvas(p) {
    const w = matrix[3] * p[0] + matrix[7] * p[1] + matrix[11] * p[2] + matrix[15];
    if (w <= 0) return null;
    return [0, 1].map(k => (matrix[k] * p[0] + matrix[4 + k] * p[1] + matrix[8 + k] * p[2] + matrix[12 + k]) / w);
  }
  // The stem whose axis passes nearest to a place of the canvas, within 14 pixels.
  function stemAt(x, y) {
    let best = 14, id = null;
    for (const shape of shapes) {
      const at = [];
      for (let k = 0; k < shape.axis.length; k += 3) at.push(onCanvas(shape.axis.slice(k, k + 3)));
      for (let k = 0; k + 1 < at.length; ++k) {
        if (!at[k] || !at[k + 1]) continue;
        const [a, b] = [at[k], at[k + 1]].map(v => [(v[0] + 1) / 2 * canvas.clientWidth, (1 - v[1]) / 2 * canvas.clientHeight]);
        const d = [b[0] - a[0], b[1] - a[1]], length = d[0] * d[0] + d[1] * d[1];
        const t = length ? Math.min(Math.max(((x - a[0]) * d[0] + (y - a[1]) * d[1]) / length, 0), 1) : 0;
        const off = Math.hypot(x - a[0] - t * d[0], y - a[1] - t * d[1]);
        if (off < best) { best = off; id = shape.id; }
      }
    }
    return id;
  }

  let last = null, moved = 0;
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    last = [event.clientX, event.clientY];
    moved = 0;
  });
  canvas.addEventListener('pointermove', event => {
    if (!last) return;
    const dx = event.clientX - last[0], dy = event.clientY - last[1];
    last = [event.clientX, event.clientY];
    moved += Math.abs(dx) + Math.abs(dy);
    if (event.shiftKey || event.buttons & 6) {
      const {right, up} = axesOf(), step = 0.73 * camera.distance / canvas.clientHeight;
      camera.target = camera.target.map((v, k) => v - step * dx * right[k] + step * dy * up[k]);
    } else {
      camera.azimuth += 0.006 * dx;
      camera.rise = Math.min(1.5706, Math.max(-0.1, camera.rise + 0.006 * dy));
    }
    redraw();
  });
  canvas.addEventListener('pointerup', event => {
    last = null;
    if (moved > 4) return;
    const place = canvas.getBoundingClientRect();
    pick(stemAt(event.clientX - place.left, event.clientY - place.top));
  });
  canvas.addEventListener('pointercancel', () => { last = null; });
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    if (document.activeElement !== canvas) return;  // the page scrolls until the view was clicked into
    event.preventDefault();
    camera.distance = Math.min(20 * span, Math.max(0.5, camera.distance * Math.exp(0.0012 * event.deltaY)));
    redraw();
  }, {passive: false});
  addEventListener('resize', redraw);
  addEventListener('beforeprint', draw);

  const on = (id, event, action) => { const e = document.getElementById(id); if (e) e.addEventListener(event, () => { action(e); redraw(); }); };
  const cutText = document.getElementById('view-cut-text');
  function setCut(slider) {
    cut = slider.value >= 100 ? Infinity : cloud.top * slider.value / 100;
    cutText.textContent = isFinite(cut) ? `${cut.toFixed(1)} m above ground` : 'the tops';
  }
  on('view-cut', 'input', setCut);
  if (cutText && cloud) setCut(document.getElementById('view-cut'));
  on('view-color', 'input', e => points.paint(e.value));
  on('view-points', 'input', e => { withPoints = e.checked; });
  on('view-top', 'click', () => { camera = {...start(), rise: 1.5706, azimuth: Math.PI, distance: 1.5 * span}; });
  on('view-side', 'click', () => { camera = {...start(), rise: 0.02}; });
  redraw();
  return {select(id) { paintStems(id); redraw(); }};
};
