"use strict";
(function (root) {
  const find = (name) => root.querySelector("." + name);
  const canvas = root.querySelector("canvas");
  const bytes = Uint8Array.from(atob(find("tg-glb").textContent), (c) => c.charCodeAt(0));

  // --- the file: header, JSON chunk, binary chunk -------------------------------------------------------------------
  function parse(bytes) {
    const words = new DataView(bytes.buffer);
    const length = words.getUint32(12, true);
    const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
    const start = 20 + length + 8;
    const array = (index) => {
      const accessor = json.accessors[index];
      const view = json.bufferViews[accessor.bufferView];
      const size = { SCALAR: 1, VEC3: 3, VEC4: 4 }[accessor.type] * accessor.count;
      const kind = accessor.componentType === 5125 ? Uint32Array : Float32Array;
      return new kind(bytes.buffer, start + (view.byteOffset || 0), size);
    };
    const about = json.scenes[json.scene || 0].extras || {};
    const parts = json.nodes.filter((node) => node.mesh !== undefined).map((node) => {
      const primitive = json.meshes[node.mesh].primitives[0];
      const material = json.materials[primitive.material].pbrMetallicRoughness || {};
      const { POSITION, NORMAL } = primitive.attributes;
      return {
        name: node.name,
        swatch: node.extras && node.extras.material_colour,
        shown: true,
        factor: material.baseColorFactor || [1, 1, 1, 1],
        positions: array(POSITION),
        normals: array(NORMAL),
        fields: (about.fields || []).map((f) => (f.attribute in primitive.attributes ? array(primitive.attributes[f.attribute]) : null)),
        indices: array(primitive.indices),
        targets: (primitive.targets || []).map((t) => [array(t.POSITION), array(t.NORMAL)]),
      };
    });
    return { parts, about };
  }

  // --- colours ------------------------------------------------------------------------------------------------------
  const bytesOf = (css) => [1, 3, 5].map((i) => parseInt(css.slice(i, i + 2), 16));
  const linear = (byte) => { const c = byte / 255; return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4; };

  // Linear-light colours of the values: stops interpolated in sRGB, as the metadata says.
  function paint(values, field) {
    const stops = field.stops.map((s) => bytesOf(s.srgb)), last = stops.length - 1, fine = 512;
    const table = Array.from({ length: fine + 1 }, (_, n) => {
      const place = (last * n) / fine, k = Math.min(Math.floor(place), last - 1), t = place - k;
      return [0, 1, 2].map((c) => linear(stops[k][c] + t * (stops[k + 1][c] - stops[k][c])));
    });
    const colours = new Float32Array(3 * values.length);
    values.forEach((v, i) => {
      const t = Math.min(1, Math.max(0, (v - field.min) / (field.max - field.min)));
      colours.set(table[Math.round(t * fine)], 3 * i);
    });
    return colours;
  }

  // --- drawing ------------------------------------------------------------------------------------------------------
  const VERTEX = `#version 300 es
    layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal; layout(location = 2) in vec3 colour;
    layout(location = 3) in vec3 move; layout(location = 4) in vec3 turn;
    uniform mat4 view; uniform float weight, stretch, lift; uniform vec3 centre;
    out vec3 light; out vec3 facing;
    void main() {
      vec3 p = position + weight * move - centre;
      facing = normalize((normal + weight * turn) * vec3(1.0, 1.0 / stretch, 1.0));
      light = colour;
      gl_Position = view * vec4(p.x, stretch * (p.y + lift), p.z, 1.0);
    }`;
  const FRAGMENT = `#version 300 es
    precision highp float;
    in vec3 light; in vec3 facing; uniform vec3 factor, lamp; out vec4 pixel;
    void main() {
      float shade = 0.62 + 0.38 * max(dot(normalize(facing), lamp), 0.0);
      vec3 c = clamp(light * factor * shade, 0.0, 1.0);
      vec3 encoded = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
      pixel = vec4(encoded, 1.0);
    }`;

  function program(gl) {
    const made = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
    return made;
  }

  function upload(gl, part) {
    const buffer = (data, kind) => {
      const made = gl.createBuffer();
      gl.bindBuffer(kind, made);
      gl.bufferData(kind, data, gl.STATIC_DRAW);
      return made;
    };
    part.array = gl.createVertexArray();
    gl.bindVertexArray(part.array);
    const attribute = (location, data, size) => {
      const made = buffer(data, gl.ARRAY_BUFFER);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, 0, 0);
      return made;
    };
    attribute(0, part.positions, 3);
    attribute(1, part.normals, 3);
    part.paint = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, part.paint);
    gl.vertexAttribPointer(2, 3, gl.FLOAT, false, 0, 0);
    part.moves = part.targets.map(([move, turn]) => [buffer(move, gl.ARRAY_BUFFER), buffer(turn, gl.ARRAY_BUFFER)]);
    part.elements = buffer(part.indices, gl.ELEMENT_ARRAY_BUFFER);
    gl.bindVertexArray(null);
  }

  // --- the camera: turn about the middle, move, zoom ----------------------------------------------------------------
  const home = () => ({ azimuth: 0.35, elevation: 0.5, distance: 2.7, right: 0, up: 0 });
  let camera = home();

  function viewMatrix(radius, aspect) {
    const [sa, ca, se, ce] = [Math.sin(camera.azimuth), Math.cos(camera.azimuth), Math.sin(camera.elevation), Math.cos(camera.elevation)];
    const x = [ca, 0, -sa], y = [-sa * se, ce, -ca * se], z = [sa * ce, se, ca * ce];
    const d = camera.distance * radius, near = Math.max(d - 4 * radius, 0.02 * radius), far = d + 4 * radius;
    // the disc is wider than high: on a narrow page its width must fit
    const f = 1 / Math.tan(0.3), g = f * Math.min(1, 0.7 * aspect);
    const rows = [
      [...x, -camera.right * radius].map((v) => (v * g) / aspect),
      [...y, -camera.up * radius].map((v) => v * g),
      [...z, -d].map((v, i) => ((far + near) / (near - far)) * v + (i === 3 ? (2 * far * near) / (near - far) : 0)),
      [...z, -d].map((v) => -v),
    ];
    const lamp = [0, 1, 2].map((i) => 0.35 * x[i] + 0.6 * y[i] + 0.72 * z[i]);
    return { view: new Float32Array([0, 1, 2, 3].flatMap((c) => rows.map((row) => row[c]))), lamp };
  }

  function extent(parts) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const { positions } of parts) {
      for (let i = 0; i < positions.length; i++) {
        low[i % 3] = Math.min(low[i % 3], positions[i]);
        high[i % 3] = Math.max(high[i % 3], positions[i]);
      }
    }
    // A cut-away solid is turned about its axis, not about the middle of its box.
    return { centre: [0, (low[1] + high[1]) / 2, 0], radius: Math.max(high[0], -low[0], high[2], -low[2], (high[1] - low[1]) / 2), height: high[1] - low[1] };
  }

  // --- everything together ------------------------------------------------------------------------------------------
  const { parts, about } = parse(bytes);
  const targets = (about.deformation && about.deformation.targets) || [];
  const box = extent(parts);
  // A disc 30 times as wide as high is a flat spot: it opens with its height stretched to half of its radius, by a round factor that is said.
  const stretched = [30, 20, 15, 10, 8, 5, 4, 3, 2].find((factor) => factor * box.height <= 0.5 * box.radius) || 1;
  const look = { target: 0, weight: targets.length ? 1 : 0, stretch: stretched, apart: 0 };
  let gl, locations, asked = false;

  function draw() {
    asked = false;
    const scale = window.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * scale));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * scale));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const tall = 0.5 * (box.height * look.stretch + 0.7 * look.apart * box.radius);
    const { view, lamp } = viewMatrix(Math.hypot(box.radius, tall), canvas.width / canvas.height);
    gl.uniformMatrix4fv(locations.view, false, view);
    gl.uniform3fv(locations.lamp, lamp);
    gl.uniform3fv(locations.centre, box.centre);
    gl.uniform1f(locations.weight, look.weight);
    gl.uniform1f(locations.stretch, look.stretch);
    parts.forEach((part, i) => {
      if (!part.shown) return;
      gl.bindVertexArray(part.array);
      const move = part.moves[look.target];
      for (const [k, location] of [[0, 3], [1, 4]]) {
        if (!move) { gl.disableVertexAttribArray(location); continue; }
        gl.bindBuffer(gl.ARRAY_BUFFER, move[k]);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0);
      }
      gl.vertexAttrib3f(2, 1, 1, 1);
      gl.uniform3fv(locations.factor, part.painted ? [1, 1, 1] : part.swatch ? bytesOf(part.swatch).map(linear) : part.factor.slice(0, 3));
      const gap = (look.apart * 0.7 * box.radius) / look.stretch / Math.max(parts.length - 1, 1);
      gl.uniform1f(locations.lift, gap * (i - (parts.length - 1) / 2));
      gl.drawElements(gl.TRIANGLES, part.indices.length, gl.UNSIGNED_INT, 0);
    });
  }
  const redraw = () => { if (!asked && gl) { asked = true; requestAnimationFrame(draw); } };

  const number = (v) => (Math.abs(v) >= 1e5 || (v !== 0 && Math.abs(v) < 1e-3) ? v.toExponential(2) : String(Number(v.toPrecision(4))));

  function describe() {
    const chosen = targets[look.target];
    const largest = about.deformation && about.deformation.largest_displacement_m;
    const shown = chosen ? `Displacements shown ${number(look.weight * chosen.factor)} times their size (largest: ${number(1e6 * largest)} µm). ` : "";
    const tall = look.stretch > 1.005 ? `Heights stretched ${number(look.stretch)} times. ` : "";
    const from = about.provenance || {};
    find("tg-says").textContent = shown + tall + [from.source, from.command, from.version && "version " + from.version].filter(Boolean).join("; ");
    find("tg-stretch-says").textContent = number(look.stretch);
    const moved = chosen && look.weight * chosen.factor;
    const parts = [look.stretch > 1.005 && `heights × ${number(look.stretch)}`, chosen && Math.abs(moved - 1) > 0.005 && `displacements × ${number(moved)}`];
    find("tg-scale").textContent = parts.filter(Boolean).join(", ") || "true to scale";
    redraw();
  }

  // Colours the parts by the chosen field, or with their materials.
  function colourBy(choice) {
    const field = (about.fields || [])[choice];
    for (const part of parts) {
      const values = field && part.fields[choice];
      part.painted = Boolean(values);
      gl.bindVertexArray(part.array);
      if (!values) { gl.disableVertexAttribArray(2); continue; }
      gl.bindBuffer(gl.ARRAY_BUFFER, part.paint);
      gl.bufferData(gl.ARRAY_BUFFER, paint(values, field), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(2);
    }
    legend(field);
    redraw();
  }

  function legend(field) {
    find("tg-bar").hidden = !field;
    find("tg-bar-numbers").textContent = "";
    if (!field) return;
    find("tg-bar-title").textContent = field.unit ? `${field.name} (${field.unit})` : field.name;
    find("tg-bar-colours").style.background = `linear-gradient(to right, ${field.stops.map((s) => s.srgb).join(", ")})`;
    const beyond = [field.data_min < field.min ? "≤ " : "", "", field.data_max > field.max ? "≥ " : ""];
    [field.min, (field.min + field.max) / 2, field.max].forEach((v, i) => {
      find("tg-bar-numbers").append(Object.assign(document.createElement("span"), { textContent: beyond[i] + number(v) }));
    });
  }

  function connectControls() {
    const select = find("tg-target"), weight = find("tg-weight"), field = find("tg-field");
    (about.fields || []).forEach((f, i) => field.append(new Option(f.unit ? `${f.name} (${f.unit})` : f.name, i)));
    field.append(new Option("materials", -1));
    field.addEventListener("change", () => colourBy(Number(field.value)));
    targets.forEach((t, i) => select.append(new Option(t.name, i)));
    find("tg-morph").hidden = !targets.length;
    if (!targets.length) find("tg-morph").style.display = "none";
    select.addEventListener("change", () => { look.target = Number(select.value); describe(); });
    weight.addEventListener("input", () => { look.weight = Number(weight.value); describe(); });
    find("tg-stretch").addEventListener("input", (e) => { look.stretch = 10 ** Number(e.target.value); describe(); });
    find("tg-apart").addEventListener("input", (e) => { look.apart = Number(e.target.value); redraw(); });
    const set = (name, value) => { find(name).value = value; find(name).dispatchEvent(new Event("input")); };
    set("tg-stretch", Math.log10(stretched));
    look.stretch = stretched; // the slider rounds
    find("tg-reset").addEventListener("click", () => { camera = home(); set("tg-stretch", Math.log10(stretched)); redraw(); });
    find("tg-true").addEventListener("click", () => {
      set("tg-stretch", 0);
      set("tg-apart", 0);
      const exact = targets.findIndex((t) => t.factor === 1);
      if (exact >= 0) { select.value = look.target = exact; set("tg-weight", 1); }
      describe();
    });
    let playing = 0;
    find("tg-play").addEventListener("click", (e) => {
      if (playing) { cancelAnimationFrame(playing); playing = 0; e.target.textContent = "Play"; return; }
      e.target.textContent = "Stop";
      const start = performance.now();
      const step = (now) => {
        look.weight = 0.5 - 0.5 * Math.cos((now - start) / 700);
        weight.value = look.weight;
        describe();
        playing = requestAnimationFrame(step);
      };
      playing = requestAnimationFrame(step);
    });
    for (const part of parts) {
      const label = document.createElement("label"), tick = document.createElement("input"), swatch = document.createElement("i");
      tick.type = "checkbox";
      tick.checked = true;
      tick.addEventListener("change", () => { part.shown = tick.checked; redraw(); });
      if (part.swatch) swatch.style.background = part.swatch;
      label.append(tick, " ", swatch, " ", part.name);
      find("tg-layers").append(label);
    }
  }

  function connectPointer() {
    const fingers = new Map();
    canvas.addEventListener("pointerdown", (e) => { canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, [e.clientX, e.clientY]); });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (e) => fingers.delete(e.pointerId));
    const zoom = (by) => { camera.distance = Math.min(20, Math.max(0.15, camera.distance * by)); redraw(); };
    canvas.addEventListener("pointermove", (e) => {
      const before = fingers.get(e.pointerId);
      if (!before) return;
      const [dx, dy] = [e.clientX - before[0], e.clientY - before[1]];
      const span = () => { const [a, b] = [...fingers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
      const wide = fingers.size === 2 ? span() : 0;
      fingers.set(e.pointerId, [e.clientX, e.clientY]);
      if (fingers.size === 2) { zoom(wide / Math.max(span(), 1)); return; }
      const rate = (0.62 * camera.distance) / canvas.clientHeight;
      if (e.shiftKey || e.buttons === 2) {
        camera.right -= dx * rate;
        camera.up += dy * rate;
      } else {
        camera.azimuth -= dx * 0.008;
        camera.elevation = Math.min(1.57, Math.max(-1.57, camera.elevation + dy * 0.008));
      }
      redraw();
    });
    canvas.addEventListener("wheel", (e) => { e.preventDefault(); zoom(Math.exp(e.deltaY * 0.001)); }, { passive: false });
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    canvas.addEventListener("keydown", (e) => {
      const turn = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[e.key];
      if (turn) { camera.azimuth += turn[0]; camera.elevation = Math.min(1.57, Math.max(-1.57, camera.elevation + turn[1])); }
      else if (e.key === "+" || e.key === "-") camera.distance *= e.key === "+" ? 0.9 : 1.1;
      else return;
      e.preventDefault();
      redraw();
    });
  }

  // An address that ends in #field=0&target=1&weight=0.5&stretch=8&apart=0.6 opens in that state.
  function openAsAsked() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const set = (name, value) => { find(name).value = value; find(name).dispatchEvent(new Event(find(name).tagName === "SELECT" ? "change" : "input")); };
    if (asked.has("field")) set("tg-field", asked.get("field"));
    if (asked.has("target") && targets[asked.get("target")]) set("tg-target", asked.get("target"));
    if (asked.has("weight") && targets.length) set("tg-weight", asked.get("weight"));
    if (asked.has("stretch")) set("tg-stretch", Math.log10(Number(asked.get("stretch"))));
    if (asked.has("apart")) set("tg-apart", asked.get("apart"));
  }

  const save = find("tg-save");
  save.href = URL.createObjectURL(new Blob([bytes], { type: "model/gltf-binary" }));
  save.download = (root.dataset.title || "scene").replace(/[^\w.-]+/g, "-") + ".glb";
  try {
    gl = canvas.getContext("webgl2", { antialias: true });
    if (!gl) throw new Error("this browser offers no WebGL 2; save the GLB and open it in another viewer");
    const made = program(gl);
    gl.useProgram(made);
    locations = Object.fromEntries(["view", "weight", "stretch", "lift", "centre", "factor", "lamp"].map((n) => [n, gl.getUniformLocation(made, n)]));
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    parts.forEach((part) => upload(gl, part));
    connectControls();
    colourBy(Number(find("tg-field").value));
    connectPointer();
    openAsAsked();
    new ResizeObserver(redraw).observe(canvas);
    describe();
  } catch (error) {
    find("tg-message").hidden = false;
    find("tg-message").textContent = "The 3D view cannot be shown: " + error.message;
  }
})(document.currentScript.parentElement);
