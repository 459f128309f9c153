// What eyes see of the sheet. The formulae and their order are those of tools/lentray-views/strips.cpp, so that the
// pixels are the same.

const data = JSON.parse(byId("data").textContent);
const state = { angle: data.angle, distance: data.distance, apart: data.eyes, mode: "one", factor: null };
const kArmsLength = 400;  // mm: of two eyes before a sheet for infinitely distant ones

// Which lens a column lies behind, and which strip has it.
const lensOf = new Int32Array(data.columns), stripOf = new Int32Array(data.columns);
for (let k = 0; k < data.columns; ++k) {
  lensOf[k] = Math.floor((k + 0.5) / data.pixels);
  stripOf[k] = k > 0 && lensOf[k - 1] === lensOf[k] ? stripOf[k - 1] + 1 : 0;
}

/** From a lens's axis to where it shows the print in a direction, mm. */
function offsetOf(slope) {
  if (data.is_paraxial) return slope * data.focal_length / data.ior;
  const n2 = data.ior * data.ior;
  return data.focal_length * slope / Math.sqrt(n2 + slope * slope * (n2 - 1));
}

/** The column of the print that each lens shows to an eye; -1: beyond the print. distance 0: infinite. */
function columnsSeen(angle, distance) {
  const tangent = Math.tan(angle * Math.PI / 180), out = new Int32Array(data.count);
  for (let i = 0; i < data.count; ++i) {
    const axis = (i + 0.5 - 0.5 * data.lenses) * data.pitch;
    const slope = (distance > 0 ? axis / distance : 0) - tangent;
    const print = axis + offsetOf(slope);
    const column = Math.floor((print - data.first) / data.pixel_size + 0.5);
    out[i] = column >= 0 && column < data.columns ? column : -1;
  }
  return out;
}

const strips = [];  // pixels of each, as bytes R, G, B, A in one number
async function loadStrips() {
  const canvas = document.createElement("canvas");
  canvas.width = data.count;
  canvas.height = data.rows;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  for (const link of data.strips) {
    const image = new Image();
    image.src = link;
    await image.decode();
    context.drawImage(image, 0, 0);
    strips.push(new Uint32Array(context.getImageData(0, 0, data.count, data.rows).data.buffer));
  }
}

const kBlack = new Uint32Array(new Uint8Array([0, 0, 0, 255]).buffer)[0];
/** One pixel a lens. */
function pixelsSeen(columns) {
  const out = new Uint32Array(data.count * data.rows), last = out.length;
  for (let i = 0; i < data.count; ++i) {
    if (columns[i] < 0) {
      for (let at = i; at < last; at += data.count) out[at] = kBlack;
      continue;
    }
    const strip = strips[stripOf[columns[i]]];
    for (let from = lensOf[columns[i]], at = i; at < last; at += data.count, from += data.count) out[at] = strip[from];
  }
  return out;
}

// Anaglyphs: a matrix for each eye, in linear light.
const light = Float64Array.from({ length: 256 }, (_, i) => i / 255 <= 0.04045 ? i / 255 / 12.92
  : ((i / 255 + 0.055) / 1.055) ** 2.4);
const kSteps = 65536;
let bytesOfLight = null;
function makeBytesOfLight() {
  bytesOfLight = Uint8Array.from({ length: kSteps + 1 }, (_, i) => {
    const v = i / kSteps;
    return Math.floor(255 * (v <= 0.0031308 ? v * 12.92 : 1.055 * v ** (1 / 2.4) - 0.055) + 0.5);
  });
}
function anaglyphOf(left, right) {
  if (!bytesOfLight) makeBytesOfLight();
  const [ofLeft, ofRight] = data.anaglyph, out = new Uint32Array(left.length);
  const l = new Uint8Array(left.buffer), r = new Uint8Array(right.buffer), to = new Uint8Array(out.buffer);
  for (let at = 0; at < l.length; at += 4) {
    const a = light[l[at]], b = light[l[at + 1]], c = light[l[at + 2]];
    const d = light[r[at]], e = light[r[at + 1]], f = light[r[at + 2]];
    for (let i = 0; i < 3; ++i) {
      const p = ofLeft[i], q = ofRight[i];
      const sum = p[0] * a + p[1] * b + p[2] * c + q[0] * d + q[1] * e + q[2] * f;
      to[at + i] = bytesOfLight[Math.round(kSteps * Math.min(1, Math.max(0, sum)))];
    }
    to[at + 3] = 255;
  }
  return out;
}

/** A quarter turn clockwise: of a sheet whose lenses lie across, which is on its side here. */
function upright(pixels) {
  const out = new Uint32Array(pixels.length);
  for (let row = 0, from = 0; row < data.rows; ++row) {
    for (let i = 0; i < data.count; ++i) out[i * data.rows + data.rows - 1 - row] = pixels[from++];
  }
  return out;
}

function put(canvas, pixels) {
  const [width, height] = data.is_across ? [data.rows, data.count] : [data.count, data.rows];
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  const bytes = new Uint8ClampedArray((data.is_across ? upright(pixels) : pixels).buffer);
  canvas.getContext("2d").putImageData(new ImageData(bytes, width, height), 0, 0);
}

/** The angle of an eye of two, `side` of their distance to the right of the middle between them. */
function angleOfEye(side) {
  const radian = Math.PI / 180, distance = state.distance > 0 ? state.distance : kArmsLength;
  return Math.atan(Math.tan(state.angle * radian) + side * state.apart / distance) / radian;
}
const distanceOfEyes = () => state.mode !== "one" && !(state.distance > 0) ? kArmsLength : state.distance;

/** Columns that are seen: of one eye, or of the left and the right one. */
function seenNow() {
  const angles = state.mode === "one" ? [state.angle] : [angleOfEye(-0.5), angleOfEye(0.5)];
  return angles.map((angle) => columnsSeen(angle, distanceOfEyes()));
}

function draw() {
  const seen = seenNow(), pictures = seen.map(pixelsSeen);
  if (state.mode === "crossed") pictures.reverse();
  if (state.mode === "anaglyph") {
    put(byId("first"), anaglyphOf(pictures[0], pictures[1]));
  } else {
    put(byId("first"), pictures[0]);
    if (pictures[1]) put(byId("second"), pictures[1]);
  }
  tellWhatIsSeen(seen);
}

/** The lens of the strip, beside the one that shows it; and the pixel in it. Of the lens in the middle. */
function inTheMiddle(columns) {
  const lens = Math.floor((data.count - 1) / 2), column = columns[lens];
  return column < 0 ? null : { zone: lensOf[column] - lens, pixel: stripOf[column] };
}

const [kBeyond, kBefore] = data.is_across ? [" below", " above"] : [" to the right", " to the left"];
const degrees = (angle) => `${fixed(Math.abs(angle), 1)}°` + (Math.abs(angle) < 0.05 ? "" : angle > 0 ? kBeyond : kBefore);

function tellWhatIsSeen(seen) {
  const distance = distanceOfEyes(), places = seen.map(inTheMiddle);
  const pixel = (place) => place ? `pixel ${place.pixel} of 0 to ${strips.length - 1}` : "nothing, beyond the print";
  const told = places.length === 1 ? pixel(places[0]) : `${pixel(places[0])} (left eye), ${pixel(places[1])} (right eye)`;
  byId("said").textContent = `Seen from ${degrees(state.angle)}, ` +
    `${distance > 0 ? `${+fixed(distance, 1)} mm away` : "infinitely far away"}. In the middle: ${told}.`;
  const [left, right] = places, zones = byId("zones");
  let warning = "";
  if (left && right && left.zone !== right.zone) {
    warning = "The two eyes are in two zones: in the middle of the sheet depth is reversed.";
  } else if (left && right && left.pixel === right.pixel) {
    warning = "Both eyes see the same pixels: in the middle of the sheet there is no depth.";
  }
  if (zones.textContent !== warning) zones.textContent = warning;
  zones.hidden = warning === "";
}

