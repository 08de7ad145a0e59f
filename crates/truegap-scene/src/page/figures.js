// On paper nothing can be unfolded; browsers that know no rule for it are told here.
const folded = () => document.querySelectorAll("details:not([open])");
let opened = [];
addEventListener("beforeprint", () => { opened = [...folded()]; opened.forEach((part) => { part.open = true; }); });
addEventListener("afterprint", () => { opened.forEach((part) => { part.open = false; }); });
// Buttons below each figure: save it as SVG, show it larger. Without this script the page reads the same.
for (const [index, figure] of document.querySelectorAll("figure").entries()) {
  const svg = figure.querySelector("svg.tg-figure");
  if (!svg) continue;
  const bar = figure.appendChild(document.createElement("p"));
  bar.className = "tools";
  const button = (text, act) => {
    const made = bar.appendChild(document.createElement("button"));
    made.textContent = text;
    made.onclick = act;
    return made;
  };
  button("Save as SVG", () => {
    // on paper, whatever the page looks like
    const copy = svg.cloneNode(true);
    copy.style.color = "#1b1f24";
    copy.querySelectorAll(".tg-cross, .tg-drag").forEach((part) => part.remove());
    copy.querySelectorAll(".tg-paper").forEach((part) => part.setAttribute("fill", "#ffffff"));
    copy.querySelectorAll(".tg-halo").forEach((part) => part.setAttribute("stroke", "#ffffff"));
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" }));
    link.download = `figure-${index + 1}.svg`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
  const larger = button("Larger", () => {
    larger.textContent = figure.classList.toggle("large") ? "Smaller" : "Larger";
  });
}
