// What all panels share: the data, elements, numbers as text and colours, and pictures of pixels.
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const life = data.primitive, fragments = life.fragments_in_window, windowRect = life.window_pixels;
const cornerColours = ['#c2362b', '#2b7d3c', '#2957b8', '#a05a00', '#7a3fa0', '#00808a', '#8a7a00', '#b03a78', '#555555'];

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Pictures are made in the namespace that the parser gives to <svg>.
const svgNamespace = new DOMParser().parseFromString('<svg></svg>', 'text/html').body.firstChild.namespaceURI;
function svgElement(name, attributes = {}, text) {
  const made = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

const panel = (name) => document.getElementById('panel-' + name);
const number = (x, digits = 4) => x === null ? 'none' : Number(x).toFixed(digits);
const tuple = (list, digits = 4) => '(' + list.map((x) => number(x, digits)).join(', ') + ')';
const counted = (n, name) => n.toLocaleString('en-US') + ' ' + name + (n === 1 ? '' : 's');
const grouped = (x) => Number(x).toLocaleString('en-US');

function figure(content, caption) {
  return element('figure', {}, content, element('figcaption', {}, caption));
}

// rows: arrays of texts or elements; the first row is the head. words: columns of running text.
function table(rows, words = []) {
  const made = element('table');
  rows.forEach((row, r) => {
    const line = element('tr');
    row.forEach((cell, c) => line.append(element(r === 0 ? 'th' : 'td', words.includes(c) ? {class: 'words'} : {}, cell)));
    made.append(line);
  });
  return element('div', {class: 'scroll'}, made);
}

function row(...children) { return element('div', {class: 'row'}, ...children); }

// A canvas that is sharp on every screen; draw(context) uses CSS pixels.
function canvas(width, height, draw, attributes = {}) {
  const made = element('canvas', attributes), scale = window.devicePixelRatio || 1;
  made.width = width * scale;
  made.height = height * scale;
  made.style.width = width + 'px';
  const redraw = () => {
    const context = made.getContext('2d');
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    draw(context);
  };
  redraw();
  made.redraw = redraw;
  return made;
}

// Dark to light: blue, violet, red, yellow.
function heat(t) {
  const stops = [[44, 52, 132], [100, 40, 150], [178, 44, 112], [230, 88, 56], [250, 170, 50], [255, 250, 190]];
  const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1), first = Math.min(Math.floor(at), stops.length - 2);
  return 'rgb(' + [0, 1, 2].map((c) => Math.round(stops[first][c] + (stops[first + 1][c] - stops[first][c]) * (at - first))).join(',') + ')';
}

const srgbCode = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055);
function shownColour(linear) {
  const code = (x) => Math.round(life.frame.colour_format === 'rgba8' ? 255 * Math.min(Math.max(x, 0), 1) : srgbCode(Math.min(Math.max(x, 0), 1)));
  return 'rgb(' + linear.slice(0, 3).map(code).join(',') + ')';
}
const rgb = (list) => 'rgb(' + list.map((x) => Math.round(255 * Math.min(Math.max(x, 0), 1))).join(',') + ')';

const windowWidth = Math.max(windowRect.right - windowRect.left, 1), windowHeight = Math.max(windowRect.bottom - windowRect.top, 1);

// The window's fragments as squares; colourOf(fragment) is a CSS colour, or null for none.
function pixelPicture(caption, colourOf) {
  const side = Math.max(3, Math.min(28, Math.floor(340 / Math.max(windowWidth, windowHeight * 1.3))));
  return figure(canvas(windowWidth * side, windowHeight * side, (context) => {
    for (const f of fragments) {
      const colour = colourOf(f);
      if (colour === null) continue;
      context.fillStyle = colour;
      context.fillRect((f.x_pixels - windowRect.left) * side, (f.y_pixels - windowRect.top) * side, side, side);
    }
  }), caption);
}
