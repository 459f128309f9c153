// The page of a chart: points that show their settings, filters, what to choose. The script that pages share comes
// before it in one module; page_compare.js follows and starts it. Keys of the data are those of page_data.cpp.

const data = JSON.parse(byId("data").textContent);
const points = data.points, byName = new Map(points.map((point) => [point.id, point]));
const picture = (place) => jpeg(data.pictures[place]);
const words = (kind) => kind.replaceAll("_", " ");

/** As the table has it. */
function figure(value) {
  if (value === undefined) return "";
  if (value === 0) return "0";
  return value < 1e-4 ? value.toExponential(1) : fixed(value, value < 0.01 ? 5 : value < 0.1 ? 4 : value < 1 ? 3 : value < 100 ? 2 : 0);
}

// What is shown, from the page's address: #kind=…&search=…&left=…&right=…&budget=…&error=…

const state = { kind: "all", search: "", left: "", right: "", budget: "", error: "" };
const defaults = { ...state };
let shown = null, kept = [];

function writeAddress() {
  const parts = new URLSearchParams();
  for (const key of Object.keys(defaults)) if (state[key] !== defaults[key]) parts.set(key, state[key]);
  try {
    history.replaceState(null, "", "#" + parts);
  } catch { /* the page works without */ }
}

// The setting in the panel.

function commandOf(point) {
  return point.command || [data.command, ...point.options.map(quoted)].filter(Boolean).join(" ");
}

function commandBox(point) {
  const command = commandOf(point);
  const button = element("button", { type: "button", class: "plain", onclick: () => copy(command, button) }, "Copy");
  return element("section", {}, element("div", { class: "titled" }, element("h3", {}, "Command"), button),
    element("pre", { tabindex: 0, "aria-label": "Command" }, clean(command)));
}

const go = (id) => element("button", { type: "button", class: "go", onclick: () => show(byName.get(id)) },
    clean(byName.get(id)?.label ?? id));

function timeText(point) {
  if (point.seconds === undefined || !point.runs) return "";
  if (point.runs === 1) return seconds(point.seconds);
  return `${seconds(point.seconds)} (${seconds(point.least)} to ${seconds(point.most)}, ${many(point.runs, "run")})`;
}

function errorList(error) {
  const isEqual = error.rms === 0;
  return listOf([["rms", isEqual ? "0: equal" : `${figure(error.rms)} / 255`],
    ["PSNR", error.psnr !== undefined && `${fixed(error.psnr, 1)} dB`],
    ["beyond 1/255", error.share !== undefined && `${percent(error.share)} of the pixels`],
    ["largest", error.largest !== undefined && `${figure(error.largest)} / 255`],
    ["perceived", error.perceived !== undefined && `${figure(error.perceived)} (Butteraugli)`],
    ["seen", error.seen !== undefined && `${figure(error.seen)} L*, rms`]]);
}

function badgesOf(point) {
  const badges = element("div", { class: "badges" });
  const add = (text, kind) => badges.append(element("span", { class: "badge " + (kind || "") }, text));
  add(point.plain ? "your options" : words(point.kind));
  if (point.state === "failed") add("failed", "is-failure");
  if (point.state === "waiting") add("waiting");
  if (point.front) add("on the front", "is-good");
  if (point.dominated_by) add("another is better");
  if (point.blurred && point.state === "done") add("error not distinguished", "is-warning");
  if (point.kind === "exact" && point.from_plain?.rms > 0) add("not the plain picture", "is-failure");
  return badges;
}

function factsOf(point) {
  const plain = points.find((one) => one.plain), facts = element("div", { class: "facts" });
  const against = plain && plain !== point && plain.seconds && point.seconds;
  facts.append(listOf([["time", timeText(point)], ["against yours", against && times(point.seconds / plain.seconds)],
    ["better is", point.dominated_by && [go(point.dominated_by)]]]));
  if (point.error) {
    const truth = point.lens ? "Error, against the truest lens model" : "Error, against the reference";
    facts.append(titled(truth, errorList(point.error)));
  }
  if (point.from_plain && !point.plain) facts.append(titled("From your options' picture", errorList(point.from_plain)));
  if (point.stock_seconds || point.from_stock) {
    facts.append(titled("POV-Ray at the same settings", listOf([
      ["time", point.stock_seconds && seconds(point.stock_seconds)],
      ["its error", point.stock_error && `${figure(point.stock_error.rms)} / 255`],
      ["from ours", point.from_stock && `${figure(point.from_stock.rms)} / 255`]])));
  }
  if (point.reason) facts.append(titled("Why it failed", element("pre", { tabindex: 0 }, clean(point.reason))));
  facts.append(commandBox(point));
  return facts;
}

/** Name, place in data.pictures, link to the file. */
function waysToLook(point) {
  const reference = point.lens ? data.lens_reference : data.reference;
  return [["Picture", point.picture, point.picture_href], ["Difference × 8", point.difference, point.difference_href],
    ["Reference", reference, point.lens ? "" : data.reference_href], ["POV-Ray", point.stock, point.stock_href],
  ].filter(([, place]) => place !== undefined);
}

let way = "Picture";  // as the reader chose it last
function looks(point) {
  const stage = element("div", { class: "stage" }), under = element("div", { class: "under" });
  const ways = waysToLook(point), place = element("span", {});
  const missing = point.picture === undefined && point.state === "done"
    ? element("p", {}, element("strong", {}, "No picture to show. "), clean(point.problem || "")) : "";
  const buttons = ways.map(([name], i) => element("button", { type: "button", onclick: () => choose(i, true) }, name));
  const choose = (which, isWish) => {
    const [name, at, href] = ways[which];
    if (isWish) way = name;
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === which)));
    stage.replaceChildren(element("img", { alt: `${name} of ${clean(point.label)}`, src: picture(at),
      width: data.width || null, height: data.height || null }));
    place.replaceChildren(href ? link(href, "file") : "");
  };
  const wish = ways.findIndex(([name]) => name === way);
  if (ways.length > 0 && point.state === "done") {
    choose(Math.max(0, wish), false);
    under.append(element("span", { class: "choice", role: "group", "aria-label": "Which picture" }, ...buttons), place);
  }
  if (missing) { stage.replaceChildren(missing); }
  if (point.state !== "done") return "";
  return element("div", {}, stage, under.children.length ? under : "");
}

function showDetail() {
  byId("detail").hidden = !shown;
  if (!shown) return;
  byId("detail-name").textContent = clean(shown.label);
  byId("detail-body").replaceChildren(badgesOf(shown), looks(shown), factsOf(shown));
  byId("detail").scrollTop = 0;
  showMarks();
}

function showMarks() {
  const isKept = shown && kept.includes(shown.id);
  byId("pin").textContent = isKept ? "Kept" : "Keep";
  byId("pin").setAttribute("aria-pressed", String(Boolean(isKept)));
  for (const hit of document.querySelectorAll(".hit")) {
    hit.classList.toggle("is-shown", hit.dataset.id === shown?.id);
    hit.classList.toggle("is-kept", kept.includes(hit.dataset.id));
    hit.setAttribute("aria-pressed", String(kept.includes(hit.dataset.id)));
  }
  for (const row of byId("settings").tBodies[0].rows) row.classList.toggle("is-kept", kept.includes(row.dataset.id));
}

function show(point) {
  if (!point || point === shown) return;
  shown = point;
  showDetail();
}

/** Two at most: they are compared. */
function keep(id) {
  kept = kept.includes(id) ? kept.filter((one) => one !== id) : [...kept, id].slice(-2);
  compareKept();
  showMarks();
}

// The charts.

function startChart(chart) {
  const hits = [...chart.querySelectorAll(".hit")];
  const pointOf = (event) => byName.get(event.target.dataset?.id);
  chart.addEventListener("pointerover", (event) => { if (event.pointerType !== "touch") show(pointOf(event)); });
  chart.addEventListener("pointerleave", () => { if (kept.length) show(byName.get(kept.at(-1))); });
  chart.addEventListener("focusin", (event) => show(pointOf(event)));
  chart.addEventListener("click", (event) => {
    const point = pointOf(event);
    if (!point) return;
    show(point);
    keep(point.id);
  });
  chart.addEventListener("keydown", (event) => {
    const at = hits.indexOf(event.target);
    if (at < 0) return;
    const free = hits.filter((hit) => !hit.classList.contains("is-dim")), place = free.indexOf(event.target);
    const to = { ArrowRight: free[place + 1], ArrowDown: free[place + 1], ArrowLeft: free[place - 1],
      ArrowUp: free[place - 1], Home: free[0], End: free.at(-1) }[event.key];
    if (event.key === "Enter" || event.key === " ") keep(event.target.dataset.id);
    else if (!to) return;
    event.preventDefault();
    if (!to) return;
    hits.forEach((hit) => hit.setAttribute("tabindex", hit === to ? "0" : "-1"));
    to.focus();
  });
}

// The table.

function fits(point) {
  const isKind = { all: true, front: Boolean(point.front), failed: point.state === "failed" }[state.kind]
    ?? point.kind === state.kind;
  const text = `${point.id} ${point.label} ${words(point.kind)} ${point.options.join(" ")}`.toLowerCase();
  return isKind && state.search.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

function showFiltered() {
  const fitting = new Set(points.filter(fits).map((point) => point.id));
  for (const row of byId("settings").tBodies[0].rows) row.hidden = !fitting.has(row.dataset.id);
  for (const hit of document.querySelectorAll(".hit")) hit.classList.toggle("is-dim", !fitting.has(hit.dataset.id));
  const kinds = new Set(points.filter((point) => fitting.has(point.id)).map((point) => point.kind));
  for (const series of document.querySelectorAll(".series")) {
    series.classList.toggle("is-dim", !kinds.has(series.dataset.kind));
  }
  byId("shown").textContent = fitting.size === points.length ? many(points.length, "setting")
    : `${fitting.size} of ${many(points.length, "setting")}`;
  for (const button of byId("filters").children) {
    button.setAttribute("aria-pressed", String(button.dataset.key === state.kind));
  }
}

function set(values) {
  Object.assign(state, values);
  writeAddress();
  showFiltered();
}

// What to choose.

/** Seconds; null where it is no duration. */
function duration(text) {
  const match = text.trim().toLowerCase().match(/^(\d+(?:[.,]\d*)?|[.,]\d+)\s*(ms|s|sec|min|m|h)?$/);
  if (!match) return null;
  const unit = { ms: 0.001, s: 1, sec: 1, min: 60, m: 60, h: 3600 }[match[2] || "s"];
  return parseFloat(match[1].replace(",", ".")) * unit;
}

const errorOf = (point) => point.error.rms;
const timeOf = (point) => point.seconds;
/** Exact settings come last: they differ from the plain one in time alone. */
const isExact = (point) => point.kind === "exact" && !point.plain;
const plainFirst = (point) => (isExact(point) ? 1e12 : 0) + timeOf(point);
/** The first in the order of `first`, and of `then` where that is equal. */
function least(list, first, then) {
  return list.reduce((best, one) => !best || first(one) < first(best) ||
    (first(one) === first(best) && then(one) < then(best)) ? one : best, null);
}

function choiceBox(point, title, reason) {
  if (!point) return titled(title, element("p", { class: "is-warning note" }, reason));
  return titled(title, element("p", {}, go(point.id),
    `: ${seconds(point.seconds)}, error ${figure(errorOf(point))} / 255` +
    (point.blurred ? ", which the reference does not tell apart from less" : "") + "."), commandBox(point));
}

function showChoice() {
  const all = points.filter((point) => point.choosable), out = [];
  const budget = state.budget.trim(), limit = state.error.trim();
  if (budget) {
    const most = duration(budget), near = least(all, timeOf, errorOf);
    out.push(most === null ? choiceBox(null, "Within the time", "A time is expected, such as 30s, 2min or 500ms.")
      : choiceBox(least(all.filter((point) => point.seconds <= most), errorOf, plainFirst), `Within ${seconds(most)}`,
        near ? `Nothing is as fast. The fastest, ${near.label}, takes ${seconds(near.seconds)}.`
          : "Nothing is measured."));
  }
  if (limit) {
    const most = Number(limit.replace(",", ".")), near = least(all, errorOf, timeOf);
    out.push(!(most >= 0) ? choiceBox(null, "Within the error", "An error in 1/255 is expected, such as 1 or 0.5.")
      : choiceBox(least(all.filter((point) => errorOf(point) <= most && !isExact(point)), timeOf, errorOf), `Within ${most} / 255`,
        near ? `Nothing is as exact. The least error, of ${near.label}, is ${figure(errorOf(near))} / 255.`
          : "Nothing is measured."));
  }
  byId("chosen").replaceChildren(...out);
}
