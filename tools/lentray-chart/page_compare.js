// Two pictures, one on top of the other up to a line that the reader moves. Follows page.js in one module and starts
// the page.

/** All that can be compared: id, name, place in data.pictures, the setting. */
const comparable = [
  ...(data.reference !== undefined ? [{ id: "reference", name: "the reference", place: data.reference }] : []),
  ...points.filter((point) => point.picture !== undefined).flatMap((point) => [
    { id: point.id, name: clean(point.label), place: point.picture, point },
    ...(point.stock !== undefined ? [{ id: "stock:" + point.id, name: "POV-Ray, " + clean(point.label),
      place: point.stock }] : [])])];
const comparableOf = (id) => comparable.find((one) => one.id === id);
const kZooms = [["fit", 0], ["1 ×", 1], ["2 ×", 2], ["4 ×", 4], ["8 ×", 8]];
let zoom = 0;

function compareFacts(one) {
  const point = one.point;
  return element("p", {}, one.name, element("small", {}, !point ? "" : [point.seconds && seconds(point.seconds),
    point.error && `error ${figure(point.error.rms)} / 255`].filter(Boolean).join(", ")));
}

function moveSplit() {
  const part = Number(byId("split").value) / 1000, [, left] = byId("rub").querySelectorAll("img");
  if (!left) return;
  left.style.clipPath = `inset(0 ${100 - 100 * part}% 0 0)`;
  byId("rub").querySelector("i").style.left = `${100 * part}%`;
  byId("split").setAttribute("aria-valuetext", `${Math.round(100 * part)} % of the width`);
}

function sizeRub() {
  const width = data.width || 640, height = data.height || 480, rub = byId("rub");
  rub.style.width = zoom ? `${width * zoom}px` : `min(100%, 70vh * ${width / height})`;
  rub.style.aspectRatio = `${width} / ${height}`;
  rub.classList.toggle("is-large", zoom > 1 || (zoom === 0 && rub.clientWidth > 1.5 * width));
  [...byId("zoom").children].forEach((button, i) => button.setAttribute("aria-pressed", String(kZooms[i][1] === zoom)));
}

function showComparison() {
  const left = comparableOf(byId("left").value), right = comparableOf(byId("right").value);
  if (!left || !right) return;
  const image = (one) => element("img", { alt: one.name, src: picture(one.place), draggable: "false" });
  byId("rub").replaceChildren(image(right), image(left), element("i", {}));
  byId("compare-facts").replaceChildren(compareFacts(left), compareFacts(right));
  moveSplit();
  Object.assign(state, { left: left.id, right: right.id });
  writeAddress();
}

/** The first that was kept is on the left, the second on the right, or else the reference. */
function compareKept() {
  const ids = kept.filter(comparableOf);
  if (byId("compare").hidden || ids.length === 0) return;
  byId("left").value = ids[0];
  if (ids[1]) byId("right").value = ids[1];
  else if (comparableOf("reference")) byId("right").value = "reference";
  showComparison();
}

function startComparison() {
  if (comparable.length < 2) return;
  byId("compare").hidden = false;
  for (const select of [byId("left"), byId("right")]) {
    select.append(...comparable.map((one) => element("option", { value: one.id }, one.name)));
    select.addEventListener("change", showComparison);
  }
  const plain = points.find((point) => point.plain), other = comparable.find((one) => one.id !== plain?.id);
  byId("left").value = (comparableOf(state.left) ?? comparableOf(plain?.id) ?? comparable.at(-1)).id;
  byId("right").value = comparableOf(state.right) ? state.right : other.id;
  for (const [name, times] of kZooms) {
    byId("zoom").append(element("button", { type: "button", onclick: () => { zoom = times; sizeRub(); } }, name));
  }
  byId("split").addEventListener("input", moveSplit);
  const rub = byId("rub"), follow = (event) => {
    const area = rub.getBoundingClientRect();
    byId("split").value = 1000 * (event.clientX - area.left) / area.width;
    moveSplit();
  };
  rub.addEventListener("pointerdown", (event) => { rub.setPointerCapture(event.pointerId); follow(event); });
  rub.addEventListener("pointermove", (event) => { if (rub.hasPointerCapture(event.pointerId)) follow(event); });
  const address = { left: state.left, right: state.right };
  showComparison();
  Object.assign(state, address);  // what the reader did not choose is not in the address
  writeAddress();
  sizeRub();
  new ResizeObserver(sizeRub).observe(byId("compare"));
}

function start() {
  const parts = new URLSearchParams(location.hash.slice(1));
  for (const key of Object.keys(defaults)) state[key] = parts.get(key) ?? defaults[key];
  if (![...byId("filters").children].some((button) => button.dataset.key === state.kind)) state.kind = defaults.kind;
  document.querySelectorAll(".chart").forEach(startChart);
  for (const button of byId("filters").children) {
    button.addEventListener("click", () => set({ kind: button.dataset.key }));
  }
  byId("search").value = state.search;
  byId("search").addEventListener("input", (event) => set({ search: event.target.value }));
  byId("settings").addEventListener("click", (event) => {
    const id = event.target.dataset?.go;
    if (!id) return;
    show(byName.get(id));
    byId("detail").scrollIntoView({ block: "nearest" });
  });
  byId("pin").addEventListener("click", () => { if (shown) keep(shown.id); });
  byId("again")?.addEventListener("click", () => location.reload());
  for (const [id, key] of [["budget", "budget"], ["limit", "error"]]) {
    byId(id).value = state[key];
    byId(id).addEventListener("input", (event) => { state[key] = event.target.value; writeAddress(); showChoice(); });
  }
  byId("choice").addEventListener("submit", (event) => event.preventDefault());
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || kept.length === 0) return;
    kept = [];
    showMarks();
  });
  const bar = document.querySelector(".bar"), isSticky = () => getComputedStyle(bar).position === "sticky";
  new ResizeObserver(() => document.documentElement.style.setProperty("--bar",
    `${isSticky() ? bar.offsetHeight : 0}px`)).observe(bar);
  startComparison();
  showFiltered();
  showChoice();
  show(points.find((point) => point.plain) ?? points[0]);
}

start();
