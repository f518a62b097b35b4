// The panel of coverage: the snapped triangles on the grid of pixels.

// Twice the area is positive for triangles that run clockwise on the screen, as drawn ones do; the
// value is 0 on the edge and positive inside. All numbers stay below 2^53, so they are exact.
function edgesOf(triangle) {
  return triangle.edges.map((e) => {
    const from = life.corners[e.from].screen_units, to = life.corners[e.to].screen_units;
    return {...e, a: from, b: to, value: (x, y) => e.per_x * (x - from[0]) + e.per_y * (y - from[1])};
  });
}

function coverage() {
  const place = panel('coverage');
  if (life.triangles.length > 0)
    place.append(table([['triangle', 'corners', 'twice the area, square units', 'area, pixels', 'facing', 'fate'],
      ...life.triangles.map((t, i) => ['t' + i, t.corners.map((c) => 'c' + c).join(' '), grouped(t.twice_area_square_units), number(t.area_pixels, 4), t.front_face ? 'front' : 'back', t.verdict])], [5]));
  const drawn = life.triangles.filter((t) => t.edges && t.edges.length > 0).map((t) => ({...t, lines: edgesOf(t)}));
  if (drawn.length === 0) return;

  const width = 900, height = Math.round(Math.min(560, Math.max(300, width * (windowHeight + 2) / (windowWidth + 2))));
  const covered = new Map(fragments.map((f) => [f.x_pixels + ',' + f.y_pixels, f]));
  let side = Math.min(width / (windowWidth + 2), height / (windowHeight + 2));
  let left = windowRect.left - (width / side - windowWidth) / 2, top = windowRect.top - (height / side - windowHeight) / 2;
  const made = canvas(width, height, (context) => {
    const x = (pixels) => (pixels - left) * side, y = (pixels) => (pixels - top) * side;
    const firstX = Math.floor(left), firstY = Math.floor(top), lastX = Math.ceil(left + width / side), lastY = Math.ceil(top + height / side);
    // Pixels, with the centres; those on an edge have a ring that says whose they are.
    for (let py = firstY; py <= lastY; ++py)
      for (let px = firstX; px <= lastX; ++px) {
        const f = covered.get(px + ',' + py);
        if (f) {
          context.fillStyle = f.lived ? '#f6cf9c' : '#d9d9d4';
          context.fillRect(x(px), y(py), side, side);
        }
      }
    // Beyond the target there are no pixels to draw.
    context.fillStyle = '#eceef1';
    const right = x(life.frame.width_pixels), bottom = y(life.frame.height_pixels);
    context.fillRect(0, 0, Math.max(x(0), 0), height);
    context.fillRect(0, 0, width, Math.max(y(0), 0));
    context.fillRect(right, 0, Math.max(width - right, 0), height);
    context.fillRect(0, bottom, width, Math.max(height - bottom, 0));
    context.lineWidth = 1;
    for (let px = firstX; px <= lastX; ++px) { context.strokeStyle = px % 8 === 0 ? '#a9b4c6' : '#e4e5e2'; context.beginPath(); context.moveTo(x(px), 0); context.lineTo(x(px), height); context.stroke(); }
    for (let py = firstY; py <= lastY; ++py) { context.strokeStyle = py % 8 === 0 ? '#a9b4c6' : '#e4e5e2'; context.beginPath(); context.moveTo(0, y(py)); context.lineTo(width, y(py)); context.stroke(); }
    for (const t of drawn)
      for (const e of t.lines) {
        context.strokeStyle = e.owns_its_centres ? '#1f7a3a' : '#c2362b';
        context.setLineDash(e.owns_its_centres ? [] : [6, 4]);
        context.lineWidth = 2;
        context.beginPath(); context.moveTo(x(e.a[0] / 256), y(e.a[1] / 256)); context.lineTo(x(e.b[0] / 256), y(e.b[1] / 256)); context.stroke();
      }
    context.setLineDash([]);
    const dot = Math.min(3, side * 0.12);
    if (side >= 6)
      for (let py = firstY; py <= lastY; ++py)
        for (let px = firstX; px <= lastX; ++px) {
          const has = covered.has(px + ',' + py), cx = px * 256 + 128, cy = py * 256 + 128;
          context.fillStyle = has ? '#22262b' : '#b9bcc0';
          context.beginPath(); context.arc(x(px + 0.5), y(py + 0.5), dot, 0, 7); context.fill();
          for (const t of drawn) {
            const values = t.lines.map((e) => e.value(cx, cy));
            if (!values.includes(0) || values.some((v) => v < 0)) continue;
            const owned = values.every((v, k) => v > 0 || t.lines[k].owns_its_centres);
            context.strokeStyle = owned ? '#1f7a3a' : '#c2362b';
            context.lineWidth = 2;
            context.beginPath(); context.arc(x(px + 0.5), y(py + 0.5), dot + 4, 0, 7); context.stroke();
          }
        }
    context.font = '12px system-ui, sans-serif';
    life.corners.forEach((c, i) => {
      const [px, py] = c.screen_pixels;
      context.fillStyle = '#2957b8';
      context.fillRect(x(px) - 3.5, y(py) - 3.5, 7, 7);
      context.fillText('c' + i, x(px) + 7, y(py) - 6);
    });
    const place = `pixels ${Math.max(firstX, 0)}..${lastX} x ${Math.max(firstY, 0)}..${lastY}`;
    context.fillStyle = 'rgba(255, 255, 255, 0.85)';
    context.fillRect(4, 4, context.measureText(place).width + 8, 20);
    context.fillStyle = '#4b525b';
    context.fillText(place, 8, 18);
  }, {class: 'grid'});
  made.addEventListener('wheel', (e) => {
    e.preventDefault();
    const box = made.getBoundingClientRect(), mx = (e.clientX - box.left) * width / box.width, my = (e.clientY - box.top) * height / box.height;
    const wanted = Math.min(Math.max(side * Math.exp(-e.deltaY * 0.0015), 2), 200);
    left += mx / side - mx / wanted;
    top += my / side - my / wanted;
    side = wanted;
    made.redraw();
  }, {passive: false});
  let held = null;
  made.addEventListener('pointerdown', (e) => { held = [e.clientX, e.clientY]; made.setPointerCapture(e.pointerId); });
  made.addEventListener('pointermove', (e) => {
    if (held === null) return;
    left -= (e.clientX - held[0]) / side;
    top -= (e.clientY - held[1]) / side;
    held = [e.clientX, e.clientY];
    made.redraw();
  });
  made.addEventListener('pointerup', () => { held = null; });

  const whole = fragments.length === life.fates.covered;
  const shown = figure(made, 'Screen space, y down. Squares: snapped corners. Green edges are left or top ones and own the centres on them, dashed red ones do not; ' +
    'a ring marks a centre that lies on an edge, green if it is owned. Orange pixels reached the target, grey ones died in a later test; beyond the target it is light grey. Thicker lines bound blocks of 8x8.' +
    (whole ? '' : ` A window of ${windowWidth}x${windowHeight} pixels; the primitive covers ${grouped(life.fates.covered)}.`));
  shown.className = 'wide';
  place.append(shown);
  place.append(table([['edge', 'kind', 'per x', 'per y', 'centres on it', 'bounds of the triangle, pixels', 'blocks of 8x8', 'tiles of 64x64'],
    ...drawn.flatMap((t) => t.lines.map((e, k) => [`c${e.from} → c${e.to}`, e.kind, grouped(e.per_x), grouped(e.per_y), e.owns_its_centres ? 'covered' : "the neighbour's",
      k === 0 ? `${t.bounds_pixels.left}..${t.bounds_pixels.right - 1} x ${t.bounds_pixels.top}..${t.bounds_pixels.bottom - 1}` : '', k === 0 ? t.blocks : '', k === 0 ? t.tiles.length : '']))]));
}
