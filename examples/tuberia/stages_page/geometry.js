// Panels of the geometry stages: the view from outside, clip space, NDC.

const transformed = (rows, p) => rows.slice(0, 3).map((r) => r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3]);

function outsideView() {
  const scene = data.scene, toView = (p) => transformed(scene.view_from_world, p);
  const frustum = scene.frustum_world.map(toView), triangle = scene.primitive_world.map(toView);
  const model = [];
  for (let i = 0; i < scene.triangles_world.length; i += 9)
    model.push([0, 3, 6].map((k) => toView(scene.triangles_world.slice(i + k, i + k + 3))));
  const all = [[0, 0, 0], ...frustum, ...triangle], low = [0, 1, 2].map((c) => Math.min(...all.map((p) => p[c])));
  const high = [0, 1, 2].map((c) => Math.max(...all.map((p) => p[c]))), middle = low.map((x, c) => (x + high[c]) / 2);
  const width = 620, height = 400;
  let yaw = -0.95, pitch = 0.42;
  const project = (p) => {
    const [x, y, z] = p.map((v, c) => v - middle[c]);
    const rx = Math.cos(yaw) * x - Math.sin(yaw) * z, rz = Math.sin(yaw) * x + Math.cos(yaw) * z;
    return [rx, Math.cos(pitch) * y - Math.sin(pitch) * rz];
  };
  const made = canvas(width, height, (context) => {
    const seen = all.map(project), extent = Math.max(...seen.map((p) => Math.max(Math.abs(p[0]) / width, Math.abs(p[1]) / height))) * 2.08 || 1;
    const place = (p) => { const [x, y] = project(p); return [width / 2 + x / extent, height / 2 - y / extent]; };
    const path = (points, close = true) => {
      context.beginPath();
      points.map(place).forEach(([x, y], i) => i === 0 ? context.moveTo(x, y) : context.lineTo(x, y));
      if (close) context.closePath();
    };
    context.lineWidth = 0.5;
    context.strokeStyle = 'rgba(70, 80, 95, 0.35)';
    for (const corners of model) { path(corners); context.stroke(); }
    context.lineWidth = 1.2;
    context.strokeStyle = '#2957b8';
    for (let i = 0; i < 4; ++i) {
      path([frustum[i], frustum[(i + 1) % 4], frustum[4 + (i + 1) % 4], frustum[4 + i]]);
      context.stroke();
    }
    context.fillStyle = 'rgba(41, 87, 184, 0.12)';
    path(frustum.slice(0, 4)); context.fill();
    context.setLineDash([4, 4]);
    for (let i = 0; i < 4; ++i) { path([[0, 0, 0], frustum[i]], false); context.stroke(); }
    context.setLineDash([]);
    if (triangle.length < 3) return;
    context.fillStyle = 'rgba(214, 120, 20, 0.55)';
    context.strokeStyle = '#b04a00';
    context.lineWidth = 2;
    path(triangle); context.fill(); context.stroke();
    context.font = '12px system-ui, sans-serif';
    const label = (text, p, colour) => { const [x, y] = place(p); context.fillStyle = colour; context.fillRect(x - 2.5, y - 2.5, 5, 5); context.fillText(text, x + 6, y - 5); };
    // Corners of a small triangle would only hide each other.
    const [a, b, c] = triangle.map(place), large = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) > 600;
    if (large) triangle.forEach((p, i) => label('v' + i, p, '#b04a00'));
    else label('the primitive', triangle[0], '#b04a00');
    label('eye', [0, 0, 0], '#22262b');
  }, {class: 'grid'});
  let held = null;
  made.addEventListener('pointerdown', (e) => { held = [e.clientX, e.clientY]; made.setPointerCapture(e.pointerId); });
  made.addEventListener('pointermove', (e) => {
    if (held === null) return;
    yaw += (e.clientX - held[0]) * 0.01;
    pitch = Math.min(Math.max(pitch + (e.clientY - held[1]) * 0.01, -1.5), 1.5);
    held = [e.clientX, e.clientY];
    made.redraw();
  });
  made.addEventListener('pointerup', () => { held = null; });
  const shown = scene.triangles_shown < scene.triangles_all ? ` (every ${Math.ceil(scene.triangles_all / scene.triangles_shown)}th triangle of the model is drawn)` : '';
  panel('view').append(row(figure(made, 'World space from outside: the eye, the view frustum (near plane tinted) and the primitive' + shown + '.')),
    table([['vertex', 'object x, y, z', 'clip x, y, z, w', 'beyond the borders of the view', 'outside of (is cut)'],
           ...life.vertices.map((v, i) => [`v${i} (#${v.number_in_mesh})`, v.object ? tuple(v.object) : 'none', tuple(v.clip), v.beyond_view_borders, v.outside_of])], [3, 4]));
}

// A picture of clip space with one coordinate to the right and w upwards. lines: {slope, name}: coordinate = slope w.
function clipPicture(axis, name, lines) {
  const width = 460, height = 320, margin = 34;
  const before = life.vertices.map((v) => [v.clip[axis], v.clip[3]]), after = life.corners.map((c) => [c.clip[axis], c.clip[3]]);
  const all = [[0, 0], ...before, ...after], w = all.map((p) => p[1]), highW = Math.max(...w, 0.1) * 1.12, lowW = Math.min(...w, 0) * 1.12 - highW * 0.06;
  const reach = Math.max(...all.map((p) => Math.abs(p[0])), highW * 0.6) * 1.12;
  const x = (v) => width / 2 + v / reach * (width / 2 - margin), y = (v) => height - margin - (v - lowW) / (highW - lowW) * (height - 2 * margin);
  const picture = svgElement('svg', {viewBox: `0 0 ${width} ${height}`, width, height});
  const polygon = (points, attributes) => picture.append(svgElement('polygon', {points: points.map((p) => x(p[0]) + ',' + y(p[1])).join(' '), ...attributes}));
  const slopes = lines.map((l) => l.slope);
  polygon([[0, 0], [Math.min(...slopes) * highW, highW], [Math.max(...slopes) * highW, highW]], {fill: '#2957b8', 'fill-opacity': 0.07});
  const line = (a, b, attributes) => picture.append(svgElement('line', {x1: x(a[0]), y1: y(a[1]), x2: x(b[0]), y2: y(b[1]), ...attributes}));
  line([-reach, 0], [reach, 0], {stroke: '#b9bcc0'});
  line([0, lowW], [0, highW], {stroke: '#b9bcc0'});
  for (const l of lines) {
    line([0, 0], [l.slope * highW, highW], {stroke: '#2957b8', 'stroke-width': 1.4});
    const up = 0.62 * Math.min(highW, l.slope === 0 ? highW : reach / Math.abs(l.slope));
    picture.append(svgElement('text', {x: x(l.slope * up) + (l.slope < 0 ? -7 : 7), y: y(up) + 8, 'text-anchor': l.slope < 0 ? 'end' : 'start', class: 'plane'}, l.name));
  }
  polygon(before, {fill: 'none', stroke: '#6b727b', 'stroke-dasharray': '5 4'});
  if (after.length > 0) polygon(after, {fill: '#d67814', 'fill-opacity': 0.4, stroke: '#b04a00', 'stroke-width': 1.6});
  const spread = Math.max(...before.map((p) => Math.hypot(x(p[0]) - x(before[0][0]), y(p[1]) - y(before[0][1]))));
  if (spread < 30) picture.append(svgElement('circle', {cx: x(before[0][0]), cy: y(before[0][1]), r: 3.5, fill: '#b04a00'}));
  before.forEach((p, i) => {
    if (spread >= 30 || i === 0) picture.append(svgElement('text', {x: x(p[0]) + 6, y: y(p[1]) + 14}, spread < 30 ? 'the primitive' : 'v' + i));
  });
  life.corners.forEach((c, i) => {
    if (!c.made_by_clipping) return;
    picture.append(svgElement('circle', {cx: x(c.clip[axis]), cy: y(c.clip[3]), r: 3.5, fill: '#b04a00'}));
    picture.append(svgElement('text', {x: x(c.clip[axis]) - 20, y: y(c.clip[3]) + 4}, 'c' + i));
  });
  picture.append(svgElement('text', {x: width - 14, y: y(0) - 5, 'text-anchor': 'end', class: 'quiet'}, name));
  picture.append(svgElement('text', {x: x(0) + 5, y: 13, class: 'quiet'}, 'clip w'));
  return picture;
}

function clipSpace() {
  const low = life.clip_limits.z_low;
  panel('clip').append(element('p', {}, 'Clipping: ' + life.clipping + '.'), row(
    figure(clipPicture(0, 'clip x', [{slope: -1, name: 'x = -w'}, {slope: 1, name: 'x = w'}]),
           `Clip x and w. Between the lines is what the view shows; x is cut only at the guard band, |x| = ${number(life.clip_limits.guard_x, 1)} w.`),
    figure(clipPicture(2, 'clip z', [{slope: low, name: low === 0 ? 'z = 0 (near)' : 'z = -w (near)'}, {slope: 1, name: 'z = w (far)'}]),
           'Clip z and w. Dashed: the primitive as it came; orange: what is left.')));
  if (life.corners.length > 0)
    panel('clip').append(table([['corner', 'clip x, y, z, w', 'weights of v0, v1, v2', ''],
      ...life.corners.map((c, i) => ['c' + i, tuple(c.clip), tuple(c.weights_of_vertices), c.made_by_clipping ? 'made by clipping' : 'a vertex'])]));
}

function ndcSpace() {
  if (life.corners.length === 0) return panel('ndc').append(element('p', {}, 'Nothing of the primitive came this far.'));
  const size = 400, points = life.corners.map((c) => c.ndc), largest = Math.max(...points.flatMap((p) => [Math.abs(p[0]), Math.abs(p[1])]));
  const reach = Math.min(Math.max(1.15, largest * 1.1), 6), at = (v) => size / 2 + v / reach * size / 2;
  const picture = svgElement('svg', {viewBox: `0 0 ${size} ${size}`, width: size, height: size});
  picture.append(svgElement('rect', {x: at(-1), y: at(-1), width: at(1) - at(-1), height: at(1) - at(-1), fill: '#2957b8', 'fill-opacity': 0.07, stroke: '#2957b8'}));
  for (const p of [[0, reach], [reach, 0]]) picture.append(svgElement('line', {x1: at(-p[0]), y1: at(p[1]), x2: at(p[0]), y2: at(-p[1]), stroke: '#d8dade'}));
  picture.append(svgElement('polygon', {points: points.map((p) => at(p[0]) + ',' + at(-p[1])).join(' '), fill: '#d67814', 'fill-opacity': 0.4, stroke: '#b04a00', 'stroke-width': 1.6}));
  const spread = Math.max(...points.map((p) => Math.hypot(p[0] - points[0][0], p[1] - points[0][1]))) / reach * size / 2;
  points.forEach((p, i) => {
    if (Math.abs(p[0]) > reach || Math.abs(p[1]) > reach || (spread < 30 && i > 0)) return;
    picture.append(svgElement('circle', {cx: at(p[0]), cy: at(-p[1]), r: 3, fill: '#b04a00'}),
                   svgElement('text', {x: at(p[0]) + (p[0] > reach * 0.7 ? -22 : 6), y: at(-p[1]) - 6}, spread < 30 ? 'the primitive' : 'c' + i));
  });
  picture.append(svgElement('text', {x: at(-1) + 5, y: at(-1) + 15, class: 'quiet'}, '(-1, 1)'), svgElement('text', {x: at(1) - 5, y: at(1) - 6, 'text-anchor': 'end', class: 'quiet'}, '(1, -1)'));
  const v = life.viewport_pixels;
  panel('ndc').append(row(figure(picture, `NDC, x right and y up; the square is what the viewport of ${v.width}x${v.height} pixels at (${v.x}, ${v.y}) shows.`),
    table([['corner', 'NDC x, y, z', 'screen, pixels', 'screen, units of 1/256', 'depth'],
           ...life.corners.map((c, i) => ['c' + i, tuple(c.ndc), tuple(c.screen_pixels, 3), tuple(c.screen_units, 0), number(c.depth_screen, 7)])])));
}
