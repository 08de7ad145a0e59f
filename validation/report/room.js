// Whether everything on a page has room: nothing beyond the width, no label without words, no two texts of a figure on one another.
addEventListener("load", () => setTimeout(() => {
  const said = [], width = document.documentElement.clientWidth;
  const words = (element) => (element.textContent || "").trim().replace(/\s+/g, " ").slice(0, 40);
  document.querySelectorAll("details").forEach((folded) => { folded.open = true; });
  document.querySelectorAll("body *").forEach((element) => {
    const box = element.getBoundingClientRect();
    // a table of many columns and lines of code scroll by themselves
    const scrolls = element.closest("pre") || element.closest(".wide")?.querySelector("th:nth-child(7)");
    if (box.width > 0 && box.right > width + 1 && !element.ownerSVGElement && !scrolls) said.push(`beyond the width: ${element.tagName} ${words(element)}`);
    if (["aria-label", "alt", "title"].some((name) => element.getAttribute(name)?.trim() === "")) said.push(`an empty label: ${element.tagName} ${words(element)}`);
    if (element.matches("button, a, svg.tg-figure") && !(element.getAttribute("aria-label") || element.textContent).trim()) said.push(`no name: ${element.tagName}`);
  });
  document.querySelectorAll("svg.tg-figure").forEach((figure) => {
    const edge = figure.getBoundingClientRect();
    const texts = [...figure.querySelectorAll("text")].filter((text) => text.textContent.trim()).map((text) => [text.textContent, text.getBoundingClientRect()]);
    texts.forEach(([text, box], at) => {
      if (box.left < edge.left - 1 || box.right > edge.right + 1 || box.top < edge.top - 1 || box.bottom > edge.bottom + 1) said.push(`cut off in a figure: ${text}`);
      texts.slice(at + 1).forEach(([other, with_]) => {
        const across = Math.min(box.right, with_.right) - Math.max(box.left, with_.left);
        const down = Math.min(box.bottom, with_.bottom) - Math.max(box.top, with_.top);
        if (across > 2 && down > 3) said.push(`on one another: ${text} / ${other}`);
      });
    });
  });
  parent.postMessage(JSON.stringify({ width, said }), "*");
}, 300));
