// Panels of the fragment stages, and of the whole frame.

const cornerOfSlot = new Map(life.corners.map((c) => [c.slot, c]));

function attributeAt(f, name) {
  const values = f.slots.map((slot) => cornerOfSlot.get(slot)?.attributes[name]);
  if (values.some((v) => v === undefined)) return null;
  return values[0].map((_, i) => values.reduce((sum, v, k) => sum + f.weights_perspective[k] * v[i], 0));
}

// How an attribute is shown as a colour.
function attributeColour(name, value, low, high) {
  if (name.startsWith('normal')) return rgb(value.map((x) => x * 0.5 + 0.5));
  if (name.startsWith('texcoord')) return rgb([value[0] - Math.floor(value[0]), value[1] - Math.floor(value[1]), 0]);
  if (name.startsWith('colour')) return shownColour(value);
  return rgb([0, 1, 2].map((i) => high[i] > low[i] ? (value[i] - low[i]) / (high[i] - low[i]) : 0.5));
}

function weights() {
  const place = panel('weights');
  if (fragments.length === 0) return place.append(element('p', {}, 'No fragment came this far.'));
  const pictures = [pixelPicture('Screen weights of the three corners of each triangle as red, green and blue.', (f) => rgb(f.weights_screen)),
                    pixelPicture('The same corrected with 1/w: what attributes are interpolated with.', (f) => rgb(f.weights_perspective))];
  const names = Object.keys(life.corners.find((c) => Object.keys(c.attributes).length > 0)?.attributes ?? {});
  for (const name of names) {
    const values = fragments.map((f) => attributeAt(f, name)).filter((v) => v !== null);
    if (values.length === 0) continue;
    const low = values[0].map((_, i) => Math.min(...values.map((v) => v[i]))), high = values[0].map((_, i) => Math.max(...values.map((v) => v[i])));
    pictures.push(pixelPicture(`${name}, interpolated: ${tuple(low, 3)} to ${tuple(high, 3)}`, (f) => { const v = attributeAt(f, name); return v && attributeColour(name, v, low, high); }));
  }
  place.append(row(...pictures));
  if (names.length > 0)
    place.append(table([['corner', ...names], ...life.corners.map((c, i) => ['c' + i, ...names.map((n) => c.attributes[n] ? tuple(c.attributes[n]) : 'not computed')])]));
  place.append(table([['first fragments: pixel', 'screen weights', 'with perspective', 'depth (screen)'],
    ...fragments.slice(0, 4).map((f) => [tuple([f.x_pixels, f.y_pixels], 0), tuple(f.weights_screen, 6), tuple(f.weights_perspective, 6), number(f.samples[0].depth_screen, 7)])]));
}

const first = (f) => f.samples[0];

function depth() {
  const place = panel('depth');
  if (fragments.length === 0) return place.append(element('p', {}, 'No fragment came this far.'));
  const coded = fragments.filter((f) => first(f).depth_code !== null).map((f) => first(f).depth_code);
  const cleared = data.cleared_depth_code, stored = fragments.map((f) => first(f).before.depth_code).filter((c) => c !== cleared);
  const low = Math.min(...coded, ...stored), high = Math.max(...coded, ...stored);
  const colour = (code) => code === null ? null : code === cleared ? '#e4e5e2' : heat(high > low ? (code - low) / (high - low) : 0.5);
  const fates = life.fates;
  place.append(element('p', {}, `${grouped(fates.covered)} fragments: ${grouped(fates.discarded)} discarded by the program, ${grouped(fates.failed_alpha)} failed the alpha test, ` +
      `${grouped(fates.failed_depth)} the stencil or depth test, ${grouped(fates.reached)} reached the target. The test: new code ${life.state.depth_test} stored code` +
      (life.state.depth_write ? '.' : '; depths are not written.')),
    row(pixelPicture(`Stored codes before; grey: still cleared (${grouped(cleared)}).`, (f) => colour(first(f).before.depth_code)),
        pixelPicture(`New codes, ${grouped(low)} (dark) to ${grouped(high)} (light), ${life.frame.depth_format}.`, (f) => colour(first(f).depth_code)),
        pixelPicture('Stored codes after.', (f) => colour(first(f).after.depth_code)),
        pixelPicture('Who lived (green) and who died (red) at any test.', (f) => f.lived ? '#4a9a5c' : '#c2362b')));
  if (first(fragments[0]).before.stencil !== undefined)
    place.append(row(pixelPicture('Stencil before, 0 (dark) to 255 (light).', (f) => heat(first(f).before.stencil / 255)),
                     pixelPicture('Stencil after.', (f) => heat(first(f).after.stencil / 255))));
}

function colours() {
  const place = panel('colour');
  if (fragments.length === 0) return place.append(element('p', {}, 'No fragment came this far.'));
  place.append(row(pixelPicture('The pixels before.', (f) => shownColour(first(f).before.colour_linear)),
                   pixelPicture("The fragments' colours; hidden ones may not have been shaded.", (f) => f.colour_program_linear && shownColour(f.colour_program_linear)),
                   pixelPicture('The pixels after.', (f) => shownColour(first(f).after.colour_linear))),
    table([['first fragments: pixel', 'program (linear)', 'pixel before (linear)', 'pixel after (linear)', 'codes after', 'fate'],
      ...fragments.slice(0, 4).map((f) => [tuple([f.x_pixels, f.y_pixels], 0), f.colour_program_linear ? tuple(f.colour_program_linear) : 'not shaded',
        tuple(first(f).before.colour_linear), tuple(first(f).after.colour_linear), first(f).after.colour_codes ? first(f).after.colour_codes.join(' ') : '', first(f).fate])], [5]));
}

function pixelHistory() {
  const pixel = data.pixel, place = panel('pixel');
  if (!pixel) return place.remove();
  const swatch = (linear) => element('span', {}, element('span', {class: 'swatch', style: 'background:' + (linear ? shownColour(linear) : 'none')}), linear ? tuple(linear) : 'not shaded');
  const rows = [['', 'primitive', 'program', 'colour (linear)', 'depth code', 'stored before', 'fate', 'pixel after (linear)'],
    ['cleared', '', '', '', '', grouped(pixel.cleared_to[0].depth_code), '', swatch(pixel.cleared_to[0].colour_linear)]];
  pixel.fragments.forEach((f, i) => rows.push([String(i), `${f.primitive} of draw ${f.draw}`, pixel.draws[f.draw].program, swatch(f.colour_program_linear),
    first(f).depth_code === null ? 'not compared' : grouped(first(f).depth_code), grouped(first(f).before.depth_code), first(f).fate, swatch(first(f).after.colour_linear)]));
  place.append(element('p', {}, `Pixel (${pixel.x_pixels}, ${pixel.y_pixels}): ${counted(pixel.fragments.length, 'fragment')} of ${counted(pixel.draws.length, 'draw')}.`), table(rows, [6]));
}

function wholeFrame() {
  const small = life.frame.width_pixels < 200;
  panel('frame').append(row(...data.maps.map((m) => {
    const image = element('img', {src: m.picture, alt: m.title, width: 352});
    if (small) image.className = 'pixelated';
    return figure(image, element('span', {}, element('strong', {}, m.title + '. '), m.legend));
  })));
}

const primitive = life.primitive_of_frame;
document.getElementById('summary').textContent = `${life.frame.caption}: primitive ${grouped(primitive)} of ${grouped(life.frame.primitives)} in the frame ` +
  `(number ${grouped(life.primitive_of_draw)} of draw ${life.draw}${life.mesh ? `, mesh '${life.mesh}'` : ''}), program '${life.state.program}', target of ` +
  `${life.frame.width_pixels}x${life.frame.height_pixels} pixels, ${life.frame.colour_format}, ${life.frame.depth_format}.`;
for (const show of [outsideView, clipSpace, ndcSpace, coverage, weights, depth, colours, pixelHistory, wholeFrame]) show();
