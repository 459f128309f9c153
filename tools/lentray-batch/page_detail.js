// The page's panel of one scene, and looking at integral images tilted. Follows page.js in one module.

// Looking at an integral image tilted: views one below the other in one JPEG, the left eye's on top.

function tiltable(box, row, onView) {
  let canvas = null, strip = null, start = null, current = -1;
  const count = row.tilt_views, middle = (count - 1) / 2;
  box.classList.add("tilts");
  const draw = () => {
    const height = strip.naturalHeight / count;
    if (!canvas) {
      canvas = element("canvas", { "aria-hidden": "true" });
      box.append(canvas);
    }
    if (canvas.width !== strip.naturalWidth) { canvas.width = strip.naturalWidth; canvas.height = height; }
    canvas.getContext("2d").drawImage(strip, 0, current * height, strip.naturalWidth, height, 0, 0, canvas.width,
        canvas.height);
    canvas.dataset.view = current;
  };
  const show = (view) => {
    const next = Math.min(count - 1, Math.max(0, Math.round(view)));
    if (next === current) return;
    current = next;
    if (onView) onView(current);
    if (strip?.complete && strip.naturalWidth) return draw();
    if (strip) return;
    strip = new Image();
    strip.onload = draw;
    strip.src = jpeg(row.tilt);
  };
  const atPointer = (event) => {
    const area = box.getBoundingClientRect();
    show((event.clientX - area.left) / area.width * count - 0.5);
  };
  box.addEventListener("pointerdown", (event) => { start = event.clientX; askForTilt(); });
  box.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "touch" || (start !== null && Math.abs(event.clientX - start) > 4)) atPointer(event);
  });
  box.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") show(middle); });
  // A drag is no click.
  box.addEventListener("click", (event) => {
    if (start !== null && Math.abs(event.clientX - start) > 8) { event.preventDefault(); event.stopPropagation(); }
    start = null;
  });
  return { show, count, middle, get view() { return current; } };
}

let tilted = null;  // the large picture, which follows the device
function askForTilt() {
  const device = window.DeviceOrientationEvent;
  if (device && typeof device.requestPermission === "function") device.requestPermission().catch(() => {});
}
window.addEventListener("deviceorientation", (event) => {
  const kReach = 25;  // degrees to either side
  if (!tilted || event.gamma === null) return;
  const across = { 90: event.beta, 180: -event.gamma, 270: -event.beta }[screen.orientation?.angle] ?? event.gamma;
  // A screen turned to the right is seen from further left.
  tilted.show(tilted.middle - across / kReach * tilted.middle);
});

function largeTilt(row) {
  const image = element("img", { alt: "", src: jpeg(row.picture || "") });
  const box = frameOf(row, image, "62vh");
  const place = element("span", {}, "");
  const count = row.tilt_views;
  const tell = (view) => {
    place.textContent = `View ${view + 1} of ${count}, from the left`;
    box.setAttribute("aria-valuenow", view + 1);
    box.setAttribute("aria-valuetext", `view ${view + 1} of ${count}`);
  };
  tilted = tiltable(box, row, tell);
  const tilt = tilted;
  for (const [name, value] of Object.entries({ tabindex: 0, role: "slider", "aria-label": "Where it is looked at from",
    "aria-valuemin": 1, "aria-valuemax": count })) box.setAttribute(name, value);
  box.addEventListener("keydown", (event) => {
    const to = { ArrowLeft: tilt.view - 1, ArrowRight: tilt.view + 1, Home: 0, End: count - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    tilt.show(to);
  });
  tilt.show(tilt.middle);
  return [box, place];
}

// The detail of a scene.

const dialog = byId("detail");
let opened = null;

function large(row) {
  const kMostPixels = 16e6;
  const full = row.shown && row.href && row.width * row.height <= kMostPixels ? row.href : "";
  const image = element("img", { alt: "The picture", src: full || (row.picture ? jpeg(row.picture) : ""),
      class: "large" });
  if (!full && !row.picture) return instead(row);
  image.addEventListener("error", () => {
    if (row.picture && image.src !== jpeg(row.picture)) image.src = jpeg(row.picture);
    else image.closest(".frame")?.replaceWith(instead({ ...row, problem: row.problem || "The file is not there." }));
  });
  const box = frameOf(row, image, "62vh");
  return box;
}

/** What the panel can show of a row: label, what it is, how to make it. */
function waysToLook(row) {
  const v = row.verdict || {}, integral = Boolean(row.lens_pixels), ways = [];
  if (row.tilt) ways.push(["Tilt to look", "", () => largeTilt(row)]);
  ways.push([row.tilt ? "Integral image" : "Ours", row.tilt ? "Interlaced, as it is printed" : "",
    () => [row.state === "done" ? large(row) : instead(row), ""]]);
  const other = (name, small, href, shown, text) => {
    const there = { state: "done", width: row.width, height: row.height, picture: small, href, shown };
    if (small || (href && shown)) ways.push([name, text, () => [large(there), text]]);
  };
  other("Stock", v.stock_picture, v.stock, v.stock_shown && !integral, integral ? "Stock's middle view" : "");
  other("Difference", v.difference_picture, v.difference, v.difference_shown,
    integral ? "Of the interlaced pictures" : "");
  return ways;
}

/** The picture in the panel, with what chooses how it is looked at. */
function looks(card, row, setRow) {
  const stage = element("div", { class: "stage" }), under = element("div", { class: "under" });
  const ways = waysToLook(row), place = element("span", {});
  const buttons = ways.map(([label], i) => element("button", { type: "button", onclick: () => choose(i) }, label));
  const choose = (which) => {
    tilted = null;
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === which)));
    const [picture, text] = ways[which][2]();
    stage.replaceChildren(picture);
    place.replaceChildren(text || ways[which][1]);
  };
  choose(0);
  if (ways.length > 1) under.append(element("span", { class: "choice", role: "group", "aria-label": "Which picture" },
      ...buttons));
  under.append(place);
  if (card.frames.length > 1) {
    const at = Math.max(0, card.frames.indexOf(row));
    under.append(player(card.frames, (frame) => {
      showSmall(stage, frame);
      setRow(frame);
    }, at));
  }
  if (row.href) under.append(link(row.href, "Open the picture"));
  return element("div", { class: "looks" }, stage, under);
}

/** Without waiting for a file: while a slider moves. */
function showSmall(stage, row) {
  const image = stage.querySelector("img");
  if (image) image.src = jpeg(row.picture);
  else stage.replaceChildren(frameOf(row, element("img", { alt: "The frame", src: jpeg(row.picture) }), "62vh"));
}

function timesOf(row) {
  const parts = [["reading", row.reading], ["building", row.building], ["rendering", row.rendering],
      ["writing", row.writing]];
  const sum = parts.reduce((all, [, value]) => all + (value || 0), 0);
  const section = titled("Times");
  if (sum > 0) {
    const stack = element("div", { class: "stack", role: "img",
      "aria-label": parts.map(([name, value]) => `${name} ${seconds(value)}`).join(", ") });
    const legend = element("ul", { class: "legend" });
    parts.forEach(([name, value], i) => {
      if (value) {
        const part = element("span", { class: `part-${i + 1}` });
        part.style.flexGrow = value / sum;
        stack.append(part);
      }
      legend.append(element("li", {}, element("i", { class: `part-${i + 1}` }), `${name} ${seconds(value)}`));
    });
    section.append(stack, legend);
  }
  if (!sum && !row.wall && !row.cpu) return "";
  const list = listOf([["on the clock", row.wall && seconds(row.wall)], ["processor", row.cpu && seconds(row.cpu)],
    ["memory", row.memory && bytes(row.memory)], ["runs it took", row.attempts]]);
  list.style.marginTop = "8px";
  section.append(list);
  return section;
}

function pictureFacts(row) {
  const views = (row.views || []).flatMap((href, i) => [i ? " " : "", link(href, String(i))]);
  if (row.view_count > (row.views || []).length) views.push(` … ${row.view_count} in all`);
  const size = row.width ? `${row.width} × ${row.height} pixels` + (row.bytes ? `, ${bytes(row.bytes)}` : "") : "";
  return titled(row.href ? "Picture" : "Scene", listOf([
    ["file", row.href && [link(row.href, clean(row.file))]], ["size", size],
    ["pixels a lens", row.lens_pixels && String(Math.round(row.lens_pixels * 1e4) / 1e4)],
    ["views, by the column of a lens", views.length ? views : ""],
    ["left out", row.left_out && clean(row.left_out.join(", "))],
    ["scene", clean(row.source || "")], ["frame", row.frame !== undefined && String(row.frame)],
    ["finished", row.finished && clean(row.finished)], ["exit status", row.status && String(row.status)]]));
}

function messagesOf(row) {
  if (!row.message_count) return "";
  const text = element("pre", { tabindex: 0, "aria-label": "Messages" });
  for (const line of row.messages || []) {
    const kind = /\bwarning\b/i.test(line) ? "is-warning" : /\b(fatal )?error\b/i.test(line) ? "is-failure" : null;
    text.append(element("span", { class: kind }, clean(line) + "\n"));
  }
  const rest = row.message_count - (row.messages || []).length;
  if (rest > 0) text.append(`… ${many(rest, "more line")}; the manifest has all`);
  return titled(many(row.message_count, "line") + " of messages", text);
}

/** What will be wrong with the sheet. */
function kindsOf(row) {
  return row.kinds ? titled("What to look at", listOf(Object.entries(row.kinds).map(([kind, text]) =>
    [kind, clean(text)]))) : "";
}

function commandOf(row) {
  if (!row.command) return "";
  const folder = (row.source || "").replace(/\/[^/]*$/, "");
  const command = (folder ? `cd ${quoted(folder)} && ` : "") + row.command.map(quoted).join(" ") +
    (row.command_words > row.command.length ? " …" : "");
  const button = element("button", { type: "button", class: "plain", onclick: () => copy(command, button) }, "Copy");
  return element("section", {}, element("div", { class: "titled" }, element("h3", {}, "Command"), button),
    element("pre", { tabindex: 0, "aria-label": "Command" }, clean(command)));
}

function filesOf(row) {
  if (!row.file_count && !row.missing_count) return "";
  const details = element("details", {}, element("summary", {}, many(row.file_count || 0, "file") +
    (row.missing_count ? `, and ${row.missing_count} looked for in vain` : "")));
  details.addEventListener("toggle", () => {
    if (!details.open || details.children.length > 1) return;
    const list = element("ul", {});
    for (const i of row.files || []) list.append(element("li", {}, clean(data.paths[i])));
    for (const i of row.missing || []) list.append(element("li", {}, "not there: " + clean(data.paths[i])));
    const rest = (row.file_count || 0) + (row.missing_count || 0) - list.children.length;
    if (rest > 0) list.append(element("li", {}, `… ${rest} more`));
    details.append(list);
  });
  return titled("What it depends on", details);
}

function comparedPicture(row, name, small, full, isWhole) {
  const own = isWhole && row.width * row.height <= 4e6 ? full : "";
  if (!small && !own) return "";
  const image = element("img", { alt: name, loading: "lazy", src: own || jpeg(small) });
  image.addEventListener("error", () => {
    if (small && image.src !== jpeg(small)) image.src = jpeg(small);
    else image.closest("figure")?.remove();
  });
  return element("figure", {}, frameOf(row, image),
    element("figcaption", {}, element("span", {}, name), full ? link(full, "file") : ""));
}

function comparisonPictures(row) {
  const v = row.verdict;
  if (!v || (!v.stock && !v.difference)) return "";
  const isIntegral = Boolean(row.lens_pixels), view = isIntegral ? ", middle view" : "";
  const all = element("div", { class: "compared" },
    comparedPicture(row, "ours" + view, row.picture, row.href, row.shown && !isIntegral),
    comparedPicture(row, "stock" + view, v.stock_picture, v.stock, v.stock_shown && !isIntegral),
    comparedPicture(row, "difference" + (isIntegral ? ", interlaced" : ""), v.difference_picture, v.difference,
      v.difference_shown));
  const marks = element("ol", {});
  for (const mark of ["0", "1", "2", "4", "12", "32 and more"]) marks.append(element("li", {}, mark));
  const label = "Scale of the difference, in 1/255: black 0, blue 1, green 2, yellow 4, red 12, white 32 and more";
  const heat = element("div", { class: "heat" }, element("div", { class: "scale", role: "img", "aria-label": label }),
    marks, "Difference of the channel that differs most, in 1/255");
  return element("div", {}, all, v.difference ? heat : "");
}

function gradesText(grades) {
  return kGrades.filter((grade) => grades?.[grade]).map((grade) => `${grades[grade]} ${grade}`).join(", ");
}

function comparisonOf(row) {
  const v = row.verdict;
  if (!v) return "";
  const isEqual = v.psnr === undefined && (v.grade === "exact") && !v.largest;
  return titled("Against stock POV-Ray", listOf([
    ["grade", v.grade ? [badge(v.grade, "is-" + v.grade)] : "none: stock has no picture"],
    ["note", v.note && clean(v.note)],
    ["PSNR", isEqual ? "equal pictures" : v.psnr !== undefined ? `${fixed(v.psnr, 2)} dB` : ""],
    ["beyond 1/255", v.grade && v.grade !== "fails" ? `${percent(v.beyond_1 || 0)} of the pixels` : ""],
    ["beyond 2/255", v.grade && v.grade !== "fails" ? `${percent(v.beyond_2 || 0)} of the pixels` : ""],
    ["largest", v.largest ? `${fixed(v.largest, v.largest % 1 ? 2 : 0)} / 255` : ""],
    ["blocks of 16 × 16", v.noise_rms !== undefined &&
      `${fixed(v.block_rms || 0, 2)} / 255; stock against itself ${fixed(v.noise_rms, 2)}`],
    ["bias", v.noise_rms !== undefined &&
      `${fixed(v.bias || 0, 2)} / 255; stock against itself ${fixed(v.noise_bias || 0, 2)}`],
    ["lenses", gradesText(v.lens_grades)], ["views", gradesText(v.view_grades)],
    ["processor, stock", v.stock_cpu && seconds(v.stock_cpu)],
    ["processor, stock's noise", v.noise_cpu && seconds(v.noise_cpu)], ["stock over ours", v.ratio && times(v.ratio)]]));
}

function factsOf(card, row, setFrame) {
  const facts = element("div", { class: "facts" });
  const failed = card.animation ? card.list.filter((one) => one.state === "failed") : [];
  if (failed.length) {
    const list = element("div", { class: "filters" });
    for (const one of failed.slice(0, 50)) {
      list.append(element("button", { type: "button", title: clean(one.reason || ""), onclick: () => setFrame(one) },
          String(one.frame)));
    }
    if (failed.length > 50) list.append(`… ${failed.length - 50} more`);
    facts.append(titled(many(failed.length, "failed frame"), list));
  }
  if (card.animation) {
    facts.append(titled("Animation", listOf([["frames", String(card.rows.length)], ["with small pictures",
      card.frames.length < card.rows.length && String(card.frames.length)], ["on the clock", seconds(card.time)],
      ["warnings", card.warnings && String(card.warnings)]])));
  }
  for (const part of [kindsOf(row), messagesOf(row), comparisonOf(row), timesOf(row), pictureFacts(row), commandOf(row),
      filesOf(row)]) {
    if (part) facts.append(part);
  }
  return facts;
}

function showDetail() {
  const card = opened;
  let row = (state.frame !== "" && card.list.find((one) => String(one.frame) === state.frame)) ||
      (card.frames[0] ?? card.row);
  if (card.state === "failed" && state.frame === "") row = card.row;
  byId("detail-name").textContent = clean(card.name);
  const place = visible.indexOf(card);
  byId("detail-place").textContent = place >= 0 ? `${place + 1} of ${visible.length}` : "";
  byId("previous").disabled = place <= 0;
  byId("next").disabled = place < 0 || place + 1 >= visible.length;
  dialog.className = `is-${row.state}`;
  const setFrame = (one) => { state.frame = String(one.frame); writeAddress(false); showDetail(); };
  let facts = factsOf(card, row, setFrame), timer = 0;
  const panel = looks(card, row, (frame) => {
    // The text follows when the slider rests.
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (opened !== card || !facts.isConnected) return;
      state.frame = String(frame.frame);
      writeAddress(false);
      dialog.className = `is-${frame.state}`;
      const next = factsOf(card, frame, setFrame);
      facts.replaceWith(next);
      facts = next;
    }, 200);
  });
  const pictures = comparisonPictures(row);
  if (pictures) panel.append(pictures);
  byId("detail-body").replaceChildren(panel, facts);
  byId("detail-body").scrollTop = 0;
}

function openCard(card, isFromAddress) {
  const wasOpen = dialog.open;
  opened = card;
  state.scene = card.name;
  if (!isFromAddress) { state.frame = ""; writeAddress(!wasOpen); }
  if (!wasOpen) dialog.showModal();
  showDetail();
  byId("detail-name").focus({ preventScroll: true });
}

function closeDetail() {
  const card = opened;
  opened = tilted = null;
  state.scene = state.frame = "";
  byId("detail-body").replaceChildren();
  writeAddress(false);
  const target = card?.element?.querySelector(".open");
  if (target && !card.element.hidden) target.focus();
}

function step(by) {
  const next = visible[visible.indexOf(opened) + by];
  if (opened && visible.includes(opened) && next) openCard(next);
}

start();
