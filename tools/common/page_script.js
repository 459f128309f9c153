// What the scripts of all pages share. A page's own script follows in the same module.

const byId = (id) => document.getElementById(id);

// Text. Names and messages are strangers': they become text nodes only.

/** Bytes of names that are no UTF-8 come as U+EF80 to U+EFFF. */
const bytesOf = (text) => text.replace(/[\uef80-\uefff]/g, (c) => "\\x" + (c.charCodeAt(0) - 0xef00).toString(16));

/** Control characters as pictures of them, direction marks without effect. */
function clean(text) {
  return bytesOf(String(text)).replace(/[\u0000-\u0008\u000b-\u001f\u007f]/g, (c) => c === "\u007f" ? "\u2421"
    : String.fromCharCode(0x2400 + c.charCodeAt(0))).replace(/[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, "\ufffd");
}

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return made;
}

const fixed = (value, digits) => value.toFixed(digits);
function seconds(s) {
  if (!s) return "0 s";
  if (s < 0.001) return "under 1 ms";
  if (s < 1) return `${Math.round(s * 1000)} ms`;
  if (s < 60) return `${fixed(s, s < 10 ? 2 : 1)} s`;
  const whole = Math.round(s), pad = (n) => String(n).padStart(2, "0");
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${pad(whole % 60)} s`;
  return `${Math.floor(whole / 3600)} h ${pad(Math.floor(whole % 3600 / 60))} min`;
}
function bytes(n) {
  const units = ["bytes", "kB", "MB", "GB", "TB"];
  let unit = 0;
  for (; n >= 1000 && unit < units.length - 1; ++unit) n /= 1000;
  return `${unit === 0 || n >= 100 ? Math.round(n) : fixed(n, 1)} ${units[unit]}`;
}
const times = (ratio) => `${fixed(ratio, ratio < 10 ? 2 : ratio < 100 ? 1 : 0)} ×`;
const percent = (share) => share === 0 ? "0 %" : share < 0.00005 ? "under 0.01 %" :
    `${fixed(100 * share, share < 0.1 ? 2 : 1)} %`;
const many = (n, one, more) => `${n} ${n === 1 ? one : more || one + "s"}`;

const tileOf = (label, value, kind) => element("div", { class: kind }, element("dt", {}, label),
    element("dd", {}, value));
const jpeg = (base64) => "data:image/jpeg;base64," + base64;
const link = (href, text) => element("a", { href, target: "_blank", rel: "noopener" }, text);

/** For a shell: with ends of lines, bytes and direction marks as escapes, where there are such. */
function quoted(word) {
  if (/^[\w@%+=:,./-]+$/.test(word)) return word;
  if (!/[\u0000-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069\uef80-\uefff]/.test(word)) {
    return "'" + word.replaceAll("'", "'\\''") + "'";
  }
  const escaped = bytesOf(word.replace(/[\\']/g, "\\$&")).replace(/[\u0000-\u001f\u007f]/g,
      (c) => "\\x" + c.charCodeAt(0).toString(16).padStart(2, "0"));
  return "$'" + escaped.replace(/[\u0080-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g,
      (c) => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0")) + "'";
}

function copy(text, button) {
  const tell = (word) => { button.textContent = word; setTimeout(() => { button.textContent = "Copy"; }, 1500); };
  const byHand = () => {
    const area = element("textarea", { class: "unseen" });
    area.value = text;
    (button.closest("dialog") || document.body).append(area);
    area.select();
    const isCopied = document.execCommand("copy");
    area.remove();
    tell(isCopied ? "Copied" : "Not copied");
  };
  if (navigator.clipboard) navigator.clipboard.writeText(text).then(() => tell("Copied"), byHand);
  else byHand();
}

function titled(text, ...children) { return element("section", {}, element("h3", {}, text), ...children); }

function listOf(pairs) {
  const list = element("dl", { class: "list" });
  for (const [name, value] of pairs) {
    if (value === undefined || value === null || value === "" || value === false) continue;
    list.append(element("dt", {}, name), element("dd", {}, ...(Array.isArray(value) ? value : [value])));
  }
  return list;
}

// Tables of the class "sorts": a button in each heading orders the rows. A cell is compared by its data-value, else by
// its text: numbers where both are, words otherwise. Cells without a value come last either way.

function sortTable(table, column, isDescending) {
  const value = (row) => {
    const cell = row.cells[column], text = cell.dataset.value ?? cell.textContent.trim();
    const number = parseFloat(text);
    return text === "" ? null : text === "inf" ? Infinity : Number.isNaN(number) ? text : number;
  };
  const compare = (a, b) => typeof a === "number" && typeof b === "number" ? Math.sign(a - b) || 0
    : String(a).localeCompare(String(b), undefined, { numeric: true });
  const kept = [...table.tBodies[0].rows].map((row, place) => ({ row, place, value: value(row) }));
  kept.sort((a, b) => a.value === null || b.value === null ? (a.value === null) - (b.value === null)
    : (isDescending ? -1 : 1) * compare(a.value, b.value) || a.place - b.place);
  table.tBodies[0].append(...kept.map(({ row }) => row));
  [...table.tHead.rows[0].cells].forEach((cell, i) => {
    if (i === column) cell.setAttribute("aria-sort", isDescending ? "descending" : "ascending");
    else cell.removeAttribute("aria-sort");
  });
}

function makeSortable(table) {
  [...table.tHead.rows[0].cells].forEach((cell, column) => {
    const isUp = () => cell.getAttribute("aria-sort") === "ascending";
    const button = element("button", { type: "button", onclick: () => sortTable(table, column, isUp()) });
    button.append(...cell.childNodes);
    cell.append(button);
  });
}
for (const table of document.querySelectorAll("table.sorts")) makeSortable(table);

