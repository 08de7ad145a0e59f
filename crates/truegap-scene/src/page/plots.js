// Values under the pointer and zoom of the plots. All of it is read from the drawing: paths in pixels, and the axes written beside them.
// Without this script the page reads the same; on paper nothing of it is seen.
{
  const LEAST = 1e-3; // of an axis; a drawing's pixels have two decimals
  const make = (parent, tag, attributes, text) => {
    const made = parent.ownerDocument.createElementNS(parent.namespaceURI, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    if (text !== undefined) made.textContent = text;
    return parent.appendChild(made);
  };
  const plain = (value, decimals) => {
    const text = Math.abs(value) >= 1e7 || decimals > 9 ? value.toPrecision(5) : value.toFixed(Math.max(0, decimals));
    return text.replace(/^-(?=0(\.0*)?$)/, "").replace("-", "\u2212");
  };
  const decimals = (step) => Math.ceil(-Math.log10(step) - 1e-9);

  // One axis; places are shares of its whole length, from 0 to 1.
  class Axis {
    constructor(group, name) {
      const [low, high, log, times, from] = group.dataset[name].split(" ").map(Number);
      Object.assign(this, { low, high, log: log === 1, times, from, name: group.dataset[name + "Name"], unit: group.dataset[name + "Unit"], view: [0, 1] });
    }
    get whole() { return this.view[0] <= 0 && this.view[1] >= 1; }
    value(place) { return this.log ? this.low * (this.high / this.low) ** place : this.low + place * (this.high - this.low); }
    place(value) { return this.log ? Math.log(value / this.low) / Math.log(this.high / this.low) : (value - this.low) / (this.high - this.low); }
    // From a share of the view to a place, and back.
    from_view(share) { return this.view[0] + share * (this.view[1] - this.view[0]); }
    to_view(place) { return (place - this.view[0]) / (this.view[1] - this.view[0]); }
    look(a, b) {
      [a, b] = [Math.max(0, Math.min(a, b)), Math.min(1, Math.max(a, b))];
      const short = Math.max(0, LEAST - (b - a)) / 2;
      this.view = [Math.max(0, a - short), Math.min(1, b + short)];
    }
    told(place) {
      const value = this.value(place), step = Math.abs(this.value(place + 2e-4) - value);
      return plain(value, decimals(step)) + (this.unit ? " " + this.unit : "");
    }
    ticks(wanted) {
      const [low, high] = this.view.map((place) => this.value(place));
      if (this.log && high / low > 8) {
        const all = [];
        for (let k = Math.ceil(Math.log10(low) - 1e-9); 10 ** k <= high * 1.000001; k++) all.push([10 ** k, k < -3 || k > 4 ? "1e" + k : String(Number((10 ** k).toPrecision(1)))]);
        if (all.length > 1) return all;
      }
      const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
      const step = [1, 2, 5, 10].find((m) => m * power >= raw * 0.999999) * power;
      const first = Math.ceil((low - this.from) / step - 1e-9), last = Math.floor((high - this.from) / step + 1e-9);
      return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => [this.from + (first + i) * step, plain(((first + i) * step) / this.times, decimals(step / this.times))]);
    }
  }

  // Points of a path as shares of the panel; null for what is no series of points (bands, bars).
  function series(path, width, height) {
    const title = path.querySelector("title"), data = path.getAttribute("d");
    const name = title ? title.textContent : "";
    if (title) title.remove(); // or the browser shows it as well
    const dots = data.includes("h0"), x = [], y = [];
    if (!dots && /[^\d\sML.-]/.test(data)) return null;
    for (const [, px, py] of data.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)) { x.push(px / width); y.push(1 - py / height); }
    const forward = x.every((v, i) => i === 0 || v >= x[i - 1]);
    return { name, x, y, dots, forward, colour: path.getAttribute("stroke") };
  }

  class Panel {
    constructor(group, x) {
      [this.left, this.top, this.width, this.height] = group.dataset.area.split(" ").map(Number);
      this.group = group;
      this.x = x || new Axis(group, "x");
      this.y = new Axis(group, "y");
      this.data = group.querySelector(".tg-data");
      this.series = [...this.data.querySelectorAll("path")].map((path) => series(path, this.width, this.height)).filter(Boolean);
      this.drawn = [...group.querySelectorAll(".tg-grid, .tg-ticks")].map((part) => [part, part.innerHTML]);
    }
    holds([x, y]) { return x >= this.left - 4 && x <= this.left + this.width + 4 && y >= this.top - 4 && y <= this.top + this.height + 4; }
    // From user units of the drawing to places on the axes, and back.
    places([x, y]) { return [this.x.from_view((x - this.left) / this.width), this.y.from_view(1 - (y - this.top) / this.height)]; }
    pixels(x, y) { return [this.left + this.x.to_view(x) * this.width, this.top + (1 - this.y.to_view(y)) * this.height]; }
    // The point of a series that is nearest to a point of the drawing, `[index, distance]`; of lines along x.
    nearest(one, [x, y], across) {
      let best = [-1, Infinity];
      for (let i = 0; i < one.x.length; i++) {
        const [px, py] = this.pixels(one.x[i], one.y[i]), distance = Math.hypot(px - x, across * (py - y));
        if (distance < best[1] && this.holds([px, this.top])) best = [i, distance];
      }
      return best;
    }
    redraw() {
      const [x, y] = [this.x, this.y], whole = x.whole && y.whole;
      const sx = 1 / (x.view[1] - x.view[0]), sy = 1 / (y.view[1] - y.view[0]);
      const tx = -x.view[0] * this.width * sx, ty = -(1 - y.view[1]) * this.height * sy;
      this.data.setAttribute("transform", `matrix(${sx} 0 0 ${sy} ${tx} ${ty})`);
      for (const part of this.data.children) part.setAttribute("vector-effect", whole ? "none" : "non-scaling-stroke");
      for (const guide of this.group.querySelectorAll(".tg-guides > g")) {
        const at = guide.dataset;
        const [dx, dy] = at.x !== undefined ? [at.x * (sx - 1) + tx, 0] : [0, at.y * (sy - 1) + ty];
        guide.setAttribute("transform", `translate(${dx} ${dy})`);
      }
      this.drawn.forEach(([part, markup]) => { part.innerHTML = markup; });
      if (!whole) this.axes();
    }
    axes() {
      const [grid, along, below] = this.drawn.map(([part]) => part);
      [grid, along, below].forEach((part) => part && part.replaceChildren());
      let strokes = "";
      for (const [value, label] of this.y.ticks(Math.max(2, this.height / 32))) {
        const [, py] = this.pixels(0, this.y.place(value));
        strokes += `M${this.left} ${py}h${this.width}`;
        make(along, "text", { x: this.left - 7, y: py + 4, "text-anchor": "end" }, label);
      }
      for (const [value, label] of this.x.ticks(this.width / 95)) {
        const [px] = this.pixels(this.x.place(value), 0);
        strokes += `M${px} ${this.top}v${this.height}`;
        if (below) make(below, "text", { x: px, y: this.top + this.height + 17, "text-anchor": "middle" }, label);
      }
      make(grid, "path", { d: strokes, stroke: "currentColor", "stroke-opacity": 0.12, fill: "none" });
    }
  }

  // What the pointer at `at` of a figure reads: where the cross goes, and lines of text.
  function reading(panels, panel, at) {
    const near = panel.series.map((one) => [one, ...panel.nearest(one, at, one.dots ? 1 : 0.05)]).sort((a, b) => a[2] - b[2])[0];
    if (!near || near[1] < 0 || near[2] > 60) return null;
    const [one, index] = near, point = [one.x[index], one.y[index]], cross = panel.pixels(...point);
    const row = (of, series, i) => [series.colour, series.name || of.y.name, of.y.told(series.y[i])];
    const rows = [row(panel, one, index)];
    for (const other of panels) {
      for (const also of other.series) {
        if (also === one || (also.dots && !(one.forward && also.forward))) continue;
        const [i, distance] = other.nearest(also, cross, other === panel ? 0.01 : 0);
        if (distance < 4 && rows.length < 8) rows.push(row(other, also, i));
      }
    }
    return { cross, head: `${panel.x.name}: ${panel.x.told(point[0])}`, rows };
  }

  // The cell of a map under the pointer.
  function cell(map, at) {
    const [left, top, width, height] = map.area, [x, y, cells] = map.numbers;
    const find = (edges, share) => edges.findIndex((edge, i) => i + 1 < edges.length && edges[0] + share * (edges[edges.length - 1] - edges[0]) <= edges[i + 1]);
    const [sx, sy] = [(at[0] - left) / width, 1 - (at[1] - top) / height];
    if (Math.min(sx, sy) < 0 || Math.max(sx, sy) > 1) return null;
    const [i, j] = [find(x, sx), find(y, sy)], value = cells[j * (x.length - 1) + i];
    const span = (name, edges, k) => `${name}: ${Number(edges[k].toPrecision(4))} to ${Number(edges[k + 1].toPrecision(4))}`;
    const told = Number.isFinite(value) ? String(Number(value.toPrecision(3))).replace("-", "\u2212") : "no value";
    return { head: span(map.names[0], x, i), rows: [["", span(map.names[1], y, j), ""], ["", map.names[2], told]] };
  }

  function show(figure, svg, found) {
    svg.querySelectorAll(".tg-cross").forEach((part) => part.remove());
    figure.querySelectorAll(".tg-values").forEach((part) => part.remove());
    if (!found) return;
    const { panel, panels, cross, at } = found;
    if (cross) {
      const group = make(svg, "g", { class: "tg-cross", stroke: "currentColor", "stroke-opacity": 0.6, fill: "none", "pointer-events": "none" });
      panels.forEach((p) => make(group, "path", { d: `M${cross[0]} ${p.top}v${p.height}`, "stroke-width": 0.8 }));
      make(group, "path", { d: `M${panel.left} ${cross[1]}h${panel.width}`, "stroke-width": 0.8 });
      make(group, "circle", { cx: cross[0], cy: cross[1], r: 4.5, "stroke-width": 1.6, "stroke-opacity": 1 });
    }
    const box = figure.appendChild(document.createElement("div"));
    box.className = "tg-values";
    box.appendChild(document.createElement("b")).textContent = found.head;
    for (const [colour, name, value] of found.rows) {
      const line = box.appendChild(document.createElement("div"));
      if (colour) line.appendChild(document.createElement("i")).style.background = colour;
      line.append(value ? `${name}: ${value}` : name);
    }
    // Beside the pointer, on the side that has room.
    const frame = figure.getBoundingClientRect(), x = at.clientX - frame.left, y = at.clientY - frame.top;
    const [w, h] = [box.offsetWidth, box.offsetHeight];
    box.style.left = `${Math.max(0, x + 16 + w > frame.width ? Math.min(x - 16, frame.width) - w : x + 16)}px`;
    box.style.top = `${Math.max(0, y - h - 12)}px`;
  }

  for (const figure of document.querySelectorAll("figure")) {
    const svg = figure.querySelector("svg.tg-figure");
    if (!svg) continue;
    const panels = [];
    for (const group of svg.querySelectorAll(".tg-panel")) panels.push(new Panel(group, panels[0] && panels[0].x));
    const maps = [...svg.querySelectorAll(".tg-cells[data-area]")].map(({ dataset: d }) => ({
      area: d.area.split(" ").map(Number), numbers: [d.x, d.y, d.cells].map((list) => list.split(" ").map(Number)), names: [d.xName, d.yName, d.name],
    }));
    if (!panels.length && !maps.length) continue;
    const user = (event) => { const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse()); return [p.x, p.y]; };
    const under = (event) => panels.find((panel) => panel.holds(user(event)));
    const hover = (event) => {
      const panel = under(event), at = user(event);
      const found = panel ? reading(panels, panel, at) : maps.map((map) => cell(map, at)).find(Boolean);
      show(figure, svg, found && { ...found, panel, panels, at: event });
    };
    const tools = figure.querySelector(".tools"), back = document.createElement("button");
    back.textContent = "Whole range";
    back.hidden = true;
    const hint = (className, textContent) => Object.assign(document.createElement("span"), { className, textContent });
    if (tools && panels.length) tools.append(back, hint("hint", "drag over a part to zoom in, double click for the whole"));
    if (tools) tools.append(hint("hint touch", "tap for values"));
    const redraw = () => {
      show(figure, svg, null);
      panels.forEach((panel) => panel.redraw());
      back.hidden = panels.every((panel) => panel.x.whole && panel.y.whole);
    };
    const reset = () => { panels.forEach((panel) => { panel.x.view = [0, 1]; panel.y.view = [0, 1]; }); redraw(); };
    back.onclick = reset;
    let start = null, active = false;
    const drop = () => { start = null; svg.querySelectorAll(".tg-drag").forEach((part) => part.remove()); };
    svg.addEventListener("pointerdown", (event) => {
      active = true;
      const panel = under(event);
      if (event.pointerType === "touch" || event.button !== 0 || !panel) return hover(event);
      event.preventDefault();
      svg.setPointerCapture(event.pointerId);
      start = { panel, at: user(event) };
    });
    // A drag mostly along one axis zooms that axis alone.
    const dragged = (event) => {
      const { panel, at } = start, end = user(event), [w, h] = [Math.abs(end[0] - at[0]), Math.abs(end[1] - at[1])];
      const along = { x: w > 6 && w > 0.2 * h, y: h > 6 && (h > 0.2 * w && h > 14) };
      const box = [along.x ? Math.min(at[0], end[0]) : panel.left, along.y ? Math.min(at[1], end[1]) : panel.top, along.x ? w : panel.width, along.y ? h : panel.height];
      return { panel, along, at, end, box };
    };
    svg.addEventListener("pointermove", (event) => {
      if (!start) return hover(event);
      const { along, box: [x, y, width, height] } = dragged(event);
      svg.querySelectorAll(".tg-drag").forEach((part) => part.remove());
      if (along.x || along.y) make(svg, "rect", { class: "tg-drag", x, y, width, height, fill: "currentColor", "fill-opacity": 0.12 });
    });
    svg.addEventListener("pointerup", (event) => {
      if (!start) return;
      const { panel, along, at, end } = dragged(event), [a, b] = [panel.places(at), panel.places(end)];
      drop();
      if (along.x) panel.x.look(a[0], b[0]);
      if (along.y) panel.y.look(a[1], b[1]);
      if (along.x || along.y) redraw(); else hover(event);
    });
    svg.addEventListener("pointercancel", drop);
    svg.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") { active = false; if (!start) show(figure, svg, null); } });
    document.addEventListener("pointerdown", (event) => { if (!figure.contains(event.target)) show(figure, svg, null); });
    svg.addEventListener("dblclick", reset);
    // The wheel scrolls the page until a figure has been clicked, or Ctrl is held; with shift it zooms along y.
    svg.addEventListener("wheel", (event) => {
      const panel = under(event);
      if (!panel || !(event.ctrlKey || event.metaKey || active)) return;
      const axis = event.shiftKey ? panel.y : panel.x, centre = panel.places(user(event))[event.shiftKey ? 1 : 0];
      const by = Math.exp((event.deltaY || event.deltaX) * 0.002);
      if (by > 1 && axis.whole) return; // nothing left to zoom out of: the page scrolls
      event.preventDefault();
      axis.look(...axis.view.map((end) => centre + by * (end - centre)));
      redraw();
    }, { passive: false });
  }
}
