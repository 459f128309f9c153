// The page of a batch: its headline, its cards, what is shown of them. The script that pages share comes before it in
// one module; page_detail.js follows and starts it.
// Keys of the data are those of page_data.cpp.

const data = JSON.parse(document.getElementById("data").textContent);
const rows = data.rows, cards = data.cards, summary = data.summary;

const kGrades = ["exact", "match", "noise", "close", "differs", "fails"];

// The headline.

function showGrades() {
  const total = kGrades.reduce((sum, grade) => sum + (summary.grades[grade] || 0), 0);
  if (total === 0) return;
  const there = kGrades.filter((grade) => summary.grades[grade]);
  const words = there.map((grade) => `${summary.grades[grade]} ${grade}`);
  const label = "Grades against stock: " + words.join(", ");
  const stack = element("div", { class: "stack", role: "img", "aria-label": label });
  const legend = element("ul", { class: "legend" });
  there.forEach((grade, i) => {
    const part = element("span", { class: "fill-" + grade });
    part.style.flexGrow = summary.grades[grade] / total;
    stack.append(part);
    legend.append(element("li", {}, element("i", { class: "fill-" + grade }), words[i]));
  });
  byId("grades").append(stack, legend);
  byId("grades").hidden = false;
}

function showHead() {
  byId("title").textContent = clean(data.title);
  const made = `${summary.made} of ${summary.expected} pictures`;
  const state = { finished: "Finished.", running: `Still running: ${made} so far.`,
    stopped: `Stopped: ${made} so far. The same command makes the others.` }[summary.stage];
  const cut = summary.all_rows > rows.length
    ? ` The page has room for ${rows.length} of ${summary.all_rows} rows; the manifest has all.` : "";
  byId("status").append(`${many(summary.cards, "scene")}` +
    (rows.length > summary.cards ? `, ${many(rows.length, "picture")}` : "") + `. ${state}${cut}` +
    (summary.kinds_text ? ` ${summary.kinds_text}.` : "") +
    (summary.restricted ? " Scenes were taken for strangers' (Restrict_IO=On)." : " Scenes might read all files (Restrict_IO=Off)."));
  if (summary.stage === "running") {
    byId("status").append(" ", element("button", { type: "button", class: "plain", onclick: () => location.reload() },
        "Load again"));
  }
  const tiles = byId("tiles");
  tiles.append(tileOf("done", summary.done));
  if (summary.failed) tiles.append(tileOf("failed", summary.failed, "is-bad"));
  if (summary.skipped) tiles.append(tileOf("skipped", summary.skipped));
  if (summary.waiting) tiles.append(tileOf("not rendered yet", summary.waiting));
  if (summary.warned) tiles.append(tileOf("with warnings", summary.warned, "is-warn"));
  if (summary.wall) tiles.append(tileOf("in all", seconds(summary.wall)));
  if (summary.cpu) tiles.append(tileOf("processor time", seconds(summary.cpu)));
  if (summary.memory) tiles.append(tileOf("memory at most", bytes(summary.memory)));
  if (summary.median_ratio) tiles.append(tileOf("stock's time over ours, median", times(summary.median_ratio)));
  showGrades();
}

// What is shown, from the page's address: #filter=…&sort=…&search=…&scene=…&frame=…

function capital(word) { return word[0].toUpperCase() + word.slice(1); }

const kFilters = [
  ["all", "All", () => true, summary.cards],
  ["failed", "Failed", (card) => card.state === "failed", summary.failed],
  ["skipped", "Skipped", (card) => card.state === "skipped", summary.skipped],
  ["waiting", "Waiting", (card) => card.state === "waiting", summary.waiting],
  ["warned", "Warned", (card) => card.warnings > 0, summary.warned],
  ...Object.entries(summary.kinds).map(([kind, count]) => [kind, capital(kind), (card) => card.kinds?.[kind], count]),
  ["slow", "Slow", (card) => card.slow, summary.slow],
  ["differs", "Differs", (card) => card.differs, summary.differing],
].filter(([key]) => (key !== "differs" || summary.compared) && (key !== "waiting" || summary.waiting));

const nameOrder = (a, b) => a.name.localeCompare(b.name, undefined, { numeric: true });
const kSorts = [
  ["batch", "as in the batch", (a, b) => a.place - b.place],
  ["name", "by name", nameOrder],
  ["time", "slowest first", (a, b) => (b.time || 0) - (a.time || 0) || a.place - b.place],
  ["grade", "worst grade first", (a, b) => kGrades.indexOf(b.grade) - kGrades.indexOf(a.grade) || a.place - b.place],
  ["ratio", "least ahead of stock first", (a, b) => (a.ratio ?? Infinity) - (b.ratio ?? Infinity) || a.place - b.place],
].filter(([key]) => summary.compared || (key !== "grade" && key !== "ratio"));

const state = { filter: "all", sort: "batch", search: "", scene: "", frame: "" };
const defaults = { ...state };
let visible = [];  // cards, in the order shown

function addressOf(values) {
  const parts = new URLSearchParams();
  for (const key of Object.keys(defaults)) if (values[key] !== defaults[key]) parts.set(key, values[key]);
  const text = parts.toString();
  return "#" + text;
}
function readAddress() {
  const parts = new URLSearchParams(location.hash.slice(1));
  for (const key of Object.keys(defaults)) state[key] = parts.get(key) ?? defaults[key];
  if (!kFilters.some(([key]) => key === state.filter)) state.filter = defaults.filter;
  if (!kSorts.some(([key]) => key === state.sort)) state.sort = defaults.sort;
}
function writeAddress(isStep) {
  const address = addressOf(state);
  if (address === (location.hash || "#")) return;
  try {
    history[isStep ? "pushState" : "replaceState"](null, "", address);
  } catch {
    location.hash = address;
  }
}

// Cards.

cards.forEach((card, place) => {
  card.place = place;
  card.list = card.rows.map((i) => rows[i]);
  card.frames = card.animation ? card.list.filter((row) => row.picture) : [];
  card.row = card.list.find((row) => row.state === card.state && (row.picture || row.state !== "done")) || card.list[0];
  card.text = [card.name, ...card.list.flatMap((row) => [row.source, row.reason, row.problem, ...(row.left_out || []),
    ...(row.messages || [])])].filter(Boolean).join("\n").toLowerCase();
});

const seen = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (!entry.isIntersecting) continue;
    seen.unobserve(entry.target);
    entry.target.src = entry.target.source;
  }
}, { rootMargin: "800px" });

function proportion(row) { return row.width && row.height ? row.width / row.height : 4 / 3; }

/** A box with the picture's proportions, `most` high at most. */
function frameOf(row, image, within) {
  const box = element("div", { class: "frame" }, image);
  box.style.aspectRatio = String(proportion(row));
  if (within) {  // as wide as its height allows
    box.style.width = `min(100%, ${within} * ${proportion(row)})`;
  }
  return box;
}

function instead(row) {
  let [head, text] = ["No small picture", row.href ? "The link leads to the picture." : ""];
  if (row.problem) [head, text] = ["No picture to show", row.problem];
  if (row.state === "failed") [head, text] = ["Failed", row.reason];
  if (row.state === "skipped") [head, text] = ["Skipped", row.reason];
  if (row.state === "waiting") [head, text] = ["Waiting", row.reason];
  return element("div", { class: "instead" }, element("strong", {}, head), clean(text || ""));
}

function badge(text, kind, title) {
  return element("span", { class: "badge " + (kind || ""), title: title || text }, text);
}

function badgesOf(card) {
  const all = [];
  if (card.grade) all.push(badge(card.grade, "is-" + card.grade));
  if (card.ratio) all.push(badge(times(card.ratio)));
  if (card.state === "failed") all.push(badge("failed", "is-failure"));
  if (card.state === "skipped") all.push(badge("skipped"));
  if (card.state === "waiting") all.push(badge("waiting"));
  for (const [kind, text] of Object.entries(card.kinds || {})) all.push(badge(kind, "is-warning", clean(text)));
  if (card.others) all.push(badge(many(card.others, "warning"), "is-warning"));
  if (card.left_out) {
    const what = [...new Set(card.list.flatMap((row) => row.left_out || []))];
    all.push(badge("left out: " + clean(what.join(", ")), "is-warning"));
  }
  if (card.slow) all.push(badge("slow"));
  return all;
}

function smallPicture(card, row) {
  const image = element("img", { alt: "", draggable: "false", decoding: "async" });
  if (row.picture) image.source = jpeg(row.picture);
  else if (row.shown && !row.problem && !row.lens_pixels) image.source = row.href;
  else return instead(row);
  image.addEventListener("error", () => {
    image.closest(".frame")?.replaceWith(instead({ ...row, problem: "It cannot be shown." }));
  });
  seen.observe(image);
  card.image = image;
  const box = frameOf(row, image);
  if (proportion(row) < 4 / 3) { box.style.width = "auto"; box.style.height = "100%"; }
  if (row.tilt) tiltable(box, row);
  return box;
}

/** The folder stands over the name. */
function captionOf(card) {
  const cut = card.name.lastIndexOf("/") + 1;
  return element("div", { class: "caption", title: clean(card.name) },
    element("span", { class: "folder" }, clean(card.name.slice(0, cut))),
    element("span", { class: "name" }, clean(card.name.slice(cut))),
    element("span", { class: "time" }, card.time ? seconds(card.time) : ""));
}

function makeCard(card) {
  const row = card.animation && card.frames.length && card.state !== "failed" ? card.frames[0] : card.row;
  const picture = element("div", { class: "picture" }, smallPicture(card, row));
  if (row.tilt) picture.append(element("span", { class: "mark" }, "tilt"));
  else if (card.animation) picture.append(element("span", { class: "mark" }, many(card.rows.length, "frame")));
  const open = element("a", { class: "open", href: addressOf({ ...defaults, scene: card.name }), draggable: "false",
    onclick: (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      openCard(card);
    } },
    picture, captionOf(card));
  card.element = element("article", { class: `card is-${card.state}` }, open);
  if (card.animation && card.frames.length > 1 && card.image) {
    card.element.append(player(card.frames, (frame) => { card.image.src = card.image.source = jpeg(frame.picture); }));
  }
  card.element.append(element("div", { class: "badges" }, ...badgesOf(card)));
}

// Animations: a slider over the frames that have small pictures, and a button that plays them.

function player(frames, show, first = 0) {
  const slider = element("input", { type: "range", min: 0, max: frames.length - 1, value: first,
      "aria-label": "Frame" });
  const number = element("span", {}, "");
  let timer = 0;
  const go = (i) => {
    slider.value = i;
    number.textContent = frames[i].frame;
    slider.setAttribute("aria-valuetext", `frame ${frames[i].frame}`);
    show(frames[i], i);
  };
  const play = element("button", { type: "button", "aria-label": "Play", onclick: () => toggle(!timer) }, "▶");
  const toggle = (on) => {
    clearInterval(timer);
    const next = () => play.isConnected ? go((Number(slider.value) + 1) % frames.length) : toggle(false);
    timer = on ? setInterval(next, 100) : 0;
    play.textContent = timer ? "❚❚" : "▶";
    play.setAttribute("aria-label", timer ? "Pause" : "Play");
  };
  slider.addEventListener("input", () => { toggle(false); go(Number(slider.value)); });
  number.textContent = frames[first].frame;
  return element("div", { class: "frames" }, play, slider, number);
}

// Filters, order, search.

function showCards() {
  const fits = kFilters.find(([key]) => key === state.filter)[2];
  const order = kSorts.find(([key]) => key === state.sort)[2];
  const words = state.search.toLowerCase().split(/\s+/).filter(Boolean);
  visible = cards.filter((card) => fits(card) && words.every((word) => card.text.includes(word))).sort(order);
  const shown = new Set(visible);
  for (const card of cards) card.element.hidden = !shown.has(card);
  byId("cards").append(...visible.map((card) => card.element));
  byId("none").hidden = visible.length > 0;
  byId("shown").textContent = visible.length === cards.length ? many(cards.length, "scene")
    : `${visible.length} of ${many(cards.length, "scene")}`;
  for (const button of byId("filters").children) {
    button.setAttribute("aria-pressed", String(button.dataset.key === state.filter));
  }
  byId("sort").value = state.sort;
  if (byId("search").value !== state.search) byId("search").value = state.search;
}

function set(values) {
  Object.assign(state, values);
  writeAddress(false);
  showCards();
}

function followAddress() {
  readAddress();
  showCards();
  const card = state.scene !== "" && cards.find((one) => one.name === state.scene);
  if (card) openCard(card, true);
  else if (dialog.open) dialog.close();
}

function start() {
  showHead();
  for (const [key, label, , count] of kFilters) {
    byId("filters").append(element("button", { type: "button", "data-key": key, "aria-pressed": "false",
      disabled: count === 0 && key !== "all", onclick: () => set({ filter: key }) }, label,
          element("b", {}, String(count))));
  }
  for (const [key, label] of kSorts) byId("sort").append(element("option", { value: key }, label));
  cards.forEach(makeCard);
  byId("sort").addEventListener("change", (event) => set({ sort: event.target.value }));
  byId("search").addEventListener("input", (event) => set({ search: event.target.value }));
  byId("reset").addEventListener("click", () => set({ filter: "all", search: "" }));
  byId("close").addEventListener("click", () => dialog.close());
  byId("previous").addEventListener("click", () => step(-1));
  byId("next").addEventListener("click", () => step(1));
  dialog.addEventListener("close", closeDetail);
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
  document.addEventListener("keydown", (event) => {
    const isTyping = ["INPUT", "SELECT", "TEXTAREA"].includes(event.target.tagName);
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping) return;
    if (dialog.open && event.key === "ArrowLeft") step(-1);
    else if (dialog.open && event.key === "ArrowRight") step(1);
    else if (!dialog.open && event.key === "/") byId("search").focus();
    else return;
    event.preventDefault();
  });
  window.addEventListener("popstate", followAddress);
  window.addEventListener("hashchange", followAddress);
  followAddress();
}
