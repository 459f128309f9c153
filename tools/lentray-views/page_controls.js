// Angle, distance, size and what the address says of them. Follows page.js in one module.

let waiting = false;
function drawSoon() {
  if (waiting || strips.length < data.strips.length) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; draw(); });
}

function writeAddress() {
  const parts = new URLSearchParams();
  if (state.mode !== "one") parts.set("mode", state.mode);
  if (state.angle !== 0) parts.set("angle", +fixed(state.angle, 3));
  if (state.distance !== data.distance) parts.set("distance", state.distance > 0 ? state.distance : "inf");
  if (state.apart !== data.eyes) parts.set("eyes", state.apart);
  const text = parts.toString();
  try {
    history.replaceState(null, "", text ? "#" + text : location.pathname + location.search);
  } catch { /* some browsers allow few changes in a short time */ }
}
let addressTimer = 0;

const kMost = 60;  // degrees
const stage = byId("stage"), angleField = byId("angle");
function setAngle(angle) {
  state.angle = Math.min(kMost, Math.max(-kMost, angle));
  angleField.value = state.angle;
  byId("angle-text").textContent = degrees(state.angle);
  stage.setAttribute("aria-valuenow", fixed(state.angle, 1));
  stage.setAttribute("aria-valuetext", degrees(state.angle));
  clearTimeout(addressTimer);
  addressTimer = setTimeout(writeAddress, 200);
  drawSoon();
}
stage.setAttribute("aria-valuemin", -kMost);
stage.setAttribute("aria-valuemax", kMost);
angleField.addEventListener("input", () => { stopMoving(); setAngle(+angleField.value); });
angleField.setAttribute("aria-valuetext", "");

const edge = Math.min(kMost, data.viewing_angle / 2);
function stepOfKey(event) {
  const step = event.shiftKey ? 0.1 : 1;
  const [less, more] = data.is_across ? ["ArrowUp", "ArrowDown"] : ["ArrowLeft", "ArrowRight"];
  return { [less]: state.angle - step, [more]: state.angle + step, PageDown: state.angle - 5,
    PageUp: state.angle + 5, Home: -edge, End: edge, 0: 0 }[event.key];
}
stage.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const angle = stepOfKey(event), size = { "+": "more", "=": "more", "-": "less" }[event.key];
  if (angle === undefined && !size) return;
  event.preventDefault();
  if (size) return setSize(size);
  stopMoving();
  setAngle(Math.round(angle * 1000) / 1000);
});

// Where lenses lie across, eyes beside each other see the same: one is enough, and it goes up and down.
if (data.is_across) {
  byId("modes").hidden = true;
  byId("apart").parentElement.hidden = true;
  stage.style.cursor = "ns-resize";
  stage.style.touchAction = "pan-x pinch-zoom";
  stage.setAttribute("aria-orientation", "vertical");
  byId("stage-help").textContent = byId("stage-help").textContent.replace("to the side", "up or down");
}

// A drag over the stage's width, or height, goes through the viewing angle and a little more.
let drag = null;
const placeOf = (event) => data.is_across ? event.clientY : event.clientX;
stage.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  drag = { at: placeOf(event), angle: state.angle, id: event.pointerId };
  stopMoving();
});
stage.addEventListener("pointermove", (event) => {
  if (!drag || event.pointerId !== drag.id) return;
  if (!stage.hasPointerCapture(drag.id)) stage.setPointerCapture(drag.id);
  const reach = data.is_across ? stage.clientHeight : stage.clientWidth;
  setAngle(drag.angle + (placeOf(event) - drag.at) / reach * Math.min(120, 1.25 * data.viewing_angle));
});
for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, () => { drag = null; });

// Moving by itself, or with the device.
let moving = 0;
function stopMoving() {
  if (moving) cancelAnimationFrame(moving);
  moving = 0;
  byId("sway").setAttribute("aria-pressed", "false");
  stopDevice();
}
byId("front").addEventListener("click", () => { stopMoving(); setAngle(0); });
byId("sway").addEventListener("click", () => {
  if (moving) return stopMoving();
  stopMoving();
  byId("sway").setAttribute("aria-pressed", "true");
  const began = performance.now();
  const step = (now) => {
    setAngle(0.9 * edge * Math.sin((now - began) / 1000));
    moving = requestAnimationFrame(step);
  };
  moving = requestAnimationFrame(step);
});

let straight = null, deviceTimer = 0, isDevice = false;
/** Where the screen's front looks, in the axes of the earth: columns of the rotation Z(alpha) X'(beta) Y''(gamma). */
function axesOf({ alpha, beta, gamma }) {
  const [a, b, c] = [alpha || 0, beta, gamma].map((v) => v * Math.PI / 180);
  const [ca, sa, cb, sb, cc, sc] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b), Math.cos(c), Math.sin(c)];
  return { x: [ca * cc - sa * sb * sc, sa * cc + ca * sb * sc, -cb * sc], y: [-sa * cb, ca * cb, sb],
    z: [ca * sc + sa * sb * cc, sa * sc - ca * sb * cc, cb * cc] };
}
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
function onDevice(event) {
  if (event.beta === null || event.gamma === null) return;
  clearTimeout(deviceTimer);
  byId("device-said").textContent = "The angle follows the device. As it is held now counts as straight.";
  const now = axesOf(event);
  straight ||= now;
  const x = dot(now.z, straight.x), y = dot(now.z, straight.y), z = dot(now.z, straight.z);
  const turn = screen.orientation?.angle;
  // A screen turned to the right is seen from further left, one turned up from further below.
  const along = data.is_across ? { 90: x, 180: -y, 270: -x }[turn] ?? y : -({ 90: -y, 180: -x, 270: y }[turn] ?? x);
  setAngle(Math.atan2(along, z) * 180 / Math.PI);
}
function stopDevice() {
  if (!isDevice) return;
  isDevice = false;
  window.removeEventListener("deviceorientation", onDevice);
  clearTimeout(deviceTimer);
  byId("device").setAttribute("aria-pressed", "false");
  byId("device-said").textContent = "";
}
async function startDevice() {
  stopMoving();
  const device = window.DeviceOrientationEvent;
  try {
    if (typeof device.requestPermission === "function" && await device.requestPermission() !== "granted") throw 0;
  } catch {
    byId("device-said").textContent = "The browser does not allow this page to follow the device.";
    return;
  }
  straight = null;
  isDevice = true;
  byId("device").setAttribute("aria-pressed", "true");
  window.addEventListener("deviceorientation", onDevice);
  deviceTimer = setTimeout(() => {
    stopDevice();
    byId("device-said").textContent = "Nothing says how this device is held. Some browsers say it only to pages " +
      "that come by https.";
  }, 1500);
}
byId("device").hidden = !("DeviceOrientationEvent" in window);
byId("device").addEventListener("click", () => isDevice ? stopDevice() : startDevice());

// Fields of text.
function bindField(id, put, read, wants) {
  const field = byId(id);
  field.value = read();
  field.addEventListener("input", () => {
    const text = field.value.trim().replace(",", "."), number = text === "inf" && id === "distance" ? 0 : Number(text);
    const isGood = text !== "" && Number.isFinite(number) && (number > 0 || text === "inf") && number <= 1e9;
    field.setAttribute("aria-invalid", String(!isGood));
    byId("field-said").textContent = isGood ? "" : wants;
    if (!isGood) return;
    put(number);
    writeAddress();
    drawSoon();
  });
}

// Size. The screen's pixels a millimetre are kept in the browser, for all previews.
const kCssPixels = 96 / 25.4, kKept = "lentray pixels a millimetre";
let scale = kCssPixels, isMatched = false;
try {
  const kept = Number(localStorage.getItem(kKept));
  if (kept >= 2.5 && kept <= 12) { scale = kept; isMatched = true; }
} catch { /* a browser that keeps nothing */ }

function layOut() {
  const across = data.count * data.pitch, along = data.height_mm;
  const [width, height] = data.is_across ? [along, across] : [across, along];
  const pictures = state.mode === "pair" || state.mode === "crossed" ? 2 : 1;
  const room = (stage.clientWidth - 20 - 12 * (pictures - 1)) / pictures;
  const fit = Math.min(room / width, Math.max(160, 0.72 * window.innerHeight) / height);
  const pixels = state.factor === null ? fit : scale * state.factor;
  for (const canvas of [byId("first"), byId("second")]) {
    canvas.style.width = `${width * pixels}px`;
    canvas.style.height = `${height * pixels}px`;
  }
  byId("card").style.width = `${scale * byId("side").value}px`;
  byId("scale-said").textContent = `${fixed(scale, 2)} pixels of this page are a millimetre` +
    `${isMatched ? "" : ", which is a guess"}. The sheet is shown ${fixed(pixels / scale, 2)} times as large as it is.`;
  for (const button of byId("sizes").querySelectorAll("[aria-pressed]")) {
    button.setAttribute("aria-pressed", String(button.dataset.size === "fit" ? state.factor === null
      : state.factor === 1));
  }
  return pixels / scale;
}
function setSize(size) {
  const step = 1.25, now = layOut();
  if (size === "fit") state.factor = null;
  else if (size === "true") state.factor = 1;
  else state.factor = Math.min(50, Math.max(0.02, size === "more" ? now * step : now / step));
  layOut();
}
byId("sizes").addEventListener("click", (event) => {
  const button = event.target.closest("button");
  if (button) setSize(button.dataset.size);
});
byId("scale").value = scale;
byId("scale").addEventListener("input", () => {
  scale = +byId("scale").value;
  isMatched = true;
  try { localStorage.setItem(kKept, scale); } catch { /* it is asked for again next time */ }
  layOut();
});
byId("side").value = window.innerWidth < 620 ? "53.98" : "85.60";
byId("side").addEventListener("change", layOut);
window.addEventListener("resize", layOut);
byId("lenses").addEventListener("change", () => byId("sheets").classList.toggle("shows-lenses", byId("lenses").checked));

const kNames = { one: ["", ""], pair: ["left eye", "right eye"], crossed: ["right eye", "left eye"],
  anaglyph: ["red: left eye, cyan: right eye", ""] };
function setMode(mode) {
  state.mode = mode;
  for (const button of byId("modes").children) {
    button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
  }
  byId("first-name").textContent = kNames[mode][0];
  byId("second-name").textContent = kNames[mode][1];
  byId("second-figure").hidden = mode !== "pair" && mode !== "crossed";
  layOut();
  writeAddress();
  drawSoon();
}
byId("modes").addEventListener("click", (event) => {
  const button = event.target.closest("button");
  if (button) setMode(button.dataset.mode);
});

function readAddress() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const positive = (name, otherwise) => Number(parts.get(name)) > 0 ? Number(parts.get(name)) : otherwise;
  state.distance = parts.get("distance") === "inf" ? 0 : positive("distance", data.distance);
  state.apart = positive("eyes", data.eyes);
  const angle = Number(parts.get("angle") ?? data.angle);
  const mode = data.is_across || !(parts.get("mode") in kNames) ? "one" : parts.get("mode");
  return { mode, angle: Number.isFinite(angle) ? angle : 0 };
}
const wanted = readAddress();
bindField("distance", (v) => { state.distance = v; }, () => state.distance > 0 ? state.distance : "inf",
  "A distance in mm greater than 0 is expected, or inf.");
bindField("apart", (v) => { state.apart = v; }, () => state.apart, "A distance in mm greater than 0 is expected.");
setAngle(wanted.angle);
setMode(wanted.mode);
loadStrips().then(() => { draw(); layOut(); document.body.dataset.ready = "yes"; }, () => {
  byId("said").textContent = "This browser cannot show the pictures of this page.";
});
