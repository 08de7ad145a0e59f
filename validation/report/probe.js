// Points at every figure of a report and drags over a part of it; what is said then is the text of a last paragraph, as JSON.
setTimeout(() => {
  const answers = [];
  for (const figure of document.querySelectorAll("figure")) {
    const svg = figure.querySelector("svg.tg-figure");
    const panel = svg && (svg.querySelector(".tg-panel[data-labelled]") || svg.querySelector(".tg-cells[data-area]"));
    if (!panel) continue;
    svg.scrollIntoView();
    svg.setPointerCapture = () => {};
    const [left, top, width, height] = panel.dataset.area.split(" ").map(Number), matrix = svg.getScreenCTM();
    const send = (kind, x, y) => {
      const at = new DOMPoint(left + x * width, top + y * height).matrixTransform(matrix);
      svg.dispatchEvent(new PointerEvent(kind, { clientX: at.x, clientY: at.y, bubbles: true, button: 0, pointerId: 1, pointerType: "mouse" }));
    };
    const ticks = () => [...svg.querySelectorAll(".tg-ticks text")].map((text) => text.textContent).join(" ");
    const values = () => [...figure.querySelectorAll(".tg-values > *")].map((line) => line.textContent);
    // the middle of a map may be a cell without a value, which is said as well
    const said = [1 / 3, 1 / 2, 2 / 3].map((x) => { send("pointermove", x, 0.5); return values(); });
    let zoomed = null;
    if (panel.classList.contains("tg-panel")) {
      const before = ticks();
      send("pointerdown", 0.4, 0.3);
      send("pointermove", 0.6, 0.6);
      send("pointerup", 0.6, 0.6);
      zoomed = { before, ticks: ticks() };
      svg.dispatchEvent(new MouseEvent("dblclick", { bubbles: true }));
      zoomed.after = ticks();
    }
    answers.push({ name: figure.querySelector("figcaption").textContent.slice(0, 40), said, zoomed });
  }
  const pre = document.body.appendChild(document.createElement("pre"));
  pre.id = "said";
  pre.textContent = JSON.stringify(answers);
}, 100);
